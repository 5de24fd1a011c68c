// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_SLIDE_TURNING_H
#define RODPACK_CONTACT_SLIDE_TURNING_H

#include <algorithm>
#include <cmath>

#include "contact_law.h"
#include "../geometry/vector3.h"

namespace rodpack {

// The direction of a slide in space. Spring and dashpot side by side, in series with a slider that
// gives way along the force: while they carry the cap, k s + c (v - w f) = cap f with the velocity
// w > 0 of the slider along f, so that
//   f = (k s + c v) / |k s + c v|,   ds/dt = v - w f,   w = (|k s + c v| - cap) / c.
// Of ds/dt only what turns the spring counts, whose length is cap / k by contact_law.h: with its
// direction u
//   du/dt = k (v - (v.u) u) / N,   N = |cap u + c v|.
// The slider stops where N = cap, that is 2 cap u.v + c v^2 = 0: there spring and dashpot go on
// alone, and the force with them. In the plane u stands still, and the slider stops with v.

/// A contact at the end of a step; vectors lie in its present plane. SI units.
struct FrictionStep {
  double stiffness, damping;  // N/m, kg/s
  double cap;                 // of friction_cap.h, N,
  double cap_rate;            // N/s,
  double cap_curvature;       // and N/s^2; 0 where it is not known
  double dt;
  double normal[3];         // unit vector, across the plane of contact
  double velocity[3][3];    // now, one and two steps ago, m/s
  int known;                // how many of these, 1 to 3
  double spring_before[3];  // one step ago, m
  bool slid;                // one step ago
  double since_touch;       // from touch to one step ago where that was the first evaluation, s
};

namespace detail {

/// The cap `age` seconds ago, N. A contact that sticks keeps the spring that carried the cap
/// then, so that without the curvature it would keep an error of O(dt^2).
inline double cap_at(const FrictionStep& step, double age) {
  return std::max(0.0, step.cap - age * (step.cap_rate - 0.5 * age * step.cap_curvature));
}

/// The velocity `age` seconds ago, of the parabola through the last three.
inline void slip_at(const FrictionStep& step, double age, double (&velocity)[3]) {
  const double x = age / step.dt;
  for (int d = 0; d < 3; ++d) {
    const double v = step.velocity[0][d];
    velocity[d] = v;
    if (step.known < 2) continue;
    const double back = step.velocity[1][d] - v;
    velocity[d] += x * back;
    if (step.known < 3) continue;
    velocity[d] += 0.5 * x * (x - 1.0) * (step.velocity[2][d] - step.velocity[1][d] - back);
  }
}

/// Whether a velocity in the plane of contact, with this normal, has more than rounding across a
/// direction, a unit vector or 0. In the plane of x and y there is nothing to the last bit.
inline bool moves_across(const double (&velocity)[3], const double (&direction)[3],
                         const double* normal) {
  double aside[3];
  cross(normal, direction, aside);
  return std::fabs(dot(velocity, aside)) > 1e-9 * std::fabs(dot(velocity, direction));
}

/// Sets `unit` to the direction of a vector, 0 if it has none, and returns its length.
inline double direction_of(const double (&vector)[3], double (&unit)[3]) {
  const double length = std::sqrt(dot(vector, vector));
  for (int d = 0; d < 3; ++d) unit[d] = length > 0.0 ? vector[d] / length : 0.0;
  return length;
}

/// The direction of a slide's spring in the course of a step.
class SlideTurning {
 public:
  /// From the unit vector `begin` on, `age` seconds ago.
  SlideTurning(const FrictionStep& step, const double (&begin)[3], double age);
  /// The direction `age` seconds ago, a unit vector.
  void at(double age, double (&direction)[3]) const;

 private:
  double angle_at(double age) const;

  const FrictionStep& step_;
  double begin_;
  double along_[3], across_[3];
};

/// What the force of a slide stands against: k s + c v, of any length; where v has nothing across
/// the spring the spring itself.
inline void slide_load(double stiffness, double damping, const double (&spring)[3],
                       const double (&velocity)[3], const double* normal, double (&load)[3]) {
  double direction[3];
  direction_of(spring, direction);
  std::copy(spring, spring + 3, load);
  if (!(damping > 0.0) || !moves_across(velocity, direction, normal)) return;
  for (int d = 0; d < 3; ++d) load[d] = stiffness * spring[d] + damping * velocity[d];
}

}  // namespace detail

/// The force of a slide, N, whose spring (m) carries the cap.
inline void slide_force(double stiffness, double damping, const double (&spring)[3],
                        const double (&velocity)[3], const double* normal, double (&force)[3]) {
  double load[3];
  detail::slide_load(stiffness, damping, spring, velocity, normal, load);
  for (int d = 0; d < 3; ++d) force[d] = spring_force(stiffness, spring[d]);
  if (std::equal(load, load + 3, spring)) return;
  const double scale = stiffness * std::sqrt(dot(spring, spring) / dot(load, load));
  for (int d = 0; d < 3; ++d) force[d] = -scale * load[d];
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_FORCE_CHANGE_H
#define RODPACK_CONTACT_FORCE_CHANGE_H

#include <algorithm>
#include <cstddef>

#include "../geometry/vector3.h"
#include "contact_law.h"

namespace rodpack {

// Events of a contact. A contact force is smooth in time but for touch, end, and changes between
// the branches of its law. A multistep formula that extrapolates through such an event is of first
// order where the force jumps (a dashpot at touch) and of second where it has a kink.
//
// Once the event is known, one step late, three things restore the order: the impulse and the
// displacement that the step has missed, and records of the past that continue the new branch
// smoothly backwards, so that the next steps extrapolate the right function. All of them follow
// from the difference D(t) = new branch - old branch, taken as linear since the event; they add up
// over the contacts of a body, and the two bodies of a contact get opposite ones, so that momentum
// is conserved to round-off. With a linear D each of the two or three steps that use it errs by
// O(dt^3), once per event: third order.

/// Moments of the change D of a force (N) or torque (N m) since an event in the last step.
struct ForceChange {
  double now[3];      // D at the end of the step
  double rate[3];     // dD/dt
  double impulse[3];  // integral of D since the event
  /// Integral over time of that impulse, as it grew since the event: displacement times mass.
  double impulse_integral[3];

  ForceChange& operator+=(const ForceChange& other) {
    for (int d = 0; d < 3; ++d) {
      now[d] += other.now[d];
      rate[d] += other.rate[d];
      impulse[d] += other.impulse[d];
      impulse_integral[d] += other.impulse_integral[d];
    }
    return *this;
  }

  ForceChange& operator*=(double factor) {
    for (int d = 0; d < 3; ++d) {
      now[d] *= factor;
      rate[d] *= factor;
      impulse[d] *= factor;
      impulse_integral[d] *= factor;
    }
    return *this;
  }

  /// What the record of the force gains that was made `age` seconds ago (component d).
  double past_force(int d, double age) const { return now[d] - age * rate[d]; }
  /// What the record of the momentum gains that was made `age` seconds ago (component d).
  double past_momentum(int d, double age) const {
    return impulse[d] - age * now[d] + 0.5 * age * age * rate[d];
  }
};

static_assert(offsetof(ForceChange, now) == 0 && offsetof(ForceChange, rate) == 24 &&
                  offsetof(ForceChange, impulse) == 48 &&
                  offsetof(ForceChange, impulse_integral) == 72 && sizeof(ForceChange) == 96,
              "changes of spheres' forces are stored, and sent, as plain doubles");

/// A change that is `now` and grows by `rate`, of an event that lies `since` seconds back.
inline ForceChange linear_change(const double (&now)[3], const double (&rate)[3], double since) {
  ForceChange change;
  const double half = 0.5 * since * since, third = since * since * since / 3.0;
  for (int d = 0; d < 3; ++d) {
    change.now[d] = now[d];
    change.rate[d] = rate[d];
    change.impulse[d] = since * now[d] - half * rate[d];
    change.impulse_integral[d] = half * now[d] - third * rate[d];
  }
  return change;
}

/// -coefficient times a velocity that has changed, where `acceleration`, `velocity` and
/// `displacement` are the changes of an event in the last step as seen at its end, and a step of
/// length `dt` has passed since: the dashpot of a contact whose bodies had an event.
inline ForceChange dashpot_change(double coefficient, const double (&acceleration)[3],
                                  const double (&velocity)[3], const double (&displacement)[3],
                                  double dt) {
  ForceChange change;
  for (int d = 0; d < 3; ++d) {
    const double a = -coefficient * acceleration[d], v = -coefficient * velocity[d];
    const double x = -coefficient * displacement[d];
    change.now[d] = v + dt * a;
    change.rate[d] = a;
    change.impulse[d] = x + dt * (v + 0.5 * dt * a);
    change.impulse_integral[d] = dt * (x + dt * (0.5 * v + dt * a / 6.0));
  }
  return change;
}

/// The torque of a changed force at `lever` (m), which moves at `lever_rate` (m/s). `product`(a, b,
/// result) is that of vectors.
template <class Product>
inline ForceChange torque_change(const double (&lever)[3], const double (&lever_rate)[3],
                                 const ForceChange& force, Product product) {
  ForceChange torque;
  double of_rate[3], of_impulse[3];
  product(lever, force.now, torque.now);
  product(lever, force.rate, torque.rate);
  product(lever_rate, force.now, of_rate);
  // int (L - (t_now - t) L') x D dt, and the integral of the impulse is int (t_now - t) D dt
  product(lever, force.impulse, torque.impulse);
  product(lever_rate, force.impulse_integral, of_impulse);
  product(lever, force.impulse_integral, torque.impulse_integral);
  for (int d = 0; d < 3; ++d) {
    torque.rate[d] += of_rate[d];
    torque.impulse[d] -= of_impulse[d];
  }
  return torque;
}

/// The torque of a changed force in space, from lever and lever rate.
inline ForceChange torque_change(const double (&lever)[3], const double (&lever_rate)[3],
                                 const ForceChange& force) {
  return torque_change(lever, lever_rate, force, cross);
}

/// The torque of a changed force where everything lies in the plane of x and y: it has a z
/// component alone, the others are 0.
inline ForceChange planar_torque_change(const double (&lever)[3], const double (&lever_rate)[3],
                                        const ForceChange& force) {
  return torque_change(lever, lever_rate, force,
                       [](const double* a, const double* b, double* result) {
                         result[0] = result[1] = 0.0;
                         result[2] = cross_z<double>({a[0], a[1]}, {b[0], b[1]});
                       });
}

/// Time since a quantity that is `before` one step ago and `now` now, of the other sign, was 0.
inline double time_since_zero(double before, double now, double dt) {
  return dt * std::min(1.0, std::max(0.0, now / (now - before)));
}

}  // namespace rodpack

#endif

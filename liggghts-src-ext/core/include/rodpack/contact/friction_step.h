// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_FRICTION_STEP_H
#define RODPACK_CONTACT_FRICTION_STEP_H

#include <algorithm>
#include <cmath>

#include "contact_law.h"
#include "force_change.h"
#include "slide_turning.h"
#include "../geometry/vector3.h"

namespace rodpack {

// The friction of contact_law.h, followed through a step in which it may begin or cease to slide.
// With a tangential dashpot the law has this limit as the step goes to 0: a contact slides until
// its velocity vanishes, since the spring alone carries the cap while it slides; and a contact
// whose cap falls below the force while the spring moves the surfaces loses the excess of its
// spring at once, and sticks again. Deciding anew in each step, without looking for the moment,
// finds these changes O(dt) early or late and is of first order. In space the spring turns while it
// slides, and the slide ends before its velocity vanishes (slide_turning.h).

struct FrictionForce {
  double force[3];  // on i, N
  bool slides;
  // The change of branch in this step, if there was one.
  bool changed, jumps;  // jumps: the force did not go on continuously
  double since;         // s
  double gain[3];       // over the force if the branch before had gone on, N
  double gain_rate[3];  // N/s
};

namespace detail {

/// Time since the slip was 0: slip[0] > 0 now, slip[1] one step ago, slip[2] earlier; of the
/// quadratic through them, or, where a jump of the bodies has stopped it in the step before, so
/// that slip[1] is not below 0, of the line through the last two.
inline double time_since_standstill(const double (&slip)[3], int known, double dt) {
  if (!(slip[1] < 0.0)) return time_since_zero(slip[1], slip[0], dt);
  double x = slip[0] / (slip[0] - slip[1]);
  if (known > 2) {
    const double c = 0.5 * (slip[2] - 2.0 * slip[1] + slip[0]), b = slip[1] - slip[0] - c;
    for (int k = 0; k < 4; ++k) x -= (slip[0] + x * (b + x * c)) / (b + 2.0 * x * c);
  }
  return x >= 0.0 && x <= 1.0 ? x * dt : time_since_zero(slip[1], slip[0], dt);
}

inline void stuck_force(const FrictionStep& step, const double (&spring)[3], double (&force)[3]) {
  for (int d = 0; d < 3; ++d)
    force[d] = trial_force(step.stiffness, spring[d], step.damping, step.velocity[0][d]);
}

/// The force of spring and dashpot one step ago, N.
inline void stuck_force_before(const FrictionStep& step, double (&force)[3]) {
  for (int d = 0; d < 3; ++d)
    force[d] =
        trial_force(step.stiffness, step.spring_before[d], step.damping, step.velocity[1][d]);
}

/// Its excess over the cap then, N.
inline double excess_before(const FrictionStep& step) {
  double before[3];
  stuck_force_before(step, before);
  return std::sqrt(dot(before, before)) - cap_at(step, step.dt);
}

/// The force of a slide without a velocity across it, under `cap` (N). `before`: its direction
/// before, a unit vector, 0 if there was none.
inline void sliding_force(const FrictionStep& step, const double (&velocity)[3], double cap,
                          const double (&before)[3], double (&force)[3]) {
  const double speed = std::sqrt(dot(velocity, velocity));
  const double kept = std::max(0.0, cap / step.damping - speed);
  for (int d = 0; d < 3; ++d) force[d] = kept * before[d] - velocity[d];
  const double length = std::sqrt(dot(force, force));
  for (int d = 0; d < 3; ++d) force[d] *= length > 0.0 ? cap / length : 0.0;
}

/// The contact slides, or goes on to. `stuck`: the force if it did not, of magnitude `trial`;
/// `direction`: of the force before; `slip`: the velocity along it.
inline FrictionForce slide(const FrictionStep& step, const double (&stuck)[3], double trial,
                           double cap, const double (&direction)[3], double slip,
                           double (&spring)[3]) {
  FrictionForce result = {};
  result.slides = true;
  sliding_force(step, step.velocity[0], cap, direction, result.force);
  for (int d = 0; d < 3; ++d) spring[d] = carrying_spring(result.force[d], step.stiffness);
  // Without friction there are no branches.
  if (step.slid || !(cap > 0.0)) return result;
  result.changed = true;
  result.since = time_since_zero(excess_before(step), trial - cap, step.dt);
  double slide_before[3], stuck_before[3];
  sliding_force(step, step.velocity[1], cap_at(step, step.dt), direction, slide_before);
  stuck_force_before(step, stuck_before);
  for (int d = 0; d < 3; ++d) {
    result.gain[d] = result.force[d] - stuck[d];
    result.gain_rate[d] = (result.gain[d] - (slide_before[d] - stuck_before[d])) / step.dt;
  }
  result.jumps = slip > 0.0;
  return result;
}

/// The force (N) of a contact that has come to stick with this spring (m). Where the cap has fallen
/// further meanwhile, the spring alone carries it, along `direction`; the force is then that of the
/// law with this spring, as ever, so that it is the same when it is evaluated again.
inline void stick_with(const FrictionStep& step, double cap, const double (&direction)[3],
                       double (&spring)[3], double (&force)[3]) {
  stuck_force(step, spring, force);
  if (!(std::sqrt(dot(force, force)) > cap)) return;
  for (int d = 0; d < 3; ++d) spring[d] = carrying_spring(cap, step.stiffness) * direction[d];
  tangential_force(step.stiffness, step.damping, cap, spring, step.velocity[0], force);
}

/// Steps that a tooth of the force under a falling cap has to last for its cap drop to be followed.
constexpr double steps_of_followed_tooth = 4.0;

/// Whether a cap drop is one of many in a row, whose teeth the steps hardly show: it takes what the
/// dashpot carries off the force, `slip` times its constant, and the excess over the cap, which has
/// grown by `growth` (N) in this step, makes that up in less than steps_of_followed_tooth. Without
/// being followed each of them gives the bodies up to half a step of that too much or too little,
/// on average nothing (theory.md, section 6). A contact that has just touched is followed in any
/// case.
inline bool is_short_tooth(const FrictionStep& step, double growth, double slip) {
  return !(step.since_touch > 0.0) && step.damping * slip < steps_of_followed_tooth * growth;
}

/// The contact sticks, from a moment in this step on, with the spring that carried the cap then,
/// and what the surfaces have moved since. `direction`: of the force before; `slip`: the velocities
/// along it.
inline FrictionForce stick(const FrictionStep& step, const double (&stuck)[3], double trial,
                           double cap, const double (&direction)[3], const double (&slip)[3],
                           double (&spring)[3]) {
  FrictionForce result = {};
  const bool stands = step.slid;
  if (stands) {
    result.changed = true;
    result.since = time_since_standstill(slip, step.known, step.dt);
  } else {
    const double excess = trial - cap, before = excess_before(step);
    result.changed = !is_short_tooth(step, excess - before, slip[0]);
    result.since = time_since_zero(before, excess, step.dt);
  }
  const double at_change = cap_at(step, result.since);
  const double share = result.since / step.dt;
  for (int d = 0; d < 3; ++d) {
    const double then = (1.0 - share) * step.velocity[0][d] + share * step.velocity[1][d];
    spring[d] = carrying_spring(at_change, step.stiffness) * direction[d] +
                0.5 * result.since * (step.velocity[0][d] + then);
  }
  stick_with(step, cap, direction, spring, result.force);
  if (!result.changed) return result;

  // After a cap drop the spring is short by the same length ever after. At a standstill the force
  // goes on from the cap.
  for (int d = 0; d < 3; ++d) {
    const double v = step.velocity[0][d];
    result.gain[d] = result.force[d] - (stands ? cap * direction[d] : stuck[d]);
    result.gain_rate[d] = stands ? spring_force(step.stiffness, v) -
                                       step.damping * (v - step.velocity[1][d]) / step.dt -
                                       step.cap_rate * direction[d]
                                 : 0.0;
  }
  result.jumps = !stands;
  return result;
}

// ---- where the surfaces move across the force, in space (friction_in_space.cpp)

/// The contact begins to slide. `stuck`: the force if it did not; `spring`: likewise.
FrictionForce begin_slide(const FrictionStep& step, const double (&stuck)[3], double (&spring)[3]);

/// The contact slid one step ago, and slides on, or sticks from a moment in this step on.
FrictionForce go_on(const FrictionStep& step, double (&spring)[3]);

}  // namespace detail

/// The force and its change of branch; `spring` (m) comes as the integral of the velocity and
/// leaves as the law wants it.
inline FrictionForce friction_force(const FrictionStep& step, double (&spring)[3]) {
  double stuck[3];
  detail::stuck_force(step, spring, stuck);
  const double trial = std::sqrt(dot(stuck, stuck)), cap = std::max(0.0, step.cap);
  if (!step.slid && trial <= cap) {
    FrictionForce result = {};
    std::copy(stuck, stuck + 3, result.force);
    return result;
  }

  double direction[3], slip[3];  // of the force; velocity against which it acts, < 0 in a slide
  const double* const reference = step.slid ? step.spring_before : stuck;
  const double length = std::sqrt(dot(reference, reference));
  for (int d = 0; d < 3; ++d)
    direction[d] = length > 0.0 ? (step.slid ? -1.0 : 1.0) * reference[d] / length : 0.0;
  for (int k = 0; k < 3; ++k) slip[k] = k < step.known ? dot(step.velocity[k], direction) : 0.0;
  const double(&velocity)[3] = step.velocity[0];
  const bool in_space = detail::moves_across(velocity, direction, step.normal);
  if (in_space && step.slid) return detail::go_on(step, spring);
  // A contact that sticks has a spring that carries the cap along `direction`, and its dashpot:
  // where a velocity across takes that beyond the cap again, it slides.
  const bool slides =
      slip[0] < 0.0 || (in_space && step.damping * dot(velocity, velocity) > 2.0 * cap * slip[0]);
  if (in_space && slides && cap > 0.0) return detail::begin_slide(step, stuck, spring);
  return slides || length == 0.0
             ? detail::slide(step, stuck, trial, cap, direction, slip[0], spring)
             : detail::stick(step, stuck, trial, cap, direction, slip, spring);
}

/// Turns the spring of a contact that slid one step ago, and slides on, without a look for the
/// moment at which that may have changed; its length is kept.
void turn_slide(const FrictionStep& step, double (&spring)[3]);

}  // namespace rodpack

#endif

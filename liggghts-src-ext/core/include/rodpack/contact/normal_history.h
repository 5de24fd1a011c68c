// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_NORMAL_HISTORY_H
#define RODPACK_CONTACT_NORMAL_HISTORY_H

#include <algorithm>

#include "contact_motion.h"
#include "force_change.h"

namespace rodpack {

// Events of the normal force k delta - c v of a contact: touch, the moment where the force would
// become negative, and what the events of other contacts of its bodies did to its dashpot
// (force_change.h). `Contact`: see contact_motion.h. `Events` has
//   add(contact, now[3], rate[3], since, jumps)   the force on i has changed `since` seconds ago by
//     `now` (N), growing by `rate` (N/s) in a frame that turns with the contact; jumps: it did not
//     grow from 0, so that the acceleration of the bodies jumped
//   add(contact, ForceChange, jumps)
//   motion_changed(contact, MotionChange&)   false if it has not.

/// What a contact remembers of its normal force.
struct NormalHistory {
  double uncut;       // force of the last evaluation before the cut at 0, N
  double touch_rate;  // its rate that was guessed at touch, N/s
  double fresh;       // 1 after the first evaluation
  double step;        // last evaluation, plus 1; 0: never
};

namespace detail {

template <class Contact, class Events>
void change_along_normal(const Contact& contact, double force, double rate, double since,
                         bool jumps, Events& events) {
  double now[3], growing[3];
  for (int d = 0; d < 3; ++d) {
    now[d] = force * contact.en[d];
    growing[d] = rate * contact.en[d];
  }
  events.add(contact, now, growing, since, jumps);
}

/// The force before the cut has changed sign within the step; `before`: one step ago.
template <class Contact, class Events>
void cross_zero(const Contact& contact, double before, double uncut, double dt, Events& events) {
  const double sign = uncut > 0.0 ? 1.0 : -1.0;
  const double since = time_since_zero(before, uncut, dt);
  change_along_normal(contact, sign * uncut, sign * (uncut - before) / dt, since, false, events);
}

template <class Contact, class Events>
void touch(const Contact& contact, NormalHistory& history, double uncut, double dt,
           Events* events) {
  if (!touched_in_step(contact, dt)) return;
  // The closing speed is taken as constant since touch; that gives the impulse of the dashpot
  // exactly, and what it misses of the rate is made good in the next step.
  const double since = std::min(dt, -contact.deltan / contact.vn);
  history.touch_rate = -contact.kn * contact.vn;
  history.fresh = 1.0;
  if (events)
    change_along_normal(contact, uncut, history.touch_rate, since, contact.gamman > 0.0, *events);
}

template <class Contact, class Events>
void go_on(const Contact& contact, const NormalHistory& history, double uncut, bool was_fresh,
           double dt, Events& events) {
  MotionChange change;
  const bool moved = events.motion_changed(contact, change);
  // The dashpot of the last evaluation did not know of it.
  const double before =
      history.uncut - (moved ? contact.gamman * dot(change.velocity, contact.en) : 0.0);
  if ((uncut > 0.0) != (before > 0.0)) cross_zero(contact, before, uncut, dt, events);
  if (!moved || !(uncut > 0.0)) return;
  double parts[3][3];
  const double* const in_full[3] = {change.acceleration, change.velocity, change.displacement};
  double normal[3];
  for (int k = 0; k < 3; ++k) {
    normal[k] = dot(in_full[k], contact.en);
    for (int d = 0; d < 3; ++d) parts[k][d] = normal[k] * contact.en[d];
  }
  events.add(contact, dashpot_change(contact.gamman, parts[0], parts[1], parts[2], dt), false);
  if (!was_fresh) return;
  // Two evaluations after touch give the rate that was guessed at touch. What was missed has been
  // felt by other contacts of the bodies, hence `jumps`.
  const double applied = history.touch_rate - contact.gamman * normal[0];
  const double missed = (uncut - before) / dt - applied;
  change_along_normal(contact, missed * dt, missed, dt, true, events);
}

}  // namespace detail

/// Reports the events of a contact whose force is `uncut` (N) before the cut, and keeps what the
/// next evaluation needs. `alive`: it was evaluated one step ago. `events` may be null.
template <class Contact, class Events>
void follow_normal_force(const Contact& contact, NormalHistory& history, double uncut, bool alive,
                         double dt, Events* events) {
  const bool was_fresh = history.fresh != 0.0;
  history.fresh = 0.0;
  if (!alive)
    detail::touch(contact, history, uncut, dt, events);
  else if (events)
    detail::go_on(contact, history, uncut, was_fresh, dt, *events);
  history.uncut = uncut;
}

/// Reports the end of the force of a contact that has opened within the step; `contact` goes on
/// with negative overlap.
template <class Contact, class Events>
void end_normal_force(const Contact& contact, const NormalHistory& history, double dt,
                      Events& events) {
  const double uncut = contact.kn * contact.deltan - contact.gamman * contact.vn;
  // A force that was cut off before has had its event.
  if (history.uncut > 0.0 && uncut < 0.0)
    detail::cross_zero(contact, history.uncut, uncut, dt, events);
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_NORMAL_HISTORY_H
#define RODPACK_CONTACT_NORMAL_HISTORY_H

#include <algorithm>

#include "contact_history.h"
#include "contact_motion.h"
#include "event_correction.h"
#include "force_change.h"

namespace rodpack {

// Events of the normal force k delta - c v of a contact: touch, the moment where the viscoelastic
// force would become negative and is cut off at 0, and what the events of other contacts of its
// bodies did to its dashpot (force_change.h). `Contact`: see contact_motion.h. `Events` has
//   add(contact, ForceChange, jumps)   the force on i has changed; jumps: it did not grow from 0,
//     so that the acceleration of the bodies jumped
//   motion_changed(contact, ContactJump&)   false if it has not.

namespace detail {

template <class Contact, class Events>
void change_along_normal(const Contact& contact, double force, double rate, double since,
                         bool jumps, Events& events) {
  double now[3], growing[3];
  for (int d = 0; d < 3; ++d) {
    now[d] = force * contact.en[d];
    growing[d] = rate * contact.en[d];
  }
  events.add(contact, change_in_space(contact, now, growing, since), jumps);
}

/// The normal force has ended, or begins again, where the viscoelastic force was 0; `before`: one
/// step ago, with all that has jumped since.
template <class Contact, class Events>
void cross_zero(const Contact& contact, double before, double viscoelastic, double dt,
                Events& events) {
  const double sign = viscoelastic > 0.0 ? 1.0 : -1.0;
  const double since = time_since_zero(before, viscoelastic, dt);
  change_along_normal(contact, sign * viscoelastic, sign * (viscoelastic - before) / dt, since,
                      false, events);
}

template <class Contact, class Events>
void touch(const Contact& contact, NormalHistory& history, double viscoelastic, double dt,
           Events* events) {
  if (!touched_in_step(contact, dt)) return;
  // The closing speed is taken as constant since touch; that gives the impulse of the dashpot
  // exactly, and what it misses of the rate is made good in the next step.
  const double since = std::min(dt, -contact.deltan / contact.vn);
  history.touch_rate = -contact.kn * contact.vn;
  history.just_touched = true;
  if (events)
    change_along_normal(contact, viscoelastic, history.touch_rate, since, contact.gamman > 0.0,
                        *events);
}

template <class Contact, class Events>
void go_on(const Contact& contact, const NormalHistory& history, double viscoelastic,
           bool had_just_touched, double dt, Events& events) {
  ContactJump jump;
  const bool moved = events.motion_changed(contact, jump);
  const double before = moved ? viscoelastic_before(history.viscoelastic, contact.gamman,
                                                    dot(jump.velocity, contact.en))
                              : history.viscoelastic;
  // The records are of the branch of the last evaluation, which did not know of the jump.
  const bool acted = history.viscoelastic > 0.0, acts = viscoelastic > 0.0;
  if (acted != acts) cross_zero(contact, before, viscoelastic, dt, events);
  if (!moved || !acted) return;
  double parts[3][3];
  const double* const in_full[3] = {jump.acceleration, jump.velocity, jump.displacement};
  double normal[3];
  for (int k = 0; k < 3; ++k) {
    normal[k] = dot(in_full[k], contact.en);
    for (int d = 0; d < 3; ++d) parts[k][d] = normal[k] * contact.en[d];
  }
  events.add(contact, dashpot_change(contact.gamman, parts[0], parts[1], parts[2], dt), false);
  if (!had_just_touched || !acts) return;
  // Two evaluations after touch give the rate that was guessed at touch. What was missed has been
  // felt by other contacts of the bodies, hence `jumps`.
  const double applied = history.touch_rate - contact.gamman * normal[0];
  const double missed = (viscoelastic - before) / dt - applied;
  change_along_normal(contact, missed * dt, missed, dt, true, events);
}

}  // namespace detail

/// The velocity that the dashpot of a contact feels in this step, m/s. It keeps the share `kept` of
/// what it felt one step ago, 0 without a relaxation time. `alive`: the contact was evaluated then.
template <class Contact>
double follow_velocity(const Contact& contact, NormalHistory& history, bool alive, double kept) {
  const bool goes_on = alive && history.relaxes;
  history.relaxes = kept > 0.0;
  history.felt_velocity =
      goes_on ? relaxed_velocity(history.felt_velocity, contact.vn, kept) : contact.vn;
  return history.felt_velocity;
}

/// Reports the events of a contact under the force `viscoelastic` (N), before its cut-off at 0, and
/// keeps what the next evaluation needs. `alive`: it was evaluated one step ago. `events` may be
/// null.
template <class Contact, class Events>
void follow_normal_force(const Contact& contact, NormalHistory& history, double viscoelastic,
                         bool alive, double dt, Events* events) {
  const bool had_just_touched = history.just_touched;
  history.just_touched = false;
  if (!alive)
    detail::touch(contact, history, viscoelastic, dt, events);
  else if (events)
    detail::go_on(contact, history, viscoelastic, had_just_touched, dt, *events);
  history.viscoelastic = viscoelastic;
}

/// Reports the end of the force of a contact that has opened within the step; `contact` goes on
/// with negative overlap.
template <class Contact, class Events>
void end_normal_force(const Contact& contact, const NormalHistory& history, double dt,
                      Events& events) {
  detail::go_on(contact, history,
                viscoelastic_force(contact.kn, contact.deltan, contact.gamman, contact.vn), false,
                dt, events);
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_TANGENTIAL_HISTORY_H
#define RODPACK_CONTACT_TANGENTIAL_HISTORY_H

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "contact_history.h"
#include "contact_law.h"
#include "contact_motion.h"
#include "event_correction.h"
#include "force_change.h"
#include "friction_cap.h"
#include "friction_step.h"
#include "../motion/multistep.h"

namespace rodpack {

// The tangential spring and dashpot of a contact (contact_law.h) over its life: the spring is the
// integral of the tangential velocity, by the multistep formula of the integrator that runs.
// `Contact`: see contact_motion.h; `Events`: see normal_history.h; `Cap`: see friction_cap.h.

/// What a contact was at the last evaluation, turned into the present plane of contact.
struct TangentialPast {
  bool alive = false, sliding = false;
  bool just_touched = false;  // that evaluation was its first
  int known = 0;              // velocities in the history, that of now included, at most 3
  double since = 0.0;         // touch, in the step that it or the last evaluation made, s
  bool moved = false;  // whether events changed the motion of its bodies in the last step, to:
  ContactJump jump;
  double spring[3] = {0.0, 0.0, 0.0}, velocity[3] = {0.0, 0.0, 0.0};
};

/// The force on i, N, and the spring, m.
struct TangentialForce {
  double force[3], spring[3];
  bool sliding;
};

/// A multistep step of the contact history: order (0: velocity Verlet), number and length (s).
/// `kept`: of what dashpots felt one step ago (dashpot_relaxation.h), 0 but for order 0.
struct TangentialStep {
  int order;
  std::int64_t now;
  double dt;
  double kept = 0.0;
};

namespace detail {

/// Takes from a vector what it has along the unit vector `en`.
inline void in_plane(const double* en, double (&vector)[3]) {
  const double normal = dot(vector, en);
  for (int d = 0; d < 3; ++d) vector[d] -= normal * en[d];
}

/// Turns vectors of the plane of contact as it was `since` seconds ago into the present one, about
/// the line in which these meet: what a vector has along the present normal lies along the normal
/// midway between the two. The turn is known to O(since^2), the length of the vector exactly.
class TurnWithContact {
 public:
  template <class Contact>
  TurnWithContact(const Contact& contact, double since) : normal_(contact.en) {
    normal_turning_rate(contact, midway_);
    for (int d = 0; d < 3; ++d) midway_[d] = normal_[d] - 0.5 * since * midway_[d];
  }
  void operator()(double* vector) const {
    const double before = dot(vector, vector);
    if (before == 0.0) return;
    const double along = dot(vector, normal_);
    for (int d = 0; d < 3; ++d) vector[d] -= along * midway_[d];
    const double after = dot(vector, vector);
    if (after == 0.0) return;
    const double scale = std::sqrt(before / after);
    for (int d = 0; d < 3; ++d) vector[d] *= scale;
  }

 private:
  const double* normal_;
  double midway_[3];
};

/// A contact remembers components along the axes of its plane, which turn by themselves.
struct NoTurn {
  void operator()(double*) const {}
};

/// The life of a contact begins within a step, when the gap closes: sets the integral of the
/// tangential velocity from then on, with the velocities taken as constant. Returns the time since.
template <class Contact>
double start_spring(const Contact& contact, double dt, double* spring) {
  const double now[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  if (contact.is_wall) {
    const double since_touch = contact.vn < 0.0 ? std::min(dt, -contact.deltan / contact.vn) : 0.0;
    for (int d = 0; d < 3; ++d) spring[d] = since_touch * now[d];
    return since_touch;
  }
  double velocity[3];
  for (int d = 0; d < 3; ++d) velocity[d] = contact.v_i[d] - contact.v_j[d];
  // The gap was closed the time t ago at which |delta - t velocity| = r_i + r_j.
  const double approach = dot(contact.delta, velocity);
  const double closed = contact.radsum * contact.radsum - contact.rsq;
  const double root = std::sqrt(approach * approach + dot(velocity, velocity) * closed);
  const double since_touch = root > approach ? std::min(dt, closed / (root - approach)) : 0.0;

  double normal[3], spin[3], at_touch[3];
  for (int d = 0; d < 3; ++d) {
    normal[d] = contact.delta[d] - since_touch * velocity[d];
    spin[d] = contact.radi * contact.omega_i[d] + contact.radj * contact.omega_j[d];
  }
  const double scale = 1.0 / std::sqrt(dot(normal, normal));
  for (int d = 0; d < 3; ++d) normal[d] *= scale;
  tangential_velocity(velocity, spin, normal, at_touch);
  TurnWithContact(contact, since_touch)(at_touch);
  for (int d = 0; d < 3; ++d) spring[d] = 0.5 * since_touch * (at_touch[d] + now[d]);
  return since_touch;
}

/// Puts into the spring and the velocities of the past what an event in the last step, which they
/// could not know of, did to the bodies; `slid`: the contact, at the last evaluation.
inline void follow_bodies(const double* en, double dt, bool slid, ContactJump& jump,
                          TangentialHistory& history) {
  in_plane(en, jump.acceleration);
  in_plane(en, jump.velocity);
  in_plane(en, jump.displacement);
  for (int d = 0; d < 3; ++d) {
    const JumpAlong<double> along = {jump.acceleration[d], jump.velocity[d], jump.displacement[d]};
    history.spring[d] = spring_after(along, slid, history.spring[d]);
    for (int k = 0; k < std::min(history.known, history.slots); ++k)
      history.velocity[k][d] = velocity_after(along, k * dt, history.velocity[k][d]);
  }
}

}  // namespace detail

/// Turns what a contact remembers from the last step into its present plane; contacts that remember
/// it otherwise have a function of this name that says so.
template <class Contact>
detail::TurnWithContact turn_of_history(const Contact& contact, double dt) {
  return detail::TurnWithContact(contact, dt);
}

/// Brings the spring from the last step to this one and stores this step's velocity. `events`: of
/// the integrator, null if it follows none.
template <class Contact, class Events>
TangentialPast advance_spring(const Contact& contact, TangentialHistory& history,
                              const TangentialStep& step, const Events* events) {
  const double dt = step.dt;
  const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};

  // A contact that was not updated in the last step is a new one, whatever is in its history.
  TangentialPast past;
  past.alive = history.known != 0 && history.step == step.now - 1;
  history.step = step.now;
  if (!past.alive) {
    past.since = history.since = detail::start_spring(contact, dt, history.spring);
    if (!touched_in_step(contact, dt)) past.since = history.since = 0.0;
    for (int k = 1; k < history.slots; ++k) std::fill_n(history.velocity[k], 3, 0.0);
    std::copy(velocity, velocity + 3, history.velocity[0]);
    history.known = past.known = 1;
    history.sliding = false;
    return past;
  }

  past.just_touched = history.known == 1;
  past.since = history.since;
  past.known = std::min({history.known + 1, history.slots, 3});
  past.sliding = history.sliding;
  history.sliding = false;
  const auto turn = turn_of_history(contact, dt);
  turn(history.spring);
  if (step.order == 0) {
    past.known = 1;
    std::copy(history.spring, history.spring + 3, past.spring);
    // Velocity Verlet shows the velocity at half the step, where the midpoint rule wants it.
    for (int d = 0; d < 3; ++d) history.spring[d] += dt * velocity[d];
    turn(history.velocity[0]);
    for (int d = 0; d < 3; ++d)
      history.velocity[0][d] = relaxed_velocity(history.velocity[0][d], velocity[d], step.kept);
    history.known = 1;
    return past;
  }
  const MultistepWeights& weights = multistep_weights(step.order, history.known);
  for (int k = 0; k < history.slots; ++k) turn(history.velocity[k]);
  if (events) {
    past.moved = events->motion_changed(contact, past.jump);
    if (past.moved) detail::follow_bodies(contact.en, dt, past.sliding, past.jump, history);
  }
  std::copy(history.spring, history.spring + 3, past.spring);
  std::copy(history.velocity[0], history.velocity[0] + 3, past.velocity);
  for (int d = 0; d < 3; ++d)
    history.spring[d] +=
        multistep_increment(weights, step.order, dt, [&](int k) { return history.velocity[k][d]; });
  for (int k = history.slots - 1; k > 0; --k)
    std::copy(history.velocity[k - 1], history.velocity[k - 1] + 3, history.velocity[k]);
  std::copy(velocity, velocity + 3, history.velocity[0]);
  history.known = std::min(history.known, history.slots) + 1;
  return past;
}

/// The friction of a contact whose normal force has been 0 begins anew, `since` seconds ago.
template <class Contact>
void begin_anew(const Contact& contact, double since, TangentialPast& past,
                TangentialHistory& history) {
  const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  for (int d = 0; d < 3; ++d) history.spring[d] = since * velocity[d];
  past.alive = past.sliding = false;
  past.since = since;
}

/// Whether a contact that lives on is not simply stuck, before and now.
template <class Contact>
bool may_change_branch(const Contact& contact, const TangentialPast& past,
                       const double (&spring)[3], const double (&velocity)[3], double cap) {
  if (past.sliding) return true;
  double squared = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double component = trial_force(contact.kt, spring[d], contact.gammat, velocity[d]);
    squared += component * component;
  }
  return squared > cap * cap;
}

/// What the friction of a contact in this step depends on.
template <class Contact, class Cap>
FrictionStep friction_step(const Contact& contact, const TangentialPast& past,
                           const TangentialHistory& history, const Cap& cap, double dt) {
  FrictionStep step = {};
  step.stiffness = contact.kt;
  step.damping = contact.gammat;
  step.cap = cap.now(contact);
  step.cap_rate = cap.rate(contact, dt);
  const double carried = contact.kt * std::sqrt(dot(past.spring, past.spring));
  step.cap_curvature = cap.curvature(contact, past.sliding, carried, dt);
  step.dt = dt;
  step.known = past.known;
  step.slid = past.sliding;
  step.since_touch = past.just_touched ? past.since : 0.0;
  std::copy(contact.en, contact.en + 3, step.normal);
  std::copy(past.spring, past.spring + 3, step.spring_before);
  for (int k = 0; k < past.known; ++k)
    std::copy(history.velocity[k], history.velocity[k] + 3, step.velocity[k]);
  return step;
}

/// What a slide has missed of a jump of its bodies in the last step, which turns the force through
/// the dashpot (slide_turning.h).
template <class Contact, class Events>
void report_turned_slide(const Contact& contact, const double (&spring)[3], const ContactJump& jump,
                         double dt, Events& events) {
  const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  double load[3], direction[3];
  detail::slide_load(contact.kt, contact.gammat, spring, velocity, contact.en, load);
  if (std::equal(load, load + 3, spring)) return;
  const double carried = detail::direction_of(load, direction);
  const double cap = contact.kt * std::sqrt(dot(spring, spring));
  ContactJump across = jump;
  detail::in_plane(direction, across.acceleration);
  detail::in_plane(direction, across.velocity);
  detail::in_plane(direction, across.displacement);
  events.add(contact,
             dashpot_change(contact.gammat * cap / carried, across.acceleration, across.velocity,
                            across.displacement, dt),
             false);
}

/// Reports the events of a contact under the tangential force `force` (N), but for what the normal
/// force does to a slide.
template <class Contact, class Events>
void report_friction(const Contact& contact, const TangentialPast& past, const FrictionForce& law,
                     const TangentialForce& result, double dt, Events& events) {
  const double(&force)[3] = result.force;
  const bool sliding = result.sliding;
  const double kt = contact.kt, gamma = contact.gammat;
  if (past.alive && !law.changed && sliding && past.moved && gamma > 0.0)
    report_turned_slide(contact, result.spring, past.jump, dt, events);
  if (past.alive && !law.changed && (sliding || past.sliding || !past.moved)) return;
  if (!past.alive) {
    double rate[3];
    if (!(past.since > 0.0)) return;
    const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    for (int d = 0; d < 3; ++d)
      rate[d] = sliding ? force[d] / past.since : spring_force(kt, velocity[d]);
    events.add(contact, change_in_space(contact, force, rate, past.since), !sliding && gamma > 0.0);
    return;
  }
  if (law.changed && law.since > 0.0)
    events.add(contact, change_in_space(contact, law.gain, law.gain_rate, law.since), law.jumps);
  // Up to a change of branch the dashpot of a stuck contact would have felt the jump.
  const ContactJump& jump = past.jump;
  if (past.moved && !past.sliding)
    events.add(contact,
               dashpot_change(gamma, jump.acceleration, jump.velocity, jump.displacement, dt),
               false);
  if (law.changed) return;
  if (!past.just_touched) return;
  // Two evaluations after touch give the rate that was guessed at touch, as constant since then.
  ForceChange missed;
  const double since = past.since;
  for (int d = 0; d < 3; ++d) {
    const double at_touch = trial_force(kt, past.spring[d], gamma, past.velocity[d]);
    // The rate of spring and dashpot is their force with velocity and acceleration in the place of
    // spring and velocity.
    const double applied =
        trial_force(kt, past.velocity[d] - jump.velocity[d], gamma, jump.acceleration[d]);
    missed.rate[d] = (force[d] - at_touch) / dt - applied;
    missed.now[d] = missed.rate[d] * dt;
    missed.impulse[d] = 0.5 * missed.rate[d] * (dt * dt - since * since);
    missed.impulse_integral[d] =
        missed.rate[d] * (dt * dt * dt / 6.0 - since * since * (0.5 * dt + since / 3.0));
  }
  events.add(contact, missed, true);
}

/// Reports what the changes of the normal force in this step do to a slide: one of the last
/// evaluation, or one that begins with the contact.
template <class Contact, class Cap, class Events>
void report_normal_changes(const Contact& contact, const TangentialPast& past,
                           const TangentialForce& result, const Cap& cap, Events& events) {
  const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  double load[3];
  if (past.alive)
    detail::slide_load(contact.kt, contact.gammat, past.spring, past.velocity, contact.en, load);
  else
    detail::slide_load(contact.kt, contact.gammat, result.spring, velocity, contact.en, load);
  cap.report_slide(contact, load, events);
}

/// The tangential force on i (N, result.force), with its history brought to this step where
/// `renewed`; else it is evaluated once more at the same time, without a trace. `followed`: events
/// of the integrator, null if it follows none; `reports`: where events go, null if nowhere.
template <class Contact, class Cap, class Events>
TangentialForce tangential_contact_force(const Contact& contact, TangentialHistory& history,
                                         Cap cap, bool renewed, const TangentialStep& step,
                                         const Events* followed, Events* reports) {
  TangentialPast past;
  TangentialForce result;
  bool& sliding = result.sliding;
  sliding = history.sliding && contact.kt > 0.0;
  if (renewed) {
    past = advance_spring(contact, history, step, followed);
    cap.renew(contact, past.alive, step.dt, followed);
    if (followed && past.alive && !cap.acted_before())
      begin_anew(contact, cap.since_return(step.dt), past, history);
    if (followed && !past.alive) past.sliding = cap.slides_from_touch(contact);
  }

  // What the dashpot feels.
  double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  if (step.kept > 0.0) std::copy(history.velocity[0], history.velocity[0] + 3, velocity);
  double(&force)[3] = result.force, (&spring)[3] = result.spring;
  std::copy(history.spring, history.spring + 3, spring);
  const double limit = cap.now(contact);
  FrictionForce law;
  law.changed = false;
  if (renewed && followed && (past.alive || past.sliding) && contact.gammat > 0.0 &&
      may_change_branch(contact, past, spring, velocity, limit)) {
    law = friction_force(friction_step(contact, past, history, cap, step.dt), spring);
    std::copy(law.force, law.force + 3, force);
    sliding = law.slides;
  } else if (renewed || !sliding) {
    sliding =
        tangential_force(contact.kt, contact.gammat, std::max(limit, 0.0), spring, velocity, force);
    if (sliding && renewed && past.sliding && contact.kt > 0.0)
      turn_slide(friction_step(contact, past, history, cap, step.dt), spring);
  }
  // The spring of a sliding contact carries the cap: taken from it, the force is the same when it
  // is evaluated again in the same step.
  if (sliding && contact.kt > 0.0)
    slide_force(contact.kt, contact.gammat, spring, history.velocity[0], contact.en, force);
  if (renewed) {
    std::copy(spring, spring + 3, history.spring);
    history.sliding = sliding;
    history.friction = cap.friction;
    history.stiffness = contact.kt;
    history.damping = contact.gammat;
    if (reports) {
      if (past.alive ? past.sliding : sliding)
        report_normal_changes(contact, past, result, cap, *reports);
      if (!Cap::damped || past.alive || !sliding)
        report_friction(contact, past, law, result, step.dt, *reports);
    }
  }
  return result;
}

/// Reports that a contact that was evaluated one step ago has opened within the step: `contact`
/// goes on with negative overlap. The history is used up.
template <class Contact, class Cap, class Events>
void end_tangential_force(const Contact& contact, TangentialHistory& history, const Cap& cap,
                          const TangentialStep& step, Events& events) {
  const double dt = step.dt, kt = history.stiffness, gamma = history.damping;
  if (!(contact.vn > 0.0)) return;
  const double since = std::min(dt, -contact.deltan / contact.vn);
  if (history.sliding) {
    double load[3], direction[3];
    const auto turn = turn_of_history(contact, dt);
    turn(history.spring);
    turn(history.velocity[0]);
    detail::slide_load(kt, gamma, history.spring, history.velocity[0], contact.en, load);
    if (slide_direction(load, direction)) cap.report_end(contact, direction, since, dt, events);
    return;
  }
  double now[3], rate[3];
  const TangentialPast past = advance_spring(contact, history, step, &events);
  const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
  for (int d = 0; d < 3; ++d) {
    now[d] = -trial_force(kt, history.spring[d], gamma, velocity[d]);
    const double before = trial_force(kt, past.spring[d], gamma, past.velocity[d]);
    rate[d] = (now[d] + before) / dt;
  }
  events.add(contact, change_in_space(contact, now, rate, since), true);
  if (past.moved)
    events.add(contact,
               dashpot_change(gamma, past.jump.acceleration, past.jump.velocity,
                              past.jump.displacement, dt),
               false);
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_FRICTION_CAP_H
#define RODPACK_CONTACT_FRICTION_CAP_H

#include <algorithm>
#include <cmath>

#include "contact_history.h"
#include "contact_law.h"
#include "event_correction.h"
#include "force_change.h"
#include "normal_history.h"

namespace rodpack {

// Coulomb's cap on the friction of a contact, of two kinds: mu times the force of the normal spring
// (Lu et al.), or mu times the whole normal force, with its dashpot, as most other programs have
// it. What tangential_history.h asks of either:
//   damped: whether the dashpot of the normal force is in it;
//   friction: the constant that is kept for the contact's end;
//   renew(...): a new step begins; then now(contact) and rate(contact, dt), N and N/s, and
//   curvature(contact, slid, carried, dt), N/s^2, 0 where it is not known: whether the contact slid
//     one step ago, and the force that its spring carried then, N;
//   slides_from_touch(contact): whether a contact that has just touched slid at once, in the limit
//     of small steps, although it may fit under the cap by now;
//   acted_before(): whether there was a normal force one step ago; if not, since_return(dt) is the
//     time since there is one again;
//   report_slide(...): what the changes of the normal force in this step do to sliding friction;
//   report_end(...): that sliding friction has ended with the contact.
// `Contact`: see contact_motion.h; `Events`: see normal_history.h.

/// The direction of the force of a slide, against its load (slide_turning.h); false without one.
inline bool slide_direction(const double (&load)[3], double (&direction)[3]) {
  const double length = std::sqrt(dot(load, load));
  if (!(length > 0.0)) return false;
  for (int d = 0; d < 3; ++d) direction[d] = -load[d] / length;
  return true;
}

/// mu times the force of the normal spring. It depends on the overlap alone, so that it is smooth
/// from touch to end, and has nothing to say when the normal force changes.
struct ElasticCap {
  static constexpr bool damped = false;
  double friction;  // mu k_n, N/m

  template <class Contact, class Events>
  void renew(const Contact&, bool, double, const Events*) {}
  template <class Contact>
  double now(const Contact& contact) const {
    return coulomb_cap(friction, contact.deltan);
  }
  template <class Contact>
  double rate(const Contact& contact, double) const {
    return coulomb_cap(friction, -contact.vn);
  }
  /// That of the parabola that meets the cap and its rate now, and one step ago what the spring of
  /// a slide carried: the cap.
  template <class Contact>
  double curvature(const Contact& contact, bool slid, double carried, double dt) const {
    return slid ? 2.0 * (carried - now(contact) + dt * rate(contact, dt)) / (dt * dt) : 0.0;
  }
  /// The cap is 0 at touch, so that there is nothing to weigh: the forces of now decide.
  template <class Contact>
  bool slides_from_touch(const Contact&) const {
    return false;
  }
  bool acted_before() const { return true; }
  double since_return(double) const { return 0.0; }
  template <class Contact, class Events>
  void report_slide(const Contact&, const double (&)[3], Events&) const {}

  /// The force, along `direction`, has fallen to zero with the cap, which would go on below it;
  /// the contact has opened `since` seconds ago.
  template <class Contact, class Events>
  void report_end(const Contact& contact, const double (&direction)[3], double since, double,
                  Events& events) const {
    double now[3], rate[3];
    for (int d = 0; d < 3; ++d) {
      now[d] = -coulomb_cap(friction, contact.deltan) * direction[d];
      rate[d] = -coulomb_cap(friction, -contact.vn) * direction[d];
    }
    events.add(contact, change_in_space(contact, now, rate, since), false);
  }
};

/// What the normal force of a contact reports in a step (the `Events` of follow_normal_force),
/// summed up along the normal.
struct NormalChanges {
  bool moved = false;  // whether events changed the motion of the bodies in the last step, to:
  ContactJump jump = {};
  ChangeOf<1> sum = {};
  bool any = false, jumps = false;

  template <class Contact>
  void add(const Contact& contact, const ForceChange& on_i, bool jump_of_force) {
    sum += component(on_i, contact.en);
    any = true;
    jumps = jumps || jump_of_force;
  }
  template <class Contact>
  bool motion_changed(const Contact&, ContactJump& result) const {
    result = jump;
    return moved;
  }
};

/// mu times the whole normal force. A slide under it is mu F_n against the slip, so that each event
/// of the normal force (touch, which jumps by the dashpot; its end, before that of the overlap; a
/// change of what the dashpot feels) is one of the friction too, mu times as large.
class TotalCap {
 public:
  static constexpr bool damped = true;
  double friction;  // mu

  /// `viscoelastic`: the normal force before its cut-off at 0, N.
  TotalCap(double mu, double viscoelastic, CapHistory& history)
      : friction(mu), viscoelastic_(viscoelastic), history_(&history) {}

  /// `alive`: the contact was evaluated one step ago; `followed`: events of the integrator, null if
  /// it follows none.
  template <class Contact, class Events>
  void renew(const Contact& contact, bool alive, double dt, const Events* followed) {
    changes_ = NormalChanges();
    before_ = alive ? history_->normal.viscoelastic : 0.0;
    earlier_ = history_->earlier;
    if (alive && followed && followed->motion_changed(contact, changes_.jump)) {
      changes_.moved = true;
      const JumpAlong<double> jump = component(changes_.jump, contact.en);
      before_ = viscoelastic_before(before_, contact.gamman, jump.velocity);
      earlier_ =
          viscoelastic_before(earlier_, contact.gamman, jump.velocity - dt * jump.acceleration);
    }
    three_ =
        alive && history_->has_earlier && viscoelastic_ > 0.0 && before_ > 0.0 && earlier_ > 0.0;
    history_->earlier = before_;
    history_->has_earlier = alive;
    follow_normal_force(contact, history_->normal, viscoelastic_, alive, dt,
                        followed ? &changes_ : nullptr);
    history_->stiffness = contact.kn;
    history_->damping = contact.gamman;
  }

  template <class Contact>
  double now(const Contact&) const {
    return coulomb_cap(friction, std::max(0.0, viscoelastic_));
  }
  /// That of the parabola through its last three values, where there are three; else their
  /// difference.
  template <class Contact>
  double rate(const Contact& contact, double dt) const {
    return (now(contact) - coulomb_cap(friction, std::max(0.0, before_))) / dt +
           0.5 * dt * curvature(contact, false, 0.0, dt);
  }
  template <class Contact>
  double curvature(const Contact&, bool, double, double dt) const {
    return three_ ? coulomb_cap(friction, viscoelastic_ - 2.0 * before_ + earlier_) / (dt * dt)
                  : 0.0;
  }
  /// At touch there are the forces of both dashpots alone.
  template <class Contact>
  bool slides_from_touch(const Contact& contact) const {
    const double velocity[3] = {contact.vtr1, contact.vtr2, contact.vtr3};
    return history_->normal.just_touched && contact.gammat * std::sqrt(dot(velocity, velocity)) >
                                                coulomb_cap(friction, -contact.gamman * contact.vn);
  }
  bool acted_before() const { return before_ > 0.0; }
  double since_return(double dt) const {
    return viscoelastic_ > 0.0 ? time_since_zero(before_, viscoelastic_, dt) : 0.0;
  }

  /// `load`: of the slide.
  template <class Contact, class Events>
  void report_slide(const Contact& contact, const double (&load)[3], Events& events) const {
    double direction[3];
    if (slide_direction(load, direction)) report_along(contact, direction, changes_, events);
  }

  /// `contact`: with the constants that are in the history; the normal force may have ended before.
  template <class Contact, class Events>
  void report_end(const Contact& contact, const double (&direction)[3], double, double dt,
                  Events& events) const {
    NormalChanges changes;
    end_normal_force(contact, history_->normal, dt, changes);
    report_along(contact, direction, changes, events);
  }

 private:
  template <class Contact, class Events>
  void report_along(const Contact& contact, const double (&direction)[3],
                    const NormalChanges& changes, Events& events) const {
    if (!changes.any) return;
    ChangeOf<1> change = changes.sum;
    change *= friction;
    events.add(contact, change_along(contact, change, direction), changes.jumps);
  }

  double viscoelastic_, before_ = 0.0, earlier_ = 0.0;  // now, one and two steps ago, N
  bool three_ = false;  // whether all of them are known, and above 0
  NormalChanges changes_;
  CapHistory* history_;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_EVENTS_H
#define RODPACK_PLANAR_EVENTS_H

#include "../planar_simd/aligned_vector.h"
#include "../planar_simd/arguments.h"
#include "rodpack/contact/event_correction.h"
#include "body_flags.h"
#include "contact.h"
#include "parts.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

/// Events of the contacts of planar bodies: sums the changes of forces over the bodies, and tells
/// contacts what jumps did to their bodies in the step before. An `Events` of normal_history.h.
class PlanarEvents {
 public:
  explicit PlanarEvents(const PlanarParts& parts) : changed_(parts), jumped_(parts) {}

  void resize(int bodies) {
    changed_.resize(bodies);
    sums_.resize(bodies, PlanarChangeSums());
    jumped_.resize(bodies);
    jumps_.resize(bodies);
  }

  void add(const PlanarContact& contact, const ForceChange& on_i, bool jumps) {
    add(contact, in_plane(on_i), jumps);
  }
  void add(const PlanarContact& contact, const PlanarForceChange& on_i, bool jumps) {
    share_change(
        contact, on_i,
        [&](int side, const PlanarForceChange& force, double(&lever)[2], double(&rate)[2]) {
          if (side > 0)
            add_to(contact.body_i, contact.arm_i, contact.v_i, contact.body_v_i, force, lever, rate,
                   jumps);
          else
            add_to(contact.body_j, contact.arm_j, contact.v_j, contact.body_v_j, force, lever, rate,
                   jumps);
        });
  }

  bool motion_changed(const PlanarContact& contact, ContactJump& jump) const {
    const bool of_i = jumped(contact.body_i), of_j = !contact.is_wall && jumped(contact.body_j);
    if (!of_i && !of_j) return false;
    jump = ContactJump();
    if (of_i) add_jump(contact, 1.0, jumps_[contact.body_i], contact.offset_i, jump);
    if (of_j) add_jump(contact, -1.0, jumps_[contact.body_j], contact.offset_j, jump);
    return true;
  }

  /// Sets what the SIMD loop needs to do the same for contacts that last.
  void set_arguments(PlanarForceArguments& forces) {
    forces.jumped = jumped_count_ > 0 ? jumped_.data() : nullptr;
    forces.jumps = jumps_.data();
    forces.changed = changed_.data();
    forces.changes = sums_.data();
  }

  /// Whether the body jumped in the last step, and how.
  bool jumped(int body) const { return jumped_[body] != 0; }
  const PlanarJump& jump(int body) const { return jumps_[body]; }
  void set_jumped(int body, const PlanarJump& jump) {
    if (!jumped(body)) ++jumped_count_;
    jumped_.set(body, 1);
    jumps_[body] = jump;
  }
  /// Forgets the jumps of the bodies of a part, before those of a new step are set.
  void forget_jumps(int part) {
    jumped_.clear(part, [&](int) { --jumped_count_; });
  }

  /// Calls visit(body, jumps) for the bodies of a part some of whose contacts changed their forces
  /// in this step; `jumps`: not all of them grew from 0.
  template <class Visit>
  void each_changed(int part, Visit visit) const {
    changed_.each(part, [&](int body) { visit(body, (changed_[body] & planar_jumps) != 0); });
  }
  /// The changes of the forces of the contacts of a body, summed up.
  const PlanarChangeSums& changes(int body) const { return sums_[body]; }
  void forget_changes(int part) {
    changed_.clear(part, [&](int body) {
      PlanarChangeSums& of = sums_[body];
      // One by one: for the whole the compiler takes a string instruction, which is slow to start.
      for (PlanarVector* sum : {&of.now, &of.rate, &of.impulse, &of.impulse_integral})
        *sum = PlanarVector();
    });
  }

 private:
  /// `lever` leads from the centre of the sphere, `arm` there from that of the body.
  void add_to(int body, const double (&arm)[3], const double (&v)[3], const double (&body_v)[3],
              const PlanarForceChange& force, double (&lever)[2], double (&rate)[2], bool jumps) {
    for (int d = 0; d < 2; ++d) {
      lever[d] += arm[d];
      rate[d] += v[d] - body_v[d];
    }
    const PlanarTorqueChange torque = torque_change(lever, rate, force);
    PlanarChangeSums& sums = sums_[body];
    add_moment(force.now, torque.now, sums.now);
    add_moment(force.rate, torque.rate, sums.rate);
    add_moment(force.impulse, torque.impulse, sums.impulse);
    add_moment(force.impulse_integral, torque.impulse_integral, sums.impulse_integral);
    changed_.set(body, jumps ? planar_changed | planar_jumps : planar_changed);
  }
  static void add_moment(const double (&force)[2], const double (&torque)[1], PlanarVector& sum) {
    sum.d[0] += force[0];
    sum.d[1] += force[1];
    sum.d[2] += torque[0];
  }

  PlanarBodyFlags changed_, jumped_;
  int jumped_count_ = 0;
  AlignedVector<PlanarChangeSums> sums_;
  AlignedVector<PlanarJump> jumps_;
};

}  // namespace rodpack

#endif

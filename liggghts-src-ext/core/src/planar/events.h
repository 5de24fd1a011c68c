// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_EVENTS_H
#define RODPACK_PLANAR_EVENTS_H

#include <vector>

#include "rodpack/contact/event_correction.h"
#include "contact.h"
#include "parts.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

/// Events of the contacts of planar bodies: sums the changes of forces over the bodies, and tells
/// contacts what jumps did to their bodies in the step before. An `Events` of normal_history.h.
class PlanarEvents {
 public:
  struct Changes {
    int body;
    BodyChange sum;
    bool jumps;
  };

  explicit PlanarEvents(const PlanarParts& parts)
      : parts_(parts), changes_(parts.count()), jumped_bodies_(parts.count()) {}

  void resize(int bodies) {
    place_.resize(bodies, -1);
    jumped_.resize(bodies, 0);
    motions_.resize(bodies);
  }

  void add(const PlanarContact& contact, const ForceChange& on_i, bool jumps) {
    share_change(contact, on_i,
                 [&](int side, const ForceChange& force, double(&lever)[3], double(&rate)[3]) {
                   if (side > 0)
                     add_to(contact.body_i, contact.arm_i, contact.v_i, contact.body_v_i, force,
                            lever, rate, jumps);
                   else
                     add_to(contact.body_j, contact.arm_j, contact.v_j, contact.body_v_j, force,
                            lever, rate, jumps);
                 });
  }

  bool motion_changed(const PlanarContact& contact, ContactJump& jump) const {
    const bool of_i = jumped_[contact.body_i] != 0;
    const bool of_j = !contact.is_wall && jumped_[contact.body_j] != 0;
    if (!of_i && !of_j) return false;
    jump = ContactJump();
    if (of_i) add_jump(contact, 1.0, motions_[contact.body_i], contact.offset_i, jump);
    if (of_j) add_jump(contact, -1.0, motions_[contact.body_j], contact.offset_j, jump);
    return true;
  }

  /// Whether each body jumped in the last step; null if none of them did.
  const char* jumped() const { return jumps_ == 0 ? nullptr : jumped_.data(); }
  bool jumped(int body) const { return jumped_[body] != 0; }
  const PlanarJump& motion(int body) const { return motions_[body]; }
  void set_jumped(int body, const PlanarJump& motion) {
    if (!jumped_[body]) {
      jumped_bodies_[parts_.of(body)].push_back(body);
      ++jumps_;
    }
    jumped_[body] = 1;
    motions_[body] = motion;
  }
  /// Forgets the jumps of the bodies of a part, before those of a new step are set.
  void forget_jumps(int part) {
    std::vector<int>& bodies = jumped_bodies_[part];
    for (int body : bodies) jumped_[body] = 0;
    jumps_ -= static_cast<int>(bodies.size());
    bodies.clear();
  }

  /// The sums of the changes of forces over the bodies of a part that had some in this step.
  const std::vector<Changes>& changes(int part) const { return changes_[part]; }
  void forget_changes(int part) {
    for (const Changes& change : changes_[part]) place_[change.body] = -1;
    changes_[part].clear();
  }

 private:
  /// `lever` leads from the centre of the sphere, `arm` there from that of the body.
  void add_to(int body, const double (&arm)[3], const double (&v)[3], const double (&body_v)[3],
              const ForceChange& force, double (&lever)[3], double (&rate)[3], bool jumps) {
    for (int d = 0; d < 3; ++d) {
      lever[d] += arm[d];
      rate[d] += v[d] - body_v[d];
    }
    std::vector<Changes>& of_part = changes_[parts_.of(body)];
    if (place_[body] < 0) {
      place_[body] = static_cast<int>(of_part.size());
      of_part.push_back(Changes{body, BodyChange(), false});
    }
    Changes& change = of_part[place_[body]];
    change.sum.force += force;
    change.sum.torque += planar_torque_change(lever, rate, force);
    change.jumps = change.jumps || jumps;
  }

  PlanarParts parts_;
  std::vector<int> place_;  // of a body in the changes of its part, -1: not there
  std::vector<std::vector<Changes>> changes_;
  std::vector<char> jumped_;
  std::vector<std::vector<int>> jumped_bodies_;
  int jumps_ = 0;
  std::vector<PlanarJump> motions_;
};

}  // namespace rodpack

#endif

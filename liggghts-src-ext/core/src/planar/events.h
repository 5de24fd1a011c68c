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
  /// A body some of whose contacts changed their forces in a step.
  struct ChangedBody {
    int body;
    PlanarBodyChange sum;
    bool jumps;
  };

  explicit PlanarEvents(const PlanarParts& parts)
      : parts_(parts), changes_(parts.count()), jumped_bodies_(parts.count()) {}

  void resize(int bodies) {
    index_.resize(bodies, -1);
    jumped_.resize(bodies, 0);
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
    const bool of_i = jumped_[contact.body_i] != 0;
    const bool of_j = !contact.is_wall && jumped_[contact.body_j] != 0;
    if (!of_i && !of_j) return false;
    jump = ContactJump();
    if (of_i) add_jump(contact, 1.0, jumps_[contact.body_i], contact.offset_i, jump);
    if (of_j) add_jump(contact, -1.0, jumps_[contact.body_j], contact.offset_j, jump);
    return true;
  }

  /// Whether each body jumped in the last step; null if none of them did.
  const char* jumped() const { return jumped_count_ == 0 ? nullptr : jumped_.data(); }
  bool jumped(int body) const { return jumped_[body] != 0; }
  const PlanarJump& jump(int body) const { return jumps_[body]; }
  void set_jumped(int body, const PlanarJump& jump) {
    if (!jumped_[body]) {
      jumped_bodies_[parts_.of(body)].push_back(body);
      ++jumped_count_;
    }
    jumped_[body] = 1;
    jumps_[body] = jump;
  }
  /// Forgets the jumps of the bodies of a part, before those of a new step are set.
  void forget_jumps(int part) {
    std::vector<int>& bodies = jumped_bodies_[part];
    for (int body : bodies) jumped_[body] = 0;
    jumped_count_ -= static_cast<int>(bodies.size());
    bodies.clear();
  }

  /// The sums of the changes of forces over the bodies of a part that had some in this step.
  const std::vector<ChangedBody>& changes(int part) const { return changes_[part]; }
  void forget_changes(int part) {
    for (const ChangedBody& change : changes_[part]) index_[change.body] = -1;
    changes_[part].clear();
  }

 private:
  /// `lever` leads from the centre of the sphere, `arm` there from that of the body.
  void add_to(int body, const double (&arm)[3], const double (&v)[3], const double (&body_v)[3],
              const PlanarForceChange& force, double (&lever)[2], double (&rate)[2], bool jumps) {
    for (int d = 0; d < 2; ++d) {
      lever[d] += arm[d];
      rate[d] += v[d] - body_v[d];
    }
    std::vector<ChangedBody>& of_part = changes_[parts_.of(body)];
    if (index_[body] < 0) {
      index_[body] = static_cast<int>(of_part.size());
      of_part.push_back(ChangedBody{body, PlanarBodyChange(), false});
    }
    ChangedBody& change = of_part[index_[body]];
    change.sum.force += force;
    change.sum.torque += torque_change(lever, rate, force);
    change.jumps = change.jumps || jumps;
  }

  PlanarParts parts_;
  std::vector<int> index_;  // of a body in the changes of its part, -1: not there
  std::vector<std::vector<ChangedBody>> changes_;
  std::vector<char> jumped_;
  std::vector<std::vector<int>> jumped_bodies_;
  int jumped_count_ = 0;
  std::vector<PlanarJump> jumps_;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_EVENTS_H
#define RODPACK_PLANAR_EVENTS_H

#include <vector>

#include "rodpack/contact/contact_motion.h"
#include "rodpack/contact/force_change.h"
#include "blocks.h"
#include "contact.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

/// Events of the contacts of planar bodies: sums the changes of forces over the bodies, and tells
/// contacts what jumps did to their bodies in the step before. An `Events` of normal_history.h.
class PlanarEvents {
 public:
  struct Changes {
    int body;
    ForceChange force, torque;  // torque about the centre of mass
    bool jumps;
  };

  explicit PlanarEvents(const PlanarParts& parts)
      : parts_(parts), changes_(parts.count()), jumped_bodies_(parts.count()) {}

  void resize(int bodies) {
    place_.resize(bodies, -1);
    jumped_.resize(bodies, 0);
    motions_.resize(bodies);
  }

  void add(const PlanarContact& contact, const double (&now)[3], const double (&rate)[3],
           double since, bool jumps) {
    double turning[3];
    rate_in_space(contact, now, rate, turning);
    add(contact, linear_change(now, turning, since), jumps);
  }

  void add(const PlanarContact& contact, const ForceChange& on_i, bool jumps) {
    double turn[3];
    normal_turning_rate(contact, turn);
    add_to(contact, turn, contact.body_i, 1.0, contact.cri, contact.arm_i, contact.v_i,
           contact.body_v_i, on_i, jumps);
    if (!contact.is_wall)
      add_to(contact, turn, contact.body_j, -1.0, contact.crj, contact.arm_j, contact.v_j,
             contact.body_v_j, on_i, jumps);
  }

  bool motion_changed(const PlanarContact& contact, MotionChange& change) const {
    const bool of_i = jumped_[contact.body_i] != 0;
    const bool of_j = !contact.is_wall && jumped_[contact.body_j] != 0;
    if (!of_i && !of_j) return false;
    change = MotionChange();
    if (of_i)
      add_motion(contact, motions_[contact.body_i], 1.0, contact.cri, contact.offset_i, change);
    if (of_j)
      add_motion(contact, motions_[contact.body_j], -1.0, contact.crj, contact.offset_j, change);
    return true;
  }

  /// For each body; null: none of them has.
  const char* jumped() const { return jumps_ == 0 ? nullptr : jumped_.data(); }
  bool jumped(int body) const { return jumped_[body] != 0; }
  const PlanarMotionChange& motion(int body) const { return motions_[body]; }
  void set_jumped(int body, const PlanarMotionChange& motion) {
    if (!jumped_[body]) {
      jumped_bodies_[parts_.of(body)].push_back(body);
      ++jumps_;
    }
    jumped_[body] = 1;
    motions_[body] = motion;
  }
  /// Of the bodies of a part, before the jumps of a new step are set.
  void forget_jumps(int part) {
    std::vector<int>& bodies = jumped_bodies_[part];
    for (int body : bodies) jumped_[body] = 0;
    jumps_ -= static_cast<int>(bodies.size());
    bodies.clear();
  }

  /// Of the bodies of a part.
  const std::vector<Changes>& changes(int part) const { return changes_[part]; }
  void forget_changes(int part) {
    for (const Changes& change : changes_[part]) place_[change.body] = -1;
    changes_[part].clear();
  }

 private:
  void add_to(const PlanarContact& contact, const double (&turn)[3], int body, double sign,
              double length, const double (&arm)[3], const double (&v)[3],
              const double (&body_v)[3], const ForceChange& on_i, bool jumps) {
    ForceChange force = on_i;
    force *= sign;
    double lever[3], rate[3];
    // the lever of i points against the force that pushes i away, that of j too
    contact_lever(contact, turn, length, -sign, lever, rate);
    for (int d = 0; d < 3; ++d) {
      lever[d] += arm[d];
      rate[d] += v[d] - body_v[d];
    }
    std::vector<Changes>& of_part = changes_[parts_.of(body)];
    if (place_[body] < 0) {
      place_[body] = static_cast<int>(of_part.size());
      of_part.push_back(Changes{body, ForceChange(), ForceChange(), false});
    }
    Changes& sum = of_part[place_[body]];
    sum.force += force;
    add_planar_torque_change(lever, rate, force, sum.torque);
    sum.jumps = sum.jumps || jumps;
  }

  static void add_motion(const PlanarContact& contact, const PlanarMotionChange& motion,
                         double sign, double length, const double (&offset)[2],
                         MotionChange& change) {
    const double arm_x = motion.cosine * offset[0] - motion.sine * offset[1];
    const double arm_y = motion.sine * offset[0] + motion.cosine * offset[1];
    const double lever_x = arm_x - sign * length * contact.en[0];
    const double lever_y = arm_y - sign * length * contact.en[1];
    const auto surface = [&](const double(&of_body)[3], double(&sum)[3]) {
      sum[0] += sign * (of_body[0] - of_body[2] * lever_y);
      sum[1] += sign * (of_body[1] + of_body[2] * lever_x);
    };
    surface(motion.acceleration, change.acceleration);
    surface(motion.velocity, change.velocity);
    surface(motion.displacement, change.displacement);
  }

  PlanarParts parts_;
  std::vector<int> place_;  // of a body in the changes of its part, -1: not there
  std::vector<std::vector<Changes>> changes_;
  std::vector<char> jumped_;
  std::vector<std::vector<int>> jumped_bodies_;
  int jumps_ = 0;
  std::vector<PlanarMotionChange> motions_;
};

}  // namespace rodpack

#endif

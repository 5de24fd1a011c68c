// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts to which nothing happens but that a body of theirs had an event in the step before: nine
// in ten of those that cannot take the fast path, where a bed is being hit.
#include <algorithm>

#include "force_evaluator.h"

namespace rodpack {

namespace {

/// The change of the force for what the dashpots, as far as they act, did not know of such jumps.
PlanarForceChange change_of_dashpots(const PlanarContact& contact,
                                     const ContactJumpComponent& normal,
                                     const ContactJumpComponent& tangential, bool pushes,
                                     bool slides, double dt) {
  const double gamma_n = pushes ? contact.gamman : 0.0, gamma_t = slides ? 0.0 : contact.gammat;
  const auto force = [&](double along_normal, double along_tangent, double(&result)[2]) {
    const Vector2<double> vector =
        in_space(contact.normal(), gamma_n * along_normal, gamma_t * along_tangent);
    result[0] = vector.x;
    result[1] = vector.y;
  };
  double of_acceleration[2], of_velocity[2], of_displacement[2];
  force(normal.acceleration, tangential.acceleration, of_acceleration);
  force(normal.velocity, tangential.velocity, of_velocity);
  force(normal.displacement, tangential.displacement, of_displacement);
  return dashpot_change(1.0, of_acceleration, of_velocity, of_displacement, dt);
}

}  // namespace

/// Does what the general path does with such a contact (normal_history.h, tangential_history.h),
/// along normal and tangent; false, with nothing done, if it is none.
bool PlanarForceEvaluator::outlast_jump(PlanarBlockPool& pool, int place, int lane,
                                        const PlanarContact& contact) {
  const PlanarBlockHead& head = pool.head(place);
  const int bit = 1 << lane;
  ContactJump jump;
  if (!follows_ || !(head.full_history & bit) || pool.cold(place).just_touched[lane] ||
      !(contact.gammat > 0.0) || !events_.motion_changed(contact, jump))
    return false;
  const double tangent[3] = {-contact.en[1], contact.en[0], 0.0};
  const ContactJumpComponent normal = component(jump, contact.en),
                             tangential = component(jump, tangent);
  double* const values = pool.mutable_values(place) + lane;
  const PlanarLawConstants& law = laws_[pool.law(place)];
  // Under the cap of the whole normal force a slide learns of the jump through that force, and
  // friction may begin anew: the general path knows how.
  const bool slid = (head.sliding & bit) != 0, total = settings_.total_force_cap;
  const double before =
      viscoelastic_before(values[planar_viscoelastic], contact.gamman, normal.velocity);
  if (total && (slid || !(before > 0.0))) return false;

  const double dt = settings_.dt;
  const MultistepWeights& weights = adams_bashforth_weights(settings_.order);
  LastingContact<OneContact> lasting;
  double velocity[max_multistep_order];
  for (int k = 0; k < slots_; ++k) velocity[k] = values[pool.velocity(k)];
  lasting.slid = slid;
  lasting.spring_before = values[planar_spring];
  follow_jump(tangential, dt, lasting.slid, lasting.spring_before, slots_,
              [&](int k) -> double& { return velocity[k]; });
  lasting.spring = lasting.spring_before;
  for (int k = 0; k < settings_.order; ++k) lasting.spring += dt * weights[k] * velocity[k];
  lasting.normal_stiffness = contact.kn;
  lasting.normal_damping = contact.gamman;
  lasting.overlap = contact.deltan;
  lasting.separation_velocity = contact.vn;
  lasting.viscoelastic_before = values[planar_viscoelastic];
  lasting.tangential_stiffness = contact.kt;
  lasting.inverse_stiffness.inverse = law.inverse_kt;
  lasting.tangential_damping = contact.gammat;
  lasting.tangential_velocity = contact.tangential_velocity();
  lasting.friction = law.friction;
  const LastingForce<OneContact> force = total ? lasting_force<WholeLoad>(lasting, 0.0, true)
                                               : lasting_force<ElasticLoad>(lasting, 0.0, true);
  if (force.changes) return false;

  const double along_tangent[3] = {force.tangential * tangent[0], force.tangential * tangent[1],
                                   0.0};
  apply(contact, force.normal, along_tangent);
  values[planar_spring] = force.spring;
  if (total) values[pool.earlier()] = before;
  values[planar_viscoelastic] = force.viscoelastic;
  for (int k = 0; k < slots_; ++k) values[pool.velocity(k)] = velocity[k];
  values[pool.velocity(0, true)] = lasting.tangential_velocity;
  if ((force.pushes && contact.gamman > 0.0) || !force.slides)
    events_.add(contact,
                change_of_dashpots(contact, normal, tangential, force.pushes, force.slides, dt),
                false);
  return true;
}

}  // namespace rodpack

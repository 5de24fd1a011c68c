// SPDX-License-Identifier: GPL-2.0-or-later
// Contact forces: what the SIMD loops are given, and the general path, one contact at a time.
#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "force_evaluator.h"
#include "../planar_lists/neighbours.h"
#include "rodpack/contact/dashpot_relaxation.h"
#include "rodpack/contact/normal_history.h"
#include "rodpack/contact/tangential_history.h"

namespace rodpack {

PlanarForceEvaluator::PlanarForceEvaluator(const PlanarSettings& given, const PlanarKernel& kernel,
                                           PlanarBodyStates& of_bodies,
                                           const PlanarNeighbours& neighbours, PlanarBlocks& blocks,
                                           PlanarEvents& of_contacts)
    : settings_(given),
      slots_(blocks.slots()),
      follows_(given.events && given.order > 1),
      kept_(kept_in_step(given.dashpot_relaxation, given.dt)),
      bodies_(of_bodies),
      neighbours_(neighbours),
      blocks_(blocks),
      events_(of_contacts),
      kernel_(kernel) {
  for (const PlanarWall& wall : settings_.walls)
    wall_lines_.push_back({wall.axis == 0 ? 1.0 : 0.0, wall.axis == 1 ? 1.0 : 0.0, wall.position,
                           static_cast<double>(wall.free_side)});
  for (const PlanarLaw& law : settings_.laws)
    laws_.push_back({law.kn, law.kt, 1.0 / law.kt,
                     settings_.total_force_cap ? law.friction : law.friction * law.kn});
}

void PlanarForceEvaluator::evaluate(int part, long step) {
  step_ = step;
  evaluate_general(blocks_.pairs(), kernel_.pairs(arguments(blocks_.pairs(), part)));
  evaluate_general(blocks_.at_walls(), kernel_.walls(arguments(blocks_.at_walls(), part)));
}

PlanarForceArguments PlanarForceEvaluator::arguments(PlanarBlockPool& pool, int part) {
  PlanarForceArguments forces = PlanarForceArguments();
  pool.set_arguments(part, forces);
  bodies_.set_arguments(forces);
  forces.travelled = neighbours_.travelled();
  events_.set_arguments(forces);
  forces.laws = laws_.data();
  forces.one_law = laws_.size() == 1;
  forces.walls = wall_lines_.data();
  forces.order = settings_.order;
  forces.dt = settings_.dt;
  forces.kept = kept_;
  const MultistepWeights& weights = adams_bashforth_weights(std::max(1, settings_.order));
  for (int k = 0; k < settings_.order; ++k) forces.spring_weights[k] = settings_.dt * weights[k];
  forces.follows = follows_;
  const int room = pool.spare() + planar_group;
  if (static_cast<int>(work_.general.size()) < room) {
    work_.general.resize(room);
    work_.awake.resize(room);
    work_.awake_jumped.resize(room);
  }
  forces.general = work_.general.data();
  forces.awake = work_.awake.data();
  forces.awake_jumped = work_.awake_jumped.data();
  return forces;
}

/// Evaluates the lanes that the SIMD loop has left, one at a time.
void PlanarForceEvaluator::evaluate_general(PlanarBlockPool& pool, int entries) {
  for (int k = 0; k < entries; ++k) pool.prefetch(work_.general[k].place);
  for (int k = 0; k < entries; ++k)
    for (int lane = 0; lane < planar_lanes; ++lane)
      if (work_.general[k].lanes & 1 << lane) evaluate_lane(pool, work_.general[k].place, lane);
}

std::vector<PlanarContactState> PlanarForceEvaluator::contacts() const {
  const PlanarBlocks& blocks = blocks_;
  std::vector<PlanarContactState> result;
  result.reserve(blocks.pairs().contacts() + blocks.at_walls().contacts());
  for (const PlanarBlockPool* pool : {&blocks.pairs(), &blocks.at_walls()})
    for (int place = 0; place < pool->size(); ++place)
      for (int lane = 0; lane < planar_lanes; ++lane)
        if (pool->head(place).alive & 1 << lane)
          result.push_back(contact_state(*pool, place, lane));
  return result;
}

PlanarContactState PlanarForceEvaluator::contact_state(const PlanarBlockPool& pool, int place,
                                                       int lane) const {
  PlanarLaneState of_lane;
  pool.save(place, lane, of_lane);
  PlanarContactState state;
  state.body_i = of_lane.i;
  state.sphere_i = of_lane.sphere_i;
  state.body_j = of_lane.j;
  state.sphere_j = of_lane.sphere_j;
  state.history = of_lane.history;
  PlanarContact contact;
  place_lane(pool, place, lane, contact);
  state.constants = {contact.kn, contact.kt, contact.gamman, contact.gammat,
                     laws_[pool.law(place)].friction};
  std::copy(contact.en, contact.en + 2, state.normal);
  return state;
}

/// Sets the contact of a lane; false if its spheres do not overlap.
bool PlanarForceEvaluator::place_lane(const PlanarBlockPool& pool, int place, int lane,
                                      PlanarContact& contact) const {
  const PlanarBlockHead head = pool.head(place);
  const double* const values = pool.values(place) + lane;
  const PlanarLawConstants& law = laws_[pool.law(place)];
  contact.body_i = head.i;
  contact.body_j = head.j;
  contact.offset_i[0] = values[planar_xi];
  contact.offset_i[1] = values[planar_yi];
  contact.offset_j[0] = values[planar_xj];
  contact.offset_j[1] = values[planar_yj];
  contact.radi = bodies_.kinematics(head.i).radius;
  contact.radj = head.j < 0 ? 0.0 : bodies_.kinematics(head.j).radius;
  contact.kn = law.kn;
  contact.kt = law.kt;
  const double* const gammas = pool.values(place) + planar_gammas;
  contact.gamman = gammas[0];
  contact.gammat = gammas[1];
  if (head.j < 0) {
    place_wall(contact, bodies_.kinematics(head.i), settings_.walls[-1 - head.j]);
    return contact.deltan >= 0.0;
  }
  place_pair(contact, bodies_.kinematics(head.i), bodies_.kinematics(head.j));
  return contact.rsq < contact.radsum * contact.radsum;
}

void PlanarForceEvaluator::apply(const PlanarContact& contact, double normal,
                                 const double (&tangential)[3]) {
  const Vector2<double> force = {normal * contact.en[0] + tangential[0],
                                 normal * contact.en[1] + tangential[1]};
  bodies_.add_load(contact.body_i, force, cross_z(contact.lever_i(), force));
  bodies_.add_contact(contact.body_i, contact.offset_i);
  if (contact.is_wall) return;
  bodies_.add_contact(contact.body_j, contact.offset_j);
  bodies_.add_load(contact.body_j, {-force.x, -force.y}, -cross_z(contact.lever_j(), force));
}

template <class Cap>
TangentialForce PlanarForceEvaluator::friction_of(const PlanarContact& contact,
                                                  TangentialHistory& history, const Cap& cap) {
  PlanarEvents* const followed = follows_ ? &events_ : nullptr;
  return tangential_contact_force(contact, history, cap, true, tangential_step(),
                                  static_cast<const PlanarEvents*>(followed), followed);
}

/// Reports that a contact has ended within the step.
template <class Cap>
void PlanarForceEvaluator::end(const PlanarContact& contact, const NormalHistory& normal,
                               TangentialHistory& history, const Cap& cap) {
  end_normal_force(contact, normal, settings_.dt, events_);
  end_tangential_force(contact, history, cap, tangential_step(), events_);
}

void PlanarForceEvaluator::evaluate_lane(PlanarBlockPool& pool, int place, int lane) {
  const bool alive = (pool.head(place).alive & 1 << lane) != 0;
  const double friction = laws_[pool.law(place)].friction;
  PlanarContact contact;
  const bool touches = place_lane(pool, place, lane, contact);
  if (!touches && !alive) return;

  PlanarLaneState lane_state;
  pool.save(place, lane, lane_state);
  // The history in space, already turned into the present plane of contact.
  NormalHistory normal_history;
  TangentialHistory history(slots_);
  to_space(lane_state.history, contact.normal(), normal_history, history);
  CapHistory of_cap = to_cap(lane_state.history, normal_history, contact.kn, contact.gamman);
  if (!alive) history.known = 0;
  history.step = step_ - 1;
  history.friction = friction;
  history.stiffness = contact.kt;
  history.damping = contact.gammat;
  const bool total = settings_.total_force_cap;

  if (!touches) {
    if (follows_ && total)
      end(contact, normal_history, history, TotalCap(friction, 0.0, of_cap));
    else if (follows_)
      end(contact, normal_history, history, ElasticCap{friction});
    pool.clear(place, lane);
    return;
  }

  ++general_contacts_;
  const NormalForce normal = normal_force(contact.kn, contact.gamman, contact.deltan,
                                          follow_velocity(contact, normal_history, alive, kept_));
  follow_normal_force(contact, normal_history, normal.viscoelastic, alive, settings_.dt,
                      follows_ ? &events_ : nullptr);
  const TangentialForce tangential =
      total ? friction_of(contact, history, TotalCap(friction, normal.viscoelastic, of_cap))
            : friction_of(contact, history, ElasticCap{friction});
  apply(contact, normal.total, tangential.force);

  lane_state.history = to_plane(normal_history, history, contact.normal());
  lane_state.history.earlier = of_cap.earlier;
  lane_state.full_history = history.known == full_count();
  pool.restore(place, lane, lane_state, true);
}

}  // namespace rodpack

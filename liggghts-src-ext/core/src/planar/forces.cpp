// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of one step: what is common to its contacts, and the general path, one contact at a time
// by the formulas that the sphere-level styles call.
#include <algorithm>
#include <cmath>

#include "scene_data.h"
#include "rodpack/contact/normal_history.h"

namespace rodpack {

/// Of the blocks of a part.
void PlanarScene::Data::evaluate_forces(int part) {
  evaluate_general(pairs, kernel.pairs(forces_of(pairs, part)));
  evaluate_general(at_walls, kernel.walls(forces_of(at_walls, part)));
}

PlanarForces PlanarScene::Data::forces_of(PlanarBlockPool& pool, int part) {
  PlanarForces forces = PlanarForces();
  forces.heads = pool.heads.data();
  forces.values = pool.all_values.data();
  forces.block_laws = pool.laws.data();
  forces.touching = pool.touching(part);
  forces.others = pool.others(part);
  forces.rows = pool.rows();
  forces.newest = pool.velocity(0, true);
  forces.frames = frames.data();
  forces.moved = moved.data();
  forces.loads = loads.data();
  forces.jumped = events.jumped();
  forces.laws = laws.data();
  forces.one_law = laws.size() == 1;
  forces.walls = wall_lines.data();
  forces.order = settings.order;
  const MultistepWeights& weights = adams_bashforth_weights(settings.order);
  for (int k = 0; k < settings.order; ++k) {
    forces.velocity[k] = pool.velocity(k);
    forces.spring_weights[k] = settings.dt * weights[k];
  }
  forces.follows = follows;
  if (static_cast<int>(general.size()) < pool.size()) {
    general.resize(pool.size());
    awake.resize(pool.size());
  }
  forces.general = general.data();
  forces.awake = awake.data();
  return forces;
}

/// The lanes that need it.
void PlanarScene::Data::evaluate_general(PlanarBlockPool& pool, int entries) {
  for (int k = 0; k < entries; ++k)
    for (int lane = 0; lane < planar_lanes; ++lane)
      if (general[k].lanes & 1 << lane) evaluate_lane(pool, general[k].place, lane);
}

/// Sets the contact of a lane; false if its spheres do not overlap.
bool PlanarScene::Data::place_lane(const PlanarBlockPool& pool, int place, int lane,
                                   PlanarContact& contact) const {
  const PlanarBlockHead& head = pool.heads[place];
  const double* const values = pool.values(place) + lane;
  const PlanarLawConstants& law = laws[pool.laws[place]];
  contact.body_i = head.i;
  contact.body_j = head.j;
  contact.offset_i[0] = values[planar_xi];
  contact.offset_i[1] = values[planar_yi];
  contact.offset_j[0] = values[planar_xj];
  contact.offset_j[1] = values[planar_yj];
  contact.radi = frames[head.i].radius;
  contact.radj = head.j < 0 ? 0.0 : frames[head.j].radius;
  contact.kn = law.kn;
  contact.kt = law.kt;
  const double* const gammas = pool.values(place) + planar_gammas;
  contact.gamman = gammas[0];
  contact.gammat = gammas[1];
  if (head.j < 0) {
    place_wall(contact, frames[head.i], settings.walls[-1 - head.j]);
    return contact.deltan >= 0.0;
  }
  place_pair(contact, frames[head.i], frames[head.j]);
  return contact.rsq < contact.radsum * contact.radsum;
}

void PlanarScene::Data::apply(const PlanarContact& contact, double normal,
                              const double (&tangential)[3]) {
  const Vector2<double> force = {normal * contact.en[0] + tangential[0],
                                 normal * contact.en[1] + tangential[1]};
  double* load = loads[contact.body_i].d;
  load[0] += force.x;
  load[1] += force.y;
  load[2] += cross_z(contact.lever_i(), force);
  if (contact.is_wall) return;
  load = loads[contact.body_j].d;
  load[0] -= force.x;
  load[1] -= force.y;
  load[2] -= cross_z(contact.lever_j(), force);
}

void PlanarScene::Data::evaluate_lane(PlanarBlockPool& pool, int place, int lane) {
  const bool alive = (pool.heads[place].alive & 1 << lane) != 0;
  const double friction = laws[pool.laws[place]].friction;
  PlanarContact contact;
  const bool touches = place_lane(pool, place, lane, contact);
  if (!touches && !alive) return;
  if (touches && outlast_jump(pool, place, lane, contact)) return;

  Saved lane_state;
  save_lane(pool, place, lane, lane_state);
  // The history in space, already turned into the present plane of contact.
  TangentialHistory history(slots);
  const auto along = [&](double component, double* vector) {
    const Vector2<double> in_plane = in_space<double>(contact.normal(), 0.0, component);
    vector[0] = in_plane.x;
    vector[1] = in_plane.y;
  };
  along(lane_state.spring, history.spring);
  for (int k = 0; k < slots; ++k) along(lane_state.velocity[k], history.velocity[k]);
  history.known = alive ? lane_state.count : 0;
  history.sliding = alive && lane_state.sliding;
  history.step = now - 1;
  history.since = lane_state.since;
  history.friction = friction;
  history.stiffness = contact.kt;
  history.damping = contact.gammat;
  NormalHistory normal_history;
  normal_history.viscoelastic = lane_state.uncut;
  normal_history.touch_rate = lane_state.touch_rate;
  normal_history.just_touched = lane_state.fresh;
  PlanarEvents* const followed = follows ? &events : nullptr;

  if (!touches) {
    const bool close = contact.is_wall
                           ? -contact.deltan < (settings.close_factor - 1.0) * contact.radi
                           : contact.r < settings.close_factor * contact.radsum;
    if (followed && close) {
      end_normal_force(contact, normal_history, settings.dt, *followed);
      end_tangential_force(contact, history, tangential_step(), *followed);
    }
    clear_lane(pool, place, lane);
    return;
  }

  ++statistics.general;
  const NormalForce normal = normal_force(contact.kn, contact.gamman, contact.deltan, contact.vn);
  follow_normal_force(contact, normal_history, normal.viscoelastic, alive, settings.dt, followed);
  const TangentialForce tangential =
      tangential_contact_force(contact, history, friction, true, tangential_step(),
                               static_cast<const PlanarEvents*>(followed), followed);
  apply(contact, normal.total, tangential.force);

  lane_state.spring = contact.along_tangent(history.spring);
  for (int k = 0; k < slots; ++k)
    lane_state.velocity[k] = contact.along_tangent(history.velocity[k]);
  lane_state.count = static_cast<std::int8_t>(history.known);
  lane_state.sliding = history.sliding;
  lane_state.mature = lane_state.count == full_count();
  lane_state.since = history.since;
  lane_state.uncut = normal_history.viscoelastic;
  lane_state.touch_rate = normal_history.touch_rate;
  lane_state.fresh = normal_history.just_touched;
  restore_lane(pool, place, lane, lane_state, true);
}

}  // namespace rodpack

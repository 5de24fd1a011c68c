// SPDX-License-Identifier: GPL-2.0-or-later
// What lies in the lanes of blocks: the spheres, and the histories of their contacts.
#include <algorithm>
#include <cmath>
#include <limits>

#include "../planar_simd/arguments.h"
#include "blocks.h"
#include "rodpack/motion/mass_scaling.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

void PlanarBlockPool::set_arguments(int part, PlanarForceArguments& forces) {
  forces.heads = heads_.data();
  forces.values = all_values_.data();
  forces.block_laws = laws_.data();
  forces.touching = touching(part);
  forces.others = others(part);
  forces.spare = spare();
  forces.rows = rows();
  forces.newest = velocity(0, true);
  forces.earlier = earlier();
  forces.felt_velocity = felt_velocity();
  if (extra_.weights) {
    forces.weight_i = weight_i();
    forces.weight_j = weight_j();
  }
  forces.slots = slots_;
  for (int k = 0; k < slots_; ++k) forces.velocity[k] = velocity(k);
}

void PlanarBlockPool::set_spheres(int place, const PlanarSphere* of_i, const PlanarSphere* of_j,
                                  const double (&gammas)[2]) {
  const PlanarBlockColdData& of_block = cold_[place];
  double* const of_place = mutable_values(place);
  std::copy_n(gammas, 2, of_place + planar_gammas);
  for (int lane = 0; lane < planar_lanes; ++lane) {
    const PlanarSphere &a = of_i[of_block.sphere_i[lane]], &b = of_j[of_block.sphere_j[lane]];
    of_place[planar_xi + lane] = a.x;
    of_place[planar_yi + lane] = a.y;
    of_place[planar_xj + lane] = b.x;
    of_place[planar_yj + lane] = b.y;
  }
}

void PlanarBlockPool::set_weights(int place, const ContactWeight& of_i, const ContactWeight& of_j) {
  double* const of_place = mutable_values(place);
  for (int lane = 0; lane < planar_lanes; ++lane) {
    const auto weight = [&](const ContactWeight& of, int row_x, int row_y) {
      const double x = of_place[row_x + lane], y = of_place[row_y + lane];
      return contact_weight(of, x * x + y * y);
    };
    of_place[weight_i() + lane] = weight(of_i, planar_xi, planar_yi);
    of_place[weight_j() + lane] = weight(of_j, planar_xj, planar_yj);
  }
}

void PlanarBlockPool::save(int place, int lane, PlanarLaneState& state) const {
  const PlanarBlockHead of_block = head(place);
  const double* const of_lane = values(place) + lane;
  const PlanarBlockColdData& cold = cold_[place];
  const int bit = 1 << lane;
  state.i = of_block.i;
  state.j = of_block.j;
  state.sphere_i = cold.sphere_i[lane];
  state.sphere_j = cold.sphere_j[lane];
  state.full_history = (of_block.full_history & bit) != 0;
  PlanarHistory& history = state.history;
  history.sliding = (of_block.sliding & bit) != 0;
  history.just_touched = cold.just_touched[lane];
  history.known = cold.known[lane];
  history.spring = of_lane[planar_spring];
  for (int k = 0; k < max_multistep_order; ++k)
    history.velocity[k] = k < slots_ ? of_lane[velocity(k)] : 0.0;
  history.viscoelastic = of_lane[planar_viscoelastic];
  history.earlier = extra_.earlier ? of_lane[earlier()] : 0.0;
  history.relaxes = extra_.felt_velocity && !std::isnan(of_lane[felt_velocity()]);
  history.felt_velocity = history.relaxes ? of_lane[felt_velocity()] : 0.0;
  history.touch_rate = cold.touch_rate[lane];
  history.since = cold.since[lane];
}

void PlanarBlockPool::restore(int place, int lane, const PlanarLaneState& state, bool aged) {
  PlanarBlockHead of_block = head(place);
  double* const of_lane = mutable_values(place) + lane;
  PlanarBlockColdData& cold = cold_[place];
  const auto set = [&](std::uint8_t& bits, bool on) {
    bits = static_cast<std::uint8_t>((bits & ~(1 << lane)) | (on ? 1 << lane : 0));
  };
  const PlanarHistory& history = state.history;
  set(of_block.alive, history.known != 0);
  set(of_block.full_history, state.full_history);
  set(of_block.sliding, history.sliding);
  set_head(place, of_block);
  cold.just_touched[lane] = history.just_touched;
  cold.known[lane] = static_cast<std::int8_t>(history.known);
  cold.touch_rate[lane] = history.touch_rate;
  cold.since[lane] = history.since;
  of_lane[planar_spring] = history.spring;
  for (int k = 0; k < slots_; ++k) of_lane[velocity(k, aged)] = history.velocity[k];
  of_lane[planar_viscoelastic] = history.viscoelastic;
  if (extra_.earlier) of_lane[earlier()] = history.earlier;
  if (extra_.felt_velocity)
    of_lane[felt_velocity()] =
        history.relaxes ? history.felt_velocity : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace rodpack

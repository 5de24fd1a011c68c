// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of contacts, four at a time. Contacts to which nothing happens in the step
// (they last, stick or slide on, push as before) take the short way here, which is the law of
// contact_law.h with the spring along the tangent; all others the general one.
#include "rodpack/lanes.h"
#include "rodpack/planar_scene_data.h"

namespace rodpack {

namespace {

/// What the contacts of a step have in common.
struct LaneStep {
  const PlanarFrame* frames;
  PlanarVector* loads;
  int slots, order;
  double spring_weights[max_multistep_order];  // times dt
  bool follows;
};

/// Forces of the lanes `done` on i, along the normal and the tangent z x n; 0 in the others.
struct LaneForces {
  Lanes normal, tangential;
  int done, general;  // general: lanes that need the general way after all
};

/// The law for the lanes `lasting`, which have a full history, and the history brought to this
/// step.
inline LaneForces lasting_forces(PlanarBlock& block, PlanarBlockHistory& history, Lanes overlap,
                                 Lanes vn, Lanes vt, int lasting, const LaneStep& step) {
  const Lanes zero = all_lanes(0.0);
  const Lanes uncut = block.kn * overlap - block.gamma_n * vn;
  const Lanes spring_before = load_lanes(history.spring);
  Lanes spring = spring_before;
  for (int k = 0; k < step.order; ++k)
    spring += step.spring_weights[k] * load_lanes(history.velocity[k]);
  const Lanes trial = -(block.kt * spring + block.gamma_t * vt);
  const Lanes cap = block.friction * overlap;
  const LaneMask negative = lane_less(trial, zero);
  const Lanes strength = lane_choice(negative, -trial, trial);
  LaneMask slides = lane_less(cap, strength);
  LaneForces forces;
  forces.general = 0;
  if (step.follows) {
    const LaneMask pushes = lane_less(zero, uncut);
    const LaneMask pushed = lane_less(zero, load_lanes(history.uncut));
    LaneMask changes = pushes ^ pushed;
    if (block.gamma_t > 0.0) {
      // Sliding goes on while the velocity keeps the direction of the spring.
      const LaneMask slid = lanes_of_bits(block.sliding);
      const LaneMask goes_on = lane_less(zero, vt * spring_before);
      changes |= lane_choice(slid, ~goes_on, slides);
      slides = slid;
    }
    forces.general = lane_bits(changes) & lasting;
  }
  forces.done = lasting & ~forces.general;

  const LaneMask acts = lanes_of_bits(forces.done);
  const Lanes limited = lane_choice(negative, -cap, cap);
  const Lanes tangential = lane_choice(slides, limited, trial);
  const Lanes normal = lane_choice(lane_less(zero, uncut), uncut, zero);
  forces.normal = lane_choice(acts, normal, zero);
  forces.tangential = lane_choice(acts, tangential, zero);
  spring = lane_choice(slides, -limited * block.inverse_kt, spring);

  const auto keep = [&](double* values, Lanes value) {
    store_lanes(values, lane_choice(acts, value, load_lanes(values)));
  };
  keep(history.spring, spring);
  for (int k = step.slots - 1; k > 0; --k)
    keep(history.velocity[k], load_lanes(history.velocity[k - 1]));
  keep(history.velocity[0], vt);
  keep(history.uncut, uncut);
  block.sliding =
      static_cast<std::uint8_t>((block.sliding & ~forces.done) | (lane_bits(slides) & forces.done));
  return forces;
}

/// Spheres' centres from that of their body.
struct Arms {
  Lanes x, y;
};

inline Arms arms_of(const double* x, const double* y, const PlanarFrame& body) {
  const Lanes bx = load_lanes(x), by = load_lanes(y);
  return {body.cosine * bx - body.sine * by, body.sine * bx + body.cosine * by};
}

/// Geometry of a block of pairs: centres, and their difference from j to i.
struct PairArms {
  Arms i, j;
  Lanes dx, dy, rsq;
};

inline PairArms pair_arms(const PlanarBlock& block, const PlanarFrame& i, const PlanarFrame& j) {
  PairArms arms;
  arms.i = arms_of(block.xi, block.yi, i);
  arms.j = arms_of(block.xj, block.yj, j);
  arms.dx = (i.x - j.x) + (arms.i.x - arms.j.x);
  arms.dy = (i.y - j.y) + (arms.i.y - arms.j.y);
  arms.rsq = arms.dx * arms.dx + arms.dy * arms.dy;
  return arms;
}

/// Evaluates lasting contacts of two bodies; returns the lanes that need the general way.
inline int evaluate_lasting(PlanarBlock& block, PlanarBlockHistory& history, const PairArms& arms,
                            int lasting, const LaneStep& step) {
  const PlanarFrame &i = step.frames[block.i], &j = step.frames[block.j];
  const Lanes r = lane_sqrt(arms.rsq), inverse = 1.0 / r;
  const Lanes nx = arms.dx * inverse, ny = arms.dy * inverse;
  const Lanes overlap = load_lanes(block.reach) - r;
  // levers to the contact point, half-way into the overlap
  const Lanes li = block.radius_i - 0.5 * overlap, lj = block.radius_j - 0.5 * overlap;
  const Lanes pix = arms.i.x - li * nx, piy = arms.i.y - li * ny;
  const Lanes pjx = arms.j.x + lj * nx, pjy = arms.j.y + lj * ny;
  const double wi = i.velocity[2], wj = j.velocity[2];
  const Lanes ux = (i.velocity[0] - j.velocity[0]) - wi * piy + wj * pjy;
  const Lanes uy = (i.velocity[1] - j.velocity[1]) + wi * pix - wj * pjx;
  const LaneForces forces =
      lasting_forces(block, history, overlap, ux * nx + uy * ny, uy * nx - ux * ny, lasting, step);
  const Lanes fx = forces.normal * nx - forces.tangential * ny;
  const Lanes fy = forces.normal * ny + forces.tangential * nx;
  const Lanes sums = lane_sums(fx, fy, pix * fy - piy * fx, pjx * fy - pjy * fx);
  double *on_i = step.loads[block.i].d, *on_j = step.loads[block.j].d;
  const Lanes i_only = {1.0, 1.0, 1.0, 0.0};
  store_lanes(on_i, load_lanes(on_i) + sums * i_only);
  store_lanes(on_j, load_lanes(on_j) - Lanes{sums[0], sums[1], sums[3], 0.0});
  return forces.general;
}

/// Where a wall pushes spheres with centres at `distance` from it along its axis.
inline Lanes sides_of(const PlanarWall& wall, Lanes distance) {
  if (wall.free_side != 0) return all_lanes(wall.free_side);
  return lane_choice(lane_less(distance, all_lanes(0.0)), all_lanes(-1.0), all_lanes(1.0));
}

/// The same with a wall: `distance` of the spheres' centres from it, along its axis.
inline int evaluate_lasting_wall(PlanarBlock& block, PlanarBlockHistory& history, const Arms& arms,
                                 const PlanarWall& wall, Lanes distance, int lasting,
                                 const LaneStep& step) {
  const PlanarFrame& i = step.frames[block.i];
  const Lanes zero = all_lanes(0.0);
  const Lanes side = sides_of(wall, distance);
  const Lanes nx = wall.axis == 0 ? side : zero, ny = wall.axis == 0 ? zero : side;
  const Lanes overlap = block.radius_i - distance * side;
  const Lanes lever = block.radius_i - 0.5 * overlap;
  const Lanes px = arms.x - lever * nx, py = arms.y - lever * ny;
  const Lanes ux = i.velocity[0] - i.velocity[2] * py, uy = i.velocity[1] + i.velocity[2] * px;
  const LaneForces forces =
      lasting_forces(block, history, overlap, ux * nx + uy * ny, uy * nx - ux * ny, lasting, step);
  const Lanes fx = forces.normal * nx - forces.tangential * ny;
  const Lanes fy = forces.normal * ny + forces.tangential * nx;
  double* const on_i = step.loads[block.i].d;
  store_lanes(on_i, load_lanes(on_i) + lane_sums(fx, fy, px * fy - py * fx, zero));
  return forces.general;
}

LaneStep step_of(PlanarScene::Data& scene) {
  LaneStep step;
  step.frames = scene.frames.data();
  step.loads = scene.loads.data();
  step.slots = scene.slots;
  step.order = scene.settings.order;
  step.follows = scene.follows;
  const MultistepWeights& weights = adams_bashforth_weights(step.order);
  for (int k = 0; k < step.order; ++k) step.spring_weights[k] = scene.settings.dt * weights[k];
  return step;
}

}  // namespace

void PlanarScene::Data::evaluate_pairs() {
  const LaneStep step = step_of(*this);
  for (int place = 0; place < pairs.size(); ++place) {
    PlanarBlock& block = pairs.blocks[place];
    const PairArms arms = pair_arms(block, frames[block.i], frames[block.j]);
    const Lanes reach = load_lanes(block.reach);
    const int touching = lane_bits(lane_less(arms.rsq, reach * reach)), alive = block.alive;
    if ((touching | alive) == 0) continue;
    int lasting = touching & block.mature;
    if (follows && (events.jumped(block.i) || events.jumped(block.j))) lasting = 0;
    int general = (touching | alive) & ~lasting;
    if (lasting) general |= evaluate_lasting(block, pairs.histories[place], arms, lasting, step);
    for (int lane = 0; general != 0; ++lane, general >>= 1)
      if (general & 1) evaluate_lane(pairs, place, lane);
  }
}

void PlanarScene::Data::evaluate_walls() {
  const LaneStep step = step_of(*this);
  for (int place = 0; place < at_walls.size(); ++place) {
    PlanarBlock& block = at_walls.blocks[place];
    const PlanarFrame& i = frames[block.i];
    const PlanarWall& wall = settings.walls[-1 - block.j];
    const Arms arms = arms_of(block.xi, block.yi, i);
    const Lanes distance =
        (wall.axis == 0 ? i.x + arms.x : i.y + arms.y) - all_lanes(wall.position);
    const Lanes side = sides_of(wall, distance);
    const int used = (1 << block.used) - 1;
    const int touching = ~lane_bits(lane_less(load_lanes(block.reach), distance * side)) & used,
              alive = block.alive;
    if ((touching | alive) == 0) continue;
    int lasting = touching & block.mature;
    if (follows && events.jumped(block.i)) lasting = 0;
    int general = (touching | alive) & ~lasting;
    if (lasting)
      general |= evaluate_lasting_wall(block, at_walls.histories[place], arms, wall, distance,
                                       lasting, step);
    for (int lane = 0; general != 0; ++lane, general >>= 1)
      if (general & 1) evaluate_lane(at_walls, place, lane);
  }
}

}  // namespace rodpack

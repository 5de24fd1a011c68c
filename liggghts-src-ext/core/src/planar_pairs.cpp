// SPDX-License-Identifier: GPL-2.0-or-later
// Forces between bodies, four sphere pairs at a time. Contacts to which nothing happens in the step
// (they last, stick or slide on, push as before) take the short way here, which is the law of
// contact_law.h with the spring along the tangent; all others the general one.
#include "rodpack/lanes.h"
#include "rodpack/planar_scene_data.h"

namespace rodpack {

namespace {

/// What the pairs of a step have in common.
struct PairStep {
  const PlanarFrame* frames;
  PlanarVector* loads;
  int slots, order;
  double spring_weights[max_multistep_order];  // times dt
  bool follows;
};

/// The geometry of a block: spheres' centres from those of their bodies, and from j to i.
struct Arms {
  Lanes ix, iy, jx, jy, dx, dy, rsq;
};

inline Arms arms_of(const PlanarBlock& block, const PlanarFrame& i, const PlanarFrame& j) {
  const Lanes xi = load_lanes(block.xi), yi = load_lanes(block.yi);
  const Lanes xj = load_lanes(block.xj), yj = load_lanes(block.yj);
  Arms arms;
  arms.ix = i.cosine * xi - i.sine * yi;
  arms.iy = i.sine * xi + i.cosine * yi;
  arms.jx = j.cosine * xj - j.sine * yj;
  arms.jy = j.sine * xj + j.cosine * yj;
  arms.dx = (i.x - j.x) + (arms.ix - arms.jx);
  arms.dy = (i.y - j.y) + (arms.iy - arms.jy);
  arms.rsq = arms.dx * arms.dx + arms.dy * arms.dy;
  return arms;
}

/// Evaluates the lanes `lasting`, which have a full history; returns those among them that need the
/// general way after all, and leaves these alone.
inline int evaluate_lasting(PlanarBlock& block, PlanarBlockHistory& history, const Arms& arms,
                            int lasting, const PairStep& step) {
  const PlanarFrame &i = step.frames[block.i], &j = step.frames[block.j];
  const Lanes r = lane_sqrt(arms.rsq), inverse = 1.0 / r;
  const Lanes nx = arms.dx * inverse, ny = arms.dy * inverse;
  const Lanes overlap = load_lanes(block.reach) - r;
  // levers to the contact point, half-way into the overlap
  const Lanes li = block.radius_i - 0.5 * overlap, lj = block.radius_j - 0.5 * overlap;
  const Lanes pix = arms.ix - li * nx, piy = arms.iy - li * ny;
  const Lanes pjx = arms.jx + lj * nx, pjy = arms.jy + lj * ny;
  const double wi = i.velocity[2], wj = j.velocity[2];
  const Lanes ux = (i.velocity[0] - j.velocity[0]) - wi * piy + wj * pjy;
  const Lanes uy = (i.velocity[1] - j.velocity[1]) + wi * pix - wj * pjx;
  const Lanes vn = ux * nx + uy * ny, vt = uy * nx - ux * ny;

  const Lanes zero = all_lanes(0.0);
  const Lanes uncut = block.kn * overlap - block.gamma_n * vn;
  const Lanes spring_before = load_lanes(history.spring);
  Lanes spring = spring_before;
  for (int k = 0; k < step.order; ++k)
    spring += step.spring_weights[k] * load_lanes(history.velocity[k]);
  const Lanes trial = -(block.kt * spring + block.gamma_t * vt);
  const Lanes cap = block.friction * overlap;
  const Lanes strength = trial < zero ? -trial : trial;
  LaneMask slides = strength > cap;
  int general = 0;
  if (step.follows) {
    const LaneMask pushes = uncut > zero, pushed = load_lanes(history.uncut) > zero;
    LaneMask changes = pushes ^ pushed;
    if (block.gamma_t > 0.0) {
      // Sliding goes on while the velocity keeps the direction of the spring.
      const LaneMask slid = lanes_of_bits(block.sliding);
      const LaneMask goes_on = vt * spring_before > zero;
      changes |= slid ? ~goes_on : slides;
      slides = slid;
    }
    general = lane_bits(changes) & lasting;
  }
  const int done = lasting & ~general;
  if (done == 0) return general;

  const LaneMask acts = lanes_of_bits(done);
  const Lanes limited = trial < zero ? -cap : cap;
  Lanes tangential = slides ? limited : trial;
  Lanes normal = uncut > zero ? uncut : zero;
  spring = slides ? -limited / block.kt : spring;
  normal = acts ? normal : zero;
  tangential = acts ? tangential : zero;
  const Lanes fx = normal * nx - tangential * ny, fy = normal * ny + tangential * nx;
  const Lanes sums = lane_sums(fx, fy, pix * fy - piy * fx, pjx * fy - pjy * fx);
  double *on_i = step.loads[block.i].d, *on_j = step.loads[block.j].d;
  const Lanes i_only = {1.0, 1.0, 1.0, 0.0};
  store_lanes(on_i, load_lanes(on_i) + sums * i_only);
  store_lanes(on_j, load_lanes(on_j) - Lanes{sums[0], sums[1], sums[3], 0.0});

  const auto keep = [&](double* values, Lanes value) {
    store_lanes(values, acts ? value : load_lanes(values));
  };
  keep(history.spring, spring);
  for (int k = step.slots - 1; k > 0; --k)
    keep(history.velocity[k], load_lanes(history.velocity[k - 1]));
  keep(history.velocity[0], vt);
  keep(history.uncut, uncut);
  block.sliding = static_cast<std::uint8_t>((block.sliding & ~done) | (lane_bits(slides) & done));
  return general;
}

}  // namespace

void PlanarScene::Data::evaluate_pairs() {
  PairStep step;
  step.frames = frames.data();
  step.loads = loads.data();
  step.slots = slots;
  step.order = settings.order;
  step.follows = follows;
  const MultistepWeights& weights = adams_bashforth_weights(settings.order);
  for (int k = 0; k < settings.order; ++k) step.spring_weights[k] = settings.dt * weights[k];

  for (int place = 0; place < pairs.size(); ++place) {
    PlanarBlock& block = pairs.blocks[place];
    const Arms arms = arms_of(block, frames[block.i], frames[block.j]);
    const Lanes reach = load_lanes(block.reach);
    const int touching = lane_bits(arms.rsq < reach * reach), alive = block.alive;
    if ((touching | alive) == 0) continue;
    int lasting = touching & block.mature;
    if (follows && (events.jumped(block.i) || events.jumped(block.j))) lasting = 0;
    int general = (touching | alive) & ~lasting;
    if (lasting) general |= evaluate_lasting(block, pairs.histories[place], arms, lasting, step);
    for (int lane = 0; general != 0; ++lane, general >>= 1)
      if (general & 1) evaluate_lane(pairs, place, lane);
  }
}

}  // namespace rodpack

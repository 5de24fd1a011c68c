// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of contacts between bodies, the blocks of a register at a time. Contacts to which nothing
// happens in the step (they last, stick or slide on, push as before) take the short way here, which
// is the law of contact_law.h with the spring along the tangent; all others the general one.
//
// Included once by a source for one set of instructions, in an unnamed namespace, after the header
// of its lanes, which sets `Lanes` and how many blocks they hold. Nothing else may be used here but
// planar_forces.h: see there.

/// The same of each block.
typedef double* const BlockValues[lane_blocks];
typedef const double* const BlockConstants[lane_blocks];

/// Forces of the lanes `done` on i, along the normal and the tangent z x n; 0 in the others.
struct LaneForces {
  Lanes normal, tangential;
  int done, general;  // general: lanes that need the general way after all
};

/// The law for the lanes `lasting`, which have a full history, and the history brought to this
/// step. `sliding`: lanes that slid; becomes those that do.
inline LaneForces lasting_forces(PlanarBlockHead* const (&heads)[lane_blocks], BlockValues& history,
                                 Lanes overlap, Lanes vn, Lanes vt, int lasting, int& sliding,
                                 const PlanarForces& forces) {
  const double* gammas[lane_blocks];
  const double* laws[lane_blocks];
  bool damped = false;
  for (int b = 0; b < lane_blocks; ++b) {
    gammas[b] = heads[b]->gamma;
    laws[b] = reinterpret_cast<const double*>(&forces.laws[heads[b]->law]);
    damped = damped || heads[b]->gamma[1] > 0.0;
  }
  const Lanes zero = all_lanes(0.0);
  const Lanes gamma_n = each_block(gammas, 0), gamma_t = each_block(gammas, 1);
  const Lanes kn = each_block(laws, 0), kt = each_block(laws, 1);
  const Lanes inverse_kt = each_block(laws, 2), friction = each_block(laws, 3);

  const Lanes uncut = kn * overlap - gamma_n * vn;
  const Lanes spring_before = lanes_of(history, PlanarBlockPool::spring);
  Lanes spring = spring_before;
  for (int k = 0; k < forces.order; ++k)
    spring += forces.spring_weights[k] * lanes_of(history, forces.velocity[k]);
  const Lanes trial = -(kt * spring + gamma_t * vt);
  const Lanes cap = friction * overlap;
  const LaneMask negative = lane_less(trial, zero);
  const Lanes strength = lane_choice(negative, -trial, trial);
  const LaneMask pushes = lane_less(zero, uncut);
  LaneMask slides = lane_less(cap, strength);
  LaneForces result;
  result.general = 0;
  if (forces.follows) {
    const LaneMask pushed = lane_less(zero, lanes_of(history, PlanarBlockPool::uncut));
    LaneMask changes = pushes ^ pushed;
    if (damped) {
      // Sliding goes on while the velocity keeps the direction of the spring.
      const LaneMask slid = lanes_of_bits(sliding), with_dashpot = lane_less(zero, gamma_t);
      const LaneMask goes_on = lane_less(zero, vt * spring_before);
      changes |= with_dashpot & lane_choice(slid, ~goes_on, slides);
      slides = lane_choice(with_dashpot, slid, slides);
    }
    result.general = lane_bits(changes) & lasting;
  }
  result.done = lasting & ~result.general;

  const LaneMask acts = lanes_of_bits(result.done);
  const Lanes limited = lane_choice(negative, -cap, cap);
  const Lanes tangential = lane_choice(slides, limited, trial);
  result.normal = lane_choice(acts & pushes, uncut, zero);
  result.tangential = lane_choice(acts, tangential, zero);
  spring = lane_choice(slides, -limited * inverse_kt, spring);
  keep_lanes(acts, history, PlanarBlockPool::spring, spring);
  keep_lanes(acts, history, PlanarBlockPool::uncut, uncut);
  keep_lanes(acts, history, forces.newest, vt);
  sliding = (sliding & ~result.done) | (lane_bits(slides) & result.done);
  return result;
}

// Values of a PlanarFrame and places in a PlanarBlock, in doubles.
enum { frame_x, frame_y, frame_cosine, frame_sine, frame_vx, frame_vy, frame_spin, frame_radius };
enum {
  block_xi,
  block_yi = planar_lanes,
  block_xj = 2 * planar_lanes,
  block_yj = 3 * planar_lanes
};

/// Spheres' centres from that of their body.
struct Arms {
  Lanes x, y;
};

inline Arms arms_of(BlockValues& block, int x, int y, BlockConstants& frame) {
  const Lanes bx = lanes_of(block, x), by = lanes_of(block, y);
  const Lanes cosine = each_block(frame, frame_cosine), sine = each_block(frame, frame_sine);
  return {cosine * bx - sine * by, sine * bx + cosine * by};
}

/// Lane bits of the blocks.
inline int lanes_in_use(PlanarBlockHead* const (&heads)[lane_blocks]) {
  int bits = 0;
  for (int b = 0; b < lane_blocks; ++b) bits |= ((1 << heads[b]->used) - 1) << b * planar_lanes;
  return bits;
}
inline int lane_bits_of(PlanarBlockHead* const (&heads)[lane_blocks],
                        std::uint8_t PlanarBlockHead::*bits) {
  int result = 0;
  for (int b = 0; b < lane_blocks; ++b) result |= heads[b]->*bits << b * planar_lanes;
  return result;
}
inline void set_sliding(PlanarBlockHead* const (&heads)[lane_blocks], int bits) {
  for (int b = 0; b < lane_blocks; ++b)
    heads[b]->sliding = static_cast<std::uint8_t>(bits >> b * planar_lanes & 15);
}

/// Evaluates lasting contacts of the blocks; returns the lanes that need the general way.
inline __attribute__((always_inline)) int evaluate_blocks(PlanarBlockHead* const (&heads)[lane_blocks], BlockValues& block,
                           BlockValues& history, BlockValues& load_i, BlockValues& load_j,
                           const PlanarForces& forces) {
  const double *frame_i[lane_blocks], *frame_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    frame_i[b] = reinterpret_cast<const double*>(&forces.frames[heads[b]->i]);
    frame_j[b] = reinterpret_cast<const double*>(&forces.frames[heads[b]->j]);
  }
  const Arms i = arms_of(block, block_xi, block_yi, frame_i);
  const Arms j = arms_of(block, block_xj, block_yj, frame_j);
  const Lanes dx = (each_block(frame_i, frame_x) - each_block(frame_j, frame_x)) + (i.x - j.x);
  const Lanes dy = (each_block(frame_i, frame_y) - each_block(frame_j, frame_y)) + (i.y - j.y);
  const Lanes square = dx * dx + dy * dy;
  const Lanes radius_i = each_block(frame_i, frame_radius);
  const Lanes radius_j = each_block(frame_j, frame_radius), reach = radius_i + radius_j;
  const int touching = lane_bits(lane_less(square, reach * reach)) & lanes_in_use(heads);
  const int here = touching | lane_bits_of(heads, &PlanarBlockHead::alive);
  if (here == 0) return 0;
  int lasting = touching & lane_bits_of(heads, &PlanarBlockHead::mature);
  if (forces.jumped)
    for (int b = 0; b < lane_blocks; ++b)
      if (forces.jumped[heads[b]->i] | forces.jumped[heads[b]->j])
        lasting &= ~(15 << b * planar_lanes);
  const int general = here & ~lasting;
  if (lasting == 0) return general;

  Lanes r, inverse;
  lane_roots(square, r, inverse);
  const Lanes nx = dx * inverse, ny = dy * inverse;
  const Lanes overlap = reach - r;
  // levers to the contact point, half-way into the overlap
  const Lanes li = radius_i - 0.5 * overlap, lj = radius_j - 0.5 * overlap;
  const Lanes pix = i.x - li * nx, piy = i.y - li * ny;
  const Lanes pjx = j.x + lj * nx, pjy = j.y + lj * ny;
  const Lanes wi = each_block(frame_i, frame_spin), wj = each_block(frame_j, frame_spin);
  const Lanes ux =
      (each_block(frame_i, frame_vx) - each_block(frame_j, frame_vx)) - wi * piy + wj * pjy;
  const Lanes uy =
      (each_block(frame_i, frame_vy) - each_block(frame_j, frame_vy)) + wi * pix - wj * pjx;
  int sliding = lane_bits_of(heads, &PlanarBlockHead::sliding);
  const LaneForces force = lasting_forces(heads, history, overlap, ux * nx + uy * ny,
                                          uy * nx - ux * ny, lasting, sliding, forces);
  set_sliding(heads, sliding);
  const Lanes fx = force.normal * nx - force.tangential * ny;
  const Lanes fy = force.normal * ny + force.tangential * nx;
  add_loads(fx, fy, pix * fy - piy * fx, pjx * fy - pjy * fx, load_i, load_j);
  return general | force.general;
}

/// Evaluates the blocks `places`, of which only the first `members` are there.
inline __attribute__((always_inline)) int evaluate_places(const int (&places)[lane_blocks], int members,
                           const PlanarForces& forces, int entries) {
  // What is missing repeats the first, without lanes and without a body to act on.
  alignas(64) PlanarVector nowhere[2];
  PlanarBlockHead none;
  PlanarBlockHead* heads[lane_blocks];
  double *block[lane_blocks], *history[lane_blocks], *load_i[lane_blocks], *load_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    const int place = places[b < members ? b : 0];
    heads[b] = &forces.heads[place];
    block[b] = reinterpret_cast<double*>(&forces.blocks[place]);
    history[b] = forces.histories + static_cast<long>(place) * forces.stride;
    load_i[b] = forces.loads[heads[b]->i].d;
    load_j[b] = forces.loads[heads[b]->j].d;
    if (b < members) continue;
    none = *heads[b];
    none.used = none.alive = none.mature = none.sliding = 0;
    heads[b] = &none;
    load_i[b] = nowhere[0].d;
    load_j[b] = nowhere[1].d;
  }
  const int general = evaluate_blocks(heads, block, history, load_i, load_j, forces);
  if (general == 0) return entries;
  for (int b = 0; b < members; ++b) {
    const int lanes = general >> b * planar_lanes & 15;
    if (lanes != 0) forces.general[entries++] = {places[b], lanes};
  }
  return entries;
}

/// All blocks of pairs, but those whose spheres cannot have met: since they were listed both bodies
/// together have moved by less than the gap.
int evaluate_pairs(const PlanarForces& forces) {
  int entries = 0, place = 0;
  while (true) {
    int places[lane_blocks], members = 0;
    for (; place < forces.count && members < lane_blocks; ++place) {
      const PlanarBlockHead& head = forces.heads[place];
      if (head.alive != 0 || !(forces.moved[head.i] + forces.moved[head.j] < head.gap))
        places[members++] = place;
    }
    if (members == 0) return entries;
    entries = evaluate_places(places, members, forces, entries);
  }
}

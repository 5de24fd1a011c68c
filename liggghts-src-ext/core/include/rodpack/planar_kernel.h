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

/// Forces on i, along the normal and the tangent z x n; 0 in lanes that are not on the short way.
struct LaneForces {
  Lanes normal, tangential;
  int general;  // lanes that need the general way after all
};

/// The law for the lanes `lasting`, which have a full history, and the history brought to this
/// step. `sliding`: lanes that slid; becomes those that do.
inline LaneForces lasting_forces(PlanarBlockHead* const (&heads)[lane_blocks], BlockValues& values,
                                 Lanes overlap, Lanes vn, Lanes vt, int lasting, int& sliding,
                                 const PlanarForces& forces) {
  const double* gammas[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) gammas[b] = heads[b]->gamma;
  const Lanes zero = all_lanes(0.0);
  const Lanes gamma_n = each_block(gammas, 0), gamma_t = each_block(gammas, 1);
  Lanes kn = all_lanes(forces.laws->kn), kt = all_lanes(forces.laws->kt);
  Lanes inverse_kt = all_lanes(forces.laws->inverse_kt);
  Lanes friction = all_lanes(forces.laws->friction);
  if (!forces.one_law) {
    const double* laws[lane_blocks];
    for (int b = 0; b < lane_blocks; ++b)
      laws[b] = reinterpret_cast<const double*>(&forces.laws[heads[b]->law]);
    kn = each_block(laws, 0);
    kt = each_block(laws, 1);
    inverse_kt = each_block(laws, 2);
    friction = each_block(laws, 3);
  }

  const Lanes uncut = kn * overlap - gamma_n * vn;
  const Lanes spring_before = lanes_of(values, planar_spring);
  Lanes spring = spring_before;
  for (int k = 0; k < forces.order; ++k)
    spring += forces.spring_weights[k] * lanes_of(values, forces.velocity[k]);
  const Lanes trial = -(kt * spring + gamma_t * vt);
  const Lanes cap = friction * overlap;
  const LaneMask negative = lane_less(trial, zero);
  const Lanes strength = lane_choice(negative, -trial, trial);
  const LaneMask pushes = lane_less(zero, uncut);
  LaneMask slides = lane_less(cap, strength);
  LaneMask acts = lanes_of_bits(lasting);
  LaneForces result;
  result.general = 0;
  if (forces.follows) {
    const LaneMask pushed = lane_less(zero, lanes_of(values, planar_uncut));
    LaneMask changes = pushes ^ pushed;
    // Sliding goes on while the velocity keeps the direction of the spring.
    const LaneMask slid = lanes_of_bits(sliding), with_dashpot = lane_less(zero, gamma_t);
    const LaneMask goes_on = lane_less(zero, vt * spring_before);
    changes = (changes | (with_dashpot & lane_choice(slid, ~goes_on, slides))) & acts;
    slides = lane_choice(with_dashpot, slid, slides);
    acts = acts & ~changes;
    result.general = lane_bits(changes);
  }
  const Lanes limited = lane_choice(negative, -cap, cap);
  const Lanes tangential = lane_choice(slides, limited, trial);
  result.normal = lane_choice(acts & pushes, uncut, zero);
  result.tangential = lane_choice(acts, tangential, zero);
  spring = lane_choice(slides, -limited * inverse_kt, spring);
  keep_lanes(acts, values, planar_spring, spring);
  keep_lanes(acts, values, planar_uncut, uncut);
  keep_lanes(acts, values, forces.newest, vt);
  sliding = lane_bits(lane_choice(acts, slides, lanes_of_bits(sliding)));
  return result;
}

// Values of a PlanarFrame, in doubles.
enum { frame_x, frame_y, frame_cosine, frame_sine, frame_vx, frame_vy, frame_spin, frame_radius };

/// Spheres' centres from that of their body.
struct Arms {
  Lanes x, y;
};

inline Arms arms_of(BlockValues& values, int x, int y, BlockConstants& frame) {
  const Lanes bx = lanes_of(values, x), by = lanes_of(values, y);
  const Lanes cosine = each_block(frame, frame_cosine), sine = each_block(frame, frame_sine);
  return {cosine * bx - sine * by, sine * bx + cosine * by};
}

/// What a PlanarHead knows of its lanes; the lanes of the blocks side by side.
struct LaneFlags {
  int used, alive, mature, sliding;
};
inline LaneFlags flags_of(PlanarBlockHead* const (&heads)[lane_blocks]) {
  unsigned all = 0;
  for (int b = 0; b < lane_blocks; ++b) {
    unsigned flags;
    __builtin_memcpy(&flags, &heads[b]->used, sizeof flags);
    all |= flags << b * planar_lanes;
  }
  return {static_cast<int>(all & 255), static_cast<int>(all >> 8 & 255),
          static_cast<int>(all >> 16 & 255), static_cast<int>(all >> 24)};
}

/// Evaluates lasting contacts of the blocks; returns the lanes that need the general way. `there`:
/// lanes of blocks that are not the repetition of another one.
inline __attribute__((always_inline)) int evaluate_blocks(
    PlanarBlockHead* const (&heads)[lane_blocks], BlockValues& values, int there,
    const PlanarForces& forces) {
  const double *frame_i[lane_blocks], *frame_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    frame_i[b] = reinterpret_cast<const double*>(&forces.frames[heads[b]->i]);
    frame_j[b] = reinterpret_cast<const double*>(&forces.frames[heads[b]->j]);
  }
  const Arms i = arms_of(values, planar_xi, planar_yi, frame_i);
  const Arms j = arms_of(values, planar_xj, planar_yj, frame_j);
  const Lanes dx = (each_block(frame_i, frame_x) - each_block(frame_j, frame_x)) + (i.x - j.x);
  const Lanes dy = (each_block(frame_i, frame_y) - each_block(frame_j, frame_y)) + (i.y - j.y);
  const Lanes square = dx * dx + dy * dy;
  const Lanes radius_i = each_block(frame_i, frame_radius);
  const Lanes radius_j = each_block(frame_j, frame_radius), reach = radius_i + radius_j;
  const LaneFlags flags = flags_of(heads);
  const int touching = lane_bits(lane_less(square, reach * reach)) & flags.used & there;
  const int here = touching | (flags.alive & there);
  if (here == 0) return 0;
  int lasting = touching & flags.mature;
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
  int sliding = flags.sliding;
  const LaneForces force = lasting_forces(heads, values, overlap, ux * nx + uy * ny,
                                          uy * nx - ux * ny, lasting, sliding, forces);
  for (int b = lane_blocks - 1; b >= 0; --b)  // the first counts where it is repeated
    heads[b]->sliding = static_cast<std::uint8_t>(sliding >> b * planar_lanes & 15);
  const Lanes fx = force.normal * nx - force.tangential * ny;
  const Lanes fy = force.normal * ny + force.tangential * nx;
  double *load_i[lane_blocks], *load_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load_i[b] = forces.loads[heads[b]->i].d;
    load_j[b] = forces.loads[heads[b]->j].d;
  }
  add_loads(fx, fy, pix * fy - piy * fx, pjx * fy - pjy * fx, load_i, load_j);
  return general | force.general;
}

/// Evaluates the blocks `places`, of which only the first `members` are there.
inline __attribute__((always_inline)) int evaluate_places(int (&places)[lane_blocks], int members,
                                                          const PlanarForces& forces, int entries) {
  PlanarBlockHead* heads[lane_blocks];
  double* values[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    const int place = places[b < members ? b : 0];
    heads[b] = &forces.heads[place];
    values[b] = forces.values + static_cast<long>(place) * forces.stride;
  }
  const int there = (1 << members * planar_lanes) - 1;
  const int general = evaluate_blocks(heads, values, there, forces);
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

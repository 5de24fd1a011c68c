// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of contacts between bodies, the blocks of a register at a time. Contacts to which nothing
// happens in the step (they last, stick or slide on, push as before) take the short way here, which
// is the law of contact_law.h with the spring along the tangent; all others the general one.
//
// Included once by a source for one set of instructions, in an unnamed namespace, after the header
// of its lanes, which sets `Lanes` and how many blocks they hold. Nothing else may be used here but
// planar_forces.h: see there.

constexpr int all_of_block = (1 << planar_lanes) - 1;  // bits of its lanes

/// The same of each block.
typedef const double* const BlockConstants[lane_blocks];

/// Values of the blocks from `first` on, which is a multiple of lane_blocks.
inline double* values_of(const PlanarForces& forces, int first) {
  const long group = first / planar_group;
  return forces.values + group * forces.rows * planar_row + first % planar_group * planar_lanes;
}

// Whole stores: stores under a mask are slow on some processors.
inline void keep_lanes(LaneMask where, double* place, Lanes x) {
  store_lanes(place, lane_choice(where, x, load_lanes(place)));
}

/// Forces on i, along the normal and the tangent z x n; 0 in lanes that are not on the short way.
struct LaneForces {
  Lanes normal, tangential;
  int general;  // lanes that need the general way after all
};

/// The law for the lanes `lasting`, which have a full history, and the history brought to this
/// step. `sliding`: lanes that slid; becomes those that do.
inline LaneForces lasting_forces(int first, double* values, Lanes overlap, Lanes vn, Lanes vt,
                                 int lasting, int& sliding, const PlanarForces& forces) {
  const double* gammas[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) gammas[b] = values + planar_gammas + b * planar_lanes;
  const Lanes zero = all_lanes(0.0);
  Lanes gamma_n, gamma_t;
  each_two(gammas, 0, gamma_n, gamma_t);
  Lanes kn = all_lanes(forces.laws->kn), kt = all_lanes(forces.laws->kt);
  Lanes inverse_kt = all_lanes(forces.laws->inverse_kt);
  Lanes friction = all_lanes(forces.laws->friction);
  if (!forces.one_law) {
    const double* laws[lane_blocks];
    for (int b = 0; b < lane_blocks; ++b)
      laws[b] = reinterpret_cast<const double*>(&forces.laws[forces.block_laws[first + b]]);
    each_two(laws, 0, kn, kt);
    each_two(laws, 2, inverse_kt, friction);
  }

  const Lanes uncut = kn * overlap - gamma_n * vn;
  const Lanes spring_before = load_lanes(values + planar_spring);
  Lanes spring = spring_before;
  for (int k = 0; k < forces.order; ++k)
    spring += forces.spring_weights[k] * load_lanes(values + forces.velocity[k]);
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
    const LaneMask pushed = lane_less(zero, load_lanes(values + planar_uncut));
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
  keep_lanes(acts, values + planar_spring, spring);
  keep_lanes(acts, values + planar_uncut, uncut);
  keep_lanes(acts, values + forces.newest, vt);
  sliding = lane_bits(lane_choice(acts, slides, lanes_of_bits(sliding)));
  return result;
}

// Places in a PlanarFrame, in doubles: of x and y, cosine and sine, velocity, spin and radius.
enum { frame_place = 0, frame_turn = 2, frame_velocity = 4, frame_spin = 6 };

/// Spheres' centres from that of their body.
struct Arms {
  Lanes x, y;
};

inline Arms arms_of(const double* x, const double* y, BlockConstants& frame) {
  const Lanes bx = load_lanes(x), by = load_lanes(y);
  Lanes cosine, sine;
  each_two(frame, frame_turn, cosine, sine);
  return {cosine * bx - sine * by, sine * bx + cosine * by};
}

/// What a PlanarHead knows of its lanes; the lanes of the blocks side by side.
struct LaneFlags {
  int used, alive, mature, sliding;
};
inline LaneFlags flags_of(const PlanarBlockHead* heads) {
  unsigned all = 0;
  for (int b = 0; b < lane_blocks; ++b) {
    unsigned flags;
    __builtin_memcpy(&flags, &heads[b].used, sizeof flags);
    all |= flags << b * planar_lanes;
  }
  return {static_cast<int>(all & 255), static_cast<int>(all >> 8 & 255),
          static_cast<int>(all >> 16 & 255), static_cast<int>(all >> 24)};
}
inline void set_sliding(PlanarBlockHead* heads, int sliding) {
  for (int b = 0; b < lane_blocks; ++b)
    heads[b].sliding = static_cast<std::uint8_t>(sliding >> b * planar_lanes & all_of_block);
}

/// The lanes of blocks whose bodies had no event in the step before.
inline int undisturbed(const PlanarBlockHead* heads, const PlanarForces& forces) {
  int lanes = (1 << lane_blocks * planar_lanes) - 1;
  if (!forces.jumped) return lanes;
  for (int b = 0; b < lane_blocks; ++b)
    if (forces.jumped[heads[b].i] | (heads[b].j >= 0 && forces.jumped[heads[b].j]))
      lanes &= ~(all_of_block << b * planar_lanes);
  return lanes;
}

/// Evaluates the lasting contacts of the blocks from `first` on; returns the lanes that need the
/// general way.
inline __attribute__((always_inline)) int evaluate_blocks(int first, const PlanarForces& forces) {
  PlanarBlockHead* const heads = forces.heads + first;
  double* const values = values_of(forces, first);
  const double *frame_i[lane_blocks], *frame_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    frame_i[b] = reinterpret_cast<const double*>(&forces.frames[heads[b].i]);
    frame_j[b] = reinterpret_cast<const double*>(&forces.frames[heads[b].j]);
  }
  const Arms i = arms_of(values + planar_xi, values + planar_yi, frame_i);
  const Arms j = arms_of(values + planar_xj, values + planar_yj, frame_j);
  Lanes xi, yi, xj, yj, wi, wj, radius_i, radius_j;
  each_two(frame_i, frame_place, xi, yi);
  each_two(frame_j, frame_place, xj, yj);
  each_two(frame_i, frame_spin, wi, radius_i);
  each_two(frame_j, frame_spin, wj, radius_j);
  const Lanes dx = (xi - xj) + (i.x - j.x), dy = (yi - yj) + (i.y - j.y);
  const Lanes square = dx * dx + dy * dy, reach = radius_i + radius_j;
  const LaneFlags flags = flags_of(heads);
  const int touching = lane_bits(lane_less(square, reach * reach)) & flags.used;
  const int here = touching | flags.alive;
  if (here == 0) return 0;
  const int lasting = touching & flags.mature & undisturbed(heads, forces);
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
  Lanes vxi, vyi, vxj, vyj;
  each_two(frame_i, frame_velocity, vxi, vyi);
  each_two(frame_j, frame_velocity, vxj, vyj);
  const Lanes ux = (vxi - vxj) - wi * piy + wj * pjy, uy = (vyi - vyj) + wi * pix - wj * pjx;
  int sliding = flags.sliding;
  const LaneForces force = lasting_forces(first, values, overlap, ux * nx + uy * ny,
                                          uy * nx - ux * ny, lasting, sliding, forces);
  set_sliding(heads, sliding);
  double *load_i[lane_blocks], *load_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load_i[b] = forces.loads[heads[b].i].d;
    load_j[b] = forces.loads[heads[b].j].d;
  }
  const Lanes fx = force.normal * nx - force.tangential * ny;
  const Lanes fy = force.normal * ny + force.tangential * nx;
  add_loads(fx, fy, pix * fy - piy * fx, pjx * fy - pjy * fx, load_i, load_j);
  return general | force.general;
}

/// Enters the blocks from `first` on that have such lanes.
inline void enter_general(int first, int general, const PlanarForces& forces, int& entries) {
  for (int b = 0; general != 0; ++b, general >>= planar_lanes)
    if ((general & all_of_block) != 0)
      forces.general[entries++] = {first + b, general & all_of_block};
}

/// Lists where lane_blocks begin: all that touch, and those of the others in which spheres may have
/// met: since they were listed both bodies together have moved by the gap. Without branches, as
/// there is no telling which.
inline int find_awake(const PlanarForces& forces) {
  int count = 0;
  for (int first = forces.touching.first; first < forces.touching.end; first += lane_blocks)
    forces.awake[count++] = first;
  for (int first = forces.others.first; first < forces.others.end; first += lane_blocks) {
    int awake = 0;
    for (int b = 0; b < lane_blocks; ++b) {
      const PlanarBlockHead& head = forces.heads[first + b];
      const bool asleep = forces.moved[head.i] + forces.moved[head.j] < head.gap;
      awake |= (head.alive != 0) | !asleep;
    }
    forces.awake[count] = first;
    count += awake;
  }
  return count;
}

int evaluate_pairs(const PlanarForces& forces) {
  int entries = 0;
  const int count = find_awake(forces);
  for (int k = 0; k < count; ++k) {
    const int general = evaluate_blocks(forces.awake[k], forces);
    if (general != 0) enter_general(forces.awake[k], general, forces, entries);
  }
  return entries;
}

// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of contacts between bodies, the blocks of a register at a time. Contacts to which nothing
// happens in the step (they last, stick or slide on, push as before) take the fast path here, by
// the same formulas as all others, which take the general path (force_evaluator.cpp).
//
// Included by a source for one set of instructions, in a namespace of its own within an unnamed
// one, after the header of its lanes, which sets `Lanes`, `LaneMask` and how many blocks they hold,
// in one register or in two (lane_runs.h). Nothing else may be used here but arguments.h: see
// there.

#include "rodpack/contact/contact_formulas.h"

/// The types of numbers that contact_formulas.h asks for, for the contacts in a register.
struct LaneContacts {
  typedef Lanes Real;
  typedef LaneMask Mask;
};

/// The load of the cap of friction: the whole normal force or its elastic part.
template <bool whole>
struct Cap {
  typedef ElasticLoad Load;
};
template <>
struct Cap<true> {
  typedef WholeLoad Load;
};

/// A pointer to a constant structure for each block of a register.
typedef const double* const BlockConstants[lane_blocks];

/// The heads of the blocks in Lanes.
struct LaneHeads {
  LaneHeads(const PlanarForceArguments& forces, LanePlaces places) {
    for (int r = 0; r < lane_runs; ++r) {
      group_[r] = &forces.heads[places.first[r] / planar_group];
      first_[r] = places.in_group(r);
    }
  }
  /// Of block b, as PlanarGroupHeads has it.
  std::uint32_t i(int b) const { return group(b).i[in_group(b)]; }
  std::int32_t j(int b) const { return group(b).j[in_group(b)]; }
  float& gap(int b) const { return group(b).gap[in_group(b)]; }
  /// The indices of the bodies of block b; negative: a wall.
  int body_i(int b) const { return static_cast<int>(i(b) / planar_stride); }
  int body_j(int b) const { return j(b) < 0 ? j(b) : j(b) / planar_stride; }
  bool is_fresh(int b) const { return (group(b).fresh & 1 << in_group(b)) != 0; }
  /// Some of the bits that groups keep, of the lanes.
  int bits(std::uint8_t PlanarGroupHeads::*of_group) const {
    int bits = 0;
    for (int r = 0; r < lane_runs; ++r)
      bits |= (group_[r]->*of_group >> first_[r] * planar_lanes & all_of_run) << r * run_lanes;
    return bits;
  }
  void set_sliding(int sliding) const {
    for (int r = 0; r < lane_runs; ++r) {
      const int shift = first_[r] * planar_lanes, of_run = sliding >> r * run_lanes & all_of_run;
      std::uint8_t& bits = group_[r]->sliding;
      bits = static_cast<std::uint8_t>((bits & ~(all_of_run << shift)) | of_run << shift);
    }
  }

 private:
  PlanarGroupHeads& group(int b) const { return *group_[b / run_blocks]; }
  int in_group(int b) const { return first_[b / run_blocks] + b % run_blocks; }
  PlanarGroupHeads* group_[lane_runs];
  int first_[lane_runs];  // of the blocks of a run in their group
};

/// The kinematics of a body of a pair, and the load on it.
inline const double* kinematics_at(const PlanarForceArguments& forces, std::uint32_t place) {
  return reinterpret_cast<const double*>(reinterpret_cast<const char*>(forces.kinematics) +
                                         2 * static_cast<std::size_t>(place));
}
inline double* load_at(const PlanarForceArguments& forces, std::uint32_t place) {
  return reinterpret_cast<double*>(reinterpret_cast<char*>(forces.loads) + place);
}

/// Values of the blocks; the first of each run is a multiple of run_blocks.
inline LaneValues values_of(const PlanarForceArguments& forces, LanePlaces places) {
  LaneValues values;
  for (int r = 0; r < lane_runs; ++r) {
    const unsigned long group = places.first[r] / planar_group;
    values.of[r] =
        forces.values + group * forces.rows * planar_row + places.in_group(r) * planar_lanes;
  }
  return values;
}

// Whole stores: stores under a mask are slow on some processors.
inline void keep_lanes(LaneMask where, LaneValues place, Lanes x) {
  store_lanes(place, lane_choice(where, x, load_lanes(place)));
}

/// How the contacts in a register move: their normals from j to i, the levers from the centres of
/// both bodies to them, and the velocity of i's surface relative to j's, along the normal and the
/// tangent z x n.
struct LaneMotion {
  Vector2<Lanes> normal, lever_i, lever_j;
  Lanes length_i, length_j;  // of the levers from the centres of the spheres
  Lanes overlap, separation_velocity, tangential_velocity;
};

inline void set_velocities(LaneMotion& motion, Vector2<Lanes> relative) {
  motion.separation_velocity = dot(relative, motion.normal);
  motion.tangential_velocity = cross_z(motion.normal, relative);
}

/// Forces on i, along the normal and the tangent z x n; 0 in lanes that are not on the fast path.
struct LaneForces {
  Lanes normal, tangential;
  int general;         // lanes that need the general path after all
  int acts;            // the others
  int pushes, slides;  // of these, along their branches
};

#include "kernel_jumps.h"

/// Sets the constants of the contacts of the blocks from `first` on.
inline void set_constants(LanePlaces places, LaneValues values, const PlanarForceArguments& forces,
                          LastingContact<LaneContacts>& contact) {
  const double* gammas[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) gammas[b] = (values + planar_gammas).block(b);
  each_two(gammas, 0, contact.normal_damping, contact.tangential_damping);
  contact.friction = all_lanes(forces.laws->friction);
  contact.normal_stiffness = all_lanes(forces.laws->kn);
  contact.tangential_stiffness = all_lanes(forces.laws->kt);
  contact.inverse_stiffness.inverse = all_lanes(forces.laws->inverse_kt);
  if (!forces.one_law) {
    const double* laws[lane_blocks];
    for (int b = 0; b < lane_blocks; ++b)
      laws[b] = reinterpret_cast<const double*>(&forces.laws[forces.block_laws[places.block(b)]]);
    each_four(laws, 0, contact.normal_stiffness, contact.tangential_stiffness,
              contact.inverse_stiffness.inverse, contact.friction);
  }
}

/// What the dashpots of contacts with a relaxation time feel (dashpot_relaxation.h).
inline void relax(LaneValues values, const PlanarForceArguments& forces,
                  LastingContact<LaneContacts>& contact) {
  contact.separation_velocity = relaxed_velocity(load_lanes(values + forces.felt_velocity),
                                                 contact.separation_velocity, forces.kept);
  contact.tangential_velocity = relaxed_velocity(load_lanes(values + forces.velocity[0]),
                                                 contact.tangential_velocity, forces.kept);
}

/// The law for the lanes `lasting`, which have a full history, and the history brought to this
/// step. `sliding`: lanes that slid; becomes those that do. `Load`: of the cap of friction.
/// `Jumps`: what is known of the jumps of the bodies.
template <class Load, class Jumps>
inline __attribute__((always_inline)) LaneForces lasting_forces(
    LanePlaces places, LaneValues values, const LaneMotion& motion, int lasting, int& sliding,
    const Jumps& jumps, const PlanarForceArguments& forces) {
  const Lanes zero = all_lanes(0.0);
  LastingContact<LaneContacts> contact;
  set_constants(places, values, forces, contact);
  contact.overlap = motion.overlap;
  contact.separation_velocity = motion.separation_velocity;
  contact.viscoelastic_before = load_lanes(values + planar_viscoelastic);
  contact.tangential_velocity = motion.tangential_velocity;
  contact.spring_before = load_lanes(values + planar_spring);
  contact.slid = lanes_of_bits(sliding);
  Lanes velocity[max_multistep_order];
  for (int k = 0; k < forces.order; ++k) velocity[k] = load_lanes(values + forces.velocity[k]);
  Lanes before = contact.viscoelastic_before;
  const LaneMask unfit = follow_jumps<Load>(jumps, values, forces, contact, before, velocity);
  contact.spring = contact.spring_before;
  for (int k = 0; k < forces.order; ++k) contact.spring += forces.spring_weights[k] * velocity[k];
  // Leapfrog shows the velocity of half the step, where the midpoint rule wants it.
  if (forces.order == 0) contact.spring += forces.dt * motion.tangential_velocity;
  if (forces.kept > 0.0) relax(values, forces, contact);
  const LastingForce<LaneContacts> force = lasting_force<Load>(contact, zero, forces.follows);

  LaneForces result;
  result.general = forces.follows ? lane_bits(force.changes | unfit) & lasting : 0;
  result.acts = lasting;
  // A branch, since it is hardly ever taken: else the forces would wait for what it asks.
  if (__builtin_expect(result.general != 0, 0)) {
    result.acts = lasting & ~result.general;
    __asm__ volatile("");  // the compiler would do without the branch
  }
  const LaneMask acts = lanes_of_bits(result.acts);
  result.pushes = lane_bits(force.pushes);
  result.slides = lane_bits(force.slides);
  result.normal = lane_choice(acts, force.normal, zero);
  result.tangential = lane_choice(acts, force.tangential, zero);
  keep_lanes(acts, values + planar_spring, force.spring);
  if (Load::damped) keep_lanes(acts, values + forces.earlier, before);
  keep_lanes(acts, values + planar_viscoelastic, force.viscoelastic);
  if (Jumps::any)
    for (int k = 0; k < forces.slots; ++k)
      keep_lanes(acts, values + forces.velocity[k], velocity[k]);
  if (forces.kept > 0.0)
    keep_lanes(acts, values + forces.felt_velocity, contact.separation_velocity);
  keep_lanes(acts, values + forces.newest, contact.tangential_velocity);
  sliding = lane_bits(lane_choice(acts, force.slides, contact.slid));
  return result;
}

/// How the bodies on a side of the contacts in a register are placed and move, and where the
/// centres of their spheres are, from those of the bodies.
struct LaneBody {
  Lanes x, y, velocity_x, velocity_y, spin, radius;
  Vector2<Lanes> arm;
};
/// `offset_x`, `offset_y`: of the spheres, in the frames of the bodies.
inline LaneBody bodies_of(BlockConstants& body, LaneValues offset_x, LaneValues offset_y) {
  LaneBody of;
  Lanes cosine, sine;
  each_four(body, body_pose, of.x, of.y, cosine, sine);
  each_four(body, body_motion, of.velocity_x, of.velocity_y, of.spin, of.radius);
  of.arm = turned<Lanes>(cosine, sine, {load_lanes(offset_x), load_lanes(offset_y)});
  return of;
}

/// Adds the forces `on_i` of the contacts in a register, and the weights of those that act, to the
/// loads on their bodies.
inline __attribute__((always_inline)) void add_forces(const LaneMotion& motion, Vector2<Lanes> on_i,
                                                      int acts, LaneValues values,
                                                      double* const (&load_i)[lane_blocks],
                                                      double* const (&load_j)[lane_blocks],
                                                      const PlanarForceArguments& forces) {
  const Lanes about_i = cross_z(motion.lever_i, on_i), about_j = cross_z(motion.lever_j, on_i);
  if (forces.weight_i == 0) {
    add_loads(on_i.x, on_i.y, about_i, about_j, load_i, load_j);
    return;
  }
  const Lanes zero = all_lanes(0.0);
  const LaneMask act = lanes_of_bits(acts);
  const Lanes weight_i = lane_choice(act, load_lanes(values + forces.weight_i), zero),
              weight_j = lane_choice(act, load_lanes(values + forces.weight_j), zero);
  add_weighted_loads(on_i.x, on_i.y, about_i, about_j, weight_i, weight_j, load_i, load_j);
}

/// Sets how far the bodies of each block may travel before its spheres, which are apart now, can
/// meet: what they have travelled, and the gap; not of fresh ones, as the frame of a body may have
/// moved in the steps that it is ahead of the other. Of the sums of the radii `reach` it takes off
/// a part that no rounding of the positions reaches in the life of a list.
inline void set_gaps(const LaneHeads& heads, Lanes square, Lanes reach,
                     const PlanarForceArguments& forces) {
  Lanes r, inverse;
  lane_roots(square, r, inverse);
  alignas(64) double gaps[lane_blocks * planar_lanes];
  LaneValues to;
  for (int run = 0; run < lane_runs; ++run) to.of[run] = gaps + run * run_lanes;
  store_lanes(to, lane_choice(lanes_of_bits(heads.bits(&PlanarGroupHeads::used)),
                              r - (1.0 + 1e-9) * reach, all_lanes(1e30)));
  for (int b = 0; b < lane_blocks; ++b) {
    if (heads.is_fresh(b)) continue;
    const double *const gap = gaps + b * planar_lanes, smallest = gap[0] < gap[1] ? gap[0] : gap[1];
    const double way =
        forces.travelled[heads.body_i(b)] + forces.travelled[heads.body_j(b)] + smallest;
    heads.gap(b) = static_cast<float>((1.0 - 1e-7) * way);  // never rounded up
  }
}

/// Evaluates the lasting contacts of the blocks from `first` on; returns the lanes that need the
/// general path.
template <class Load, class Jumps>
inline __attribute__((always_inline)) int evaluate_blocks(LanePlaces places,
                                                          const PlanarForceArguments& forces) {
  const LaneHeads heads(forces, places);
  const LaneValues values = values_of(forces, places);
  const double *body_i[lane_blocks], *body_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    body_i[b] = kinematics_at(forces, heads.i(b));
    body_j[b] = kinematics_at(forces, heads.j(b));
  }
  const LaneBody i = bodies_of(body_i, values + planar_xi, values + planar_yi);
  const LaneBody j = bodies_of(body_j, values + planar_xj, values + planar_yj);
  const Lanes dx = (i.x - j.x) + (i.arm.x - j.arm.x), dy = (i.y - j.y) + (i.arm.y - j.arm.y);
  const Lanes square = dx * dx + dy * dy, reach = i.radius + j.radius;
  const int touching =
      lane_bits(lane_less(square, reach * reach)) & heads.bits(&PlanarGroupHeads::used);
  const int here = touching | heads.bits(&PlanarGroupHeads::alive);
  if (here == 0) {
    set_gaps(heads, square, reach, forces);
    return 0;
  }
  const int lasting = touching & heads.bits(&PlanarGroupHeads::full_history);
  const int general = here & ~lasting;
  if (lasting == 0) return general;

  Lanes r, inverse;
  lane_roots(square, r, inverse);
  LaneMotion motion;
  motion.normal = {dx * inverse, dy * inverse};
  motion.overlap = reach - r;
  motion.length_i = lever_length(i.radius, motion.overlap);
  motion.length_j = lever_length(j.radius, motion.overlap);
  motion.lever_i = lever_in_plane(i.arm, motion.length_i, motion.normal);
  motion.lever_j = lever_in_plane(j.arm, -motion.length_j, motion.normal);
  const Vector2<Lanes> of_centres = {i.velocity_x - j.velocity_x, i.velocity_y - j.velocity_y};
  set_velocities(motion, velocity_at(velocity_at(of_centres, i.spin, motion.lever_i), -j.spin,
                                     motion.lever_j));
  int sliding = heads.bits(&PlanarGroupHeads::sliding);
  const Jumps jumps = Jumps::of(heads, values, motion, forces);
  const LaneForces force =
      lasting_forces<Load>(places, values, motion, lasting, sliding, jumps, forces);
  heads.set_sliding(sliding);
  double *load_i[lane_blocks], *load_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load_i[b] = load_at(forces, heads.i(b));
    load_j[b] = load_at(forces, heads.j(b));
  }
  add_forces(motion, in_space(motion.normal, force.normal, force.tangential), force.acts, values,
             load_i, load_j, forces);
  report_jumps(heads, motion, {of_centres, i.arm, j.arm, i.spin, j.spin, inverse}, values, force,
               jumps, forces);
  return general | force.general;
}

/// The same of blocks with a body that had an event in the step before: a function of its own, so
/// that the others do not pay for its registers.
template <class Load>
__attribute__((noinline)) int evaluate_jumped_blocks(LanePlaces places,
                                                     const PlanarForceArguments& forces) {
  return evaluate_blocks<Load, LaneJumps>(places, forces);
}

/// Enters the blocks from `first` on that have lanes for the general path.
inline void enter_general(LanePlaces places, int general, const PlanarForceArguments& forces,
                          int& entries) {
  for (int b = 0; general != 0; ++b, general >>= planar_lanes)
    if ((general & all_of_block) != 0)
      forces.general[entries++] = {places.block(b), general & all_of_block};
}

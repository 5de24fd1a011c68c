// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of contacts between bodies, the blocks of a register at a time. Contacts to which nothing
// happens in the step (they last, stick or slide on, push as before) take the fast path here, by
// the same formulas as all others, which take the general path (force_evaluator.cpp).
//
// Included once by a source for one set of instructions, in an unnamed namespace, after the header
// of its lanes, which sets `Lanes`, `LaneMask` and how many blocks they hold. Nothing else may be
// used here but arguments.h: see there.

#include "rodpack/contact/contact_formulas.h"

/// The types of numbers that contact_formulas.h asks for, for the contacts in a register.
struct LaneContacts {
  typedef Lanes Real;
  typedef LaneMask Mask;
};

constexpr int all_of_block = (1 << planar_lanes) - 1;  // bits of its lanes

/// A pointer to a constant structure for each block of a register.
typedef const double* const BlockConstants[lane_blocks];

/// Values of the blocks from `first` on, which is a multiple of lane_blocks.
inline double* values_of(const PlanarForceArguments& forces, int first) {
  const long group = first / planar_group;
  return forces.values + group * forces.rows * planar_row + first % planar_group * planar_lanes;
}

// Whole stores: stores under a mask are slow on some processors.
inline void keep_lanes(LaneMask where, double* place, Lanes x) {
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
inline void set_constants(int first, const double* values, const PlanarForceArguments& forces,
                          LastingContact<LaneContacts>& contact) {
  const double* gammas[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) gammas[b] = values + planar_gammas + b * planar_lanes;
  each_two(gammas, 0, contact.normal_damping, contact.tangential_damping);
  contact.friction = all_lanes(forces.laws->friction);
  contact.normal_stiffness = all_lanes(forces.laws->kn);
  contact.tangential_stiffness = all_lanes(forces.laws->kt);
  contact.inverse_stiffness.inverse = all_lanes(forces.laws->inverse_kt);
  if (!forces.one_law) {
    const double* laws[lane_blocks];
    for (int b = 0; b < lane_blocks; ++b)
      laws[b] = reinterpret_cast<const double*>(&forces.laws[forces.block_laws[first + b]]);
    each_four(laws, 0, contact.normal_stiffness, contact.tangential_stiffness,
              contact.inverse_stiffness.inverse, contact.friction);
  }
}

/// What the dashpots of contacts with a relaxation time feel (dashpot_relaxation.h).
inline void relax(const double* values, const PlanarForceArguments& forces,
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
inline LaneForces lasting_forces(int first, double* values, const LaneMotion& motion, int lasting,
                                 int& sliding, const Jumps& jumps,
                                 const PlanarForceArguments& forces) {
  const Lanes zero = all_lanes(0.0);
  LastingContact<LaneContacts> contact;
  set_constants(first, values, forces, contact);
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

  LaneMask acts = lanes_of_bits(lasting);
  LaneForces result;
  result.general = 0;
  if (forces.follows) {
    const LaneMask leaves = force.changes | unfit;
    result.general = lane_bits(leaves & acts);
    acts = acts & ~leaves;
  }
  result.acts = lasting & ~result.general;
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
inline LaneBody bodies_of(BlockConstants& body, const double* offset_x, const double* offset_y) {
  LaneBody of;
  Lanes cosine, sine;
  each_four(body, body_pose, of.x, of.y, cosine, sine);
  each_four(body, body_motion, of.velocity_x, of.velocity_y, of.spin, of.radius);
  of.arm = turned<Lanes>(cosine, sine, {load_lanes(offset_x), load_lanes(offset_y)});
  return of;
}

/// The bits of PlanarBlockHead, with the lanes of the blocks side by side. full_history: lanes
/// whose contact has lasted until its history is full.
struct LaneFlags {
  int used, alive, full_history, sliding;
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

/// Adds the forces `on_i` of the contacts in a register, and the weights of those that act, to the
/// loads on their bodies.
inline void add_forces(const LaneMotion& motion, Vector2<Lanes> on_i, int acts,
                       const double* values, double* const (&load_i)[lane_blocks],
                       double* const (&load_j)[lane_blocks], const PlanarForceArguments& forces) {
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

/// Evaluates the lasting contacts of the blocks from `first` on; returns the lanes that need the
/// general path.
template <class Load, class Jumps>
inline __attribute__((always_inline)) int evaluate_blocks(int first,
                                                          const PlanarForceArguments& forces) {
  PlanarBlockHead* const heads = forces.heads + first;
  double* const values = values_of(forces, first);
  const double *body_i[lane_blocks], *body_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    body_i[b] = reinterpret_cast<const double*>(&forces.kinematics[heads[b].i]);
    body_j[b] = reinterpret_cast<const double*>(&forces.kinematics[heads[b].j]);
  }
  const LaneBody i = bodies_of(body_i, values + planar_xi, values + planar_yi);
  const LaneBody j = bodies_of(body_j, values + planar_xj, values + planar_yj);
  const Lanes dx = (i.x - j.x) + (i.arm.x - j.arm.x), dy = (i.y - j.y) + (i.arm.y - j.arm.y);
  const Lanes square = dx * dx + dy * dy, reach = i.radius + j.radius;
  const LaneFlags flags = flags_of(heads);
  const int touching = lane_bits(lane_less(square, reach * reach)) & flags.used;
  const int here = touching | flags.alive;
  if (here == 0) return 0;
  const int lasting = touching & flags.full_history;
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
  int sliding = flags.sliding;
  const Jumps jumps = Jumps::of(heads, values, motion, forces);
  const LaneForces force =
      lasting_forces<Load>(first, values, motion, lasting, sliding, jumps, forces);
  set_sliding(heads, sliding);
  double *load_i[lane_blocks], *load_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load_i[b] = forces.loads[heads[b].i].d;
    load_j[b] = forces.loads[heads[b].j].d;
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
__attribute__((noinline)) int evaluate_jumped_blocks(int first,
                                                     const PlanarForceArguments& forces) {
  return evaluate_blocks<Load, LaneJumps>(first, forces);
}

/// Enters the blocks from `first` on that have lanes for the general path.
inline void enter_general(int first, int general, const PlanarForceArguments& forces,
                          int& entries) {
  for (int b = 0; general != 0; ++b, general >>= planar_lanes)
    if ((general & all_of_block) != 0)
      forces.general[entries++] = {first + b, general & all_of_block};
}

/// Lists where lane_blocks begin: all that touch, and those of the others in which spheres may have
/// met: since they were listed both bodies together have moved by the gap. Without branches, as
/// there is no telling which.
inline int find_awake(const PlanarForceArguments& forces) {
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

template <class Load>
int evaluate_pairs(const PlanarForceArguments& forces) {
  int entries = 0;
  const int count = find_awake(forces);
  for (int k = 0; k < count; ++k) {
    const int first = forces.awake[k];
    const int general = have_jumped(forces.heads + first, forces)
                            ? evaluate_jumped_blocks<Load>(first, forces)
                            : evaluate_blocks<Load, NoJumps>(first, forces);
    if (general != 0) enter_general(first, general, forces, entries);
  }
  return entries;
}

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_ARGUMENTS_H
#define RODPACK_PLANAR_ARGUMENTS_H

#include <cstddef>
#include <cstdint>

#include "block_layout.h"
#include "kinematics.h"
#include "range.h"
#include "rodpack/contact/planar_jump.h"
#include "rodpack/motion/multistep.h"
#include "rodpack/planar/instructions.h"

namespace rodpack {

// What the SIMD loops (kernel.h, kernel_motion.h) are given. It is pointers alone: these loops are
// compiled for one set of processor instructions each, and a member function or template that they
// compiled with it could take the place of everybody's.

/// A vector with components along x, along y and about z; the fourth fills the register, and is
/// unused but where a comment says so.
struct alignas(32) PlanarVector {
  double d[4];
};

/// Sums of the moments of the changes of the forces on a body since the events of its contacts in
/// the last step, and of the torques about its centre of mass (ChangeMoments).
struct PlanarChangeSums {
  PlanarVector now, rate, impulse, impulse_integral;
};
/// What is known of the changes of a body: there are some; not all forces grew from 0.
enum PlanarChangeFlag { planar_changed = 1, planar_jumps = 2 };

/// A block of which some lanes, one bit for each, need the general path.
struct PlanarGeneralBlock {
  int place, lanes;
};

/// A wall: the points at which x along_x + y along_y is its position; free_side as in PlanarWall.
struct PlanarWallLine {
  double along_x, along_y, position, free_side;
};

/// Arguments of the loops over blocks, which evaluate the contacts on the fast path.
struct PlanarForceArguments {
  // Blocks, their numbers (block_layout.h) and the indices of their constants.
  PlanarGroupHeads* heads;
  double* values;
  const int* block_laws;
  unsigned rows;  // of the numbers of a group
  // The blocks to evaluate, in whole groups. Those of `touching` had contacts when they were
  // sorted, so that it is not worth the time to ask whether their spheres can have met.
  PlanarRange touching, others;
  int spare;                          // the first block of a group of holes
  int slots;                          // tangential velocities that a contact remembers
  int velocity[max_multistep_order];  // offsets of these, k + 1 steps back
  int newest;                         // offset of the tangential velocity of this step
  int earlier;                        // of the normal force two steps back, under a WholeLoad
  int felt_velocity;                  // of what the normal dashpot felt, if kept > 0
  int weight_i, weight_j;             // of the contacts' weights; 0 without mass scaling
  // Bodies.
  const PlanarKinematics* kinematics;
  const double* travelled;  // paths since they were listed, upper bounds, m
  PlanarVector* loads;  // the forces are added to them, with mass scaling the weights to the fourth
  // Whether a body had an event in the step before (null: none had), and what it did to its motion;
  // what changes in this step, and by how much.
  const std::uint8_t* jumped;
  const PlanarJump* jumps;
  std::uint8_t* changed;
  PlanarChangeSums* changes;
  // The contact law.
  const PlanarLawConstants* laws;
  bool one_law;
  const PlanarWallLine* walls;
  int order;  // 0: leapfrog
  double dt;
  double kept;                                 // of dashpot_relaxation.h; 0: dashpots do not relax
  double spring_weights[max_multistep_order];  // of the velocities in the spring, times dt, s
  bool follows;                                // whether events are corrected for
  // Room for an entry for each block.
  PlanarGeneralBlock* general;
  int *awake, *awake_jumped;
};

/// Reference state of a body: where its neighbour list was made the last time, and with which skin.
struct PlanarReference {
  double x, y, cosine, sine;
  double reach;  // distance of its farthest point from the centre of mass, m
  double skin;   // m
};

// Where registers find four numbers of a body, counted in doubles.
constexpr int doubles_before(std::size_t bytes) { return static_cast<int>(bytes / sizeof(double)); }
enum PlanarOffset {
  body_pose = doubles_before(offsetof(PlanarKinematics, x)),          // y, cosine and sine
  body_motion = doubles_before(offsetof(PlanarKinematics, velocity))  // and radius
};
static_assert(offsetof(PlanarLawConstants, kn) == 0 && offsetof(PlanarLawConstants, kt) == 8 &&
                  offsetof(PlanarLawConstants, inverse_kt) == 16 &&
                  offsetof(PlanarLawConstants, friction) == 24,
              "kernel.h reads laws as four doubles in this order");
static_assert(offsetof(PlanarWallLine, along_x) == 0 && offsetof(PlanarWallLine, along_y) == 8 &&
                  offsetof(PlanarWallLine, position) == 16 &&
                  offsetof(PlanarWallLine, free_side) == 24,
              "kernel_walls.h reads walls as four doubles in this order");
static_assert(sizeof(PlanarVector) == planar_stride &&
                  sizeof(PlanarKinematics) == 2 * planar_stride,
              "kernel.h finds loads and kinematics by the distance of vectors");

constexpr int body_lanes = 8;  // bodies whose references lie side by side

/// Reference states of so many bodies, side by side, at some step, and what they move by in each.
/// `strain` (m) is to be added to the motion that is seen from them. A lane without a body has an
/// infinite skin.
struct alignas(64) PlanarReferenceLanes {
  double x[body_lanes], y[body_lanes], cosine[body_lanes], sine[body_lanes];
  double reach[body_lanes], skin[body_lanes], strain[body_lanes];
  double step_x[body_lanes], step_y[body_lanes], strain_step[body_lanes];
};

/// Arguments of the loop that advances bodies by a step.
struct PlanarAdvanceArguments {
  PlanarRange bodies;  // `first` is a multiple of body_lanes
  int order;           // of the formula: 1 for leapfrog, which has its weights
  bool leapfrog;       // positions follow from the velocities after the step
  double dt;
  PlanarKinematics* kinematics;
  // Become the bodies' weights, to which the forces of the next step are added; the fourth, the
  // contacts' weights of mass scaling, becomes 0.
  PlanarVector* loads;
  PlanarVector gravity;           // m/s^2
  const PlanarVector* inertia;    // 1/mass, 1/mass, 1/moment, mass
  double inverse_square_scaling;  // 1/S^2 of mass_scaling.h; 0: none
  PlanarVector *past_velocity[max_multistep_order], *past_acceleration[max_multistep_order];
  signed char* evaluations;  // counted up to order + 1
  bool any_young;            // whether a body has fewer
  double velocity_weights[max_multistep_order];
  double force_weights[max_multistep_order + 2][max_multistep_order];  // by number of evaluations
  const PlanarReferenceLanes* references;
  double steps_since;  // made with this one, since the reference states were those
  int steps_ahead;     // a body that will leave its skin in so many further steps is listed now
  // Upper bounds, m, with room for whole registers: how far from the reference position each body
  // is; the path since it was listed, to which that of this step is added.
  double *moved, *travelled;
  int* to_list;  // becomes the bodies to be listed anew; room for all
};

/// The SIMD loops for one set of processor instructions.
struct PlanarKernel {
  int (*pairs)(const PlanarForceArguments&);      // returns the number of entries in `general`
  int (*walls)(const PlanarForceArguments&);      // the same
  int (*advance)(const PlanarAdvanceArguments&);  // returns the number of entries in `to_list`
};

/// Forces under the cap of friction that PlanarSettings::total_force_cap says.
PlanarKernel planar_kernel_baseline(bool total_force_cap);
PlanarKernel planar_kernel_avx2(bool total_force_cap);
PlanarKernel planar_kernel_avx512(bool total_force_cap);

/// @throws std::invalid_argument if the processor or the compiler does not support them.
PlanarKernel planar_kernel(PlanarInstructions instructions, bool total_force_cap);

}  // namespace rodpack

#endif

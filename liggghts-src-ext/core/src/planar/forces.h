// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_FORCES_H
#define RODPACK_PLANAR_FORCES_H

#include "block_layout.h"
#include "contact.h"
#include "parts.h"
#include "rodpack/motion/multistep.h"
#include "rodpack/planar/instructions.h"

namespace rodpack {

/// x, y, about z, unused: one register.
struct alignas(32) PlanarVector {
  double d[4];
};

// What the sources for one set of instructions (planar_kernel.h) see of a scene: pointers only,
// since a function of a class or template that they compiled could take the place of everybody's.

/// A block of which some lanes need the general way.
struct PlanarGeneral {
  int place, lanes;  // bit per lane
};

/// A wall: those (x, y) at which x along_x + y along_y is its position; free_side as in PlanarWall.
struct PlanarWallLine {
  double along_x, along_y, position, free_side;
};

/// Blocks, and what their contacts need. Those on the short way are evaluated.
struct PlanarForces {
  // blocks
  PlanarBlockHead* heads;
  double* values;
  const int* block_laws;
  int rows;
  PlanarRange touching, others;       // whole groups; touching: not worth a look at their gap
  int velocity[max_multistep_order];  // places of those k + 1 steps back in them
  int newest;                         // of that of now
  // bodies
  const PlanarFrame* frames;
  const double* moved;  // at most, since it was listed, m
  PlanarVector* loads;
  const char* jumped;  // in the step before; null: none
  // law
  const PlanarLawConstants* laws;
  bool one_law;
  const PlanarWallLine* walls;
  int order;
  double spring_weights[max_multistep_order];  // times dt
  bool follows;                                // events
  PlanarGeneral* general;                      // room for all blocks
  int* awake;                                  // room for all blocks
};

/// Where a body was listed.
struct PlanarListed {
  double x, y, cosine, sine;
  double reach;  // of its farthest point from the centre of mass, m
  double skin;   // that it was listed with
};

constexpr int body_lanes = 4;  // bodies that move at a time

/// The same for these; one that is not there has an endless skin.
struct alignas(64) PlanarListedLanes {
  double x[body_lanes], y[body_lanes], cosine[body_lanes], sine[body_lanes];
  double reach[body_lanes], skin[body_lanes];
};

/// Bodies, and what their motion needs.
struct PlanarMotions {
  PlanarRange bodies;  // from the first of a register on
  int order;
  double dt;
  PlanarFrame* frames;
  PlanarVector* loads;  // become weights, for the forces of the next evaluation
  PlanarVector gravity;
  const PlanarVector* inertia;  // 1/mass, 1/mass, 1/moment, mass
  PlanarVector *past_velocity[max_multistep_order], *past_acceleration[max_multistep_order];
  signed char* evaluations;
  double velocity_weights[max_multistep_order];
  double force_weights[max_multistep_order + 2][max_multistep_order];  // after so many evaluations
  const PlanarListedLanes* listed;
  int steps_ahead;  // a body that is about to leave its skin in so many further steps is listed now
  double* moved;    // room for whole lanes
  int* to_list;     // room for all bodies
};

/// The functions of one set of instructions.
struct PlanarKernel {
  int (*pairs)(const PlanarForces&);  // return the number of entries in `general`
  int (*walls)(const PlanarForces&);
  int (*advance)(const PlanarMotions&);  // returns the number of entries in `to_list`
};

PlanarKernel planar_kernel_baseline();
PlanarKernel planar_kernel_avx2();
PlanarKernel planar_kernel_avx512();

/// @throws std::invalid_argument if the processor or the compiler does not support them.
PlanarKernel planar_kernel(PlanarInstructions instructions);

}  // namespace rodpack

#endif

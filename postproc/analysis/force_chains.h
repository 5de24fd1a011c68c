// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_FORCE_CHAINS_H
#define RODPACK_ANALYSIS_FORCE_CHAINS_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// What two particles, or a particle and a wall, exert on each other: the sum over their sphere
/// contacts, between the centres of mass. At a wall the line ends in the middle of the contact
/// points, weighted by their forces; walls are told apart by their normals.
struct ForceLine {
  double x1, y1, x2, y2;  // m, in the periodic images that touch
  double force;           // magnitude, N
  long particle, other;   // ids; other: 0 at a wall
  std::array<double, 2>
      wall_normal;  // at a wall, from there to the particle, to hundredths; else 0
};

/// Sums up one line per touching pair, of a frame with the columns `body_i body_j wall fx fy fz bix
/// biy bjx bjy nx ny nz`. @throws DataError when a column is missing, TooFewParticles when there
/// are no contacts.
std::vector<ForceLine> force_lines(const Frame& contacts);

}  // namespace rodpack

#endif

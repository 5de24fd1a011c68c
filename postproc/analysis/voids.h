// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_VOIDS_H
#define RODPACK_ANALYSIS_VOIDS_H

#include <vector>

#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// A row of a void's area, for drawing: from x_low to x_high, `VoidSearch::step` high around y, m.
struct VoidRow {
  double y, x_low, x_high;
};

/// A connected region of the plane that a disc of the probe's diameter covers from wherever it has
/// room: one into which a sphere of that size fits without overlapping a particle, a wall or the
/// surface. Narrower gaps between particles are not part of it.
struct Void {
  double x = 0, y = 0;  // centre of its area, m
  double area = 0;      // m^2
  // More than half of its area lies in the hollow of one curved particle: between the inside of its
  // arc and the chord of its end spheres' centres, moved away from the arc by a sphere's radius.
  bool in_hollow = false;
  std::vector<VoidRow> rows;
};

struct VoidSearch {
  double probe = 0;    // diameter of the disc, m
  double step = 0;     // of the raster, m
  double surface = 0;  // y that no void reaches above, m
};

/// Finds the voids of a frame of spheres (columns `body x y radius`), on a raster: areas are exact
/// to about the void's circumference times half a step. Walls as given, a missing side wall or
/// floor ends the search too. They come in the order of their lowest rows. @throws DataError when a
/// column is missing or a length is not positive.
std::vector<Void> find_voids(const Frame& spheres, const Walls& walls, const VoidSearch& search);

}  // namespace rodpack

#endif

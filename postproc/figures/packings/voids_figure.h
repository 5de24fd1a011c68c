// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PACKINGS_VOIDS_FIGURE_H
#define RODPACK_FIGURES_PACKINGS_VOIDS_FIGURE_H

#include <array>
#include <string>
#include <vector>

#include "analysis/voids.h"

namespace rodpack {

/// Draws the particles in a window (xlo, xhi, ylo, yhi, m) and marks the voids, those in the hollow
/// of a curved particle in a colour of their own: `stem`.svg and `stem`.png. `diameter`: d_p, m.
/// @throws DataError when a column is missing or drawing fails.
void draw_voids(const Frame& spheres, const std::vector<Void>& voids, const VoidSearch& search,
                const Walls& walls, const std::array<double, 4>& window, double diameter,
                const std::string& stem);

}  // namespace rodpack

#endif

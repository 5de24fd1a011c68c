// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SOLID_FRACTION_FIGURE_H
#define RODPACK_FIGURES_SOLID_FRACTION_FIGURE_H

#include <string>

#include "analysis/solid_fraction.h"

namespace rodpack {

/// Draws the profile over the height: `stem`.png and `stem`.svg. Surface and what the kernel
/// averages over empty space are marked, and so is the area that the particles cover below the
/// surface over that of the bed; of the means, the one that the kernel does not spoil is named.
/// `particle_diameter`: d_p, m; `floor`: y of the floor, m. @throws DataError when that fails.
void plot_solid_fraction(const SolidFraction& field, double particle_diameter, double floor,
                         const std::string& stem);

}  // namespace rodpack

#endif

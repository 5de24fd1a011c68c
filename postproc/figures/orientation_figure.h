// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_ORIENTATION_FIGURE_H
#define RODPACK_FIGURES_ORIENTATION_FIGURE_H

#include <string>

#include "analysis/orientation.h"

namespace rodpack {

/// Draws the histogram over gamma: `stem`.png and `stem`.svg. @throws DataError when that fails.
void plot_orientation_linear(const OrientationDistribution& distribution, const std::string& stem);

/// Draws the rose diagram, sectors of equal angle whose radius is the density: `stem`.png and
/// `stem`.svg. @throws DataError when that fails.
void plot_orientation_polar(const OrientationDistribution& distribution, const std::string& stem);

}  // namespace rodpack

#endif

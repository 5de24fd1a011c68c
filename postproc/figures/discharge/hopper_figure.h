// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_DISCHARGE_HOPPER_FIGURE_H
#define RODPACK_FIGURES_DISCHARGE_HOPPER_FIGURE_H

#include <string>
#include <vector>

#include "analysis/discharge/hopper_factor.h"

namespace rodpack {

/// Draws the factors with standard errors over the half angle, a symbol per width, with Rose and
/// Tanaka's law for 45 degrees of the flow's boundary, into `stem`.png and .svg.
void plot_hopper_factors(const std::vector<HopperFactor>& factors, const std::string& stem);

}  // namespace rodpack

#endif

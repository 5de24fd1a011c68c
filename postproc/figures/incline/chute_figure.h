// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_INCLINE_CHUTE_FIGURE_H
#define RODPACK_FIGURES_INCLINE_CHUTE_FIGURE_H

#include <string>
#include <vector>

#include "analysis/incline/chute_profile.h"

namespace rodpack {

/// Draws velocity, solid fraction and stresses with the loads that they balance, over the height
/// above the base, into `stem`.png and .svg.
void plot_chute(const ChuteProfile& profile, const std::string& stem);

/// Friction -xy/yy and solid fraction of flows over their inertial number, into `stem`.png and
/// .svg; vectors of equal length.
void plot_rheology(const std::vector<double>& inertial_number, const std::vector<double>& friction,
                   const std::vector<double>& solid_fraction, const std::string& stem);

}  // namespace rodpack

#endif

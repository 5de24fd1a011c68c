// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_VERTICAL_PROFILE_FIGURE_H
#define RODPACK_FIGURES_SPACE_VERTICAL_PROFILE_FIGURE_H

#include <string>

#include "analysis/space/vertical_profile.h"

namespace rodpack {

/// Draws stresses over depth with Janssen's law, unless null, `stem`.png and .svg. What lies within
/// 3 w of floor or surface, where the kernel reaches beyond them, is shaded.
/// @throws DataError as draw_figure().
void plot_vertical_stresses(const VerticalProfile& profile, const JanssenFit* fit,
                            const std::string& stem);
/// The same of the solid fraction over height.
void plot_layers(const VerticalProfile& profile, const std::string& stem);

}  // namespace rodpack

#endif

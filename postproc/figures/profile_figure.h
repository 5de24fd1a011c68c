// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PROFILE_FIGURE_H
#define RODPACK_FIGURES_PROFILE_FIGURE_H

#include <string>

#include "analysis/janssen_fit.h"
#include "analysis/pressure_profile.h"

namespace rodpack {

/// Draws P_0 over the depth from surface to floor, with the fit unless it is null, depths at which
/// the kernel reaches beyond the bed in grey: `stem`.png and `stem`.svg. @throws
/// DataError when that fails.
void plot_profile(const PressureProfile& profile, const JanssenFit* fit, const std::string& stem);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_PRESSURE_H
#define RODPACK_STUDY_PRESSURE_H

#include <optional>
#include <string>

#include "analysis/janssen_fit.h"
#include "ensemble/ensemble.h"

namespace rodpack {

/// The mean P_0(h) of a case, for the fit of Janssen's law: depth in m, w = 3 AR d_p.
/// @return none when the case has no such curve or its parameters lack aspect_ratio or
/// particle_diameter_m.
std::optional<PressureProfile> mean_profile(const EnsembleCase& each);

/// Fits Janssen's law to the mean P_0(h) of a case; none when there is no curve or no fit, with the
/// reason in `why`.
std::optional<JanssenFit> janssen_of(const EnsembleCase& each, std::string& why);

}  // namespace rodpack

#endif

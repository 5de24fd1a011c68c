// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_CASE_MEAN_H
#define RODPACK_ENSEMBLE_CASE_MEAN_H

#include "ensemble/cases.h"
#include "ensemble/ensemble.h"

namespace rodpack {

/// Means over the repetitions of a case of what their analyses say: every number of summary.json
/// but standard errors, every curve (read_curves()), and the cost of the runs. Quantities that the
/// runs have only together get their errors from bootstrap_over_runs():
/// - nematic_order_S2_pooled, director_pooled_deg: of the particles of all runs together;
/// - rdf_peak_r_over_dp, rdf_peak_g: the highest peak of the mean G(r), the top of the parabola
///   through the highest bin and its neighbours;
/// - janssen_pressure_of_mean_profile_N_m, janssen_depth_of_mean_profile_over_dp: Janssen's law
///   fitted to the mean profile, where it saturates; janssen_depth_over_fitted_depth: h_c over the
///   depth of the fit, below 1 if it does.
/// A number that no run has is left out.
/// @throws DataError naming the run whose analysis is not current or does not fit the others.
EnsembleCase mean_over_case(const CaseRuns& one);

}  // namespace rodpack

#endif

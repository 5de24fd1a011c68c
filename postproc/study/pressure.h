// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_PRESSURE_H
#define RODPACK_STUDY_PRESSURE_H

#include <optional>
#include <string>
#include <vector>

#include "analysis/janssen_fit.h"
#include "ensemble/statistics.h"

namespace rodpack {

/// Fits Janssen's law to the mean P_0(h) of a case; none when there is no curve or no fit, with the
/// reason in `why`.
std::optional<JanssenFit> janssen_of(const EnsembleCase& each, std::string& why);

/// The depth from which the floor is nearer than 3 w, in d_p: what lies below is not compared. None
/// without a profile, or in a bed lower than that; `each` may be null.
std::optional<double> usable_depth(const EnsembleCase* each);

/// Mean of P_0 over the depths `from` to `to`, d_p, that all runs reach, N/m: near the highest
/// surface the lower beds have no value yet. n is 0 when there is no depth.
EnsembleMean mean_pressure(const EnsembleCase& each, double from, double to);

/// A weighted sum of such means; its error knows that depths of a run share its noise
/// (sum_over_ranges()).
EnsembleMean sum_of_pressures(const EnsembleCase& each, const std::vector<RangeTerm>& terms);

/// The mean pressures over theta (0: straight, smooth) of one aspect ratio, in the lower half of
/// the depths that all cases have.
struct PressureOverTheta {
  std::vector<double> theta;  // degrees
  std::vector<EnsembleMean> pressure;
  double from = 0, to = 0;  // depths, d_p
};
PressureOverTheta pressure_over_theta(const Ensemble& ensemble, double aspect_ratio);

}  // namespace rodpack

#endif

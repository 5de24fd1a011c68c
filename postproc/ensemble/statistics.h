// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_STATISTICS_H
#define RODPACK_ENSEMBLE_STATISTICS_H

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "ensemble/ensemble.h"

namespace rodpack {

/// One value a run; none where a run has none, as the solid fraction of a bed that is too low.
using ValuesOfRuns = std::vector<std::optional<double>>;

/// Returns the mean over the runs that have a value and its standard error, the standard deviation
/// (of n - 1 degrees of freedom) over sqrt(n). Runs are independent, so this holds for each bin of
/// a curve, however its bins are correlated. Without any value n is 0 and the mean not a number.
EnsembleMean mean_over_runs(const ValuesOfRuns& values);

/// The same for directions of an axis, degrees: those that differ by 180 are one, and the mean of
/// 179 and 3 is 1. The mean is half the argument of the mean of exp(2 i angle), in [0, 180); the
/// standard error is that of the deviations from it, within -90 to 90.
EnsembleMean mean_axis_over_runs(const ValuesOfRuns& degrees);

/// A quantity derived from several runs together, such as the place of a peak of their mean curve:
/// a function of the runs' numbers, of which some may occur more than once; none where it does not
/// exist.
using FunctionOfRuns = std::function<std::optional<double>(const std::vector<std::size_t>&)>;

/// Returns `quantity` of all runs and its standard error by a bootstrap over runs: its standard
/// deviation over resamples of `runs` runs drawn with replacement, times sqrt(n / (n - 1)), which
/// makes the error of a plain mean exactly the standard error of the mean. Up to four runs all n^n
/// resamples are taken, beyond that `bootstrap_resamples` random ones from a fixed seed. No error
/// for a single run, or when the quantity exists in fewer than 90 % of the resamples.
EnsembleMean bootstrap_over_runs(std::size_t runs, const FunctionOfRuns& quantity);

/// The mean of a curve over the bins with from <= x <= to, with a weight.
struct RangeTerm {
  double weight, from, to;
};

/// Returns a weighted sum of means over ranges of a curve, such as the difference of two: each
/// run's own sum, then mean_over_runs(), so that noise common to the bins of a run is not taken for
/// several. Bins that not all runs have are left out: a mean over others would be one of another
/// range. n is 0 when nothing is left of a range, or the curve was not kept for the runs
/// (EnsembleCurve::of_runs).
EnsembleMean sum_over_ranges(const EnsembleCurve& curve, const std::vector<RangeTerm>& terms);

constexpr int bootstrap_resamples = 1000;

}  // namespace rodpack

#endif

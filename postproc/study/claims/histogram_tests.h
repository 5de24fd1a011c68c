// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STUDY_CLAIMS_HISTOGRAM_TESTS_H
#define RODPACK_STUDY_CLAIMS_HISTOGRAM_TESTS_H

#include <optional>

#include "ensemble/ensemble.h"

namespace rodpack {

/// How much a distribution departs from a shape, against the scatter between repetitions.
///
/// Per bin the square of the departure and the square of the standard error are both divided by the
/// density that the shape gives, since the variance of a count is proportional to it; their means
/// over the bins are estimates of the same noise when there is no departure, and their ratio is F.
/// The scatter of all bins together has many degrees of freedom even for few repetitions, where
/// that of one bin says little.
struct Departure {
  double mean_square = 0, above = 1;  // of the departures, and its degrees of freedom
  double noise = 0, below = 1;        // of the standard errors, and its degrees of freedom
  double density = 1;                 // mean density

  double f() const { return mean_square / noise; }
  /// Significance in standard deviations of a normal variable.
  double sigmas() const;
  /// Mean square of the relative departure, the noise subtracted (it may be below 0), and its
  /// standard error, from the variances 2 s^4 / dof of both mean squares.
  double relative_square() const { return (mean_square - noise) / density; }
  double relative_square_error() const;
  /// Its root, 0 where the square is below 0.
  double relative() const;
};

/// Departure of a distribution over [0, 180) degrees from the best smooth one, a + b cos 2g +
/// c sin 2g + d cos 4g + e sin 4g: narrow peaks remain. @return none without standard errors or
/// with fewer than 12 bins.
std::optional<Departure> narrow_peaks(const EnsembleCurve& distribution);

/// Departure of a distribution over [0, 360) degrees from symmetry about the vertical, p(g) =
/// p(180 - g): differences of such pairs of bins, over their sum. @return none without standard
/// errors or when bins have no partner.
std::optional<Departure> asymmetry(const EnsembleCurve& distribution);

}  // namespace rodpack

#endif

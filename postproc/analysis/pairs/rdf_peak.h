// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_RDF_PEAK_H
#define RODPACK_ANALYSIS_PAIRS_RDF_PEAK_H

#include <optional>
#include <vector>

#include "analysis/rdf.h"

namespace rodpack {

/// A peak of G(r): neighbouring bins. Distances in d_p.
struct RdfPeak {
  std::size_t first = 0, last = 0;  // bins, both included
  double from = 0, to = 0;          // their outer edges
  double summit = 0;                // middle of the highest bin
  double g = 0;                     // in it
};

/// Returns all peaks that rise by more than three standard errors: local maxima whose prominence,
/// the height above the higher one of the two lowest values between it and the next higher bins (or
/// the ends of the table), exceeds three times the standard error of the highest bin. A peak's bins
/// are those around the maximum where G is above the middle between the maximum and that base.
std::vector<RdfPeak> rdf_peaks(const Rdf& rdf);

/// Returns the peak whose highest bin is nearest to `r`, and at most 0.2 d_p from it, edge of the
/// bin included; or, with `half_width` (d_p), all bins whose middle is no further than that from
/// `r`, at least the one that holds `r`.
/// @throws DataError when r is beyond the table, when no such peak is there (the message lists
/// those that are), or when the bins hold no pair.
RdfPeak find_rdf_peak(const Rdf& rdf, double r, std::optional<double> half_width = std::nullopt);

}  // namespace rodpack

#endif

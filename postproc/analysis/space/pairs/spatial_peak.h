// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_PAIRS_SPATIAL_PEAK_H
#define RODPACK_ANALYSIS_SPACE_PAIRS_SPATIAL_PEAK_H

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/pairs/peak_shares.h"
#include "analysis/pairs/rdf_sums.h"
#include "analysis/space/pairs/spatial_configuration.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// Collects the pairs of a peak of G(r) in space over one or several frames, and sorts them into
/// configurations, as PeakSample does in the plane (postproc/README.md, Definitions).
class SpatialPeakSample {
 public:
  /// `options`: those with which `peak` was found.
  SpatialPeakSample(const RdfOptions& options, const RdfPeak& peak)
      : options_(options), peak_(peak) {}
  /// Adds the pairs of a frame. @throws DataError naming the dump when its particles are curved, of
  /// another number of spheres or aspect ratio than those before, or a column is missing.
  void add(const Frame& bodies, const SpatialPacking& packing);
  /// Leaves out configurations with less than `least_share` of the pairs.
  PeakExplanation result(double least_share = 0.03) const;

 private:
  void check_shape(const Frame& bodies, const SpatialPacking& packing);
  bool are_near(std::size_t a, std::size_t b) const;
  double least_distance(std::size_t pair, const std::vector<SpatialConfiguration>& others) const;
  PeakClusters clusters() const;
  PeakConfiguration describe(const std::vector<std::size_t>& members, std::size_t summit) const;

  RdfOptions options_;
  RdfPeak peak_;
  std::optional<ChainShape> shape_;
  int spheres_ = 0;
  double arm_ = 0;  // see distance_between(); 0 for spheres
  std::vector<PeakPair> pairs_;
  std::vector<std::vector<SpatialConfiguration>> equal_;  // of the same, themselves first
};

}  // namespace rodpack

#endif

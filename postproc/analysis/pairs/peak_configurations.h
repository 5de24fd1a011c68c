// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_PEAK_CONFIGURATIONS_H
#define RODPACK_ANALYSIS_PAIRS_PEAK_CONFIGURATIONS_H

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/pairs/pair_configuration.h"
#include "analysis/pairs/peak_shares.h"
#include "analysis/pairs/rdf_peak.h"
#include "analysis/rdf.h"
#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// Collects the pairs of a peak over one or several frames, and sorts them into configurations
/// (postproc/README.md, Definitions).
class PeakSample {
 public:
  /// `options`: those with which `peak` was found.
  PeakSample(const RdfOptions& options, const RdfPeak& peak) : options_(options), peak_(peak) {}
  /// Adds the pairs of a frame. @throws DataError naming the dump when its particles are of another
  /// number of spheres, aspect ratio or curvature than those before, or a column is missing.
  void add(const Frame& bodies, const Packing& packing);
  /// Leaves out configurations with less than `least_share` of the pairs.
  PeakExplanation result(double least_share = 0.03) const;

 private:
  void check_shape(const Frame& bodies, const Packing& packing);
  PeakClusters clusters() const;
  PeakConfiguration describe(const std::vector<std::size_t>& members, std::size_t summit) const;

  RdfOptions options_;
  RdfPeak peak_;
  std::optional<ChainShape> shape_;
  int spheres_ = 0;
  ParticleKind kind_ = ParticleKind::sphere;
  std::vector<PeakPair> pairs_;
  std::vector<PairConfiguration> configurations_;  // of the same
};

}  // namespace rodpack

#endif

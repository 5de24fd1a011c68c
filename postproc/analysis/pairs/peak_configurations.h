// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_PEAK_CONFIGURATIONS_H
#define RODPACK_ANALYSIS_PAIRS_PEAK_CONFIGURATIONS_H

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/pairs/pair_configuration.h"
#include "analysis/pairs/rdf_peak.h"
#include "analysis/rdf.h"
#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// One way in which many pairs of a peak lie.
struct PeakConfiguration {
  std::string name;
  PairConfiguration pair;        // mean of the pairs next to the densest place of the cluster
  double distance = 0;           // of the centres in it, d_p
  double spread = 0;             // rms distance of the cluster's pairs from it, d_p
  double near_share = 0;         // of the cluster's pairs, those within 0.3 d_p of it
  double pairs = 0;              // as G(r) counts them
  double share = 0;              // of the peak's pairs
  double share_error = 0;        // standard error for independent pairs
  double touching_share = 0;     // of the cluster's pairs, those that touch
  double common_neighbours = 0;  // mean number of particles next to both
};

/// What stands behind a peak of G(r).
struct PeakExplanation {
  RdfPeak peak;
  ParticleKind kind = ParticleKind::sphere;
  ChainShape shape{};  // nominal, in d_p, to be drawn
  double pairs = 0;    // of the peak, as G(r) counts them
  double touching_share = 0;
  std::vector<PeakConfiguration> configurations;  // above the least share, the commonest first
  double other_share = 0;                         // of all pairs in none of them
};

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
  struct Pair {
    PairConfiguration configuration;
    double weight;  // how often G(r) counts it, 1 or 2
    bool touching;
    int common;  // particles next to both
  };
  void check_shape(const Frame& bodies, const Packing& packing);
  std::map<std::size_t, std::vector<std::size_t>> clusters() const;  // members by their summit
  PeakConfiguration describe(const std::vector<std::size_t>& members, std::size_t summit) const;

  RdfOptions options_;
  RdfPeak peak_;
  std::optional<ChainShape> shape_;
  int spheres_ = 0;
  ParticleKind kind_ = ParticleKind::sphere;
  std::vector<Pair> pairs_;
};

/// Writes a CSV table: configuration, along_over_dp, across_over_dp, angle_deg, distance_over_dp,
/// spread_over_dp, near_share, share, share_standard_error, pairs, touching_share,
/// common_neighbours; the last row, "other", holds the share of all others.
void write_peak_table(const PeakExplanation& explanation, const std::string& file);

}  // namespace rodpack

#endif

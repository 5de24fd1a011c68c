// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_PEAK_SHARES_H
#define RODPACK_ANALYSIS_PAIRS_PEAK_SHARES_H

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/pairs/pair_configuration.h"
#include "analysis/pairs/rdf_peak.h"
#include "reading/checks/body_axes.h"

namespace rodpack {

// What the configurations of a peak have in common in the plane and in space: the
// postproc/README.md says what they are (Definitions).

/// Pairs nearer than this to each other, in d_p, are neighbours in the space of configurations.
constexpr double peak_bandwidth = 0.15;
/// A pass this much lower than the lower summit parts two configurations.
constexpr double peak_pass_depth = 0.5;

/// One way in which many pairs of a peak lie.
struct PeakConfiguration {
  std::string name;
  PairConfiguration pair;     // mean of the pairs next to the densest place of the cluster
  Vector3 axis{};             // in space: the neighbour's, across is y; the angle is in 0 to 90°
  double distance = 0;        // of the centres in it, d_p
  double spread = 0;          // rms distance of the cluster's pairs from it, d_p
  double near_share = 0;      // of the cluster's pairs, those within 0.3 d_p of it
  double pairs = 0;           // as G(r) counts them
  double share = 0;           // of the peak's pairs
  double share_error = 0;     // standard error for independent pairs
  double touching_share = 0;  // of the cluster's pairs, those that touch
  double common_neighbours = 0;  // mean number of particles next to both
};

/// What stands behind a peak of G(r).
struct PeakExplanation {
  RdfPeak peak;
  bool in_space = false;
  ParticleKind kind = ParticleKind::sphere;
  ChainShape shape{};  // nominal, in d_p, to be drawn
  double pairs = 0;    // of the peak, as G(r) counts them
  double touching_share = 0;
  std::vector<PeakConfiguration> configurations;  // above the least share, the commonest first
  double other_share = 0;                         // of all pairs in none of them
};

/// A pair of a peak, however it lies.
struct PeakPair {
  double weight = 0;  // how often G(r) counts it, 1 or 2
  bool touching = false;
  int common = 0;  // particles next to both
};

/// Members of a sample by the densest of their cluster.
using PeakClusters = std::map<std::size_t, std::vector<std::size_t>>;

/// Adds to a configuration what its members say; `off`: of each, its distance from it, d_p.
void count_members(const std::vector<PeakPair>& pairs, const std::vector<std::size_t>& members,
                   const std::vector<double>& off, PeakConfiguration& configuration);

/// Adds to an explanation the shares of its pairs; `describe` makes a configuration of a cluster.
/// Leaves out those with less than `least_share`. @throws DataError when there are no pairs.
void share_out(const std::vector<PeakPair>& pairs, const PeakClusters& clusters,
               const std::function<PeakConfiguration(const std::vector<std::size_t>& members,
                                                     std::size_t summit)>& describe,
               double least_share, PeakExplanation& explanation);

/// Writes a CSV table: configuration, along_over_dp, across_over_dp, angle_deg (in space also
/// axis_to_centres_deg, of the neighbour's axis to the line of the centres), distance_over_dp,
/// spread_over_dp, near_share, share, share_standard_error, pairs, touching_share,
/// common_neighbours; the last row, "other", holds the share of all others.
void write_peak_table(const PeakExplanation& explanation, const std::string& file);

}  // namespace rodpack

#endif

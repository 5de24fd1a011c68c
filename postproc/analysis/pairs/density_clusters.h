// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_DENSITY_CLUSTERS_H
#define RODPACK_ANALYSIS_PAIRS_DENSITY_CLUSTERS_H

#include <cstddef>
#include <functional>
#include <vector>

namespace rodpack {

/// Clusters points by their density: each point joins the cluster of its densest neighbour, and two
/// clusters are one unless the pass between them is below `depth` times the density of the lower of
/// their summits, and by more than three standard errors of that count (ToMATo; Chazal, Guibas,
/// Oudot, Skraba, J. ACM 60, 41, 2013, with the prominence relative to the summit). Of points of
/// equal density the earlier one counts as the denser: the result depends on nothing but the input.
///
/// `density`: how many points are near each; `neighbours`: calls `visit` with the places of the
/// points near one, symmetric, in any order. Returns for each point the place of its cluster's
/// summit, the densest point of it.
using Visit = std::function<void(std::size_t)>;
std::vector<std::size_t> density_clusters(
    const std::vector<double>& density,
    const std::function<void(std::size_t, const Visit&)>& neighbours, double depth);

}  // namespace rodpack

#endif

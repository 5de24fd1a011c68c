// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/density_clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rodpack {

std::vector<std::size_t> density_clusters(
    const std::vector<double>& density,
    const std::function<void(std::size_t, const Visit&)>& neighbours, double depth) {
  std::vector<std::size_t> order(density.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return density[a] > density[b]; });
  std::vector<std::size_t> rank(density.size());
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k;

  // Union-find whose root is the summit.
  std::vector<std::size_t> parent(density.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto summit = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<std::size_t> summits;  // of the denser neighbours, each once: few
  for (const auto i : order) {
    summits.clear();
    std::size_t densest = i;
    neighbours(i, [&](std::size_t j) {
      if (rank[j] >= rank[i]) return;
      if (rank[j] < rank[densest]) densest = j;
      const auto top = summit(j);
      if (std::find(summits.begin(), summits.end(), top) == summits.end()) summits.push_back(top);
    });
    parent[i] = summit(densest);
    // From the densest down, so that the outcome does not depend on the order of the neighbours.
    std::sort(summits.begin(), summits.end(),
              [&](std::size_t a, std::size_t b) { return rank[a] < rank[b]; });
    for (const auto other : summits) {
      const auto own = summit(i);
      const auto theirs = summit(other);
      if (own == theirs) continue;
      const auto [higher, lower] =
          rank[own] < rank[theirs] ? std::pair(own, theirs) : std::pair(theirs, own);
      const bool deep = density[i] < depth * density[lower] &&
                        density[lower] - density[i] > 3 * std::sqrt(density[lower]);
      if (!deep) parent[lower] = higher;
    }
  }
  std::vector<std::size_t> of_points(density.size());
  for (std::size_t i = 0; i < of_points.size(); ++i) of_points[i] = summit(i);
  return of_points;
}

}  // namespace rodpack

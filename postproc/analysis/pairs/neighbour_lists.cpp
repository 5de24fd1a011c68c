// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/neighbour_lists.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace rodpack {

// Sweeps along the axis, so that only particles near one another along it are compared.
NeighbourLists::NeighbourLists(const std::vector<double>& position, double reach,
                               const std::function<bool(std::size_t, std::size_t)>& are_next)
    : neighbours_(position.size()) {
  std::vector<std::size_t> order(position.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return position[a] < position[b]; });
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t m = k + 1; m < order.size(); ++m) {
      const auto i = order[k], j = order[m];
      if (position[j] - position[i] > reach) break;
      if (!are_next(i, j)) continue;
      neighbours_[i].push_back(j);
      neighbours_[j].push_back(i);
    }
  for (auto& each : neighbours_) std::sort(each.begin(), each.end());
}

int NeighbourLists::common(std::size_t i, std::size_t j) const {
  std::vector<std::size_t> both;
  std::set_intersection(neighbours_[i].begin(), neighbours_[i].end(), neighbours_[j].begin(),
                        neighbours_[j].end(), std::back_inserter(both));
  return static_cast<int>(both.size());
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_NEIGHBOUR_LISTS_H
#define RODPACK_ANALYSIS_PAIRS_NEIGHBOUR_LISTS_H

#include <cstddef>
#include <functional>
#include <vector>

namespace rodpack {

/// Which particles are next to each other, in a plane or in space.
class NeighbourLists {
 public:
  NeighbourLists() = default;
  /// Asks `are_next` of all pairs whose coordinates along one axis, which is not periodic, differ
  /// by at most `reach`; `position`: that coordinate of each particle, in the unit of `reach`.
  NeighbourLists(const std::vector<double>& position, double reach,
                 const std::function<bool(std::size_t i, std::size_t j)>& are_next);
  /// How many particles are next to both i and j.
  int common(std::size_t i, std::size_t j) const;

 private:
  std::vector<std::vector<std::size_t>> neighbours_;  // in ascending order
};

}  // namespace rodpack

#endif

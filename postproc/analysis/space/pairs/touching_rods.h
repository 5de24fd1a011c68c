// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_PAIRS_TOUCHING_RODS_H
#define RODPACK_ANALYSIS_SPACE_PAIRS_TOUCHING_RODS_H

#include <cstddef>
#include <vector>

#include "analysis/pairs/neighbour_lists.h"
#include "reading/dump.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// Which straight particles of a frame in space touch, and which are next to each other, from their
/// spheres, with the gaps of TouchingChains.
class TouchingRods {
 public:
  /// @throws DataError when a column is missing, or no axis of the container has a wall.
  TouchingRods(const Frame& bodies, const SpatialPacking& packing);
  /// Whether particle j touches i when its centre of mass lies `to` from that of i, m.
  bool touch(std::size_t i, std::size_t j, const Vector3& to) const;
  /// How many particles are next to both i and j. Across a periodic border counts too.
  int common_neighbours(std::size_t i, std::size_t j) const;

 private:
  bool nearer(std::size_t i, std::size_t j, const Vector3& to, double gap) const;
  void find_neighbours();

  const SpatialPacking& packing_;
  std::vector<int> spheres_;
  std::vector<double> reach_, radius_;  // of the end sphere's centre from the middle; m
  double gap_, next_;                   // m
  NeighbourLists neighbours_;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_TOUCHING_CHAINS_H
#define RODPACK_ANALYSIS_PAIRS_TOUCHING_CHAINS_H

#include <cstddef>
#include <vector>

#include "analysis/order/body_points.h"
#include "analysis/pairs/neighbour_lists.h"
#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// Spheres of two particles that are so close, in d_p, count as touching: less than the weight of
/// one particle presses them together.
constexpr double touching_gap = 1e-4;
/// Particles that are so close, in d_p, are next to each other: the spread of sizes leaves gaps of
/// that order in an arrangement that would touch.
constexpr double neighbouring_gap = 0.1;

/// Which particles of a frame touch, from their shapes: two of their spheres are closer than
/// touching_gap.
class TouchingChains {
 public:
  /// @throws DataError naming the dump when a column is missing or a particle has no valid shape.
  TouchingChains(const Frame& bodies, const Packing& packing);
  /// Whether particle j touches i when its centre of mass lies (dx, dy) from that of i, m.
  bool touch(std::size_t i, std::size_t j, double dx, double dy) const;
  /// How many particles are next to both i and j, with a gap below neighbouring_gap. Across a
  /// periodic border counts too.
  int common_neighbours(std::size_t i, std::size_t j) const;

 private:
  bool nearer(std::size_t i, std::size_t j, double dx, double dy, double gap) const;
  void find_neighbours(const Packing& packing);

  std::vector<PointList> centres_;  // of the spheres, from that of mass, m
  std::vector<double> radius_;      // m
  double gap_;                      // largest that counts as touching, m
  double next_;                     // largest of particles that are next to each other, m
  NeighbourLists neighbours_;
};

}  // namespace rodpack

#endif

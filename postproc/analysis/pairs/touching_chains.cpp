// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/touching_chains.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

TouchingChains::TouchingChains(const Frame& bodies, const Packing& packing)
    : centres_(body_points(bodies, packing,
                           [](const ChainShape& shape) { return sphere_centres(shape); })),
      radius_(bodies.column("radius")),
      gap_(touching_gap * packing.particle_diameter),
      next_(neighbouring_gap * packing.particle_diameter) {
  find_neighbours(packing);
}

bool TouchingChains::touch(std::size_t i, std::size_t j, double dx, double dy) const {
  return nearer(i, j, dx, dy, gap_);
}

bool TouchingChains::nearer(std::size_t i, std::size_t j, double dx, double dy, double gap) const {
  const double limit = radius_[i] + radius_[j] + gap;
  for (const auto& a : centres_[i])
    for (const auto& b : centres_[j]) {
      const double x = dx + b[0] - a[0], y = dy + b[1] - a[1];
      if (x * x + y * y <= limit * limit) return true;
    }
  return false;
}

int TouchingChains::common_neighbours(std::size_t i, std::size_t j) const {
  return neighbours_.common(i, j);
}

void TouchingChains::find_neighbours(const Packing& packing) {
  double extent = 0;  // largest distance of a particle's rim from its centre of mass
  for (std::size_t i = 0; i < centres_.size(); ++i)
    for (const auto& [x, y] : centres_[i]) extent = std::max(extent, std::hypot(x, y) + radius_[i]);
  const double reach = 2 * extent + next_;
  const double period = packing.walls.sides ? 0 : packing.walls.width();
  if (!packing.walls.bottom)
    throw DataError("configurations of pairs: expected a floor, found y periodic");
  neighbours_ = NeighbourLists(packing.y, reach, [&](std::size_t i, std::size_t j) {
    double dx = packing.x[j] - packing.x[i];
    if (period > 0) dx = std::remainder(dx, period);
    return std::abs(dx) <= reach && nearer(i, j, dx, packing.y[j] - packing.y[i], next_);
  });
}

}  // namespace rodpack

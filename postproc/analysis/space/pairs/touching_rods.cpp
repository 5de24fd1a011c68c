// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/pairs/touching_rods.h"

#include <algorithm>
#include <cmath>

#include "analysis/pairs/touching_chains.h"

namespace rodpack {

TouchingRods::TouchingRods(const Frame& bodies, const SpatialPacking& packing)
    : packing_(packing),
      radius_(bodies.column("radius")),
      gap_(touching_gap * packing.particle_diameter),
      next_(neighbouring_gap * packing.particle_diameter) {
  const auto& half_length = bodies.column("half_length");
  const auto& spheres = bodies.column("nspheres");
  for (std::size_t row = 0; row < bodies.rows; ++row) {
    spheres_.push_back(static_cast<int>(spheres[row]));
    reach_.push_back(spheres_.back() > 1 ? half_length[row] - radius_[row] : 0);
  }
  find_neighbours();
}

bool TouchingRods::touch(std::size_t i, std::size_t j, const Vector3& to) const {
  return nearer(i, j, to, gap_);
}

bool TouchingRods::nearer(std::size_t i, std::size_t j, const Vector3& to, double gap) const {
  const double limit = radius_[i] + radius_[j] + gap;
  const double apart = std::hypot(to[0], to[1], to[2]);
  if (apart > limit + reach_[i] + reach_[j]) return false;
  const auto along = [&](std::size_t particle, int k) {
    return spheres_[particle] < 2 ? 0 : reach_[particle] * (2.0 * k / (spheres_[particle] - 1) - 1);
  };
  const auto &u = packing_.axis[i], &v = packing_.axis[j];
  for (int a = 0; a < spheres_[i]; ++a)
    for (int b = 0; b < spheres_[j]; ++b) {
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c)
        square += std::pow(to[c] + along(j, b) * v[c] - along(i, a) * u[c], 2);
      if (square <= limit * limit) return true;
    }
  return false;
}

int TouchingRods::common_neighbours(std::size_t i, std::size_t j) const {
  return neighbours_.common(i, j);
}

void TouchingRods::find_neighbours() {
  const auto& walls = packing_.walls;
  const auto found = std::find(walls.periodic.begin(), walls.periodic.end(), false);
  if (found == walls.periodic.end())
    throw DataError("configurations of pairs: expected an axis with walls, found all periodic");
  const auto sweep = static_cast<std::size_t>(found - walls.periodic.begin());
  double extent = 0;
  for (std::size_t i = 0; i < packing_.size(); ++i)
    extent = std::max(extent, reach_[i] + radius_[i]);
  const auto& centre = packing_.centre;
  std::vector<double> position;
  for (const auto& each : centre) position.push_back(each[sweep]);
  neighbours_ = NeighbourLists(position, 2 * extent + next_, [&](std::size_t i, std::size_t j) {
    Vector3 to{};
    for (std::size_t c = 0; c < 3; ++c) {
      to[c] = centre[j][c] - centre[i][c];
      if (walls.periodic[c]) to[c] = std::remainder(to[c], walls.high[c] - walls.low[c]);
    }
    return nearer(i, j, to, next_);
  });
}

}  // namespace rodpack

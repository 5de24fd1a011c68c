// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/spatial_orientation.h"

namespace rodpack {

void SpatialOrientationSample::add(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  if (vertical_.value_or(walls.vertical) != walls.vertical)
    throw DataError("orientation: expected one vertical in all frames, found two");
  vertical_ = walls.vertical;
  const double margin = packing.axial_length();
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const auto& place = packing.centre[i];
    if (!packing.elongated[i])
      ++spheres_;
    else if (walls.distance_to_sides(place) < margin || walls.height(place) < margin)
      ++near_walls_;
    else
      axes_.push_back(packing.axis[i]);
  }
}

SpatialOrientation SpatialOrientationSample::result(std::optional<int> bins) const {
  if (axes_.size() < 2)
    throw TooFewParticles("expected at least 2 particles to take the orientation of, found " +
                          std::to_string(axes_.size()) + ": " + std::to_string(spheres_) +
                          " spheres have no axis, " + std::to_string(near_walls_) +
                          " particles are closer than AR d_p to a wall");
  SpatialOrientation result;
  result.vertical = *vertical_;
  result.order = order_tensor(axes_);
  result.near_walls = near_walls_;
  result.spheres = spheres_;
  result.about_vertical = order_about(axes_, *vertical_);
  result.polar = polar_histogram(axes_, *vertical_, static_cast<std::size_t>(bins.value_or(18)));
  result.azimuth =
      azimuth_histogram(axes_, *vertical_, static_cast<std::size_t>(bins.value_or(36)));
  return result;
}

}  // namespace rodpack

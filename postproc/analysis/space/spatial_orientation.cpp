// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/spatial_orientation.h"

#include <cmath>

#include "reading/csv_file.h"

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
  const double n = static_cast<double>(axes_.size());
  const auto order_about_vertical = [&](const Vector3& axis) {
    return (3 * axis[*vertical_] * axis[*vertical_] - 1) / 2;
  };
  for (const auto& axis : axes_) result.vertical_order += order_about_vertical(axis) / n;
  double square = 0;
  for (const auto& axis : axes_)
    square += std::pow(order_about_vertical(axis) - result.vertical_order, 2);
  result.vertical_order_standard_error = std::sqrt(square / (n * (n - 1)));
  result.polar = polar_histogram(axes_, *vertical_, static_cast<std::size_t>(bins.value_or(18)));
  result.azimuth =
      azimuth_histogram(axes_, *vertical_, static_cast<std::size_t>(bins.value_or(36)));
  return result;
}

void write_order_table(const OrderTensor& order, std::size_t vertical, const std::string& file) {
  std::vector<double> value, error, polar, azimuth;
  std::array<std::vector<double>, 3> components;
  for (std::size_t k = 0; k < 3; ++k) {
    value.push_back(order.value[k]);
    error.push_back(order.standard_error[k]);
    const auto& direction = order.direction[k];
    const double sign = direction[vertical] < 0 ? -1 : 1;
    for (std::size_t c = 0; c < 3; ++c) components[c].push_back(sign * direction[c]);
    const auto angles = direction_angles(direction, vertical);
    polar.push_back(angles.polar);
    azimuth.push_back(angles.azimuth);
  }
  write_csv(file, {{"order", value},
                   {"standard_error", error},
                   {"direction_x", components[0]},
                   {"direction_y", components[1]},
                   {"direction_z", components[2]},
                   {"polar_deg", polar},
                   {"azimuth_deg", azimuth}});
}

}  // namespace rodpack

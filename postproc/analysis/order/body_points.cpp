// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/order/body_points.h"

#include <cmath>
#include <stdexcept>

#include "analysis/pairs/pair_configuration.h"

namespace rodpack {

std::vector<PointList> body_points(const Frame& bodies, const Packing& packing,
                                   const std::function<PointList(const ChainShape&)>& of_shape) {
  const auto& spheres = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const double d = packing.particle_diameter;
  std::vector<PointList> points;
  for (std::size_t i = 0; i < packing.size(); ++i) {
    try {
      const auto shape = shape_of_body(static_cast<int>(spheres[i]), 2 * half_length[i] / d, d,
                                       2 * radius[i], packing.curvature[i]);
      const double c = std::cos(packing.angle[i]), s = std::sin(packing.angle[i]);
      points.emplace_back();
      for (const auto& [x, y] : of_shape(shape))
        points.back().push_back({{c * x - s * y, s * x + c * y}});
    } catch (const std::invalid_argument& reason) {
      throw DataError(bodies.file + ": particle in row " + std::to_string(i + 1) + " of timestep " +
                      std::to_string(bodies.timestep) + ": " + reason.what());
    }
  }
  return points;
}

}  // namespace rodpack

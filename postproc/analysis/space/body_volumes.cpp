// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/body_volumes.h"

#include <map>
#include <stdexcept>
#include <tuple>

#include "analysis/pairs/pair_configuration.h"
#include "reading/angles.h"
#include "reading/checks/body_axes.h"

namespace rodpack {
namespace {

// Of a chain of spheres of radius 1; `aspect_ratio`: half length over radius.
double chain_volume(int spheres, double aspect_ratio, double curvature) {
  constexpr double sphere = 4 * pi / 3;
  if (spheres < 2 || aspect_ratio <= 1) return sphere;
  // Spheres of a straight line that do not overlap are no chain of ours.
  if (aspect_ratio - 1 >= spheres - 1 && curvature == 0) return spheres * sphere;
  return union_volume(shape_of_body(spheres, aspect_ratio, 2, 2, curvature));
}

}  // namespace

std::vector<double> body_volumes(const Frame& bodies) {
  const auto& spheres = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto& curvature = bodies.column("curvature");
  std::map<std::tuple<double, double, double>, double> known;  // most bodies are alike
  std::vector<double> volumes;
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    const double ratio = half_length[i] / radius[i];
    const auto place = known.try_emplace({spheres[i], ratio, curvature[i]}, 0.0);
    if (place.second) try {
        place.first->second = chain_volume(static_cast<int>(spheres[i]), ratio, curvature[i]);
      } catch (const std::invalid_argument& reason) {
        throw DataError(at_row(bodies, i) + reason.what());
      }
    volumes.push_back(place.first->second * radius[i] * radius[i] * radius[i]);
  }
  return volumes;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "reading/angles.h"
#include "reading/checks/inside_walls.h"
#include "reading/checks/particle_sizes.h"
#include "reading/checks/planar.h"
#include "reading/number_text.h"
#include "reading/scene/scene_walls.h"

namespace rodpack {

Walls find_walls(const Frame& frame, const PackingOptions& options,
                 const std::optional<RunParameters>& parameters) {
  Walls walls;
  walls.sides = !frame.periodic[0];
  walls.bottom = !frame.periodic[1];
  if (const auto scene = options.walls.empty() ? find_scene(frame) : std::nullopt) {
    walls = walls_of_scene(*scene, frame);
  } else if (!options.walls.empty()) {
    walls.left = options.walls.at(0);
    walls.right = options.walls.at(1);
    walls.floor = options.walls.at(2);
    walls.source = "--walls";
  } else if (parameters && parameters->values.contains("container_width_m")) {
    walls.right = parameters->number("container_width_m");
    walls.source = parameters->file;
  } else {
    walls.left = frame.bounds[0][0];
    walls.right = frame.bounds[0][1];
    walls.floor = frame.bounds[1][0];
    walls.source = "box bounds of " + frame.file;
  }
  if (!walls.bottom) {
    walls.floor = frame.bounds[1][0];
    walls.ceiling = frame.bounds[1][1];
  }
  if (!(walls.right > walls.left))
    throw DataError(walls.source + ": expected the right wall beyond the left one, found " +
                    number_text(walls.left) + " and " + number_text(walls.right));
  // The images of what crosses the border are one period of the dump away, no other length.
  const double period = frame.bounds[0][1] - frame.bounds[0][0];
  if (!walls.sides && std::abs(walls.width() - period) > 1e-9 * period)
    throw DataError(walls.source + ": expected the period of the dump in x, " +
                    number_text(period) + " m, found " + number_text(walls.width()) + " m");
  return walls;
}

namespace {

// How far each centre lies beyond the side walls and the floor, m; negative inside.
std::vector<double> beyond_walls(const Packing& packing) {
  const auto& walls = packing.walls;
  std::vector<double> beyond;
  for (std::size_t i = 0; i < packing.x.size(); ++i) {
    double distance = -std::numeric_limits<double>::infinity();
    if (walls.sides) distance = std::max(walls.left - packing.x[i], packing.x[i] - walls.right);
    if (walls.bottom) distance = std::max(distance, walls.floor - packing.y[i]);
    beyond.push_back(distance);
  }
  return beyond;
}

}  // namespace

Packing read_packing(const Frame& frame, const PackingOptions& options) {
  const auto where = frame.file + ":" + std::to_string(frame.header_line);
  if (frame.rows == 0)
    throw DataError(where + ": the frame of timestep " + std::to_string(frame.timestep) +
                    " holds no particles");
  const auto parameters = find_parameters(frame.file, options.parameters);
  Packing packing;
  packing.timestep = frame.timestep;
  packing.x = frame.column("x");
  packing.y = frame.column("y");
  packing.angle = frame.column("angle");
  packing.curvature = frame.column("curvature");
  packing.area = frame.column("area");
  for (const double count : frame.column("nspheres")) packing.elongated.push_back(count > 1);
  packing.walls = find_walls(frame, options, parameters);
  if (parameters && parameters->values.contains("inclination_deg"))
    packing.inclination = parameters->number("inclination_deg") * degree;

  const auto sizes = particle_sizes(frame, options, parameters);
  packing.particle_diameter = sizes.diameter;
  packing.aspect_ratio = sizes.aspect_ratio;
  if (!options.out_of_plane_too) require_planar_bodies(frame, packing.particle_diameter);
  if (packing.walls.width() < packing.particle_diameter)
    throw DataError(packing.walls.source + ": expected a container or period of at least d_p = " +
                    number_text(packing.particle_diameter, 4) + " m, found one of " +
                    number_text(packing.walls.width(), 4) + " m");
  // It would touch itself, and a kernel of its size would see many images of all others.
  if (!packing.walls.sides && packing.axial_length() > packing.walls.width())
    throw DataError(packing.walls.source + ": expected a period of at least a particle's length, " +
                    number_text(packing.axial_length(), 4) + " m, found one of " +
                    number_text(packing.walls.width(), 4) + " m");
  require_inside_walls(frame, beyond_walls(packing), packing.particle_diameter,
                       packing.walls.source);
  packing.surface = packing.walls.ceiling;
  if (packing.walls.bottom) {
    const double layer = std::max(2 * packing.particle_diameter, packing.axial_length() / 2);
    packing.surface =
        bed_surface(packing.y, packing.area, packing.walls.floor, packing.walls.width(), layer);
  }
  return packing;
}

std::string note_on_slope(const Packing& packing) {
  if (packing.inclination == 0) return "";
  return "gravity is " + number_text(packing.inclination * degrees_in_radian, 4) +
         " degrees off -y: angles are to the base (x), depths across it (along y)";
}

double sphere_diameter(const Frame& spheres, const PackingOptions& options) {
  if (options.particle_diameter) return *options.particle_diameter;
  const auto parameters = find_parameters(spheres.file, options.parameters);
  if (parameters && parameters->values.contains("particle_diameter_m"))
    return parameters->number("particle_diameter_m");
  const auto& radius = spheres.column("radius");
  return 2 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(spheres.rows);
}

double bed_surface(const std::vector<double>& y, const std::vector<double>& area, double floor,
                   double width, double layer) {
  const double top = *std::max_element(y.begin(), y.end());
  constexpr double most_layers = 1e5;
  if (!((top - floor) / layer < most_layers))
    throw DataError("surface of the bed: expected at most " + number_text(most_layers) +
                    " layers of the thickness " + number_text(layer, 4) +
                    " m between the floor, y = " + number_text(floor, 4) +
                    " m, and the highest particle, y = " + number_text(top, 4) + " m");
  const auto layers =
      static_cast<std::size_t>(std::max(0.0, std::floor((top - floor) / layer))) + 1;
  std::vector<double> fraction(layers + 1, 0.0);  // the last one stays empty
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double index = std::max(0.0, std::floor((y[i] - floor) / layer));
    fraction[static_cast<std::size_t>(index)] += area[i] / (layer * width);
  }

  // Median over the covered area, so that thinly filled layers above the bed carry no weight.
  auto sorted = fraction;
  std::sort(sorted.begin(), sorted.end());
  const double half = std::accumulate(sorted.begin(), sorted.end(), 0.0) / 2;
  double sum = 0;
  double bulk = 0;
  for (auto value = sorted.begin(); value != sorted.end() && sum <= half; ++value) {
    bulk = *value;
    sum += bulk;
  }

  for (std::size_t k = layers; k-- > 0;)
    if (fraction[k] >= bulk / 2) {
      const double drop = fraction[k] - fraction[k + 1];
      const double part = drop > 0 ? (fraction[k] - bulk / 2) / drop : 0;
      return floor + (static_cast<double>(k) + 0.5 + part) * layer;
    }
  return top;
}

}  // namespace rodpack

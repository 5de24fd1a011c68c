// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/space/spatial_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reading/checks/inside_walls.h"
#include "reading/checks/particle_sizes.h"
#include "reading/checks/planar.h"
#include "reading/number_text.h"
#include "reading/parsing.h"
#include "reading/scene/scene_walls.h"
#include "reading/space/vertical_axis.h"

namespace rodpack {
namespace {

constexpr const char* axis_names = "xyz";
constexpr double endless = std::numeric_limits<double>::infinity();

std::optional<std::size_t> axis_named(const std::string& name) {
  const auto at = std::string(axis_names).find(name);
  if (name.size() != 1 || at == std::string::npos) return std::nullopt;
  return at;
}

// The axis that points up, if anybody says so.
std::optional<std::size_t> stated_vertical(const std::optional<RunScene>& scene,
                                           const std::optional<RunParameters>& parameters,
                                           const SpaceOptions& space) {
  if (!space.vertical.empty()) {
    if (const auto axis = axis_named(space.vertical)) return axis;
    throw DataError("--vertical: expected one of x, y, z, found '" + shortened(space.vertical) +
                    "'");
  }
  if (const auto axis = scene ? scene->vertical() : std::nullopt) return axis;
  return parameters ? vertical_axis(*parameters) : std::nullopt;
}

void add_cylinder(const std::vector<double>& cylinder, SpatialWalls& walls) {
  walls.round = true;
  walls.middle = {cylinder.at(0), cylinder.at(1)};
  walls.radius = cylinder.at(2);
  if (!(walls.radius > 0))
    throw DataError("--cylinder: expected a positive radius, found " + number_text(walls.radius));
  for (const std::size_t which : {0U, 1U})
    if (walls.periodic[walls.horizontal(which)])
      throw DataError(std::string("--cylinder: expected a dump with walls along ") +
                      axis_names[walls.horizontal(which)] + ", which is periodic");
}

// Adds what the options leave open and the deck states: `container`, "box" or "cylinder", on the
// floor 0, between 0 and container_width_m along both horizontal axes. Returns whether it does.
bool add_stated_container(const Frame& bodies, const std::optional<RunParameters>& parameters,
                          std::size_t vertical, SpaceOptions& space) {
  if (!space.container.empty() || !parameters) return false;
  const auto kind = parameters->values.value("container", nlohmann::json());
  if (kind != "box" && kind != "cylinder") return false;
  const double width = parameters->number("container_width_m");
  space.container = {0, width, 0, width, 0, width};
  space.container[2 * vertical + 1] = bodies.bounds[vertical][1];
  if (kind == "cylinder" && space.cylinder.empty())
    space.cylinder = {width / 2, width / 2, width / 2};
  return true;
}

SpatialWalls find_spatial_walls(const Frame& bodies, SpaceOptions space,
                                const std::optional<RunScene>& scene,
                                const std::optional<RunParameters>& parameters,
                                std::size_t vertical) {
  // A cylinder of the command line has its floor from the scene.
  if (scene && space.container.empty()) {
    auto walls = spatial_walls_of_scene(*scene, bodies, vertical);
    if (space.cylinder.empty()) return walls;
    add_cylinder(space.cylinder, walls);
    walls.source = "--cylinder, " + walls.source;
    return walls;
  }
  SpatialWalls walls;
  walls.vertical = vertical;
  walls.periodic = bodies.periodic;
  const bool round = !space.cylinder.empty();
  const bool stated = add_stated_container(bodies, parameters, vertical, space);
  const bool given = !space.container.empty();
  walls.source = stated ? parameters->file : given ? "--container" : "box bounds of " + bodies.file;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    walls.low[axis] = given ? space.container.at(2 * axis) : bodies.bounds[axis][0];
    walls.high[axis] = given ? space.container.at(2 * axis + 1) : bodies.bounds[axis][1];
    if (!(walls.high[axis] > walls.low[axis]))
      throw DataError(walls.source + ": expected the upper wall along " + axis_names[axis] +
                      " beyond the lower one, found " + number_text(walls.low[axis]) + " and " +
                      number_text(walls.high[axis]));
    // The images of what crosses the border are one period of the dump away, no other length.
    const double slack = 1e-9 * (walls.high[axis] - walls.low[axis]);
    const auto& bounds = bodies.bounds[axis];
    if (walls.periodic[axis] && (std::abs(walls.low[axis] - bounds[0]) > slack ||
                                 std::abs(walls.high[axis] - bounds[1]) > slack))
      throw DataError(walls.source + ": expected the period of the dump along " + axis_names[axis] +
                      ", " + number_text(bounds[0]) + " to " + number_text(bounds[1]) +
                      " m, found " + number_text(walls.low[axis]) + " to " +
                      number_text(walls.high[axis]) + " m");
  }
  if (!space.cylinder.empty()) {
    add_cylinder(space.cylinder, walls);
    if (round) walls.source = "--cylinder, " + walls.source;
  }
  return walls;
}

// What a body adds to its layer, of whose contents only ratios matter: mass serves as volume does,
// and so does length times cross-section where a dump of spheres has told the bodies.
std::vector<double> weights(const Frame& bodies) {
  if (bodies.has("mass")) return bodies.column("mass");
  auto weight = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  for (std::size_t row = 0; row < weight.size(); ++row) weight[row] *= radius[row] * radius[row];
  return weight;
}

// A container narrower than a sphere, or a period in which a particle would touch itself.
void require_room(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double extent = walls.high[axis] - walls.low[axis];
    if (walls.round && axis != walls.vertical) extent = std::min(extent, 2 * walls.radius);
    const double needed = walls.periodic[axis] ? packing.axial_length() : packing.particle_diameter;
    if (extent < needed)
      throw DataError(walls.source + ": expected " +
                      (walls.periodic[axis] ? "a period of at least a particle's length, "
                                            : "a container of at least d_p = ") +
                      number_text(needed, 4) + " m along " + axis_names[axis] + ", found " +
                      number_text(extent, 4) + " m");
  }
}

}  // namespace

double SpatialWalls::distance_to_sides(const Vector3& place) const {
  double distance = endless;
  for (const std::size_t which : {0U, 1U}) {
    const auto axis = horizontal(which);
    if (round || periodic[axis]) continue;
    distance = std::min({distance, place[axis] - low[axis], high[axis] - place[axis]});
  }
  if (round)
    distance =
        radius - std::hypot(place[horizontal(0)] - middle[0], place[horizontal(1)] - middle[1]);
  return distance;
}

double SpatialWalls::height(const Vector3& place) const {
  return periodic[vertical] ? endless : place[vertical] - low[vertical];
}

std::optional<std::size_t> find_vertical(const Frame& frame, const std::string& parameters,
                                         const SpaceOptions& space) {
  return stated_vertical(find_scene(frame), find_parameters(frame.file, parameters), space);
}

bool is_in_space(const Frame& frame, const PackingOptions& options, const SpaceOptions& space) {
  const auto vertical = find_vertical(frame, options.parameters, space);
  if (frame.rows == 0) return false;
  constexpr std::size_t y = 1;
  if (vertical.value_or(y) != y) return true;
  const double diameter = sphere_diameter(frame, options);
  const auto reason = frame.has("half_length") ? why_bodies_not_planar(frame, diameter)
                                               : why_spheres_not_planar(frame, diameter);
  if (!reason.empty() && !vertical)
    throw DataError(
        reason +
        "; a scene in space needs --vertical, or 'vertical_axis' in parameters.json, "
        "the axis that points up, or a 'dump scene' in the deck, with gravity along it");
  return !reason.empty();
}

SpatialWalls read_spatial_walls(const Frame& frame, const PackingOptions& options,
                                const SpaceOptions& space) {
  const auto parameters = find_parameters(frame.file, options.parameters);
  const auto scene = find_scene(frame);
  const auto vertical = stated_vertical(scene, parameters, space);
  if (!vertical) throw DataError("--vertical: expected one of x, y, z, found none");
  return find_spatial_walls(frame, space, scene, parameters, *vertical);
}

SpatialPacking read_spatial_packing(const Frame& bodies, const PackingOptions& options,
                                    const SpaceOptions& space) {
  if (bodies.rows == 0)
    throw DataError(bodies.file + ":" + std::to_string(bodies.header_line) +
                    ": the frame of timestep " + std::to_string(bodies.timestep) +
                    " holds no particles");
  const auto parameters = find_parameters(bodies.file, options.parameters);
  SpatialPacking packing;
  packing.walls = read_spatial_walls(bodies, options, space);
  packing.timestep = bodies.timestep;
  const auto place = vector_columns(bodies, {"x", "y", "z"});
  const auto& count = bodies.column("nspheres");
  const BodyAxes axes(bodies);
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    packing.centre.push_back({(*place[0])[i], (*place[1])[i], (*place[2])[i]});
    packing.elongated.push_back(count[i] > 1);
    packing.axis.push_back(count[i] > 1 ? axes.axis(i, 0) : Vector3{1, 0, 0});
  }
  const auto sizes = particle_sizes(bodies, options, parameters);
  packing.particle_diameter = sizes.diameter;
  packing.aspect_ratio = sizes.aspect_ratio;
  require_room(packing);
  const auto& walls = packing.walls;
  std::vector<double> beyond;
  for (const auto& centre : packing.centre)
    beyond.push_back(-std::min(walls.distance_to_sides(centre), walls.height(centre)));
  require_inside_walls(bodies, beyond, packing.particle_diameter, walls.source);
  const auto up = walls.vertical;
  packing.surface = walls.high[up];
  if (!walls.periodic[up]) {
    const double layer = std::max(2 * packing.particle_diameter, packing.axial_length() / 2);
    packing.surface = bed_surface(*place[up], weights(bodies), walls.low[up], 1, layer);
  }
  return packing;
}

}  // namespace rodpack

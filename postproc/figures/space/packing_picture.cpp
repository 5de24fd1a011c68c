// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/packing_picture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>

#include "analysis/long_axis.h"
#include "figures/drawing.h"
#include "figures/packings/base64.h"
#include "figures/packings/particles.h"
#include "figures/space/ray_tracing.h"
#include "reading/angles.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

constexpr const char* edge_colour = "#303030";
constexpr const char* floor_colour = "#e8e8e8";

// What is drawn: spheres, and the container as high as the bed, all in units of d_p.
struct TracedBed {
  std::vector<Vector3> centre;
  std::vector<double> radius;
  SpatialWalls walls;
  double top = 0;  // of the container as it is drawn, along the vertical
};

TracedBed bed_of(const Frame& spheres, const RenderOptions& options, double diameter) {
  const auto place = vector_columns(spheres, {"x", "y", "z"});
  const auto& radius = spheres.column("radius");
  TracedBed bed;
  bed.walls = read_spatial_walls(spheres, options.packing, options.space);
  auto& walls = bed.walls;
  const auto scaled = [diameter](double& length) { length /= diameter; };
  for (auto* corner : {&walls.low, &walls.high})
    std::for_each(corner->begin(), corner->end(), scaled);
  std::for_each(walls.middle.begin(), walls.middle.end(), scaled);
  scaled(walls.radius);
  const auto up = walls.vertical;
  bed.top = walls.periodic[up] ? walls.high[up] : walls.low[up];
  for (std::size_t i = 0; i < spheres.rows; ++i) {
    bed.centre.push_back(
        {(*place[0])[i] / diameter, (*place[1])[i] / diameter, (*place[2])[i] / diameter});
    bed.radius.push_back(radius[i] / diameter);
    bed.top = std::max(bed.top, bed.centre.back()[up] + bed.radius.back() + 0.5);
  }
  return bed;
}

// The outline of floor and rim, closed: the corners of a box, or points of a circle.
std::vector<std::array<double, 2>> outline_of(const SpatialWalls& walls) {
  if (walls.round) {
    std::vector<std::array<double, 2>> circle;
    for (int k = 0; k < 90; ++k)
      circle.push_back({walls.middle[0] + walls.radius * std::cos(4 * k * degree),
                        walls.middle[1] + walls.radius * std::sin(4 * k * degree)});
    return circle;
  }
  const auto a = walls.horizontal(0), b = walls.horizontal(1);
  return {{walls.low[a], walls.low[b]},
          {walls.high[a], walls.low[b]},
          {walls.high[a], walls.high[b]},
          {walls.low[a], walls.high[b]}};
}

Vector3 place_at(const SpatialWalls& walls, const std::array<double, 2>& across, double up) {
  Vector3 place{};
  place[walls.horizontal(0)] = across[0];
  place[walls.horizontal(1)] = across[1];
  place[walls.vertical] = up;
  return place;
}

// Floor, rim and upright edges, those of a cylinder where it is seen from the side.
void add_container(const TracedBed& bed, const Camera& camera, double azimuth, double thickness,
                   TracedScene& scene) {
  const auto& walls = bed.walls;
  const auto outline = outline_of(walls);
  const double floor = walls.low[walls.vertical];
  const auto see = [&](const std::array<double, 2>& across, double up) {
    return camera.see(place_at(walls, across, up));
  };
  const auto upright = [&](const std::array<double, 2>& across) {
    scene.line(see(across, floor), see(across, bed.top), thickness, edge_colour);
  };
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto& next = outline[(k + 1) % outline.size()];
    for (const double level : {floor, bed.top})
      scene.line(see(outline[k], level), see(next, level), thickness, edge_colour);
    if (!walls.round) upright(outline[k]);
    if (k > 0 && k + 1 < outline.size() && !walls.periodic[walls.vertical])
      scene.triangle({see(outline[0], floor), see(outline[k], floor), see(next, floor)},
                     floor_colour);
  }
  if (!walls.round) return;
  for (const double side : {90.0, -90.0})
    upright({walls.middle[0] + walls.radius * std::cos((azimuth + side) * degree),
             walls.middle[1] + walls.radius * std::sin((azimuth + side) * degree)});
}

void add_spheres(const Frame& spheres, const TracedBed& bed, const Camera& camera,
                 const std::function<std::string(std::size_t)>& shade, TracedScene& scene) {
  std::vector<std::size_t> all(spheres.rows);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  for (const auto i : all) scene.ball(camera.see(bed.centre[i]), bed.radius[i], shade(i));
  for (const auto& joint : joints_of(spheres, all))
    scene.rod(camera.see(bed.centre[joint.sphere]), camera.see(bed.centre[joint.other]),
              bed.radius[joint.sphere] / 2, shade(joint.sphere));
}

// Of all contact forces on the particle that each sphere is of: in one shade it keeps apart from
// others.
std::vector<double> sums_of_particles(const Frame& spheres) {
  const auto &body = spheres.column("body"), &force = spheres.column("fsum");
  std::map<double, double> sums;
  for (std::size_t i = 0; i < spheres.rows; ++i) sums[body[i]] += force[i];
  std::vector<double> of_spheres;
  for (const double each : body) of_spheres.push_back(sums.at(each));
  return of_spheres;
}

ColourScale scale_of(const Frame& spheres, const RenderOptions& options,
                     const SpatialWalls& walls) {
  if (options.colour == SphereColour::none) return {};
  if (options.colour == SphereColour::force)
    return sphere_force_scale(spheres, options.colour, options.largest);
  if (options.colour == SphereColour::fsum)
    return force_scale(sums_of_particles(spheres), options.largest, "sum of contact forces");
  ColourScale scale;
  scale.values = degrees_to_axis(spheres, walls.vertical);
  scale.highest = 90;
  scale.tick = 15;
  scale.label =
      std::string("angle of the long axis to the vertical, ") + "xyz"[walls.vertical] + " (°)";
  return scale;
}

// Three arrows in the lower left corner, as the camera sees the axes.
void draw_axes(Drawing& drawing, const Camera& camera, double x, double y, double length,
               double font) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3 direction{};
    direction[axis] = 1;
    const auto seen = camera.turn(direction);
    const double to_x = x + length * seen[0], to_y = y - length * seen[1];
    drawing.line(x, y, to_x, to_y, font / 9, edge_colour, "round");
    drawing.label(x + 1.35 * (to_x - x), y + 1.35 * (to_y - y) + 0.36 * font, font, "middle",
                  std::string(1, "xyz"[axis]), "font-style=\"italic\"");
  }
}

struct View {
  Camera camera;
  Frustum frustum;
  double distance, near, far;  // of the middle of the bed, the nearest and the farthest place
};

View view_of(const TracedBed& bed, double azimuth, double elevation) {
  const auto& walls = bed.walls;
  const double floor = walls.low[walls.vertical];
  std::vector<Vector3> corners;
  for (const auto& across : outline_of(walls))
    for (const double up : {floor, bed.top}) corners.push_back(place_at(walls, across, up));
  Vector3 middle{};
  for (const auto& corner : corners)
    for (std::size_t c = 0; c < 3; ++c)
      middle[c] += corner[c] / static_cast<double>(corners.size());
  double reach = 0;
  const auto from_middle = [&](const Vector3& place) {
    return std::hypot(place[0] - middle[0], place[1] - middle[1], place[2] - middle[2]);
  };
  for (const auto& corner : corners) reach = std::max(reach, from_middle(corner));
  for (std::size_t i = 0; i < bed.centre.size(); ++i)
    reach = std::max(reach, from_middle(bed.centre[i]) + bed.radius[i]);
  const double distance = 3.5 * reach;
  View view{
      {middle, distance, azimuth, elevation, walls.vertical}, {}, distance, distance, distance};
  const auto include = [&](const Vector3& place, double radius) {
    const auto seen = view.camera.see(place);
    view.frustum.include(seen, radius);
    view.near = std::min(view.near, seen[2] - radius);
    view.far = std::max(view.far, seen[2] + radius);
  };
  for (const auto& corner : corners) include(corner, 0);
  for (std::size_t i = 0; i < bed.centre.size(); ++i) include(bed.centre[i], bed.radius[i]);
  view.frustum.widen(0.015);
  return view;
}

}  // namespace

void render_in_space(const Frame& spheres, const RenderOptions& options, const std::string& stem) {
  if (spheres.rows == 0)
    throw DataError(spheres.file + ": the frame of timestep " + std::to_string(spheres.timestep) +
                    " holds no spheres");
  const double diameter = sphere_diameter(spheres, options.packing);
  const auto bed = bed_of(spheres, options, diameter);
  const auto scale = scale_of(spheres, options, bed.walls);
  const auto view = view_of(bed, options.azimuth, options.elevation);
  const auto& seen = view.frustum;
  const double width = seen.right - seen.left, height = seen.top - seen.bottom;
  const double pixels = options.pixels > 0 ? options.pixels : 1200;
  const double per_unit = pixels / std::max(width, height);

  TracedScene scene;
  add_container(bed, view.camera, options.azimuth, 1.2 * view.distance / per_unit, scene);
  add_spheres(
      spheres, bed, view.camera, [&](std::size_t i) { return scale.shade(i); }, scene);
  const auto traced = stem + ".traced.png";
  trace_rays(
      scene.text(seen, static_cast<std::size_t>(std::lround(width * per_unit)),
                 static_cast<std::size_t>(std::lround(height * per_unit)), view.near, view.far),
      traced);

  // The picture's plane is that of the middle of the bed, m.
  const double plane = view.distance * diameter;
  PackingPicture picture(
      {seen.left * plane, seen.right * plane, seen.bottom * plane, seen.top * plane}, pixels,
      !scale.values.empty());
  auto& drawing = picture.begin();
  const double left = picture.x(seen.left * plane), top = picture.y(seen.top * plane);
  drawing.raw("<image x=\"" + Drawing::at(left) + "\" y=\"" + Drawing::at(top) + "\" width=\"" +
              Drawing::at(width * per_unit) + "\" height=\"" + Drawing::at(height * per_unit) +
              "\" preserveAspectRatio=\"none\" href=\"data:image/png;base64," +
              base64(read_text(traced)) + "\"/>");
  std::error_code ignored;
  std::filesystem::remove(traced, ignored);
  const double font = picture.font();
  draw_axes(drawing, view.camera, left + 3.2 * font, top + height * per_unit - 3.2 * font,
            2.2 * font, font);
  Walls none;
  none.sides = none.bottom = false;
  picture.finish(none, diameter, scale, stem, {}, "at the middle of the bed");
}

}  // namespace rodpack

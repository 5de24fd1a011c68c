// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/render.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "figures/drawing.h"
#include "reading/text.h"

namespace rodpack {
namespace {
constexpr double degree = 3.14159265358979323846 / 180;

ColourScale orientation_scale(const Frame& spheres) {
  ColourScale scale;
  const double period = spheres.periodic[0] ? spheres.bounds[0][1] - spheres.bounds[0][0] : 0;
  scale.values =
      long_axis_degrees(spheres.column("body"), spheres.column("x"), spheres.column("y"), period);
  scale.highest = 180;
  scale.tick = 45;
  scale.palette = &twilight;
  scale.label = "direction of the long axis (°)";
  return scale;
}

ColourScale sphere_force_scale(const Frame& spheres, SphereColour colour,
                               std::optional<double> largest) {
  if (colour == SphereColour::fsum)
    return force_scale(spheres.column("fsum"), largest, "sum of contact forces");
  const auto& fx = spheres.column("fx");
  const auto& fy = spheres.column("fy");
  const auto& fz = spheres.column("fz");
  std::vector<double> forces;
  for (std::size_t i = 0; i < spheres.rows; ++i) forces.push_back(std::hypot(fx[i], fy[i], fz[i]));
  return force_scale(forces, largest, "contact force on sphere");
}

}  // namespace

std::vector<double> long_axis_degrees(const std::vector<double>& body, const std::vector<double>& x,
                                      const std::vector<double>& y, double period) {
  struct Moments {
    double x0, y0;  // the first sphere of the body, to unwrap the others
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::map<double, Moments> bodies;
  for (std::size_t i = 0; i < body.size(); ++i) {
    auto& m = bodies.try_emplace(body[i], Moments{x[i], y[i]}).first->second;
    double dx = x[i] - m.x0;
    if (period > 0) dx -= period * std::round(dx / period);
    const double dy = y[i] - m.y0;
    m.n += 1;
    m.x += dx;
    m.y += dy;
    m.xx += dx * dx;
    m.xy += dx * dy;
    m.yy += dy * dy;
  }
  std::vector<double> result;
  for (const double id : body) {
    const auto& m = bodies.at(id);
    if (m.n < 2) {
      result.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const double xx = m.xx - m.x * m.x / m.n;
    const double xy = m.xy - m.x * m.y / m.n;
    const double yy = m.yy - m.y * m.y / m.n;
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy) / degree;
    result.push_back(angle < 0 ? angle + 180 : angle);
  }
  return result;
}

double sphere_diameter(const Frame& spheres, const PackingOptions& options) {
  if (options.particle_diameter) return *options.particle_diameter;
  const auto parameters = find_parameters(spheres.file, options.parameters);
  if (parameters && parameters->values.contains("particle_diameter_m"))
    return parameters->number("particle_diameter_m");
  const auto& radius = spheres.column("radius");
  return 2 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(spheres.rows);
}

void render_spheres(const Frame& spheres, const RenderOptions& options, const std::string& stem) {
  const auto& x = spheres.column("x");
  const auto& y = spheres.column("y");
  const auto& radius = spheres.column("radius");
  if (spheres.rows == 0)
    throw DataError(spheres.file + ": the frame of timestep " + std::to_string(spheres.timestep) +
                    " holds no spheres");
  const Walls walls = find_walls(spheres, options.packing,
                                 find_parameters(spheres.file, options.packing.parameters));
  const double diameter = sphere_diameter(spheres, options.packing);

  double top = walls.floor;
  for (std::size_t i = 0; i < spheres.rows; ++i) top = std::max(top, y[i] + radius[i]);
  const auto window = options.window.value_or(
      std::array<double, 4>{walls.left, walls.right, walls.floor, top + 0.5 * diameter});
  const double width = window[1] - window[0];
  const double height = window[3] - window[2];
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    if (x[i] + radius[i] > window[0] && x[i] - radius[i] < window[1] &&
        y[i] + radius[i] > window[2] && y[i] - radius[i] < window[3])
      visible.push_back(i);
  if (visible.empty())
    throw DataError(spheres.file + ": no sphere lies in the window x " + number_text(window[0]) +
                    " ... " + number_text(window[1]) + " m, y " + number_text(window[2]) + " ... " +
                    number_text(window[3]) + " m");

  ColourScale scale;
  if (options.colour == SphereColour::orientation)
    scale = orientation_scale(spheres);
  else if (options.colour != SphereColour::none)
    scale = sphere_force_scale(spheres, options.colour, options.largest);

  const double longer = std::max(width, height);
  const double pixels =
      options.pixels > 0 ? options.pixels : std::clamp(8 * longer / diameter, 1200.0, 4000.0);
  PackingPicture picture(window, pixels, !scale.values.empty());
  Drawing& drawing = picture.begin();
  const double per_metre = picture.per_metre();
  // All dark discs first, the shaded ones a little smaller on top: an outline around each particle,
  // none between the overlapping spheres of one.
  const double outline = std::clamp(0.06 * diameter * per_metre, 0.3, 3.0);
  for (const auto i : visible)
    drawing.circle(picture.x(x[i]), picture.y(y[i]), radius[i] * per_metre);
  for (const auto i : visible)
    drawing.circle(picture.x(x[i]), picture.y(y[i]), radius[i] * per_metre - outline,
                   scale.shade(i));
  picture.finish(walls, diameter, scale, stem);
}

}  // namespace rodpack

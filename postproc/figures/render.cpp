// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/render.h"

#include <algorithm>
#include <cmath>

#include "analysis/long_axis.h"
#include "figures/drawing.h"
#include "figures/packings/particles.h"
#include "figures/palette.h"
#include "reading/checks/planar.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

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

}  // namespace

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

void render_spheres(const Frame& spheres, const RenderOptions& options, const std::string& stem) {
  const auto& y = spheres.column("y");
  const auto& radius = spheres.column("radius");
  if (spheres.rows == 0)
    throw DataError(spheres.file + ": the frame of timestep " + std::to_string(spheres.timestep) +
                    " holds no spheres");
  const Walls walls = find_walls(spheres, options.packing,
                                 find_parameters(spheres.file, options.packing.parameters));
  const double diameter = sphere_diameter(spheres, options.packing);
  require_planar_spheres(spheres, diameter);

  double top = walls.floor;
  for (std::size_t i = 0; i < spheres.rows; ++i) top = std::max(top, y[i] + radius[i]);
  const auto window = options.window.value_or(
      std::array<double, 4>{walls.left, walls.right, walls.floor, top + 0.5 * diameter});
  const double width = window[1] - window[0];
  const double height = window[3] - window[2];
  const auto visible = visible_spheres(spheres, window);
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
  draw_particles(picture, picture.begin(), spheres, visible, diameter, "",
                 [&scale](std::size_t i) { return scale.shade(i); });
  picture.finish(walls, diameter, scale, stem);
}

}  // namespace rodpack

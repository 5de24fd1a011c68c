// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/voids_figure.h"

#include "figures/drawing.h"
#include "figures/figure.h"
#include "figures/packings/particles.h"

namespace rodpack {

void draw_voids(const Frame& spheres, const std::vector<Void>& voids, const VoidSearch& search,
                const Walls& walls, const std::array<double, 4>& window, double diameter,
                const std::string& stem) {
  PackingPicture picture(window, 1200, false);
  Drawing& drawing = picture.begin();
  const double scale = picture.per_metre();
  draw_particles(picture, drawing, spheres, visible_spheres(spheres, window), diameter, "#606060",
                 [](std::size_t) { return "#dde3e8"; });
  for (const auto& each : voids) {
    const std::string fill = std::string("fill=\"") +
                             (each.in_hollow ? colour::vermilion : colour::blue) +
                             "\" shape-rendering=\"crispEdges\"";
    for (const auto& row : each.rows)
      if (row.x_high > window[0] && row.x_low < window[1] && row.y > window[2] && row.y < window[3])
        drawing.rectangle(picture.x(row.x_low), picture.y(row.y + search.step / 2),
                          (row.x_high - row.x_low) * scale, search.step * scale, fill);
  }
  picture.finish(
      walls, diameter, {}, stem,
      {{colour::vermilion, "void in a hollow"}, {colour::blue, "void between particles"}});
}

}  // namespace rodpack

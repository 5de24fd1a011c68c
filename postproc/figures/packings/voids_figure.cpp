// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/voids_figure.h"

#include <algorithm>

#include "figures/drawing.h"
#include "figures/figure.h"

namespace rodpack {

void draw_voids(const Frame& spheres, const std::vector<Void>& voids, const VoidSearch& search,
                const Walls& walls, const std::array<double, 4>& window, double diameter,
                const std::string& stem) {
  const auto &x = spheres.column("x"), &y = spheres.column("y"), &radius = spheres.column("radius");
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    if (x[i] + radius[i] > window[0] && x[i] - radius[i] < window[1] &&
        y[i] + radius[i] > window[2] && y[i] - radius[i] < window[3])
      visible.push_back(i);
  PackingPicture picture(window, 1200, false);
  Drawing& drawing = picture.begin();
  const double scale = picture.per_metre();
  const double outline = std::clamp(0.06 * diameter * scale, 0.3, 3.0);
  for (const auto i : visible)
    drawing.circle(picture.x(x[i]), picture.y(y[i]), radius[i] * scale, "#606060");
  for (const auto i : visible)
    drawing.circle(picture.x(x[i]), picture.y(y[i]), radius[i] * scale - outline, "#dde3e8");
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

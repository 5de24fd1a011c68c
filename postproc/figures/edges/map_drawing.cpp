// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/edges/map_drawing.h"

#include <algorithm>
#include <cmath>

#include "analysis/fields.h"
#include "figures/edges/shading.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {

std::string palette_command() {
  std::string text = "set palette defined (";
  for (std::size_t k = 0; k < viridis.size(); ++k)
    text += (k ? ", " : "") + std::to_string(k) + " '" +
            palette_colour(viridis, static_cast<double>(k) / (viridis.size() - 1)) + "'";
  return text + ")\n";
}

Rectangle FieldMap::area() const {
  const double half_x = 0.5 * spacing[0], half_y = 0.5 * spacing[1];
  return {x.front() - half_x, x.back() + half_x, y.front() - half_y, y.back() + half_y};
}

void FieldMap::hatch(const std::vector<Rectangle>& parts, const std::string& reason) {
  if (parts.empty()) return;
  blocks += hatch_block("disturbed", parts);
  // The key's sample, on a ground on which white lines show.
  edges += ", " + hatched("disturbed") +
           ", keyentry with boxes fillstyle pattern 4 border linecolor '" + colour::grey +
           "' title '" + reason + "'";
}

void FieldMap::mark_surface(double height) {
  const auto shown = area();
  if (!(height > shown.bottom && height < shown.top)) return;
  blocks += datablock("surface", {{shown.left, shown.right}, {height, height}});
  edges += ", $surface using 1:2 with lines " + surface_look() + " title 'surface'";
}

void draw_map(const FieldMap& map, const std::string& stem) {
  const double width = map.x.back() - map.x.front(), height = map.y.back() - map.y.front();
  const auto shown = map.area();
  // Room for the colour bar, the axes and their labels beside and below the map, the key above it.
  const double aspect = std::clamp(1.25 * width / height * 0.78, 0.5, 2.6);
  draw_figure(stem, aspect,
              datablock("map", {map.x, map.y, map.value}) + map.blocks + palette_command() +
                  "set key tmargin center horizontal\n"
                  "set size ratio -1\nset tics out nomirror\n"
                  "set xlabel '" +
                  map.x_label + "'\nset ylabel '" + map.y_label + "'\nset cblabel '" +
                  map.value_label + "'\nset cbrange [0:*]\nset xrange [" + number_text(shown.left) +
                  ":" + number_text(shown.right) + "]\nset yrange [" + number_text(shown.bottom) +
                  ":" + number_text(shown.top) + "]\nplot $map using 1:2:3 with image" + map.edges +
                  map.over + "\n");
}

void add_crosses(const PlaneStress& stress, std::size_t columns, FieldMap& map) {
  const std::size_t rows = map.x.size() / columns;
  std::vector<PrincipalStress> principal;
  double largest = 0;
  for (std::size_t i = 0; i < map.x.size(); ++i) {
    principal.push_back(principal_stress(stress.xx[i], stress.xy[i], stress.yx[i], stress.yy[i]));
    largest = std::max(largest, principal.back().larger);
  }
  // The longest arms touch; shaft and back, so that an arm is a vector from end to end.
  const double longer = std::max(map.spacing[0] * static_cast<double>(columns),
                                 map.spacing[1] * static_cast<double>(rows));
  const auto stride = [&](std::size_t axis) {
    return static_cast<std::size_t>(std::max(1L, std::lround(longer / 20 / map.spacing[axis])));
  };
  const std::size_t step_x = stride(0), step_y = stride(1);
  const double arm = std::min(static_cast<double>(step_x) * map.spacing[0],
                              static_cast<double>(step_y) * map.spacing[1]);
  std::vector<double> x, y, dx, dy;
  for (std::size_t j = step_y / 2; j < rows; j += step_y)
    for (std::size_t i = step_x / 2; i < columns; i += step_x) {
      const std::size_t at = j * columns + i;
      if (!stress.shown.empty() && !stress.shown[at]) continue;
      for (const auto& [value, turn] :
           {std::pair{principal[at].larger, 0.0}, std::pair{principal[at].smaller, 90.0}}) {
        const double angle = (principal[at].direction + turn) * pi / 180;
        const double length = largest > 0 ? arm * value / largest : 0;
        dx.push_back(length * std::cos(angle));
        dy.push_back(length * std::sin(angle));
        x.push_back(map.x[at] - dx.back() / 2);
        y.push_back(map.y[at] - dy.back() / 2);
      }
    }
  if (x.empty()) return;
  map.blocks += datablock("crosses", {x, y, dx, dy});
  // White on a dark rim, so that they keep apart from the hatching.
  const std::string crosses = ", $crosses using 1:2:3:4 with vectors nohead linewidth ";
  map.over += crosses + "2.4 linecolor '#202020'" + crosses + "1 linecolor '#ffffff'";
}

}  // namespace rodpack

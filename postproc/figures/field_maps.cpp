// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/field_maps.h"

#include <algorithm>
#include <cmath>

#include "analysis/edges/undisturbed.h"
#include "figures/figure.h"
#include "figures/palette.h"
#include "figures/edges/shading.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// What a map shows beside its values: where the bed ends, and where the kernel reaches beyond it.
struct Edges {
  std::string blocks, plots;
};

Edges edges_of(const MappedBed& bed, const Rectangle& map) {
  const auto& packing = bed.packing;
  const double d = packing.particle_diameter;
  const auto in_diameters = [&](const Rectangle& part) {
    return Rectangle{(part.left - packing.walls.left) / d, (part.right - packing.walls.left) / d,
                     (part.bottom - packing.walls.floor) / d, (part.top - packing.walls.floor) / d};
  };
  Edges edges;
  const auto parts =
      parts_outside(in_diameters(undisturbed_part(packing, bed.reach, bed.normalisation)), map);
  if (!parts.empty()) {
    edges.blocks = hatch_block("disturbed", parts);
    // The key's sample, on a ground on which white lines show.
    edges.plots = ", " + hatched("disturbed") +
                  ", keyentry with boxes fillstyle pattern 4 border linecolor '" + colour::grey +
                  "' title '" +
                  shade_title(bed.reach / bed.scale, bed.normalisation == Normalisation::walls) +
                  "'";
  }
  const double surface = (packing.surface - packing.walls.floor) / d;
  if (surface > map.bottom && surface < map.top) {
    edges.blocks += datablock("surface", {{map.left, map.right}, {surface, surface}});
    edges.plots += ", $surface using 1:2 with lines " + surface_look() + " title 'surface'";
  }
  return edges;
}

// Draws a map of `values` over the grid, lengths in d_p; `over` is drawn on top of it.
void plot_map(const Grid& grid, const std::vector<double>& values, const std::string& label,
              const MappedBed& bed, const std::string& blocks, const std::string& over,
              const std::string& stem) {
  const auto& packing = bed.packing;
  const double d = packing.particle_diameter;
  std::vector<double> x, y;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Vector place = grid.place(i);
    x.push_back((place[0] - packing.walls.left) / d);
    y.push_back((place[1] - packing.walls.floor) / d);
  }
  const double half_x = 0.5 * grid.spacing[0] / d, half_y = 0.5 * grid.spacing[1] / d;
  const double width = x.back() - x.front(), height = y.back() - y.front();
  const Rectangle map{x.front() - half_x, x.back() + half_x, y.front() - half_y, y.back() + half_y};
  const auto edges = edges_of(bed, map);
  // Room for the colour bar, the axes and their labels beside and below the map, the key above it.
  const double aspect = std::clamp(1.25 * width / height * 0.78, 0.5, 2.6);
  draw_figure(stem, aspect,
              datablock("map", {x, y, values}) + edges.blocks + blocks + palette_command() +
                  "set key tmargin center horizontal\n"
                  "set size ratio -1\nset tics out nomirror\n"
                  "set xlabel '{/:Italic x} / {/:Italic d}_p'\n"
                  "set ylabel '{/:Italic y} / {/:Italic d}_p'\n"
                  "set cblabel '" +
                  label + "'\nset cbrange [0:*]\nset xrange [" + number_text(map.left) + ":" +
                  number_text(map.right) + "]\nset yrange [" + number_text(map.bottom) + ":" +
                  number_text(map.top) + "]\nplot $map using 1:2:3 with image" + edges.plots +
                  over + "\n");
}

}  // namespace

std::string palette_command() {
  std::string text = "set palette defined (";
  for (std::size_t k = 0; k < viridis.size(); ++k)
    text += (k ? ", " : "") + std::to_string(k) + " '" +
            palette_colour(viridis, static_cast<double>(k) / (viridis.size() - 1)) + "'";
  return text + ")\n";
}

MappedBed mapped_bed(const FieldSample& sample, const Packing& packing) {
  const auto& kernel = sample.averages().kernel();
  return {packing, kernel.scale(), kernel_reach(kernel), sample.normalisation()};
}

void plot_solid_fraction_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                             const MappedBed& bed, const std::string& stem) {
  plot_map(*averages.grid(), field_named(fields, "solid_fraction").values[0],
           "solid fraction {/:Italic φ}", bed, "", "", stem);
}

void plot_pressure_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                       const MappedBed& bed, const std::string& stem) {
  const auto& packing = bed.packing;
  const Grid& grid = *averages.grid();
  const auto& stress = field_named(fields, "contact_stress").values;
  const double d = packing.particle_diameter;
  std::vector<double> pressure(grid.size());
  double largest = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    pressure[i] = 0.5 * (stress[0][i] + stress[3][i]);
    largest = std::max(
        largest, principal_stress(stress[0][i], stress[1][i], stress[2][i], stress[3][i]).larger);
  }
  const auto unit = scaled_unit(largest, "N/m");
  for (double& value : pressure) value *= unit.factor;

  // Crosses about 20 along the longer side, the longest arms touching; shaft and back, so that an
  // arm is a vector from end to end.
  const double longer = std::max(grid.spacing[0] * grid.count[0], grid.spacing[1] * grid.count[1]);
  const auto stride = [&](std::size_t axis) {
    return std::max(1, static_cast<int>(std::lround(longer / 20 / grid.spacing[axis])));
  };
  const int step_x = stride(0), step_y = stride(1);
  const double arm = std::min(step_x * grid.spacing[0], step_y * grid.spacing[1]) / d;
  std::vector<double> x, y, dx, dy;
  for (int j = step_y / 2; j < grid.count[1]; j += step_y)
    for (int i = step_x / 2; i < grid.count[0]; i += step_x) {
      const auto at = static_cast<std::size_t>(j * grid.count[0] + i);
      const auto principal =
          principal_stress(stress[0][at], stress[1][at], stress[2][at], stress[3][at]);
      const Vector place = grid.place(at);
      for (const auto& [value, turn] :
           {std::pair{principal.larger, 0.0}, std::pair{principal.smaller, 90.0}}) {
        const double angle = (principal.direction + turn) * pi / 180;
        const double length = largest > 0 ? arm * value / largest : 0;
        dx.push_back(length * std::cos(angle));
        dy.push_back(length * std::sin(angle));
        x.push_back((place[0] - packing.walls.left) / d - dx.back() / 2);
        y.push_back((place[1] - packing.walls.floor) / d - dy.back() / 2);
      }
    }
  // White on a dark rim, so that they keep apart from the hatching.
  const std::string crosses = ", $crosses using 1:2:3:4 with vectors nohead linewidth ";
  plot_map(grid, pressure, "pressure {/:Italic P}_0 (" + unit.name + ")", bed,
           datablock("crosses", {x, y, dx, dy}),
           crosses + "2.4 linecolor '#202020'" + crosses + "1 linecolor '#ffffff'", stem);
}

}  // namespace rodpack

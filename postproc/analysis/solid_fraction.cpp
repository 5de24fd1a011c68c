// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"

#include <algorithm>
#include <cmath>

#include "rodpack/averaging/averaging_kernel.h"
#include "figures/figure.h"
#include "reading/text.h"

namespace rodpack {

SolidFraction solid_fraction(const Packing& packing) {
  const auto& walls = packing.walls;
  const double width = 2 * packing.axial_length();
  const double left = (walls.left + walls.right - width) / 2;
  SolidFraction field;
  field.scale = 3 * packing.axial_length();
  field.surface = packing.surface;
  field.lowest = walls.floor + (walls.bottom ? 3 * field.scale : 0);
  field.side_distance_kept = !walls.sides || left - walls.left >= 3 * field.scale;

  // Share of each particle's area that the kernel puts into the slice's x range, per slice width.
  std::vector<double> share(packing.size());
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const double x = packing.x[i] - left;
    share[i] = packing.area[i] * gaussian_integral(-x, width - x, field.scale) / width;
    if (!walls.sides)
      for (const double image : {x - walls.width(), x + walls.width()})
        share[i] += packing.area[i] * gaussian_integral(-image, width - image, field.scale) / width;
  }

  const auto mean = [&](double from, double to) -> std::optional<double> {
    if (to <= from) return std::nullopt;
    double sum = 0;
    for (std::size_t i = 0; i < packing.size(); ++i)
      sum += share[i] * gaussian_integral(from - packing.y[i], to - packing.y[i], field.scale);
    return sum / (to - from);
  };
  field.up_to_surface = mean(field.lowest, field.surface);
  field.up_to_3_scales_below = mean(field.lowest, field.surface - 3 * field.scale);

  for (std::size_t i = 0; i < packing.size(); ++i)
    if (packing.y[i] < packing.surface) field.covered_below_surface += packing.area[i];
  field.covered_below_surface /= walls.width() * (packing.surface - walls.floor);

  constexpr int points = 300;
  const double height = std::max(field.surface - walls.floor, packing.particle_diameter);
  for (int k = 0; k <= points; ++k) {
    const double y = walls.floor + height * k / points;
    double phi = 0;
    for (std::size_t i = 0; i < packing.size(); ++i)
      phi += share[i] * gaussian(y - packing.y[i], field.scale);
    field.height.push_back(y - walls.floor);
    field.phi.push_back(phi);
  }
  return field;
}

void write_solid_fraction_table(const SolidFraction& field, double particle_diameter,
                                const std::string& file) {
  auto height = field.height;
  for (auto& each : height) each /= particle_diameter;
  write_csv(file, {{"height_over_dp", height}, {"solid_fraction", field.phi}});
}

void plot_solid_fraction(const SolidFraction& field, double particle_diameter, double floor,
                         const std::string& stem) {
  auto height = field.height;
  for (auto& each : height) each /= particle_diameter;
  std::string range;
  if (field.up_to_surface)
    range = "set object rectangle from graph 0, first " +
            number_text((field.lowest - floor) / particle_diameter) + " to graph 1, first " +
            number_text((field.surface - floor) / particle_diameter) +
            " behind fillstyle solid noborder fillcolor '#EEEEEE'\n"
            "set label 'mean over the grey range: {/:Italic φ} = " +
            number_text(*field.up_to_surface, 3) + "' at graph 0.05, 0.55\n";
  // Nearer to the surface the kernel averages over the empty space above it.
  if (field.up_to_3_scales_below)
    range += "set label 'up to 3{/:Italic ω} below the surface: {/:Italic φ} = " +
             number_text(*field.up_to_3_scales_below, 3) + "' at graph 0.05, 0.49\n";
  draw_figure(stem, 1.0,
              datablock("phi", {height, field.phi}) + range +
                  "set xlabel 'solid fraction {/:Italic φ}'\n"
                  "set ylabel 'height above the floor / {/:Italic d}_p'\n"
                  "set xrange [0:1]\nset yrange [0:" +
                  number_text(height.back()) +
                  "]\n"
                  "plot $phi using 2:1 with lines linewidth 1.6 linecolor '" +
                  colour::blue + "'\n");
}

}  // namespace rodpack

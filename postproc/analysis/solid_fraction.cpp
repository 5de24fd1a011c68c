// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"

#include <algorithm>
#include <cmath>

#include "reading/csv_file.h"
#include "rodpack/averaging/averaging_kernel.h"

namespace rodpack {
namespace {

// Relative margin of comparisons of lengths: the paper's container leaves exactly 3 w beside its
// slice, and lengths in parameters.json and dumps are rounded to six digits or more.
constexpr double rounding = 1e-5;

}  // namespace

SolidFraction solid_fraction(const Packing& packing) {
  const auto& walls = packing.walls;
  const double width = 2 * packing.axial_length();
  const double left = (walls.left + walls.right - width) / 2;
  SolidFraction field;
  field.scale = 3 * packing.axial_length();
  field.surface = packing.surface;
  field.lowest = walls.floor + (walls.bottom ? 3 * field.scale : 0);
  field.side_distance_kept = !walls.sides || left - walls.left >= 3 * field.scale * (1 - rounding);

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

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/solid_fraction.h"

#include <algorithm>
#include <cmath>

#include "analysis/fields.h"
#include "analysis/edges/undisturbed.h"
#include "reading/csv_file.h"
#include "rodpack/averaging/kernel_share.h"

namespace rodpack {
namespace {

// Mean of f between two places by Simpson's rule, steps below `longest`.
template <class Function>
double simpson_mean(double from, double to, double longest, Function f) {
  const int steps = 2 * std::max(1, static_cast<int>(std::ceil((to - from) / longest / 2)));
  double sum = f(from) + f(to);
  for (int k = 1; k < steps; ++k) sum += (k % 2 ? 4 : 2) * f(from + (to - from) * k / steps);
  return sum / (3 * steps);
}

// Mean over the slice from the height `from` to the surface of the solid fraction divided by the
// kernel's share between the walls and below the surface, which is a product of one factor across
// the bed and one along its height. `share`: as below, for a bed without side walls.
double normalised_mean(const Packing& packing, double left, double width, double from, double scale,
                       std::vector<double> share) {
  const AveragingKernel kernel(KernelShape::gaussian, 2, scale);
  const double step = scale / 24;  // leaves an error of (1/24)^4 / 180 of the Gaussian: 2e-8
  const auto space = counted_space(packing, Normalisation::walls_and_surface);
  const Rectangle all = counted_space(packing, Normalisation::none);
  const double middle_x = left + width / 2, middle_y = (from + packing.surface) / 2;
  const Rectangle between{space.left, space.right, all.bottom, all.top};
  const Rectangle below{all.left, all.right, space.bottom, space.top};
  if (packing.walls.sides)
    for (std::size_t i = 0; i < packing.size(); ++i)
      share[i] =
          packing.area[i] * simpson_mean(left, left + width, step, [&](double x) {
            return gaussian(x - packing.x[i], scale) / kernel_share(kernel, x, middle_y, between);
          });
  return simpson_mean(from, packing.surface, step, [&](double y) {
    double phi = 0;
    for (std::size_t i = 0; i < packing.size(); ++i)
      phi += share[i] * gaussian(y - packing.y[i], scale);
    return phi / kernel_share(kernel, middle_x, y, below);
  });
}

}  // namespace

SolidFraction solid_fraction(const Packing& packing) {
  const auto& walls = packing.walls;
  // A periodic bed has no middle: its slice is the whole period.
  const double width = walls.sides ? 2 * packing.axial_length() : walls.width();
  const double left = (walls.left + walls.right - width) / 2;
  SolidFraction field;
  field.scale = 3 * packing.axial_length();
  field.surface = packing.surface;
  field.lowest = walls.floor + (walls.bottom ? 3 * field.scale : 0);
  field.side_distance_kept = slice_is_undisturbed(packing, 3 * field.scale);

  // Share of each particle's area that the kernel puts into the slice's x range, per slice width.
  std::vector<double> share(packing.size());
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const double x = packing.x[i] - left;
    const double inside = walls.sides ? gaussian_integral(-x, width - x, field.scale) : 1;
    share[i] = packing.area[i] * inside / width;
  }
  // Images above and below, as far as the kernel counts.
  std::vector<double> shifts{0};
  if (!walls.bottom) {
    const double period = walls.ceiling - walls.floor;
    const int most = 1 + static_cast<int>(std::ceil(8 * field.scale / period));
    for (int k = 1; k <= most; ++k) shifts.insert(shifts.end(), {-k * period, k * period});
  }

  const auto mean = [&](double from, double to) -> std::optional<double> {
    if (to <= from) return std::nullopt;
    double sum = 0;
    for (const double shift : shifts)
      for (std::size_t i = 0; i < packing.size(); ++i) {
        const double y = packing.y[i] + shift;
        sum += share[i] * gaussian_integral(from - y, to - y, field.scale);
      }
    return sum / (to - from);
  };
  field.up_to_surface = mean(field.lowest, field.surface);
  field.up_to_3_scales_below =
      mean(field.lowest, field.surface - (walls.bottom ? 3 * field.scale : 0));

  const auto normalised = [&](double from) -> std::optional<double> {
    if (packing.surface <= from || !walls.bottom) return std::nullopt;
    return normalised_mean(packing, left, width, from, field.scale, share);
  };
  field.normalised_up_to_surface = normalised(field.lowest);
  field.normalised_from_floor_to_surface = normalised(walls.floor);

  for (std::size_t i = 0; i < packing.size(); ++i)
    if (packing.y[i] < packing.surface) field.covered_below_surface += packing.area[i];
  field.covered_below_surface /= walls.width() * (packing.surface - walls.floor);

  constexpr int points = 300;
  const double height = std::max(field.surface - walls.floor, packing.particle_diameter);
  for (int k = 0; k <= points; ++k) {
    const double y = walls.floor + height * k / points;
    double phi = 0;
    for (const double shift : shifts)
      for (std::size_t i = 0; i < packing.size(); ++i)
        phi += share[i] * gaussian(y - packing.y[i] - shift, field.scale);
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

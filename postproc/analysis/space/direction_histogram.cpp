// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/direction_histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reading/angles.h"
#include "reading/csv_file.h"

namespace rodpack {
namespace {

void normalise_bins(DirectionHistogram& histogram) {
  double total = 0;
  for (const double each : histogram.count) total += each;
  const double bins = static_cast<double>(histogram.count.size());
  for (const double each : histogram.count) {
    const double p = total > 0 ? each / total : 0;
    histogram.density.push_back(p * bins);
    histogram.standard_error.push_back(total > 0 ? std::sqrt(p * (1 - p) / total) * bins : 0);
  }
}

}  // namespace

DirectionAngles direction_angles(const Vector3& direction, std::size_t vertical) {
  const double up = direction[vertical];
  const double first = direction[(vertical + 1) % 3], second = direction[(vertical + 2) % 3];
  const double across = std::hypot(first, second);
  DirectionAngles angles{};
  angles.polar = std::atan2(across, std::abs(up)) / degree;
  // Nearer to the vertical than rounding errors, a direction has no azimuth.
  angles.azimuth = std::numeric_limits<double>::quiet_NaN();
  if (across > 1e-12) {
    const double azimuth = std::atan2(second, first) / degree;
    angles.azimuth = azimuth < 0 ? azimuth + 180 : azimuth;
    if (angles.azimuth >= 180) angles.azimuth -= 180;
  }
  return angles;
}

DirectionHistogram polar_histogram(const std::vector<Vector3>& directions, std::size_t vertical,
                                   std::size_t bins) {
  DirectionHistogram histogram;
  const double steps = static_cast<double>(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    histogram.from.push_back(std::acos(1 - static_cast<double>(k) / steps) / degree);
    histogram.to.push_back(std::acos(1 - static_cast<double>(k + 1) / steps) / degree);
  }
  histogram.count.assign(bins, 0);
  for (const auto& direction : directions) {
    const double below_top = (1 - std::abs(direction[vertical])) * steps;
    histogram.count[std::min(static_cast<std::size_t>(std::max(below_top, 0.0)), bins - 1)] += 1;
  }
  normalise_bins(histogram);
  return histogram;
}

DirectionHistogram azimuth_histogram(const std::vector<Vector3>& directions, std::size_t vertical,
                                     std::size_t bins) {
  DirectionHistogram histogram;
  const double width = 180 / static_cast<double>(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    histogram.from.push_back((static_cast<double>(k) - 0.5) * width);
    histogram.to.push_back((static_cast<double>(k) + 0.5) * width);
  }
  histogram.count.assign(bins, 0);
  for (const auto& direction : directions) {
    const double azimuth = direction_angles(direction, vertical).azimuth;
    if (std::isnan(azimuth)) continue;
    histogram.count[static_cast<std::size_t>(azimuth / width + 0.5) % bins] += 1;
  }
  normalise_bins(histogram);
  return histogram;
}

void write_direction_table(const DirectionHistogram& histogram, const std::string& angle,
                           const std::string& file) {
  write_csv(file, {{angle + "_from_deg", histogram.from},
                   {angle + "_to_deg", histogram.to},
                   {"count", histogram.count},
                   {"density_over_isotropic", histogram.density},
                   {"standard_error", histogram.standard_error}});
}

}  // namespace rodpack

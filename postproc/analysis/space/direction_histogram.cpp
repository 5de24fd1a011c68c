// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/direction_histogram.h"

#include <algorithm>
#include <array>
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

std::size_t polar_bin(const Vector3& direction, std::size_t vertical, std::size_t bins) {
  const double below_top = (1 - std::abs(direction[vertical])) * static_cast<double>(bins);
  return std::min(static_cast<std::size_t>(std::max(below_top, 0.0)), bins - 1);
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
  for (const auto& direction : directions)
    histogram.count[polar_bin(direction, vertical, bins)] += 1;
  normalise_bins(histogram);
  return histogram;
}

DirectionHistogram azimuth_histogram(const std::vector<Vector3>& directions, std::size_t vertical,
                                     std::size_t bins) {
  DirectionHistogram histogram;
  if (bins == 0) return histogram;
  const double width = 180 / static_cast<double>(bins);
  for (std::size_t k = 0; k < bins; ++k) {
    histogram.from.push_back((static_cast<double>(k) - 0.5) * width);
    histogram.to.push_back((static_cast<double>(k) + 0.5) * width);
  }
  histogram.count.assign(bins, 0);
  for (const auto& direction : directions) {
    const double azimuth = direction_angles(direction, vertical).azimuth;
    if (std::isnan(azimuth)) continue;
    const double nearest = std::round(azimuth / width);
    histogram.count[static_cast<std::size_t>(nearest) % histogram.count.size()] += 1;
  }
  normalise_bins(histogram);
  return histogram;
}

void write_direction_table(
    const DirectionHistogram& histogram, const std::string& angle, const std::string& file,
    const std::vector<std::pair<std::string, std::vector<double>>>& further) {
  std::vector<std::pair<std::string, std::vector<double>>> columns{
      {angle + "_from_deg", histogram.from},
      {angle + "_to_deg", histogram.to},
      {"count", histogram.count},
      {"density_over_isotropic", histogram.density},
      {"standard_error", histogram.standard_error}};
  columns.insert(columns.end(), further.begin(), further.end());
  write_csv(file, columns);
}

void write_order_table(const OrderTensor& order, std::size_t vertical, const std::string& file) {
  std::vector<double> value, error, polar, azimuth;
  std::array<std::vector<double>, 3> components;
  for (std::size_t k = 0; k < 3; ++k) {
    value.push_back(order.value[k]);
    error.push_back(order.standard_error[k]);
    const auto& direction = order.direction[k];
    const double sign = direction[vertical] < 0 ? -1 : 1;
    for (std::size_t c = 0; c < 3; ++c) components[c].push_back(sign * direction[c]);
    const auto angles = direction_angles(direction, vertical);
    polar.push_back(angles.polar);
    azimuth.push_back(angles.azimuth);
  }
  write_csv(file, {{"order", value},
                   {"standard_error", error},
                   {"direction_x", components[0]},
                   {"direction_y", components[1]},
                   {"direction_z", components[2]},
                   {"polar_deg", polar},
                   {"azimuth_deg", azimuth}});
}

}  // namespace rodpack

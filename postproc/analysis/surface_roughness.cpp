// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/surface_roughness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace rodpack {
namespace {

/// Returns the spacing of the spheres, in d.
double spacing(double overlap) {
  if (!(overlap >= 0 && overlap < 1))
    throw std::invalid_argument("overlap = " + std::to_string(overlap) +
                                ": expected at least 0 and below 1");
  return 1 - overlap;
}

}  // namespace

double groove_depth(double overlap) {
  const double s = spacing(overlap);
  return (1 - std::sqrt(1 - s * s)) / 2;
}

double sliding_amplitude(double overlap) {
  const double half = spacing(overlap) / 2;
  return 1 - std::sqrt(1 - half * half);
}

double groove_friction(double overlap) { return std::tan(std::asin(spacing(overlap) / 2)); }

double chain_force_ratio(double overlap, double depth, double offset) {
  const double s = spacing(overlap);
  if (!(depth > 0 && depth < 1))
    throw std::invalid_argument("depth = " + std::to_string(depth) + ": expected between 0 and 1");
  const double height = 1 - depth;
  // Spheres in touch are at most this far along the axis.
  const double reach = std::sqrt(1 - height * height);
  double force = 0;
  for (double j = std::ceil(-reach / s - offset); (j + offset) * s <= reach; ++j) {
    const double distance = std::hypot(height, (j + offset) * s);
    force += std::max(0.0, 1 - distance) * height / distance;
  }
  return force / depth;
}

ForceRatioRange chain_force_range(double overlap, double depth) {
  constexpr int samples = 2000;
  ForceRatioRange range{INFINITY, 0, 0};
  for (int i = 0; i <= samples; ++i) {
    const double ratio = chain_force_ratio(overlap, depth, 0.5 * i / samples);
    range.least = std::min(range.least, ratio);
    range.largest = std::max(range.largest, ratio);
    range.mean += ratio * (i == 0 || i == samples ? 0.5 : 1) / samples;
  }
  return range;
}

}  // namespace rodpack

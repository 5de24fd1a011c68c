// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/peaks.h"

#include <algorithm>
#include <cmath>

namespace rodpack {
namespace {

// Square of the standard error, smoothed over the bins within half a unit; negative: not known.
std::vector<double> variances_of(const EnsembleCurve& curve, double width) {
  const auto bins = static_cast<long>(curve.y.size());
  const long half = std::max(1L, std::lround(0.5 / width));
  std::vector<double> variance(curve.y.size(), -1);
  for (long k = 0; k < bins; ++k) {
    double sum = 0;
    int count = 0;
    for (long i = std::max(0L, k - half); i <= std::min(bins - 1, k + half); ++i) {
      const auto& sem = curve.y[static_cast<std::size_t>(i)].sem;
      if (!sem || !std::isfinite(*sem)) continue;
      sum += *sem * *sem;
      ++count;
    }
    if (count > 0) variance[static_cast<std::size_t>(k)] = sum / count;
  }
  return variance;
}

// The lowest bin between `peak` and the next higher one, or the end, in direction `step`.
std::size_t low_beside(const std::vector<EnsembleMean>& y, std::size_t peak, int step) {
  std::size_t low = peak;
  for (long k = static_cast<long>(peak) + step; k >= 0 && k < static_cast<long>(y.size());
       k += step) {
    const auto bin = static_cast<std::size_t>(k);
    if (y[bin].mean > y[peak].mean) break;
    if (y[bin].mean < y[low].mean) low = bin;
  }
  return low;
}

// Vertex of the parabola through three bins at -w, 0, w: w (a - c) / (2 (a - 2 b + c)).
void place_peak(Peak& peak, const EnsembleCurve& curve, std::size_t bin, double width,
                const std::vector<double>& variance) {
  const double a = curve.y[bin - 1].mean, b = curve.y[bin].mean, c = curve.y[bin + 1].mean;
  const double bend = a - 2 * b + c;
  peak.position = curve.x[bin] + width * (a - c) / (2 * bend);
  const double by_a = width * (c - b) / (bend * bend);
  const double by_b = width * (a - c) / (bend * bend);
  const double by_c = width * (b - a) / (bend * bend);
  peak.position_error = std::sqrt(by_a * by_a * variance[bin - 1] + by_b * by_b * variance[bin] +
                                  by_c * by_c * variance[bin + 1]);
}

}  // namespace

std::vector<Peak> find_peaks(const EnsembleCurve& curve) {
  std::vector<Peak> peaks;
  if (curve.x.size() < 3) return peaks;
  const double width = curve.x[1] - curve.x[0];
  const auto variance = variances_of(curve, width);
  for (std::size_t bin = 1; bin + 1 < curve.x.size(); ++bin) {
    const double here = curve.y[bin].mean;
    if (!(variance[bin] >= 0) || !(here > curve.y[bin - 1].mean) || !(here > curve.y[bin + 1].mean))
      continue;
    const auto left = low_beside(curve.y, bin, -1), right = low_beside(curve.y, bin, 1);
    const auto low = curve.y[left].mean > curve.y[right].mean ? left : right;
    Peak peak;
    peak.height = curve.y[bin];
    peak.prominence = curve.y[bin].mean - curve.y[low].mean;
    peak.prominence_error = std::sqrt(variance[bin] + std::max(0.0, variance[low]));
    if (!(peak.prominence > peak_significance * peak.prominence_error)) continue;
    place_peak(peak, curve, bin, width, variance);
    peaks.push_back(peak);
  }
  return peaks;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/rdf_peak.h"

#include <algorithm>
#include <cmath>

#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double nearest = 0.2;  // d_p, between the given distance and a peak's highest bin
constexpr double rounding = 1e-9;

double bin_width(const Rdf& rdf) { return 2 * rdf.r.front(); }

RdfPeak from_bins(const Rdf& rdf, std::size_t first, std::size_t last) {
  RdfPeak peak;
  peak.first = first;
  peak.last = last;
  peak.from = rdf.r[first] - bin_width(rdf) / 2;
  peak.to = rdf.r[last] + bin_width(rdf) / 2;
  const auto highest = std::max_element(rdf.g.begin() + static_cast<std::ptrdiff_t>(first),
                                        rdf.g.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  peak.summit = rdf.r[static_cast<std::size_t>(highest - rdf.g.begin())];
  peak.g = *highest;
  return peak;
}

// Lowest G on the way from bin k to the next higher bin or the end, in the direction of `step`.
double lowest_beside(const std::vector<double>& g, std::size_t k, int step) {
  double lowest = g[k];
  for (auto i = static_cast<std::ptrdiff_t>(k) + step;
       i >= 0 && i < static_cast<std::ptrdiff_t>(g.size()); i += step) {
    const double value = g[static_cast<std::size_t>(i)];
    if (value > g[k]) break;
    lowest = std::min(lowest, value);
  }
  return lowest;
}

std::string list_of(const std::vector<RdfPeak>& peaks) {
  if (peaks.empty()) return "it has none that rise by three standard errors";
  std::string text = "its peaks are at ";
  for (std::size_t k = 0; k < peaks.size(); ++k)
    text += (k > 0 ? ", " : "") + number_text(peaks[k].summit, 4);
  return text + " d_p";
}

RdfPeak bins_around(const Rdf& rdf, double r, double half_width) {
  std::size_t first = static_cast<std::size_t>(r / bin_width(rdf)), last = first;
  while (first > 0 && rdf.r[first - 1] >= r - half_width - rounding) --first;
  while (last + 1 < rdf.r.size() && rdf.r[last + 1] <= r + half_width + rounding) ++last;
  return from_bins(rdf, first, last);
}

}  // namespace

std::vector<RdfPeak> rdf_peaks(const Rdf& rdf) {
  std::vector<RdfPeak> peaks;
  const auto& g = rdf.g;
  for (std::size_t k = 0; k < g.size(); ++k) {
    if ((k > 0 && g[k - 1] >= g[k]) || (k + 1 < g.size() && g[k + 1] > g[k])) continue;
    const double base = std::max(lowest_beside(g, k, -1), lowest_beside(g, k, 1));
    if (!(g[k] - base > 3 * rdf.standard_error[k])) continue;
    std::size_t first = k, last = k;
    while (first > 0 && g[first - 1] > (g[k] + base) / 2) --first;
    while (last + 1 < g.size() && g[last + 1] > (g[k] + base) / 2) ++last;
    peaks.push_back(from_bins(rdf, first, last));
  }
  return peaks;
}

RdfPeak find_rdf_peak(const Rdf& rdf, double r, std::optional<double> half_width) {
  const double end = rdf.r.back() + bin_width(rdf) / 2;
  if (!(r >= 0 && r < end - rounding))
    throw DataError("the distance to explain, " + number_text(r, 6) +
                    " d_p, is not within the range of G(r), 0 to " + number_text(end, 6) + " d_p");
  RdfPeak peak;
  if (half_width) {
    peak = bins_around(rdf, r, *half_width);
    double pairs = 0;
    for (std::size_t k = peak.first; k <= peak.last; ++k) pairs += rdf.pairs[k];
    if (pairs > 0) return peak;
    throw DataError("no pair of particles is " + number_text(peak.from, 6) + " to " +
                    number_text(peak.to, 6) + " d_p apart: there is nothing to explain");
  }
  const auto peaks = rdf_peaks(rdf);
  const auto distance = [r](const RdfPeak& each) { return std::abs(each.summit - r); };
  const auto closest = std::min_element(
      peaks.begin(), peaks.end(),
      [&](const RdfPeak& a, const RdfPeak& b) { return distance(a) < distance(b); });
  if (closest == peaks.end() || distance(*closest) > nearest + bin_width(rdf) / 2 + rounding)
    throw DataError("G(r) has no peak within " + number_text(nearest) + " d_p of " +
                    number_text(r, 6) + " d_p; " + list_of(peaks));
  return *closest;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/volume_shares.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

namespace {

/// Adds to each sphere its share of the slab [from, to], inside which the spheres' cross-sections,
/// concentric discs, do not change their order. The k largest discs share what lies between the
/// k-th and the next; its area is quadratic in x, so Simpson's rule is exact.
void add_slab(const std::vector<double>& x, double radius, double from, double to,
              std::vector<double>& shares) {
  const double middle = 0.5 * (from + to);
  std::vector<std::size_t> cut;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(middle - x[i]) < radius) cut.push_back(i);
  std::sort(cut.begin(), cut.end(), [&](std::size_t i, std::size_t j) {
    return std::abs(middle - x[i]) < std::abs(middle - x[j]);
  });
  const auto disc = [&](std::size_t i) {  // volume of disc i over the slab, divided by pi
    const auto area = [&](double at) { return radius * radius - (at - x[i]) * (at - x[i]); };
    return (to - from) / 6. * (area(from) + 4. * area(middle) + area(to));
  };
  double inner = 0, share = 0;
  for (std::size_t k = cut.size(); k-- > 0;) {
    const double outer = disc(cut[k]);
    share += (outer - inner) / static_cast<double>(k + 1);
    shares[cut[k]] += share;
    inner = outer;
  }
}

}  // namespace

std::vector<double> volume_shares(const ChainShape& shape) {
  const auto centres = sphere_centres(shape);
  std::vector<double> shares(centres.size(), 0.);
  if (centres.size() == 1) return {1.};

  const double radius = 0.5 * shape.diameter;
  const double spacing = std::hypot(centres[1][0] - centres[0][0], centres[1][1] - centres[0][1]);
  std::vector<double> x;
  for (std::size_t i = 0; i < centres.size(); ++i) x.push_back(spacing * static_cast<double>(i));
  std::vector<double> borders;
  for (std::size_t i = 0; i < x.size(); ++i) {
    borders.push_back(x[i] - radius);
    borders.push_back(x[i] + radius);
    for (std::size_t j = i + 1; j < x.size() && x[j] - x[i] < 2. * radius; ++j)
      borders.push_back(0.5 * (x[i] + x[j]));
  }
  std::sort(borders.begin(), borders.end());
  for (std::size_t i = 1; i < borders.size(); ++i)
    if (borders[i] > borders[i - 1]) add_slab(x, radius, borders[i - 1], borders[i], shares);

  double total = 0;
  for (double share : shares) total += share;
  for (double& share : shares) share /= total;
  return shares;
}

}  // namespace rodpack

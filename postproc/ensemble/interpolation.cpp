// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/interpolation.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

std::optional<double> interpolated(const std::vector<double>& x, const std::vector<double>& y,
                                   double at) {
  if (x.empty()) return std::nullopt;
  const double rounding = 1e-9 * (std::fabs(x.front()) + std::fabs(x.back()));
  if (at < x.front() - rounding || at > x.back() + rounding) return std::nullopt;
  const std::size_t points = std::min<std::size_t>(4, x.size());
  const auto above = static_cast<std::size_t>(std::lower_bound(x.begin(), x.end(), at) - x.begin());
  const std::size_t first = std::min(above - std::min<std::size_t>(above, 2), x.size() - points);
  double value = 0;
  for (std::size_t i = first; i < first + points; ++i) {
    double weight = 1;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
    value += weight * y[i];
  }
  return value;
}

}  // namespace rodpack

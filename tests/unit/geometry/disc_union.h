// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_UNIT_DISC_UNION_H
#define RODPACK_TESTS_UNIT_DISC_UNION_H

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace rodpack::test {

using Points = std::vector<std::array<double, 2>>;

/// Integrals of 1, y, x^2, y^2 over a union of equal discs, and of z^2 where it is a solid.
struct Moments {
  double one = 0, y = 0, xx = 0, yy = 0, zz = 0;
};

/// Integral of f over [a, b] by tanh-sinh quadrature: exact to round-off also where f has a square
/// root at either end.
template <class F>
void tanh_sinh(double a, double b, F f) {
  const double pi = std::acos(-1.0), step = 1.0 / 12;
  for (int k = -40; k <= 40; ++k) {
    const double t = k * step, u = 0.5 * pi * std::sinh(t);
    const double weight =
        0.5 * (b - a) * step * 0.5 * pi * std::cosh(t) / std::pow(std::cosh(u), 2);
    f(0.5 * (a + b) + 0.5 * (b - a) * std::tanh(u), weight);
  }
}

/// Green's theorem on the arcs of the outline: nothing is assumed about how the discs are arranged.
inline Moments disc_union(const Points& centres, double r) {
  const double pi = std::acos(-1.0);
  Moments sum;
  for (std::size_t i = 0; i < centres.size(); ++i) {
    std::vector<std::pair<double, double>> covered;
    for (std::size_t j = 0; j < centres.size(); ++j) {
      const double dx = centres[j][0] - centres[i][0], dy = centres[j][1] - centres[i][1];
      const double distance = std::hypot(dx, dy);
      if (i == j || distance >= 2 * r) continue;
      const double towards = std::atan2(dy, dx), half = std::acos(distance / (2 * r));
      double from = towards - half;
      while (from < 0) from += 2 * pi;
      const double to = from + 2 * half;
      covered.push_back({from, std::min(to, 2 * pi)});
      if (to > 2 * pi) covered.push_back({0.0, to - 2 * pi});
    }
    covered.push_back({2 * pi, 2 * pi});
    std::sort(covered.begin(), covered.end());
    double bare = 0;
    for (const auto& [from, to] : covered) {
      if (from > bare) {
        // Each line integral is smooth on the arc.
        tanh_sinh(bare, from, [&](double a, double w) {
          const double x = centres[i][0] + r * std::cos(a), y = centres[i][1] + r * std::sin(a);
          const double wdx = -w * r * std::sin(a), wdy = w * r * std::cos(a);
          sum.one += 0.5 * (x * wdy - y * wdx);
          sum.y -= 0.5 * y * y * wdx;
          sum.xx += x * x * x / 3 * wdy;
          sum.yy -= y * y * y / 3 * wdx;
        });
      }
      bare = std::max(bare, to);
    }
  }
  return sum;
}

/// Union of equal balls: slices of `disc_union` over z, split where the outline of a slice changes.
inline Moments ball_union(const Points& centres, double r, const std::vector<double>& slice_radii) {
  std::vector<double> levels = {0.0, r};
  for (double s : slice_radii)
    if (s < r) levels.push_back(std::sqrt(r * r - s * s));
  std::sort(levels.begin(), levels.end());
  Moments sum;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    if (levels[i + 1] - levels[i] < 1e-12 * r) continue;
    tanh_sinh(levels[i], levels[i + 1], [&](double z, double w) {
      if (z >= r) return;
      const Moments slice = disc_union(centres, std::sqrt((r - z) * (r + z)));
      sum.one += 2 * w * slice.one;
      sum.y += 2 * w * slice.y;
      sum.xx += 2 * w * slice.xx;
      sum.yy += 2 * w * slice.yy;
      sum.zz += 2 * w * z * z * slice.one;
    });
  }
  return sum;
}

}  // namespace rodpack::test

#endif

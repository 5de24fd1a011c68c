// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/interpolation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace rodpack;

TEST(Interpolation, IsExactForACubic) {
  const auto cubic = [](double x) { return 2 - x + 0.5 * x * x - 0.25 * x * x * x; };
  std::vector<double> x, y;
  for (int k = 0; k < 8; ++k) {
    x.push_back(0.7 * k);
    y.push_back(cubic(x.back()));
  }
  for (double at = 0; at <= x.back(); at += 0.01)
    EXPECT_NEAR(interpolated(x, y, at).value(), cubic(at), 1e-12);
}

// A Gaussian of scale w = 1 has |y''''| <= 3. With points w/4 apart the cubic is off by at most
// 3/128 (1/4)^4 3 = 2.75e-4 between its middle two points, (1/4)^4 / 24 3 = 4.9e-4 beside them. The
// bound is nearly reached at the top, so that a straight line, off by (1/4)^2 / 8 = 8e-3, fails.
TEST(Interpolation, OfAGaussianIsOffByTheBoundThatIsStated) {
  const auto gaussian = [](double x) { return std::exp(-x * x / 2); };
  double worst = 0;
  for (double shift = 0; shift < 0.25; shift += 0.01) {
    std::vector<double> x, y;
    for (int k = -20; k <= 20; ++k) {
      x.push_back(0.25 * k + shift);
      y.push_back(gaussian(x.back()));
    }
    for (double at = -4; at <= 4; at += 0.013)
      worst = std::max(worst, std::fabs(interpolated(x, y, at).value() - gaussian(at)));
  }
  EXPECT_LT(worst, 2.75e-4);
  EXPECT_GT(worst, 2.2e-4);
  // In the first interval, with the steepest part of the curve there.
  for (double start = -3; start <= 3; start += 0.05) {
    std::vector<double> x, y;
    for (int k = 0; k < 8; ++k) {
      x.push_back(start + 0.25 * k);
      y.push_back(gaussian(x.back()));
    }
    for (double at = start; at < start + 0.25; at += 0.01)
      EXPECT_LT(std::fabs(interpolated(x, y, at).value() - gaussian(at)), 4.9e-4);
  }
}

TEST(Interpolation, ThereIsNoneBeyondThePoints) {
  const std::vector<double> x = {1, 2, 3}, y = {1, 4, 9};
  EXPECT_FALSE(interpolated(x, y, 0.999));
  EXPECT_FALSE(interpolated(x, y, 3.001));
  EXPECT_NEAR(interpolated(x, y, 3 + 1e-12).value(), 9, 1e-9);
  EXPECT_NEAR(interpolated(x, y, 2.5).value(), 6.25, 1e-12) << "three points: their parabola";
  EXPECT_FALSE(interpolated({}, {}, 1));
}

}  // namespace

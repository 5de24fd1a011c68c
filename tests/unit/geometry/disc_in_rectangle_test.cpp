// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/disc_in_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace rodpack;

namespace {
const double pi = std::acos(-1.0);
constexpr double endless = std::numeric_limits<double>::infinity();
}  // namespace

TEST(QuarterDiscArea, MatchesClosedForms) {
  EXPECT_NEAR(quarter_disc_area(2, 5, 5), pi, 1e-12);  // whole quarter: pi r^2 / 4
  EXPECT_NEAR(quarter_disc_area(5, 1, 2), 2, 1e-12);   // whole rectangle
  EXPECT_NEAR(quarter_disc_area(1, 0, 1), 0, 1e-12);
  // Cut at x = r/2: half of the strip = (r^2/2)(t + sin t cos t) with sin t = 1/2.
  const double t = pi / 6;
  EXPECT_NEAR(quarter_disc_area(1, 0.5, 3), 0.5 * (t + 0.5 * std::cos(t)), 1e-12);
  EXPECT_NEAR(quarter_disc_area(1, 3, 0.5), 0.5 * (t + 0.5 * std::cos(t)), 1e-12);
  // a = b = 0.8, r = 1: flat part 0.8 * 0.6, then the integral of sqrt(1 - x^2) from 0.6 to 0.8,
  // (asin 0.8 - asin 0.6) / 2 + (0.8 * 0.6 - 0.6 * 0.8) / 2.
  EXPECT_NEAR(quarter_disc_area(1, 0.8, 0.8), 0.48 + (std::asin(0.8) - std::asin(0.6)) / 2, 1e-12);
}

// Half a disc on a wall, a quarter in a corner, and the segment beyond a wall at d = r / 2 from a
// centre outside: r^2 (acos(d / r) - (d / r) sqrt(1 - d^2 / r^2)).
TEST(DiscInRectangle, EndlessSidesGiveHalfPlanesAndCorners) {
  const Rectangle plane{-endless, endless, -endless, endless};
  const Rectangle right{0, endless, -endless, endless};
  const Rectangle corner{0, endless, 0, endless};
  EXPECT_NEAR(disc_area_inside(plane, 3, -4, 2), 4 * pi, 1e-12);
  EXPECT_NEAR(disc_area_inside(right, 0, 7, 2), 2 * pi, 1e-12);
  EXPECT_NEAR(disc_area_inside(corner, 0, 0, 2), pi, 1e-12);
  EXPECT_NEAR(disc_area_inside(right, -1, 0, 2), 4 * (std::acos(0.5) - 0.5 * std::sqrt(0.75)),
              1e-12);
  EXPECT_NEAR(disc_area_inside(corner, -3, 5, 2), 0, 1e-12);
}

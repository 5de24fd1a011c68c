// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/ball_in_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "rodpack/geometry/disc_in_rectangle.h"

namespace {
using namespace rodpack;
const double pi = std::acos(-1.0);
const double inf = std::numeric_limits<double>::infinity();

TEST(BallInBox, WholeHalfQuarterEighthAndNone) {
  const double ball = 4 * pi / 3 * 8;
  EXPECT_NEAR(ball_volume_inside({{-2, -2, -2}, {2, 2, 2}}, {0, 0, 0}, 2), ball, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{0, -9, -inf}, {9, 9, inf}}, {0, 0, 0}, 2), ball / 2, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{0, 0, -9}, {9, 9, 9}}, {0, 0, 0}, 2), ball / 4, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{0, -9, 0}, {9, 0, 9}}, {0, 0, 0}, 2), ball / 8, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{3, -9, -9}, {9, 9, 9}}, {0, 0, 0}, 2), 0, 1e-12);
  EXPECT_EQ(ball_volume_inside({{-1, -1, -1}, {1, 1, 1}}, {0, 0, 0}, 0), 0);
}

// A cap of height h: pi h^2 (3 r - h) / 3. Cut to a box that lies in it wholly: the box.
TEST(BallInBox, CapsAndBoxesInside) {
  EXPECT_NEAR(ball_volume_inside({{-9, -9, 1.5}, {9, 9, 9}}, {0, 0, 0}, 2),
              pi * 0.25 * (6 - 0.5) / 3, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{0.1, -0.3, 0.2}, {1.1, 0.7, 0.9}}, {0, 0, 0}, 2), 0.7, 1e-12);
  EXPECT_NEAR(ball_volume_inside({{-1, -1, -1}, {1, 1, 1}}, {0.3, 0, 0}, 9), 8, 1e-11);
}

// The discs at height z in closed form, added up over z by the midpoint rule; the integrand has
// kinks, so that n steps are good to some n^-2.
double by_slices(const Box& box, const Vector3& centre, double r) {
  const int n = 40000;
  const double low = std::max(box.low[2], centre[2] - r),
               high = std::min(box.high[2], centre[2] + r);
  const Rectangle rectangle{box.low[0], box.high[0], box.low[1], box.high[1]};
  double sum = 0;
  for (int k = 0; k < n && high > low; ++k) {
    const double z = low + (k + 0.5) * (high - low) / n - centre[2];
    sum += disc_area_inside(rectangle, centre[0], centre[1], std::sqrt(r * r - z * z)) / n;
  }
  return sum * std::max(0.0, high - low);
}

TEST(BallInBox, AnyPlaceAgreesWithDiscsAddedUp) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Box box{{-0.5, -0.4, -0.3}, {0.6, 0.5, 0.7}};
  int cut = 0;
  for (int k = 0; k < 60; ++k) {
    const Vector3 centre{uniform(random), uniform(random), uniform(random)};
    const double r = 0.75 + 0.6 * uniform(random);
    const double volume = ball_volume_inside(box, centre, r);
    EXPECT_NEAR(volume, by_slices(box, centre, r), 1e-6) << k;
    if (volume > 1e-3 && volume < box.volume() - 1e-3) ++cut;
  }
  EXPECT_GT(cut, 30);
}

TEST(BallInBox, TwoBoxesAddUpToTheirUnion) {
  const Vector3 centre{0.2, -0.1, 0.3};
  for (int step = -16; step <= 16; ++step) {
    const double at = step / 16.0;
    const double parts = ball_volume_inside({{-1, -1, -1}, {at, 1, 1}}, centre, 1.1) +
                         ball_volume_inside({{at, -1, -1}, {1, 1, 1}}, centre, 1.1);
    EXPECT_NEAR(parts, ball_volume_inside({{-1, -1, -1}, {1, 1, 1}}, centre, 1.1), 1e-12);
  }
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/voids.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {
using namespace rodpack;
const double pi = std::acos(-1.0);

struct Sphere {
  double body, x, y, radius;
};

Frame frame_of(const std::vector<Sphere>& spheres) {
  Frame frame;
  frame.rows = spheres.size();
  frame.names = {"body", "x", "y", "radius"};
  frame.columns.resize(4);
  frame.bad_fields.resize(4);
  for (const auto& each : spheres) {
    frame.columns[0].push_back(each.body);
    frame.columns[1].push_back(each.x);
    frame.columns[2].push_back(each.y);
    frame.columns[3].push_back(each.radius);
  }
  return frame;
}

Walls box(double width) {
  Walls walls;
  walls.right = width;
  return walls;
}

TEST(Voids, EmptyBoxIsOneWithTheCornersThatADiscCannotReach) {
  // w h - (4 - pi) (probe / 2)^2; the raster is exact to a fraction of a step times the
  // circumference of the four quarter circles.
  const auto voids = find_voids(frame_of({}), box(6), {1, 0.02, 4});
  ASSERT_EQ(voids.size(), 1U);
  EXPECT_NEAR(voids[0].area, 24 - (4 - pi) * 0.25, pi * 0.01);
  EXPECT_NEAR(voids[0].x, 3, 1e-3);
  EXPECT_NEAR(voids[0].y, 2, 1e-3);
}

TEST(Voids, GapOfFourSpheresInASquareTakesADiscOfSqrt2LessOneAndNoLargerOne) {
  // Spheres of diameter 1 that touch; walls just beyond, so that nothing else has room.
  const auto square =
      frame_of({{1, 0.5, 0.5, 0.5}, {2, 1.5, 0.5, 0.5}, {3, 0.5, 1.5, 0.5}, {4, 1.5, 1.5, 0.5}});
  const double fits = std::sqrt(2.0) - 1;
  const auto voids = find_voids(square, box(2), {0.98 * fits, 0.002, 2});
  ASSERT_EQ(voids.size(), 1U);
  EXPECT_NEAR(voids[0].x, 1, 0.002);
  EXPECT_NEAR(voids[0].y, 1, 0.002);
  // Between that of the disc itself and, moved about by 2 %, a little more.
  EXPECT_GT(voids[0].area, pi / 4 * std::pow(0.97 * fits, 2));
  EXPECT_LT(voids[0].area, pi / 4 * std::pow(1.06 * fits, 2));
  EXPECT_TRUE(find_voids(square, box(2), {1.02 * fits, 0.002, 2}).empty());
}

TEST(Voids, NarrowThroatSeparatesTwo) {
  // A disc of radius 1 in the middle of a channel of width 2.6 leaves 0.3 on either side.
  const auto voids = find_voids(frame_of({{1, 4, 1.3, 1}}), box(8), {0.5, 0.02, 2.6});
  EXPECT_EQ(voids.size(), 2U);
  EXPECT_EQ(find_voids(frame_of({{1, 4, 1.3, 1}}), box(8), {0.25, 0.02, 2.6}).size(), 1U);
}

// An arc of spheres of radius 1/2, bent to radius R over 120 degrees, that bulges up.
std::vector<Sphere> arc(double x, double y, double radius) {
  std::vector<Sphere> spheres;
  for (int k = 0; k <= 12; ++k) {
    const double angle = (150 - 10 * k) * pi / 180;
    spheres.push_back({7, x + radius * std::cos(angle), y + radius * std::sin(angle), 0.5});
  }
  return spheres;
}

TEST(Voids, LieInAHollowBetweenArcAndChordAndNotElsewhere) {
  // A lid of spheres on the chord shuts the hollow: its void lies in the hollow, that above the arc
  // and those beside it do not.
  auto spheres = arc(6, 2, 3);  // chord at y = 3.5, top of the centre line at y = 5
  for (int k = 0; k <= 40; ++k) spheres.push_back({100.0 + k, 3 + 0.15 * k, 2.9, 0.3});
  const auto voids = find_voids(frame_of(spheres), box(12), {0.5, 0.02, 9});
  int hollow = 0;
  for (const auto& each : voids)
    if (each.in_hollow) {
      ++hollow;
      EXPECT_NEAR(each.x, 6, 0.05);
      EXPECT_GT(each.y, 3);
      EXPECT_LT(each.y, 4.5);
    }
  EXPECT_EQ(hollow, 1);
  EXPECT_GT(voids.size(), 1U);
}

TEST(Voids, StraightParticlesHaveNoHollow) {
  std::vector<Sphere> spheres;
  for (int k = 0; k < 13; ++k) spheres.push_back({1, 3 + 0.5 * k, 4, 0.5});
  for (const auto& each : find_voids(frame_of(spheres), box(12), {0.5, 0.02, 8}))
    EXPECT_FALSE(each.in_hollow);
}

TEST(Voids, RefuseABedWithoutHeight) {
  EXPECT_THROW(find_voids(frame_of({}), box(6), {1, 0.02, 0}), DataError);
}

}  // namespace

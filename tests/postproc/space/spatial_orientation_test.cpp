// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/spatial_orientation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::watson_axes;

// d_p = 1, AR = 3 in a box of 20 with z up.
SpatialPacking empty_packing() {
  SpatialPacking packing;
  packing.walls.high = {20, 20, 20};
  packing.particle_diameter = 1;
  packing.aspect_ratio = 3;
  packing.surface = 20;
  return packing;
}

void add_rod(SpatialPacking& packing, const Vector3& centre, const Vector3& axis = {0, 0, 1}) {
  packing.centre.push_back(centre);
  packing.axis.push_back(axis);
  packing.elongated.push_back(true);
}

// A direction and its opposite are one.
TEST(DirectionAngles, PolarFromTheVerticalAzimuthInTheOrderOfTheAxes) {
  const double s = std::sqrt(0.5), h = std::sqrt(0.75);
  for (const double sign : {1.0, -1.0}) {
    const auto tilted = direction_angles({sign * s / 2, sign * s * h, sign * s}, 2);
    EXPECT_NEAR(tilted.polar, 45, 1e-12);
    EXPECT_NEAR(tilted.azimuth, 60, 1e-12);
    // y up: from z to x.
    const auto other = direction_angles({sign * h, 0, sign * -0.5}, 1);
    EXPECT_NEAR(other.polar, 90, 1e-12);
    EXPECT_NEAR(other.azimuth, 120, 1e-12);
    EXPECT_EQ(direction_angles({0, 0, sign}, 2).polar, 0);
    EXPECT_TRUE(std::isnan(direction_angles({0, 0, sign}, 2).azimuth));
  }
  EXPECT_EQ(direction_angles({-1, 0, 0}, 2).azimuth, 0);
  EXPECT_EQ(direction_angles({-1, -1e-20, 0}, 2).azimuth, 0);
}

// Two bins of equal solid angle of a half sphere part at the cosine 1/2, 60 degrees.
TEST(DirectionHistogram, PolarBinsHaveEqualSolidAngle) {
  const auto histogram =
      polar_histogram({{0, 0, 1}, {0, 0, -0.51}, {0, 0, 0.49}, {1, 0, 0}, {0, 1, 0}}, 2, 2);
  EXPECT_NEAR(histogram.to[0], 60, 1e-12);
  EXPECT_NEAR(histogram.from[1], 60, 1e-12);
  EXPECT_NEAR(histogram.to[1], 90, 1e-12);
  EXPECT_THAT(histogram.count, testing::ElementsAre(2, 3));
  EXPECT_NEAR(histogram.density[0], 0.8, 1e-12);
  // p = 2/5 of n = 5, over 1/2: 2 sqrt(0.24 / 5).
  EXPECT_NEAR(histogram.standard_error[0], 2 * std::sqrt(0.24 / 5), 1e-12);
}

TEST(DirectionHistogram, AzimuthBinsAreCentredOnMultiplesAndWrapAround) {
  std::vector<Vector3> directions{{0, 0, 1}};  // has none
  for (const double angle : {0.0, 22.0, 23.0, 157.0, 158.0, 90.0})
    directions.push_back(
        {std::cos(angle * std::acos(-1.0) / 180), std::sin(angle * std::acos(-1.0) / 180), 0});
  const auto histogram = azimuth_histogram(directions, 2, 4);
  EXPECT_THAT(histogram.count, testing::ElementsAre(3, 1, 1, 1));
  EXPECT_EQ(histogram.from[0], -22.5);
  EXPECT_NEAR(histogram.density[0], 2, 1e-12);
}

// The densities of isotropic rods are 1 in every bin, within 4.5 errors; of Watson's distribution
// the polar one is exp(kappa t^2) / (mean of it over t), here over each bin by Simpson's rule.
TEST(SpatialOrientation, IsotropicDensitiesAreOneAndWatsonsFollowsItsLaw) {
  for (const double kappa : {0.0, 3.0}) {
    auto packing = empty_packing();
    for (const auto& axis : watson_axes(kappa, 20000, 3)) add_rod(packing, {10, 10, 10}, axis);
    SpatialOrientationSample sample;
    sample.add(packing);
    const auto result = sample.result();
    ASSERT_EQ(result.polar.density.size(), 18U);
    ASSERT_EQ(result.azimuth.density.size(), 36U);
    const auto mean = [&](double low, double high) {
      double sum = 0;
      for (int k = 0; k < 1000; ++k)
        sum += std::exp(kappa * std::pow(low + (k + 0.5) * (high - low) / 1000, 2)) / 1000;
      return sum;
    };
    for (std::size_t k = 0; k < 18; ++k) {
      const double high = 1 - static_cast<double>(k) / 18, low = high - 1.0 / 18;
      EXPECT_NEAR(result.polar.density[k], mean(low, high) / mean(0, 1),
                  4.5 * result.polar.standard_error[k]);
    }
    for (std::size_t k = 0; k < 36; ++k)
      EXPECT_NEAR(result.azimuth.density[k], 1, 4.5 * result.azimuth.standard_error[k]);
    const double exact = kappa > 0 ? (3 * rodpack::test::watson_mean_square(kappa) - 1) / 2 : 0;
    EXPECT_NEAR(result.about_vertical.value, exact, 4 * result.about_vertical.standard_error);
    if (kappa > 0) continue;
    // The variance of P_2 is 1/5.
    EXPECT_NEAR(result.about_vertical.standard_error, 1 / std::sqrt(5 * 20000.0), 1e-4);
  }
}

TEST(SpatialOrientation, ParticlesCloserThanAnAxialLengthToAWallAreLeftOut) {
  auto packing = empty_packing();  // AR d_p = 3
  for (const double x : {2.999, 3.001, 17.001, 16.999}) add_rod(packing, {x, 10, 10});
  for (const double y : {2.999, 3.001}) add_rod(packing, {10, y, 10});
  for (const double z : {2.999, 3.001, 19.9}) add_rod(packing, {10, 10, z});  // the top is open
  add_rod(packing, {10, 10, 10});
  packing.elongated.back() = false;
  const auto near_walls = [&] {
    SpatialOrientationSample sample;
    sample.add(packing);
    const auto result = sample.result();
    EXPECT_EQ(result.spheres, 1U);
    EXPECT_EQ(result.order.number + result.near_walls, 9U);
    return result.near_walls;
  };
  EXPECT_EQ(near_walls(), 4U);
  packing.walls.vertical = 0;  // x up: its far end is the open top, that of z a wall
  EXPECT_EQ(near_walls(), 4U);
  packing.walls.vertical = 2;
  packing.walls.periodic = {true, false, false};
  EXPECT_EQ(near_walls(), 2U);
  packing.walls.periodic = {true, true, true};
  EXPECT_EQ(near_walls(), 0U);
}

TEST(SpatialOrientation, InACylinderItsWallCounts) {
  auto packing = empty_packing();
  packing.walls.round = true;
  packing.walls.middle = {10, 9};
  packing.walls.radius = 8;
  // 5 from the axis is 3 from the wall.
  for (const double off : {4.999, 5.001}) {
    add_rod(packing, {10 + off, 9, 10});
    add_rod(packing, {10 - 0.6 * off, 9 + 0.8 * off, 10});
  }
  SpatialOrientationSample sample;
  sample.add(packing);
  EXPECT_EQ(sample.result().near_walls, 2U);
}

TEST(SpatialOrientation, TwoVerticalsAndMissingParticlesAreErrors) {
  auto packing = empty_packing();
  SpatialOrientationSample sample;
  EXPECT_THROW(sample.result(), TooFewParticles);
  add_rod(packing, {10, 10, 10});
  sample.add(packing);
  EXPECT_THROW(sample.result(), TooFewParticles);
  packing.walls.vertical = 1;
  EXPECT_THROW(sample.add(packing), DataError);
}

}  // namespace

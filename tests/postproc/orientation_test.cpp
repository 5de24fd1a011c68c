// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/orientation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace {
using namespace rodpack;
const double pi = std::acos(-1.0);
const double degree = pi / 180;

// A packing of d_p = 1, AR = 3 in a box 20 wide with its floor at 0.
Packing empty_packing() {
  Packing packing;
  packing.walls.right = 20;
  packing.particle_diameter = 1;
  packing.aspect_ratio = 3;
  packing.surface = 20;
  return packing;
}

void add_rod(Packing& packing, double x, double y, double angle_degrees, double curvature = 0) {
  packing.x.push_back(x);
  packing.y.push_back(y);
  packing.angle.push_back(angle_degrees * degree);
  packing.curvature.push_back(curvature);
  packing.area.push_back(2.5);
  packing.elongated.push_back(true);
}

TEST(Gamma, StraightFoldsToHalfATurnCurvedToAFullOne) {
  EXPECT_NEAR(gamma_degrees(30 * degree, false), 30, 1e-12);
  EXPECT_NEAR(gamma_degrees(210 * degree, false), 30, 1e-12);
  EXPECT_NEAR(gamma_degrees(-30 * degree, false), 150, 1e-12);
  EXPECT_NEAR(gamma_degrees(210 * degree, true), 210, 1e-12);
  EXPECT_NEAR(gamma_degrees(-30 * degree, true), 330, 1e-12);
  // A rounding error below zero belongs to 0, never to the end of the range.
  EXPECT_EQ(gamma_degrees(-1e-20, false), 0);
  EXPECT_EQ(gamma_degrees(-1e-20, true), 0);
}

TEST(NematicOrder, ParallelRodsHaveOrderOneWhicheverEndIsTheHead) {
  const auto nematic = nematic_order({25, 205, 25, 25, 205});
  EXPECT_NEAR(nematic.order, 1, 1e-12);
  EXPECT_NEAR(nematic.director, 25, 1e-12);
  EXPECT_NEAR(nematic.standard_error, 0, 1e-8);
}

TEST(NematicOrder, EvenlySpreadDirectionsHaveNone) {
  std::vector<double> gamma(180);
  std::iota(gamma.begin(), gamma.end(), 0.0);
  EXPECT_NEAR(nematic_order(gamma).order, 0, 1e-12);
}

// Uniform on [-a, a] about a director: <cos 2 t> = sin(2a) / 2a; with a = 45 degrees 2 / pi. The
// midpoint sum over n points is off by the factor 2a/n / sin(2a/n), 4e-7 here.
TEST(NematicOrder, UniformSpreadAboutADirectorMatchesClosedForm) {
  const int n = 1000;
  std::vector<double> gamma;
  for (int i = 0; i < n; ++i) gamma.push_back(170 + 90 * ((i + 0.5) / n - 0.5));
  const auto nematic = nematic_order(gamma);
  EXPECT_NEAR(nematic.order, 2 / pi, 1e-6);
  EXPECT_NEAR(nematic.director, 170, 1e-9);
  // Variance of cos 2t: 1/2 + sin(4a)/8a - (2/pi)^2 = 1/2 - 4/pi^2 for a = 45 degrees.
  EXPECT_NEAR(nematic.standard_error, std::sqrt((0.5 - 4 / (pi * pi)) / n), 1e-6);
}

TEST(OrientationSample, ParticlesCloserThanAnAxialLengthToAWallAreLeftOut) {
  auto packing = empty_packing();  // AR d_p = 3
  add_rod(packing, 2.999, 10, 0);
  add_rod(packing, 3.001, 10, 0);
  add_rod(packing, 17.001, 10, 0);
  add_rod(packing, 16.999, 10, 0);
  add_rod(packing, 10, 2.999, 0);
  add_rod(packing, 10, 3.001, 0);
  add_rod(packing, 10, 19.9, 0);  // the surface is no wall
  packing.elongated.push_back(false);
  packing.x.push_back(10);
  packing.y.push_back(10);
  OrientationSample sample;
  sample.add(packing);
  const auto result = sample.distribution(4);
  EXPECT_EQ(result.particles, 4U);
  EXPECT_EQ(result.near_walls, 3U);
  EXPECT_EQ(result.spheres, 1U);

  packing.walls.sides = false;  // periodic in x: only the floor is left
  OrientationSample periodic;
  periodic.add(packing);
  EXPECT_EQ(periodic.distribution(4).near_walls, 1U);
}

TEST(OrientationSample, DensityIntegratesToOneAndErrorIsBinomial) {
  auto packing = empty_packing();
  for (int i = 0; i < 30; ++i) add_rod(packing, 10, 10, 10);   // bin 0, [-22.5, 22.5)
  for (int i = 0; i < 10; ++i) add_rod(packing, 10, 10, 270);  // folds to 90: bin 2
  OrientationSample sample;
  sample.add(packing);
  const auto result = sample.distribution(4);
  EXPECT_THAT(result.centre, testing::ElementsAre(0, 45, 90, 135));
  EXPECT_THAT(result.count, testing::ElementsAre(30, 0, 10, 0));
  const double integral = std::accumulate(result.density.begin(), result.density.end(), 0.0) * 45;
  EXPECT_NEAR(integral, 1, 1e-12);
  // p = 3/4 of n = 40: sqrt(p (1-p) / n) = sqrt(0.1875 / 40), per 45 degrees.
  EXPECT_NEAR(result.standard_error[0], std::sqrt(0.1875 / 40) / 45, 1e-15);
}

TEST(OrientationSample, CurvedParticlesKeepTheirDirection) {
  auto packing = empty_packing();
  add_rod(packing, 10, 10, 180, 1.0);  // opens up
  add_rod(packing, 10, 10, 0, 1.0);    // bulges up
  OrientationSample sample;
  sample.add(packing);
  const auto result = sample.distribution(4);
  EXPECT_EQ(result.range, 360);
  EXPECT_THAT(result.count, testing::ElementsAre(1, 0, 1, 0));
}

// Figures 3 and 7 of the paper: bins centred on 0, 5, 10 ... degrees. What lies half a width or
// less below the end of the range is in the bin of 0, since both are one direction.
TEST(OrientationSample, BinsAreCentredOnMultiplesOfFiveDegreesAndWrapAround) {
  for (const bool curved : {false, true}) {
    auto packing = empty_packing();
    const double range = curved ? 360 : 180;
    for (const double gamma : {0.0, 2.4, range - 2.4, range - 2.6, 2.6, 87.6, 92.4})
      add_rod(packing, 10, 10, gamma, curved ? 1.0 : 0.0);
    OrientationSample sample;
    sample.add(packing);
    const auto result = sample.distribution();
    ASSERT_EQ(result.centre.size(), curved ? 72U : 36U);
    std::vector<double> expected(result.centre.size(), 0);
    expected[0] = 3;
    expected.back() = 1;
    expected[1] = 1;
    expected[18] = 2;
    EXPECT_EQ(result.count, expected);
    for (std::size_t k = 0; k < result.centre.size(); ++k)
      EXPECT_EQ(result.centre[k], 5.0 * static_cast<double>(k));
  }
}

TEST(OrientationSample, MixedOrMissingParticlesAreErrors) {
  auto packing = empty_packing();
  add_rod(packing, 10, 10, 0);
  add_rod(packing, 10, 10, 0, 1.0);
  OrientationSample sample;
  EXPECT_THROW(sample.add(packing), DataError);
  EXPECT_THROW(OrientationSample().distribution(4), TooFewParticles);
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/axial_rdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "reading/dump.h"
#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::random_places;
using rodpack::test::watson_axes;
using rodpack::test::with_y_up;

SpatialPacking rods(const Vector3& size, const std::vector<Vector3>& places,
                    const std::vector<Vector3>& axes) {
  SpatialPacking packing;
  packing.walls.high = size;
  packing.surface = size[2];
  packing.particle_diameter = 1;
  packing.aspect_ratio = 3;
  packing.centre = places;
  packing.axis = axes;
  packing.elongated.assign(places.size(), true);
  return packing;
}

AxialRdf axial_of(const SpatialPacking& packing, const AxialRdfOptions& options) {
  AxialRdfSample sample(options);
  sample.add(packing);
  return sample.result();
}

// Places at random, whatever the axes: 1 in every bin, within 4.5 errors.
TEST(AxialRdf, IdealGasGivesOneWhicheverWayTheAxesPoint) {
  const Vector3 size{14, 14, 14};
  for (const double kappa : {0.0, 20.0}) {
    auto packing = rods(size, random_places(size, 3000, 8), watson_axes(kappa, 3000, 9));
    packing.walls.periodic = {true, true, true};
    const auto rdf = axial_of(packing, {1, 6});
    EXPECT_EQ(rdf.centres, 3000U);
    EXPECT_EQ(rdf.margin, 0);
    // Squares of the first quadrant with their outer corner in the circle of radius 6.
    ASSERT_EQ(rdf.g.size(), 22U);
    for (std::size_t k = 0; k < rdf.g.size(); ++k)
      EXPECT_NEAR(rdf.g[k], 1, 4.5 * rdf.standard_error[k]) << rdf.along[k] << ' ' << rdf.across[k];
    EXPECT_LT(rdf.standard_error.back(), 0.02);  // the check above means something
  }
}

// Between walls the centres keep 3 + 4 away, so that no ring is cut.
TEST(AxialRdf, IdealGasGivesOneBetweenWalls) {
  const Vector3 size{24, 24, 24};
  const auto rdf =
      axial_of(rods(size, random_places(size, 14000, 18), watson_axes(0, 14000, 19)), {1, 4});
  EXPECT_EQ(rdf.margin, 7);
  EXPECT_NEAR(static_cast<double>(rdf.centres), 1000, 4 * std::sqrt(1000));
  // The common scatter of rho, 1 / sqrt(1000), is not in the bins' errors.
  for (std::size_t k = 0; k < rdf.g.size(); ++k)
    EXPECT_NEAR(rdf.g[k], 1, 4.5 * rdf.standard_error[k] + 4 / std::sqrt(1000));
}

// Parallel rods on a tetragonal lattice, 1.03 apart across and 5.07 along: numbers of neighbours by
// bin, on a ring of the same z and on the two next ones.
TEST(AxialRdf, ParallelRodsOnALatticeHaveTheirRings) {
  const double a = 1.03, c = 5.07;
  std::vector<Vector3> places;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      for (int k = 0; k < 3; ++k) places.push_back({(i + 0.5) * a, (j + 0.5) * a, (k + 0.5) * c});
  const Vector3 size{12 * a, 12 * a, 3 * c};
  const std::vector<Vector3> upright(places.size(), {0, 0, 1});
  for (const bool turned : {false, true}) {
    auto packing = turned ? rods(with_y_up({size})[0], with_y_up(places), with_y_up(upright))
                          : rods(size, places, upright);
    packing.walls.periodic = {true, true, true};
    const auto rdf = axial_of(packing, {0.25, 6});
    std::map<std::pair<int, int>, double> expected;  // by bin: along, across
    for (int i = -6; i <= 6; ++i)
      for (int j = -6; j <= 6; ++j)
        for (int k = -1; k <= 1; ++k)
          if (i != 0 || j != 0 || k != 0)
            expected[{static_cast<int>(std::abs(k) * c / 0.25),
                      static_cast<int>(std::hypot(i, j) * a / 0.25)}] += 1;
    EXPECT_EQ((expected[{0, 4}]), 4);
    EXPECT_EQ((expected[{20, 0}]), 2);
    EXPECT_EQ((expected[{20, 4}]), 8);
    for (std::size_t k = 0; k < rdf.g.size(); ++k) {
      const std::pair<int, int> at{static_cast<int>(rdf.along[k] / 0.25),
                                   static_cast<int>(rdf.across[k] / 0.25)};
      const double number = rdf.pairs[k] / static_cast<double>(rdf.centres);
      EXPECT_NEAR(number, expected[at], 1e-12) << rdf.along[k] << ' ' << rdf.across[k];
      // Two rings, of the thickness 1/4 each way.
      const double volume = 2 * 2 * std::acos(-1.0) * rdf.across[k] * 0.25 * 0.25;
      EXPECT_NEAR(rdf.g[k], expected[at] / volume * a * a * c, 1e-9);
      // All pairs count twice, from either end: the error of number N is sqrt(2 N).
      EXPECT_NEAR(rdf.standard_error[k] * std::sqrt(rdf.pairs[k]), std::sqrt(2.0) * rdf.g[k], 1e-9);
    }
  }
}

// Spheres are neighbours, and count for the density, but have no axis to look along.
TEST(AxialRdf, SpheresAreNeighboursAlone) {
  auto packing = rods({20, 20, 20}, {{5, 5, 5}, {6.1, 5, 5}}, {{1, 0, 0}, {1, 0, 0}});
  packing.walls.periodic = {true, true, true};
  packing.elongated[1] = false;
  const auto rdf = axial_of(packing, {1, 3});
  EXPECT_EQ(rdf.centres, 1U);
  double pairs = 0;
  for (std::size_t k = 0; k < rdf.g.size(); ++k) {
    pairs += rdf.pairs[k];
    // rho = 2 / 8000; the bin at 1.5, 0.5 holds the sphere, its two rings have volume 2 pi.
    const bool holds = rdf.along[k] == 1.5 && rdf.across[k] == 0.5;
    EXPECT_NEAR(rdf.g[k], holds ? 8000 / (2 * 2 * std::acos(-1.0)) : 0, 1e-9);
  }
  EXPECT_EQ(pairs, 1);
  packing.elongated[0] = false;
  EXPECT_THROW(axial_of(packing, {1, 3}), TooFewParticles);
}

TEST(AxialRdf, ABedWithoutRoomIsAnError) {
  const Vector3 size{10, 10, 10};
  const auto packing = rods(size, random_places(size, 100, 1), watson_axes(0, 100, 1));
  EXPECT_THROW(axial_of(packing, {1, 4}), TooFewParticles);
}

}  // namespace

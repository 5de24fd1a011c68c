// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/spatial_rdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::random_places;
const double pi = std::acos(-1.0);

// d_p = 1, AR = 1, z up, filled to its top.
SpatialPacking box(const Vector3& size, const std::vector<Vector3>& places) {
  SpatialPacking packing;
  packing.walls.high = size;
  packing.surface = size[2];
  packing.particle_diameter = 1;
  packing.centre = places;
  packing.axis.assign(places.size(), {0, 0, 1});
  packing.elongated.assign(places.size(), false);
  return packing;
}

SpatialPacking ideal_gas(double width, int count, unsigned seed) {
  const Vector3 size{width, width, width};
  return box(size, random_places(size, count, seed));
}

// In an ideal gas every bin is 1 within its error; 4.5 of them leave a chance of 1e-5 per bin.
void expect_ideal(const Rdf& rdf) {
  for (std::size_t k = 0; k < rdf.g.size(); ++k)
    EXPECT_NEAR(rdf.g[k], 1, 4.5 * rdf.standard_error[k]) << "r = " << rdf.r[k];
  EXPECT_NEAR(rdf.tail_g, 1, 4 * rdf.tail_standard_error);
  EXPECT_LT(rdf.tail_standard_error, 0.1);  // the check above means something
}

Rdf rdf_of(const SpatialPacking& packing, const RdfOptions& options) {
  SpatialRdfSample sample(options);
  sample.add(packing);
  return sample.result();
}

TEST(SpatialRdf, IdealGasGivesOneWithWholeShells) {
  const auto rdf = rdf_of(ideal_gas(36, 20000, 2), {0.5, 8, -1});
  EXPECT_FALSE(rdf.margin_reduced);
  EXPECT_NEAR(rdf.margin, 11, 1e-12);
  EXPECT_NEAR(rdf.density, 20000 / std::pow(36.0, 3), 4 * rdf.density / std::sqrt(rdf.centres));
  expect_ideal(rdf);
}

TEST(SpatialRdf, IdealGasGivesOneWhereWallsAndSurfaceCutTheShells) {
  expect_ideal(rdf_of(ideal_gas(16, 2000, 3), {0.5, 12, 1}));
}

TEST(SpatialRdf, IdealGasGivesOneAcrossPeriodicSidesAndInAPeriodicBox) {
  auto packing = ideal_gas(16, 2000, 4);
  packing.walls.periodic = {true, true, false};
  expect_ideal(rdf_of(packing, {0.5, 8, 2}));
  packing.walls.periodic = {true, true, true};
  const auto rdf = rdf_of(packing, {0.5, 8, -1});
  EXPECT_EQ(rdf.centres, 2000U);
  EXPECT_EQ(rdf.margin, 0);
  expect_ideal(rdf);
}

TEST(SpatialRdf, IdealGasGivesOneInACylinderAboutAnyVertical) {
  for (const std::size_t vertical : {0U, 1U, 2U}) {
    auto packing = ideal_gas(20, 6000, 5);
    packing.walls.vertical = vertical;
    packing.walls.round = true;
    packing.walls.middle = {10, 10};
    packing.walls.radius = 10;
    std::vector<Vector3> inside;
    for (const auto& place : packing.centre)
      if (packing.walls.distance_to_sides(place) > 0) inside.push_back(place);
    auto round = box({20, 20, 20}, inside);
    round.walls = packing.walls;
    const auto rdf = rdf_of(round, {0.5, 8, 2});
    // A square prism of diagonal 16, 16 high: 128 * 16 of the 8000, 6000 particles.
    EXPECT_NEAR(static_cast<double>(rdf.centres), 0.75 * 128 * 16, 4 * std::sqrt(0.75 * 128 * 16));
    expect_ideal(rdf);
  }
}

TEST(SpatialRdf, FramesAddUp) {
  SpatialRdfSample sample({0.5, 6, -1});
  for (unsigned seed = 10; seed < 14; ++seed) sample.add(ideal_gas(18, 3000, seed));
  const auto rdf = sample.result();
  EXPECT_TRUE(rdf.margin_reduced);
  EXPECT_NEAR(rdf.margin, 6, 1e-12);
  expect_ideal(rdf);
}

// Over many samples of an ideal gas, (g - 1) / standard error has mean 0 and spread 1, within
// 4 / sqrt(samples) = 0.28 and 4 / sqrt(2 samples) = 0.2; shells whole and cut.
TEST(SpatialRdf, StandardErrorIsTheSpreadOverManySamples) {
  for (const double margin : {-1.0, 1.0}) {
    const int samples = 200;
    double sum[2] = {}, square[2] = {};
    for (int seed = 0; seed < samples; ++seed) {
      const auto rdf =
          rdf_of(ideal_gas(12, 1200, 100 + static_cast<unsigned>(seed)), {1, 5, margin});
      const double deviations[2] = {(rdf.g[4] - 1) / rdf.standard_error[4],
                                    (rdf.tail_g - 1) / rdf.tail_standard_error};
      for (int k = 0; k < 2; ++k) {
        sum[k] += deviations[k] / samples;
        square[k] += deviations[k] * deviations[k] / samples;
      }
    }
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(sum[k], 0, 0.28) << "margin " << margin << ", quantity " << k;
      EXPECT_NEAR(std::sqrt(square[k]), 1, 0.2) << "margin " << margin << ", quantity " << k;
    }
  }
}

// `shells`: distances and numbers of neighbours; every other bin is empty. g is the number over rho
// and the shell's volume.
void expect_shells(const Rdf& rdf, double density,
                   const std::vector<std::pair<double, double>>& shells) {
  std::vector<double> expected(rdf.g.size(), 0);
  const double bin = 2 * rdf.r[0];
  for (const auto& [r, neighbours] : shells)
    expected[static_cast<std::size_t>(r / bin)] += neighbours;
  for (std::size_t k = 0; k < rdf.g.size(); ++k) {
    EXPECT_NEAR(rdf.pairs[k] / static_cast<double>(rdf.centres), expected[k], 1e-12) << rdf.r[k];
    const double inner = static_cast<double>(k) * bin, outer = inner + bin;
    const double volume = 4 * pi / 3 * (std::pow(outer, 3) - std::pow(inner, 3));
    EXPECT_NEAR(rdf.g[k], expected[k] / volume / density, 1e-9) << rdf.r[k];
  }
}

std::vector<Vector3> lattice(int cells, double cell, const std::vector<Vector3>& sites) {
  std::vector<Vector3> places;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k)
        for (const auto& site : sites)
          places.push_back({(i + site[0]) * cell, (j + site[1]) * cell, (k + site[2]) * cell});
  return places;
}

// A spacing of 1.03 keeps the shells off the edges of the bins.
TEST(SpatialRdf, SimpleCubicLatticeHasItsShellsAndNothingBetween) {
  const double a = 1.03;
  const std::vector<std::pair<double, double>> shells{{a, 6},
                                                      {std::sqrt(2) * a, 12},
                                                      {std::sqrt(3) * a, 8},
                                                      {2 * a, 6},
                                                      {std::sqrt(5) * a, 24},
                                                      {std::sqrt(6) * a, 24},
                                                      {std::sqrt(8) * a, 12}};
  auto packing = box({12 * a, 12 * a, 12 * a}, lattice(12, a, {{0.5, 0.5, 0.5}}));
  packing.walls.periodic = {true, true, true};
  const auto periodic = rdf_of(packing, {0.1, 2.9999, -1});
  EXPECT_EQ(periodic.centres, 1728U);
  expect_shells(periodic, 1 / (a * a * a), shells);

  // Between walls, and with a margin of 3 a, 6^3 centres in a region of as many cells; the window
  // begins 1 from the walls, 2 cells before the region.
  packing.walls.periodic = {false, false, false};
  const auto walled = rdf_of(packing, {0.1, 1.9999, 3 * a});
  EXPECT_EQ(walled.centres, 216U);
  expect_shells(walled, 1 / (a * a * a), {{a, 6}, {std::sqrt(2) * a, 12}, {std::sqrt(3) * a, 8}});
}

// Face-centred cubic with the edge a: 12 neighbours at a / sqrt 2, 6 at a, 24 at a sqrt 3/2, 12 at
// a sqrt 2, 24 at a sqrt 5/2; four sites per cell.
TEST(SpatialRdf, FaceCentredCubicLatticeHasTwelveNeighbours) {
  const double a = 1.47;
  auto packing = box({6 * a, 6 * a, 6 * a},
                     lattice(6, a, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}));
  packing.walls.periodic = {true, true, true};
  expect_shells(rdf_of(packing, {0.1, 2.3999, -1}), 4 / (a * a * a),
                {{std::sqrt(0.5) * a, 12},
                 {a, 6},
                 {std::sqrt(1.5) * a, 24},
                 {std::sqrt(2.0) * a, 12},
                 {std::sqrt(2.5) * a, 24}});
}

TEST(SpatialRdf, TooFewCentresAndTooShortPeriodsAreErrors) {
  EXPECT_THROW(rdf_of(ideal_gas(15, 500, 5), {0.5, 5, 8}), TooFewParticles);
  EXPECT_THROW(rdf_of(ideal_gas(15, 1, 5), {0.5, 5, 1}), TooFewParticles);
  auto periodic = ideal_gas(15, 500, 5);
  periodic.walls.periodic = {false, true, false};
  try {
    rdf_of(periodic, {0.5, 10, -1});
    FAIL() << "a shell wider than the period was accepted";
  } catch (const DataError& error) {
    EXPECT_STREQ(error.what(),
                 "the largest distance, 10 d_p, exceeds half of the period in y, 7.5 d_p");
  }
  // Exactly half of it is none too many, though 0.1 * 75 is more than 7.5 in floating point.
  periodic.walls.high[1] = 2 * (0.1 * 75) * (1 - 1e-15);
  EXPECT_NO_THROW(rdf_of(periodic, {0.1, 7.5, 2}));
}

}  // namespace

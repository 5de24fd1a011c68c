// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/rdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "figures/rdf_figure.h"

namespace {
using namespace rodpack;
const double pi = std::acos(-1.0);

Packing box(double width, double height) {
  Packing packing;
  packing.walls.right = width;
  packing.surface = height;
  packing.particle_diameter = 1;
  packing.aspect_ratio = 1;
  return packing;
}

Packing ideal_gas(double width, double height, int count, unsigned seed) {
  auto packing = box(width, height);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < count; ++i) {
    packing.x.push_back(width * uniform(random));
    packing.y.push_back(height * uniform(random));
  }
  return packing;
}

// In an ideal gas every bin is 1 within its error; 4.5 of them leave a chance of 1e-5 per bin.
void expect_ideal(const Rdf& rdf) {
  for (std::size_t k = 0; k < rdf.g.size(); ++k)
    EXPECT_NEAR(rdf.g[k], 1, 4.5 * rdf.standard_error[k]) << "r = " << rdf.r[k];
  EXPECT_NEAR(rdf.tail_g, 1, 4 * rdf.tail_standard_error);
  EXPECT_LT(rdf.tail_standard_error, 0.1);  // the check above means something
}

TEST(Rdf, IdealGasGivesOneWithWholeRings) {
  RdfSample sample({0.25, 10, -1});
  sample.add(ideal_gas(120, 120, 14400, 2));
  const auto rdf = sample.result();
  EXPECT_FALSE(rdf.margin_reduced);
  EXPECT_NEAR(rdf.margin, 11, 1e-12);
  expect_ideal(rdf);
}

TEST(Rdf, IdealGasGivesOneWhereWallsAndSurfaceCutTheRings) {
  RdfSample sample({0.25, 15, 1});  // centres 1 from the walls, rings up to 15
  sample.add(ideal_gas(60, 40, 6000, 3));
  expect_ideal(sample.result());
}

TEST(Rdf, IdealGasGivesOneAcrossAPeriodicSide) {
  auto packing = ideal_gas(40, 80, 6000, 4);
  packing.walls.sides = false;
  RdfSample sample({0.25, 10, -1});
  sample.add(packing);
  expect_ideal(sample.result());
}

TEST(Rdf, FramesAddUp) {
  RdfSample sample({0.5, 10, -1});
  for (unsigned seed = 10; seed < 14; ++seed) sample.add(ideal_gas(60, 60, 3600, seed));
  const auto rdf = sample.result();
  expect_ideal(rdf);
  EXPECT_NEAR(rdf.density, 1, 4 / std::sqrt(static_cast<double>(rdf.centres)));
}

// Over many samples of an ideal gas, (g - 1) / standard error has mean 0 and spread 1, within
// 4 / sqrt(samples) = 0.28 and 4 / sqrt(2 samples) = 0.2; rings whole and cut.
TEST(Rdf, StandardErrorIsTheSpreadOverManySamples) {
  for (const double margin : {-1.0, 1.0}) {
    const int samples = 200;
    double sum[3] = {}, square[3] = {};
    for (int seed = 0; seed < samples; ++seed) {
      RdfSample sample({1, 8, margin});
      sample.add(ideal_gas(40, 40, 1600, 100 + static_cast<unsigned>(seed)));
      const auto rdf = sample.result();
      const double deviations[3] = {(rdf.g[0] - 1) / rdf.standard_error[0],
                                    (rdf.g[7] - 1) / rdf.standard_error[7],
                                    (rdf.tail_g - 1) / rdf.tail_standard_error};
      for (int k = 0; k < 3; ++k) {
        sum[k] += deviations[k] / samples;
        square[k] += deviations[k] * deviations[k] / samples;
      }
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(sum[k], 0, 0.28) << "margin " << margin << ", quantity " << k;
      EXPECT_NEAR(std::sqrt(square[k]), 1, 0.2) << "margin " << margin << ", quantity " << k;
    }
  }
}

// Square lattice of unit spacing: 4 neighbours at 1, 4 at sqrt 2, 4 at 2, 8 at sqrt 5, 4 at sqrt 8.
// 38 x 38 sites lie further than 11 from the walls of a 60 x 60 box, a region of area 38^2: rho =
// 1, so g of a bin is the number of neighbours over the area of its ring.
TEST(Rdf, SquareLatticeHasItsShellsAndNothingBetween) {
  auto packing = box(60, 60);
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) {
      packing.x.push_back(i + 0.5);
      packing.y.push_back(j + 0.5);
    }
  RdfSample sample({0.1, 2.95, -1});
  sample.add(packing);
  const auto rdf = sample.result();
  EXPECT_EQ(rdf.centres, 38U * 38U);
  std::vector<double> shell(rdf.g.size(), 0);
  for (const auto& [r, neighbours] :
       {std::pair{1.0, 4}, {std::sqrt(2.0), 4}, {2.0, 4}, {std::sqrt(5.0), 8}, {std::sqrt(8.0), 4}})
    shell[static_cast<std::size_t>(r / 0.1 + 1e-9)] = neighbours;
  for (std::size_t k = 0; k < rdf.g.size(); ++k) {
    // 1 and 2 sit on the edge between two bins, where rounding decides: take the pair of bins.
    if (std::abs(rdf.r[k] + 0.05 - std::round(rdf.r[k] + 0.05)) < 1e-9) continue;
    double pairs = rdf.pairs[k];
    if (std::abs(rdf.r[k] - 0.05 - std::round(rdf.r[k] - 0.05)) < 1e-9 && k > 0)
      pairs += rdf.pairs[k - 1];
    EXPECT_NEAR(pairs / (38.0 * 38.0), shell[k], 1e-12) << "r = " << rdf.r[k];
    EXPECT_NEAR(rdf.g[k], rdf.pairs[k] / (38.0 * 38.0) / (2 * pi * rdf.r[k] * 0.1), 1e-9);
  }
}

// In a box of 20 x 20 no ring of more than its diagonal is in sight, neither full nor empty.
TEST(Rdf, CurvesHaveNoPointWhereNoRingIsInSight) {
  RdfSample sample({1, 40, 1});
  sample.add(ideal_gas(20, 20, 400, 6));
  const auto rdf = sample.result();
  const auto drawn = drawn_g(rdf);
  ASSERT_EQ(drawn.size(), 40U);
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (rdf.r[k] < 17 * std::sqrt(2.0)) {
      EXPECT_EQ(drawn[k], rdf.g[k]);
    }
    if (rdf.r[k] > 20 * std::sqrt(2.0)) {
      EXPECT_TRUE(std::isnan(drawn[k]));
    }
  }
}

TEST(Rdf, SmallBedShrinksTheMarginToAThirdAndSaysSo) {
  RdfSample sample({0.5, 10, -1});
  sample.add(ideal_gas(60, 15, 900, 5));
  const auto rdf = sample.result();
  EXPECT_TRUE(rdf.margin_reduced);
  EXPECT_NEAR(rdf.margin, 5, 1e-12);
  expect_ideal(rdf);
}

TEST(Rdf, TooFewCentresAndTooShortPeriodsAreErrors) {
  RdfSample sample({0.5, 10, 8});
  EXPECT_THROW(sample.add(ideal_gas(60, 15, 900, 5)), TooFewParticles);
  auto periodic = ideal_gas(15, 60, 900, 5);
  periodic.walls.sides = false;
  try {
    sample.add(periodic);
    FAIL() << "a ring wider than the period was accepted";
  } catch (const DataError& error) {
    EXPECT_STREQ(error.what(),
                 "the largest distance, 10 d_p, exceeds half of the period in x, 7.5 d_p");
  }
}

}  // namespace

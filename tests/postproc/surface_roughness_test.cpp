// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/surface_roughness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "rodpack/geometry/chain_geometry.h"

namespace {

using namespace rodpack;

const ChainShape rod(double overlap) { return {5, 1, overlap, 0, 1}; }

/// Height of the chain's surface above its axis at x, d.
double surface_height(const ChainShape& shape, double x) {
  double height = 0;
  for (const auto& centre : sphere_centres(shape)) {
    const double square = 0.25 - std::pow(x - centre[0], 2);
    if (square > 0) height = std::max(height, std::sqrt(square));
  }
  return height;
}

/// Distance of the axis from the centre of a sphere of diameter d at x that just touches.
double touching_distance(const ChainShape& shape, double x) {
  double distance = 0;
  for (const auto& centre : sphere_centres(shape)) {
    const double square = 1 - std::pow(x - centre[0], 2);
    if (square > 0) distance = std::max(distance, std::sqrt(square));
  }
  return distance;
}

}  // namespace

// Against the chains of core, scanned along the middle
TEST(SurfaceRoughness, ClosedFormsAreThoseOfTheChains) {
  for (const double f : {0.0, 0.5, 0.75, 0.875}) {
    const auto shape = rod(f);
    double lowest = 1, closest = 1, slope = 0;
    constexpr int samples = 4096;
    const double h = 2.0 / samples;
    for (int i = 0; i <= samples; ++i) {
      const double x = -1 + i * h;
      lowest = std::min(lowest, surface_height(shape, x));
      closest = std::min(closest, touching_distance(shape, x));
      slope = std::max(
          slope,
          std::fabs(touching_distance(shape, x + 1e-7) - touching_distance(shape, x)) / 1e-7);
    }
    EXPECT_NEAR(groove_depth(f), 0.5 - lowest, 1e-12) << f;
    EXPECT_NEAR(sliding_amplitude(f), 1 - closest, 1e-12) << f;
    EXPECT_NEAR(groove_friction(f), slope, 1e-5) << f;
  }
}

TEST(SurfaceRoughness, ValuesOfTheCommonSurfaces) {
  EXPECT_NEAR(groove_depth(0), 0.5, 1e-15);
  EXPECT_NEAR(sliding_amplitude(0), 1 - std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(groove_friction(0), 1 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(groove_depth(0.5), 0.5 * (1 - std::sqrt(0.75)), 1e-15);
  // (1 - f)^2 / 8 for small spacings
  EXPECT_NEAR(sliding_amplitude(0.99) / (1e-4 / 8), 1, 1e-4);
}

// On top of a sphere, the others out of reach: one spring, as of the capsule
TEST(SurfaceRoughness, ForceOnTopOfASphereIsTheCapsules) {
  EXPECT_NEAR(chain_force_ratio(0.5, 0.01, 0), 1, 1e-12);
  EXPECT_NEAR(chain_force_ratio(0.5, 0.01, 3), 1, 1e-12);  // at any sphere
  EXPECT_EQ(chain_force_ratio(0.5, 0.01, 0.5), 0);         // the groove is deeper: 0.032
  // in the groove two spheres, each d - D' deep at D' = sqrt(0.95^2 + 0.25^2), leaning sideways
  const double distance = std::hypot(0.95, 0.25);
  EXPECT_NEAR(chain_force_ratio(0.5, 0.05, 0.5), 2 * (1 - distance) * 0.95 / distance / 0.05,
              1e-12);
  EXPECT_NEAR(chain_force_ratio(0.5, 0.05, -0.5), chain_force_ratio(0.5, 0.05, 0.5), 1e-12);
}

// Many spheres at once: sum of (depth - x^2/2) over x = j s within sqrt(2 depth), that is
// 2/3 sqrt(2 depth) 2 depth / s: the more spheres, the stiffer
TEST(SurfaceRoughness, ManySpheresAreManySprings) {
  const double depth = 1e-3, s = 1e-3;
  const auto range = chain_force_range(1 - s, depth);
  EXPECT_NEAR(range.mean / (4.0 / 3 * std::sqrt(2 * depth) / s), 1, 2e-3);
  EXPECT_NEAR(range.least / range.largest, 1, 0.01);
  const auto rough = chain_force_range(0, 1e-3);
  EXPECT_EQ(rough.least, 0);
  EXPECT_NEAR(rough.largest, 1, 1e-12);
  EXPECT_LT(rough.mean, 0.1);
}

TEST(SurfaceRoughness, OtherOverlapsAreRefused) {
  for (const double f : {-0.1, 1.0, std::nan("")}) {
    EXPECT_THROW(groove_depth(f), std::invalid_argument);
    EXPECT_THROW(sliding_amplitude(f), std::invalid_argument);
    EXPECT_THROW(groove_friction(f), std::invalid_argument);
    EXPECT_THROW(chain_force_ratio(f, 0.01, 0), std::invalid_argument);
  }
  EXPECT_THROW(chain_force_ratio(0.5, 0, 0), std::invalid_argument);
}

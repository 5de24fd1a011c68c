// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "liggghts_run.h"
#include "analysis/solid_fraction.h"
#include "synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;

const char* columns = "nspheres x y angle half_length radius curvature area";

Frame two_rods(const std::string& flags = "ff ff pp") {
  const auto text = rodpack::test::frame_head(3, 2, 0.5, 2, columns, flags) +
                    "9 0.1 0.1 0 7.5e-3 1.4e-3 0 4e-5\n9 0.2 0.2 1 7.5e-3 1.6e-3 0 4e-5\n";
  return last_frame({put(fresh_folder() / "dumps" / "a.dump", text)});
}

TEST(Packing, ScalesAndWallsComeFromTheDumpWhenNothingElseIsThere) {
  const auto packing = read_packing(two_rods());
  EXPECT_NEAR(packing.particle_diameter, 3e-3, 1e-15);  // mean of 2.8 and 3.2 mm
  EXPECT_NEAR(packing.aspect_ratio, 5, 1e-12);
  EXPECT_EQ(packing.walls.right, 0.5);
  EXPECT_TRUE(packing.walls.sides);
  EXPECT_THAT(packing.walls.source, HasSubstr("box bounds"));
  EXPECT_FALSE(read_packing(two_rods("pp ff pp")).walls.sides);
}

TEST(Packing, ParametersGoBeforeTheDumpAndOptionsBeforeBoth) {
  const auto frame = two_rods();
  const auto run = std::filesystem::path(frame.file).parent_path().parent_path();
  put(run / "parameters.json",
      R"({"container_width_m": 0.3, "particle_diameter_m": 2.5e-3, "aspect_ratio": 6})");
  auto packing = read_packing(frame);
  EXPECT_EQ(packing.walls.left, 0);
  EXPECT_EQ(packing.walls.right, 0.3);
  EXPECT_EQ(packing.particle_diameter, 2.5e-3);
  EXPECT_EQ(packing.aspect_ratio, 6);

  PackingOptions options;
  options.walls = {0.05, 0.4, 0.01};
  options.particle_diameter = 3e-3;
  options.aspect_ratio = 5;
  packing = read_packing(frame, options);
  EXPECT_EQ(packing.walls.left, 0.05);
  EXPECT_EQ(packing.walls.right, 0.4);
  EXPECT_EQ(packing.walls.floor, 0.01);
  EXPECT_EQ(packing.particle_diameter, 3e-3);
  EXPECT_EQ(packing.aspect_ratio, 5);
}

TEST(Packing, BadParametersAreNamed) {
  const auto frame = two_rods();
  const auto run = std::filesystem::path(frame.file).parent_path().parent_path();
  const auto error = [&](const std::string& json) -> std::string {
    put(run / "parameters.json", json);
    try {
      read_packing(frame);
    } catch (const DataError& reason) {
      return reason.what();
    }
    return "no error";
  };
  EXPECT_THAT(error(R"({"container_width_m": "wide"})"),
              HasSubstr("parameters.json: key 'container_width_m': expected a number of 1e-12 to "
                        "1000000, found \"wide\""));
  EXPECT_THAT(error(R"({"container_width_m": -1})"),
              HasSubstr("container_width_m': expected a number of 1e-12 to 1000000, found -1"));
  EXPECT_THAT(error(R"({"particle_diameter_m": 0})"),
              HasSubstr("particle_diameter_m': expected a number of 1e-12 to 1000, found 0"));
  EXPECT_THAT(error("not json"), HasSubstr("expected a JSON object"));
}

TEST(Packing, AFrameWithoutParticlesIsAnError) {
  const auto file =
      put(fresh_folder() / "a.dump", rodpack::test::frame_head(3, 0, 0.5, 2, columns));
  try {
    read_packing(last_frame({file}));
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.dump:9: the frame of timestep 3 holds no particles"));
  }
}

// Points on a grid of spacing 0.1, each with area 0.008 (solid fraction 0.8), up to y = 3.
struct Bed {
  std::vector<double> x, y, area;
  explicit Bed(double width = 4, double height = 3) {
    for (double a = 0.05; a < width; a += 0.1)
      for (double b = 0.05; b < height; b += 0.1) {
        x.push_back(a);
        y.push_back(b);
        area.push_back(0.008);
      }
  }
};

TEST(BedSurface, IsTheTopOfAnEvenBed) {
  const Bed bed;
  EXPECT_NEAR(bed_surface(bed.y, bed.area, 0, 4, 0.2), 3, 0.02);
}

TEST(BedSurface, DoesNotSeeParticlesThatStillFall) {
  Bed bed;
  for (int i = 0; i < 200; ++i) {
    bed.y.push_back(3.5 + 0.05 * i);
    bed.area.push_back(0.008);
  }
  EXPECT_NEAR(bed_surface(bed.y, bed.area, 0, 4, 0.2), 3, 0.02);
}

// In an even bed far from its edges the coarse-grained field is the area per area, 0.8. Towards the
// surface it loses the kernel's tail t(z) at depth z, whose integral is w / sqrt(2 pi); the bed's
// rows, h = 0.1 apart, sum it by the midpoint rule, which adds h^2/24 t'(0) = -h^2 / (24 w sqrt(2
// pi)). With d_p = 0.05, AR = 1: w = 0.15, the mean starts at 3 w = 0.45.
TEST(SolidFraction, EvenBedMatchesAreaPerAreaAndTheKernelsTail) {
  const Bed bed;
  Packing packing;
  packing.x = bed.x;
  packing.y = bed.y;
  packing.area = bed.area;
  packing.walls.right = 4;
  packing.particle_diameter = 0.05;
  packing.aspect_ratio = 1;
  packing.surface = 3;
  const auto field = solid_fraction(packing);
  EXPECT_NEAR(field.scale, 0.15, 1e-15);
  EXPECT_NEAR(field.lowest, 0.45, 1e-15);
  // Where a mean ends 3 w from an edge, the kernel's tail still takes
  // 0.8 w (exp(-9/2) / sqrt(2 pi) - 3 (1 - Phi(3))) / height = 2.2e-5.
  EXPECT_NEAR(*field.up_to_3_scales_below, 0.8, 5e-5);
  const double loss = (0.15 - 0.01 / (24 * 0.15)) / std::sqrt(2 * std::acos(-1.0));
  EXPECT_NEAR(*field.up_to_surface, 0.8 * (1 - loss / 2.55), 5e-5);
  EXPECT_NEAR(field.phi.back(), 0.4, 1e-3);   // half of the kernel at the surface
  EXPECT_NEAR(field.phi.front(), 0.4, 1e-3);  // and at the floor
  EXPECT_NEAR(field.covered_below_surface, 0.8, 1e-12);
  EXPECT_TRUE(field.side_distance_kept);
}

// Divided by the kernel's share the same even bed keeps 0.8 from the floor to the surface. Rows h
// apart sum the kernel by the midpoint rule, whose error h^2/24 t'(z), divided by a share of 1/2 or
// more, is at both edges together at most 4 h^2 / (24 w sqrt(2 pi)) / height of it: 2e-4 with h =
// w/3 and a height of 3. So low a bed as 2 w is measured alike.
TEST(SolidFraction, NormalisedByTheKernelsShareAnEvenBedIsEvenToItsEdges) {
  for (const double height : {3.0, 0.3})
    for (const bool periodic : {false, true}) {
      Packing packing;
      const double h = 0.05;
      for (int i = 0; i < 4 / h; ++i)
        for (int j = 0; j < height / h - 1e-9; ++j) {
          packing.x.push_back((i + 0.5) * h);
          packing.y.push_back((j + 0.5) * h);
          packing.area.push_back(0.8 * h * h);
        }
      packing.walls.right = 4;
      packing.walls.sides = !periodic;
      packing.particle_diameter = 0.05;
      packing.aspect_ratio = 1;  // w = 0.15
      packing.surface = height;
      const auto field = solid_fraction(packing);
      const double error = 0.8 * 4 * h * h / (24 * 0.15 * std::sqrt(2 * std::acos(-1.0))) / height;
      EXPECT_NEAR(*field.normalised_from_floor_to_surface, 0.8, error);
      ASSERT_EQ(field.normalised_up_to_surface.has_value(), height > 0.45);
      EXPECT_NEAR(field.covered_below_surface, 0.8, 1e-12);
      if (!field.normalised_up_to_surface) continue;
      EXPECT_NEAR(*field.normalised_up_to_surface, 0.8, error);
      EXPECT_LT(*field.up_to_surface, 0.8 - 10 * error);  // as it is, it sinks to the surface
    }
}

// The slice of a narrow container, 2.2 l_axial wide: the walls are 0.1 l_axial from it, and the
// kernel's loss there is made good too.
TEST(SolidFraction, NormalisationCountsSideWallsNearTheSlice) {
  Packing packing;
  const double h = 0.01;
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 100; ++j) {
      packing.x.push_back((i + 0.5) * h);
      packing.y.push_back((j + 0.5) * h);
      packing.area.push_back(0.8 * h * h);
    }
  packing.walls.right = 0.11;
  packing.particle_diameter = 0.05;
  packing.surface = 1;
  const auto field = solid_fraction(packing);
  EXPECT_FALSE(field.side_distance_kept);
  EXPECT_LT(*field.up_to_3_scales_below, 0.3);
  EXPECT_NEAR(*field.normalised_from_floor_to_surface, 0.8, 1e-3);
}

TEST(SolidFraction, BedLowerThanTheAveragingHeightsHasNoMean) {
  const Bed bed(4, 0.4);
  Packing packing;
  packing.x = bed.x;
  packing.y = bed.y;
  packing.area = bed.area;
  packing.walls.right = 4;
  packing.particle_diameter = 0.05;
  packing.surface = 0.4;
  const auto field = solid_fraction(packing);
  EXPECT_FALSE(field.up_to_surface);
  EXPECT_FALSE(field.up_to_3_scales_below);
}

// The paper's container is 20 l_axial wide and its slice 2 l_axial, which leaves 9 l_axial = 3 w on
// either side: exactly what is asked for, and in binary numbers some units in the last place more
// or less, depending on AR. A wall that is closer by a thousandth is too close.
TEST(SolidFraction, SideWallsOfThePapersContainerAreThreeScalesFromTheSlice) {
  const auto kept = [](double aspect_ratio, double width_in_lengths) {
    Packing packing;
    packing.x = {0.1};
    packing.y = {0.1};
    packing.area = {4e-5};
    packing.particle_diameter = 3e-3;
    packing.aspect_ratio = aspect_ratio;
    packing.walls.right = width_in_lengths * aspect_ratio * 3e-3;
    packing.surface = 0.2;
    return solid_fraction(packing).side_distance_kept;
  };
  for (const double aspect_ratio : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) {
    EXPECT_TRUE(kept(aspect_ratio, 20)) << aspect_ratio;
    EXPECT_FALSE(kept(aspect_ratio, 20 * 0.999)) << aspect_ratio;
    EXPECT_TRUE(kept(aspect_ratio, 20 * 1.001)) << aspect_ratio;
  }
}

}  // namespace

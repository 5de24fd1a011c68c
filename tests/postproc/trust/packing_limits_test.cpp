// SPDX-License-Identifier: GPL-2.0-or-later
// Packings whose numbers are each in their range, but not together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../synthetic_packing.h"
#include "analysis/fields.h"
#include "liggghts_run.h"
#include "reading/packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::HasSubstr;

// Two rods of AR = 5, d_p = 3 mm, the upper one at that height in a box 0.3 m wide and 1e4 m high.
Frame two_rods(const std::string& height) {
  const std::string rest = " 0 0 0.0075 0.0015 0 4e-5 2e-4 0 0 0\n";
  const auto file = put(
      fresh_folder() / "b.dump",
      rodpack::test::frame_head(1, 2, 0.3, 1e4,
                                "id nspheres x y z angle half_length radius curvature area mass "
                                "vx vy vz") +
          "1 5 0.1 0.1" + rest + "2 5 0.1 " + height + rest);
  return last_frame({file});
}

template <class Use>
std::string error_of(Use use) {
  try {
    use();
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

TEST(PackingLimits, DiameterOfAnotherUnitIsRefused) {
  PackingOptions options;
  const auto frame = two_rods("0.2");
  const auto error = [&](double diameter) {
    options.particle_diameter = diameter;
    return error_of([&] { read_packing(frame, options); });
  };
  EXPECT_EQ(error(0.004), "no error");
  EXPECT_THAT(error(0.3), HasSubstr("expected about the spheres' mean, 0.003 m, found 0.3 m"));
  EXPECT_THAT(error(1e-5), HasSubstr("expected about the spheres' mean, 0.003 m, found 1e-05 m"));
}

// Layers are 7.5 mm thick, half an axial length: 1e5 of them are 750 m.
TEST(PackingLimits, HeightIsLimitedInLayers) {
  EXPECT_EQ(error_of([] { read_packing(two_rods("749")); }), "no error");
  EXPECT_THAT(error_of([] { read_packing(two_rods("751")); }),
              HasSubstr("expected at most 100000 layers of the thickness 0.0075 m"));
}

// Walls of another run, or in another unit, do not hold the particles; a soft one lets a centre in.
TEST(PackingLimits, WallsHoldTheParticles) {
  PackingOptions options;
  const auto error = [&](const std::vector<double>& walls) {
    options.walls = walls;
    return error_of([&] { read_packing(two_rods("0.2"), options); });
  };
  EXPECT_EQ(error({0.102, 0.3, 0}), "no error");
  EXPECT_THAT(
      error({0.15, 0.3, 0}),
      HasSubstr("b.dump:10: expected the particles within the walls (--walls), found 2 of 2 "
                "further than d_p beyond them, this one by 16.7 d_p"));
  EXPECT_THAT(error({0, 0.09, 0}), HasSubstr("this one by 3.33 d_p"));
  EXPECT_THAT(error({0, 0.3, 0.15}), HasSubstr("found 1 of 2 further than d_p beyond them"));
}

// A shorter period would let a kernel see any number of images.
TEST(PackingLimits, ContainersAreAtLeastAsWideAsAParticle) {
  PackingOptions options;
  options.walls = {0, 2.9e-3, 0};
  EXPECT_THAT(error_of([&] { read_packing(two_rods("0.2"), options); }),
              HasSubstr("--walls: expected a container or period of at least d_p = 0.003 m, found "
                        "one of 0.0029 m"));
}

// Found by fuzzing: rods much longer than the period took seconds each.
TEST(PackingLimits, PeriodsAreAtLeastAsLongAsAParticle) {
  PackingOptions options;
  const auto error = [&](double period) {
    options.walls = {0, period, 0};
    auto frame = two_rods("0.2");
    frame.periodic[0] = true;
    frame.bounds[0] = {0, period};
    return error_of([&] { read_packing(frame, options); });
  };
  EXPECT_EQ(error(0.0151), "no error");
  EXPECT_THAT(error(0.0149),
              HasSubstr("--walls: expected a period of at least a particle's length, "
                        "0.015 m, found one of 0.0149 m"));
}

TEST(PackingLimits, GridsAreLimitedInPlaces) {
  const auto frame = two_rods("0.2");
  FieldOptions options;
  options.window = {{0, 0.1, 0, 0.1}};
  const auto error = [&](double spacing) {
    options.spacing = spacing;
    FieldSample sample(options);
    return error_of([&] { sample.add(read_packing(frame), frame, nullptr); });
  };
  EXPECT_EQ(error(1e-2), "no error");
  EXPECT_THAT(error(0.99e-4), HasSubstr("grid: expected at most 1000000 places, found "));
  EXPECT_THAT(error(1e-9), HasSubstr("more than 1e8 places"));
}

}  // namespace

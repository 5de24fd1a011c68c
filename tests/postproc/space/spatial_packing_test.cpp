// SPDX-License-Identifier: GPL-2.0-or-later
// Which dumps are scenes in space, and what is read of them.
#include "reading/space/spatial_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "liggghts_run.h"
#include "spatial_scene.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::spatial_bodies;
using testing::HasSubstr;

class SpatialReading : public testing::Test {
 protected:
  std::filesystem::path folder_ = fresh_folder();

  Frame frame(const std::vector<Vector3>& centres, const std::vector<Vector3>& axes,
              const std::string& flags = "ff ff ff") {
    const auto text = spatial_bodies(centres, axes, {0.1, 0.2, 0.3}, flags);
    return last_frame({put(folder_ / "b.dump", text)});
  }
  Frame upright() {
    return frame({{0.05, 0.05, 0.005}, {0.05, 0.07, 0.005}}, {{0, 0, 1}, {0, 0, 1}});
  }
  Frame flat() { return frame({{0.05, 0.05, 0.1}, {0.05, 0.1, 0.1}}, {{0, 1, 0}, {1, 0, 0}}); }

  static std::string error_of(const Frame& bodies, const SpaceOptions& space,
                              const PackingOptions& options = {}) {
    try {
      if (is_in_space(bodies, options, space)) read_spatial_packing(bodies, options, space);
    } catch (const DataError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(SpatialReading, QuaternionsGiveTheAxes) {
  const std::vector<Vector3> axes{{2.0 / 3, -1.0 / 3, 2.0 / 3}, {0, 0.6, -0.8}, {1, 0, 0}};
  const auto bodies = frame(std::vector<Vector3>(3, {0.05, 0.05, 0.05}), axes);
  const BodyAxes read(bodies);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(read.axis(i, 0)[c], axes[i][c], 1e-12);
  // The turn is about a normal of x: y stays as near to itself as may be, for x to (0, 0.6, -0.8)
  // to (-0.6, 1 - 0.36, 0.48).
  EXPECT_NEAR(read.axis(1, 1)[0], -0.6, 1e-12);
  EXPECT_NEAR(read.axis(1, 1)[1], 0.64, 1e-12);
  EXPECT_NEAR(read.axis(1, 1)[2], 0.48, 1e-12);
}

TEST_F(SpatialReading, WhatLiesInAPlaneIsPlanarUnlessAnotherAxisThanYPointsUp) {
  EXPECT_FALSE(is_in_space(flat(), {}, {}));
  EXPECT_FALSE(is_in_space(flat(), {}, {"y", {}, {}}));
  EXPECT_TRUE(is_in_space(flat(), {}, {"z", {}, {}}));
  EXPECT_TRUE(is_in_space(upright(), {}, {"y", {}, {}}));
  EXPECT_THAT(error_of(upright(), {}),
              testing::AllOf(HasSubstr("b.dump:10: expected a planar packing"),
                             HasSubstr("; a scene in space needs --vertical, or 'vertical_axis' "
                                       "in parameters.json")));
}

TEST_F(SpatialReading, ParametersSayWhichAxisPointsUp) {
  put(folder_ / "parameters.json", "{\"vertical_axis\": \"z\"}\n");
  EXPECT_TRUE(is_in_space(upright(), {}, {}));
  EXPECT_EQ(read_spatial_packing(upright(), {}, {}).walls.vertical, 2U);
  EXPECT_EQ(read_spatial_packing(upright(), {}, {"x", {}, {}}).walls.vertical, 0U);
  for (const std::string wrong : {"\"w\"", "2", "\"xy\"", "\"\""}) {
    put(folder_ / "parameters.json", "{\"vertical_axis\": " + wrong + "}\n");
    EXPECT_THAT(error_of(upright(), {}),
                HasSubstr("key 'vertical_axis': expected \"x\", \"y\" or \"z\", found " + wrong));
  }
}

TEST_F(SpatialReading, WallsAreTheContainersOrTheBoxs) {
  const auto from_box = read_spatial_packing(upright(), {}, {"z", {}, {}});
  EXPECT_NEAR(from_box.walls.high[1], 0.2, 1e-12);
  EXPECT_NEAR(from_box.walls.distance_to_sides({0.03, 0.1, 0.9}), 0.03, 1e-12);
  EXPECT_NEAR(from_box.walls.height({0.03, 0.1, 0.25}), 0.25, 1e-12);
  EXPECT_NEAR(from_box.particle_diameter, 0.002, 1e-12);
  EXPECT_NEAR(from_box.aspect_ratio, 5, 1e-12);

  const auto given =
      read_spatial_packing(upright(), {}, {"z", {0.01, 0.09, 0, 0.15, 0.001, 0.3}, {}});
  EXPECT_NEAR(given.walls.distance_to_sides({0.03, 0.1, 0.1}), 0.02, 1e-12);
  EXPECT_NEAR(given.walls.height({0.03, 0.1, 0.25}), 0.249, 1e-12);
  const auto round = read_spatial_packing(upright(), {}, {"z", {}, {0.05, 0.06, 0.04}});
  EXPECT_NEAR(round.walls.distance_to_sides({0.08, 0.1, 0}), -0.01, 1e-12);

  const auto periodic =
      read_spatial_packing(frame({{0.05, 0.05, 0.05}}, {{0, 0, 1}}, "pp pp pp"), {}, {"z", {}, {}});
  EXPECT_TRUE(std::isinf(periodic.walls.distance_to_sides({0, 0, 0})));
  EXPECT_TRUE(std::isinf(periodic.walls.height({0, 0, 0})));
  EXPECT_EQ(periodic.surface, 0.3);
}

// Layers of AR d_p / 2 = 5 mm: the twelve from 0 to 60 mm hold ten rods each, the ones above none,
// so that the content falls through half of it midway between the middles 57.5 and 62.5 mm.
// The box of the dump begins outside of the walls: soft ones let spheres in.
TEST_F(SpatialReading, ParametersSayWhatTheContainerIs) {
  const auto walls = [&](const std::string& container, const SpaceOptions& space = {}) {
    put(folder_ / "parameters.json", "{\"vertical_axis\": \"z\", \"container_width_m\": 0.08, " +
                                         ("\"container\": \"" + container + "\"}\n"));
    return read_spatial_packing(upright(), {}, space).walls;
  };
  const auto box = walls("box");
  EXPECT_EQ(box.low, (Vector3{0, 0, 0}));
  EXPECT_EQ(box.high, (Vector3{0.08, 0.08, 0.3}));
  EXPECT_FALSE(box.round);
  EXPECT_THAT(box.source, HasSubstr("parameters.json"));
  const auto cylinder = walls("cylinder");
  EXPECT_TRUE(cylinder.round);
  EXPECT_EQ(cylinder.radius, 0.04);
  EXPECT_EQ(cylinder.middle[0], 0.04);
  EXPECT_EQ(cylinder.middle[1], 0.04);
  // What the command line says goes first.
  const auto given = walls("cylinder", {"", {0, 0.1, 0, 0.1, 0, 0.1}, {}});
  EXPECT_FALSE(given.round);
  EXPECT_EQ(given.source, "--container");
  EXPECT_EQ(walls("box", {"", {}, {0.05, 0.05, 0.03}}).radius, 0.03);
  // Another word is a deck's own affair.
  EXPECT_THAT(walls("hopper").source, HasSubstr("box bounds of"));
  put(folder_ / "parameters.json",
      "{\"vertical_axis\": \"z\", \"container\": \"box\", \"container_width_m\": -1}\n");
  EXPECT_THAT(error_of(upright(), {}), HasSubstr("key 'container_width_m': expected"));
}

TEST_F(SpatialReading, SurfaceIsWhereTheLayersEnd) {
  std::vector<Vector3> centres;
  for (int layer = 0; layer < 12; ++layer)
    for (int k = 0; k < 10; ++k)
      centres.push_back({0.05, 0.015 * k + 0.02, 0.005 * layer + 0.0005 * k + 0.0001});
  centres.push_back({0.05, 0.1, 0.2});  // still falls
  const auto bodies = frame(centres, std::vector<Vector3>(centres.size(), {1, 0, 0}));
  EXPECT_NEAR(read_spatial_packing(bodies, {}, {"z", {}, {}}).surface, 0.06, 1e-12);
}

TEST_F(SpatialReading, WhatCannotBeIsRefusedByName) {
  const auto bodies = upright();
  EXPECT_THAT(error_of(bodies, {"w", {}, {}}),
              HasSubstr("--vertical: expected one of x, y, z, found 'w'"));
  EXPECT_THAT(error_of(bodies, {"z", {0.1, 0, 0, 0.2, 0, 0.3}, {}}),
              HasSubstr("--container: expected the upper wall along x beyond the lower one, found "
                        "0.1 and 0"));
  EXPECT_THAT(error_of(bodies, {"z", {0, 0.001, 0, 0.2, 0, 0.3}, {}}),
              HasSubstr("--container: expected a container of at least d_p = 0.002 m along x, "
                        "found 0.001 m"));
  EXPECT_THAT(error_of(bodies, {"z", {}, {0.05, 0.05, 0.0009}}),
              HasSubstr("expected a container of at least d_p = 0.002 m along x, found 0.0018 m"));
  EXPECT_THAT(error_of(bodies, {"z", {}, {0.05, 0.05, -1}}),
              HasSubstr("--cylinder: expected a positive radius, found -1"));
  EXPECT_THAT(
      error_of(bodies, {"z", {}, {0.02, 0.02, 0.02}}),
      HasSubstr("b.dump:10: expected the particles within the walls (--cylinder, box bounds"));
  EXPECT_THAT(error_of(bodies, {"z", {0, 0.1, 0, 0.2, 0.1, 0.3}, {}}),
              HasSubstr("(--container), found 2 of 2 further than d_p beyond them, this one by "
                        "47.5 d_p"));
  const auto periodic = frame({{0.05, 0.05, 0.005}}, {{0, 0, 1}}, "ff pp ff");
  EXPECT_THAT(error_of(periodic, {"z", {}, {0.05, 0.05, 0.04}}),
              HasSubstr("--cylinder: expected a dump with walls along y, which is periodic"));
  EXPECT_THAT(
      error_of(periodic, {"z", {0, 0.1, 0, 0.1, 0, 0.3}, {}}),
      HasSubstr(
          "--container: expected the period of the dump along y, 0 to 0.2 m, found 0 to 0.1 m"));
  PackingOptions long_rods;
  long_rods.aspect_ratio = 101;
  EXPECT_THAT(error_of(periodic, {"z", {}, {}}, long_rods),
              HasSubstr("expected a period of at least a particle's length, 0.202 m along y"));
  put(folder_ / "two.dump",
      rodpack::test::frame_head(1, 1, 0.3, 2, "id nspheres x y z") + "1 5 0.1 0.1 0\n");
  EXPECT_THAT(error_of(last_frame({(folder_ / "two.dump").string()}), {"z", {}, {}}),
              HasSubstr("no column 'qw'"));
  Frame empty;
  empty.file = "e.dump";
  EXPECT_THROW(read_spatial_packing(empty, {}, {"z", {}, {}}), DataError);
}

}  // namespace

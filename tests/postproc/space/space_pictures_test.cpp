// SPDX-License-Identifier: GPL-2.0-or-later
// Pictures of packings in space: the camera against the ray tracer's own projection, colours, and
// the subcommand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/long_axis.h"
#include "figures/packings/particles.h"
#include "figures/space/camera.h"
#include "figures/space/ray_tracing.h"
#include "liggghts_run.h"
#include "reading/text_file.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;
const double degree = std::acos(-1.0) / 180;

// From the side of the first horizontal axis the second one points to the right, and the vertical
// up; right, up and towards the eye are right-handed, whichever way it looks.
TEST(Camera, SeesTheAxesWhereTheyAre) {
  const Camera side({1, 2, 3}, 10, 0, 0, 2);
  const auto expect = [](const SeenPlace& seen, double right, double up, double depth) {
    EXPECT_NEAR(seen[0], right, 1e-12);
    EXPECT_NEAR(seen[1], up, 1e-12);
    EXPECT_NEAR(seen[2], depth, 1e-12);
  };
  expect(side.see({1, 2, 3}), 0, 0, 10);
  expect(side.see({1, 3, 3}), 1, 0, 10);
  expect(side.see({1, 2, 4}), 0, 1, 10);
  expect(side.see({3, 2, 3}), 0, 0, 8);
  // With y up the axes after it are z and x.
  const Camera other({0, 0, 0}, 10, 90, 0, 1);
  expect(other.turn({0, 1, 0}), 0, 1, 0);
  expect(other.turn({0, 0, 1}), -1, 0, 0);
  expect(other.turn({1, 0, 0}), 0, 0, -1);
  const Camera any({0, 0, 0}, 5, 33, 21, 2);
  const auto x = any.turn({1, 0, 0}), y = any.turn({0, 1, 0}), z = any.turn({0, 0, 1});
  // The determinant of right, up and depth is -1: depth points away from the eye.
  EXPECT_NEAR(x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) +
                  x[2] * (y[0] * z[1] - y[1] * z[0]),
              -1, 1e-12);
  EXPECT_NEAR(z[1], std::cos(21 * degree), 1e-12);
}

// A ball of radius 3 at distance 5 is seen under asin(3/5), whose tangent is 3/4.
TEST(Frustum, HoldsWholeBalls) {
  Frustum frustum;
  frustum.include({0, 0, 5}, 3);
  EXPECT_NEAR(frustum.left, -0.75, 1e-12);
  EXPECT_NEAR(frustum.top, 0.75, 1e-12);
  frustum.include({0, 8, 4}, 0);
  EXPECT_NEAR(frustum.top, 2, 1e-12);
  EXPECT_NEAR(frustum.bottom, -0.75, 1e-12);
  frustum.widen(0.1);
  EXPECT_NEAR(frustum.top, 2.275, 1e-12);
  EXPECT_NEAR(frustum.right, 0.75 + 0.275, 1e-12);
}

struct Pixels {
  int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;  // of one colour, both ends included
};

// Of a binary PPM, the pixels in which that channel stands out.
Pixels pixels_of(const std::string& ppm, int width, int height, int channel) {
  const auto first = ppm.size() - static_cast<std::size_t>(3 * width * height);
  Pixels found;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto at = first + static_cast<std::size_t>(3 * (y * width + x));
      const auto value = [&](int c) {
        return static_cast<int>(static_cast<unsigned char>(ppm[at + static_cast<std::size_t>(c)]));
      };
      if (value(channel) < value((channel + 1) % 3) + 20) continue;
      found.left = std::min(found.left, x);
      found.right = std::max(found.right, x);
      found.top = std::min(found.top, y);
      found.bottom = std::max(found.bottom, y);
    }
  return found;
}

// Two balls beside the middle are where Camera and Frustum say, not mirrored, to a pixel: the lines
// of sight that touch a ball at the angle a off the view have the angles a +- asin(r / distance).
TEST(RayTracing, DrawsWhatTheCameraSees) {
  const Camera camera({0, 0, 0}, 20, 30, 20, 2);
  const Vector3 red{2, 3, 1}, green{1, -3, -2};
  Frustum frustum;
  for (const auto& place : {red, green}) frustum.include(camera.see(place), 3);
  const int width = 320;
  const double per_unit = width / (frustum.right - frustum.left);
  const int height = static_cast<int>(std::lround(per_unit * (frustum.top - frustum.bottom)));
  TracedScene scene;
  scene.ball(camera.see(red), 1, "#ff0000");
  scene.ball(camera.see(green), 1, "#00ff00");
  const auto file = (fresh_folder() / "balls.ppm").string();
  trace_rays(scene.text(frustum, static_cast<std::size_t>(width), static_cast<std::size_t>(height),
                        10, 100),
             file, "PPM");
  const auto picture = read_text(file);
  for (const int channel : {0, 1}) {
    Frustum ball;
    ball.include(camera.see(channel == 0 ? red : green), 1);
    const auto found = pixels_of(picture, width, height, channel);
    EXPECT_NEAR(found.left, (ball.left - frustum.left) * per_unit, 1.6) << channel;
    EXPECT_NEAR(found.right + 1, (ball.right - frustum.left) * per_unit, 1.6) << channel;
    EXPECT_NEAR(found.top, (frustum.top - ball.top) * per_unit, 1.6) << channel;
    EXPECT_NEAR(found.bottom + 1, (frustum.top - ball.bottom) * per_unit, 1.6) << channel;
  }
}

Frame spheres_frame(const std::string& rows, std::size_t number, const std::string& flags) {
  return last_frame({put(fresh_folder() / "spheres.1.dump",
                         "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n" + std::to_string(number) +
                             "\nITEM: BOX BOUNDS " + flags +
                             "\n0 10\n0 10\n0 10\nITEM: ATOMS id body x y z radius\n" + rows)});
}

TEST(LongAxis, InSpaceIsTheChordOfTheFarthestSpheres) {
  // Three spheres along (1, 2, 2), out of order and across a periodic side; an upright pair; one.
  const auto frame = spheres_frame(
      "1 1 9.5 2 2 0.5\n2 1 0.5 4 4 0.5\n3 1 0 3 3 0.5\n4 2 5 5 5 0.5\n5 2 5 5 6 0.5\n"
      "6 3 7 7 7 0.5\n",
      6, "pp ff ff");
  const auto to_z = degrees_to_axis(frame, 2), to_x = degrees_to_axis(frame, 0);
  for (const std::size_t row : {0U, 1U, 2U}) {
    EXPECT_NEAR(to_z[row], std::acos(2.0 / 3) / degree, 1e-9);
    EXPECT_NEAR(to_x[row], std::acos(1.0 / 3) / degree, 1e-9);
  }
  EXPECT_NEAR(to_z[3], 0, 1e-9);
  EXPECT_NEAR(to_x[4], 90, 1e-9);
  EXPECT_TRUE(std::isnan(to_z[5]));
}

TEST(Joints, OfUprightSpheresAreFoundInSpace) {
  const auto frame = spheres_frame("1 1 5 5 5 0.5\n2 1 5 5 6 0.5\n3 1 5 5 9 0.5\n", 3, "ff ff ff");
  const auto joints = joints_of(frame, {0, 1, 2});
  ASSERT_EQ(joints.size(), 1U);  // the third one is no neighbour
  EXPECT_EQ(joints[0].sphere, 0U);
  EXPECT_EQ(joints[0].other, 1U);
}

class SpaceRender : public testing::Test {
 protected:
  void SetUp() override {
    std::string rows;
    for (int k = 0; k < 27; ++k)
      for (int s = 0; s < 2; ++s)
        rows += std::to_string(2 * k + s + 1) + " " + std::to_string(k + 1) + " 1 " +
                std::to_string(0.0015 + 0.006 * (k % 3) + 0.003 * s) + " " +
                std::to_string(0.0015 + 0.006 * (k / 3 % 3)) + " " +
                std::to_string(0.0015 + 0.003 * (k / 9)) + " 0.0015 0 0 " +
                std::to_string(1e-3 * (k + 1)) + " " + std::to_string(2e-3 * (k + 1)) + "\n";
    put(folder_ / "spheres.dump",
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n54\nITEM: BOX BOUNDS ff ff ff\n0 0.018\n0 "
        "0.018\n"
        "0 0.1\nITEM: ATOMS id body type x y z radius fx fy fz fsum\n" +
            rows);
  }
  rodpack::test::Run run(const std::string& arguments) const {
    return rodpack::test::run_rodpack("render spheres.dump " + arguments, folder_);
  }
  fs::path folder_ = fresh_folder();
};

TEST_F(SpaceRender, WritesAPictureWithItsScales) {
  const auto result = run("--vertical z --pixels 300");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto svg = text_of(folder_ / "packing.svg");
  for (const std::string part : {"data:image/png;base64,", "sum of contact forces (mN)",
                                 "at the middle of the bed", ">x</text>", ">z</text>"})
    EXPECT_THAT(svg, HasSubstr(part));
  EXPECT_GT(fs::file_size(folder_ / "packing.png"), 10000U);
  for (const auto& entry : fs::directory_iterator(folder_))  // nothing of the way there is left
    EXPECT_EQ(entry.path().string().find("traced"), std::string::npos) << entry.path();
  const auto other = run(
      "--vertical z --cylinder 0.009 0.009 0.013 --azimuth -60 --elevation 40 --colour orientation "
      "--pixels 300 -o round");
  ASSERT_EQ(other.exit_code, 0) << other.output;
  EXPECT_THAT(text_of(folder_ / "round.svg"),
              HasSubstr("angle of the long axis to the vertical, z (°)"));
}

TEST_F(SpaceRender, RefusesWhatIsOfAPlaneOrMissing) {
  const auto refuses = [&](const std::string& arguments, int exit_code, const std::string& reason) {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments << result.output;
    EXPECT_THAT(result.output, HasSubstr(reason)) << arguments;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  };
  refuses("", 1, "a scene in space needs --vertical");
  refuses("--vertical z --window 0 1 0 1", 2, "--window: expected in a scene in a plane alone");
  refuses("--vertical z --elevation 90", 2, "--elevation: expected a number of -89 to 89");
  rodpack::test::SyntheticPacking planar;
  planar.fill();
  put(folder_ / "planar.dump", planar.spheres_frame(1));
  const auto flat = rodpack::test::run_rodpack("render planar.dump --azimuth 3", folder_);
  EXPECT_EQ(flat.exit_code, 2);
  EXPECT_THAT(flat.output, HasSubstr("--azimuth: expected in a scene in space alone"));
  // A machine without the ray tracer.
  const auto without = rodpack::test::run_command(
      "PATH=/nowhere '" RODPACK_BIN "/rodpack' render spheres.dump --vertical z", folder_);
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_THAT(without.output, HasSubstr("tachyon was not found: install tachyon-bin-nox"));
  EXPECT_FALSE(fs::exists(folder_ / "packing.png"));
}

}  // namespace

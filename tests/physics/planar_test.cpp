// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;

const char* deck = "verification/planar/in.planar";

void expect_planar_for_1e5_steps(const std::map<std::string, std::string>& vars, std::size_t rows) {
  const auto run = run_liggghts(deck, vars);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  for (int frame = 0; frame <= 5; ++frame) {
    const Table spheres = read_dump(run.folder / "spheres.dump", frame);
    for (const char* name : {"z", "vz", "omegax", "omegay", "fz"})
      for (double value : spheres.column(name)) ASSERT_EQ(value, 0.) << name << " frame " << frame;
  }
  const Table spheres = read_dump(run.folder / "spheres.dump");
  // rods (type 2) turn about z and nothing else: quaternion exactly (w, 0, 0, z)
  const Table bodies = read_dump(run.folder / "bodies.dump");
  for (std::size_t i = 0; i < bodies.rows(); ++i) {
    if (bodies.column("half_length")[i] != 0.0045) continue;
    EXPECT_EQ(bodies.column("qx")[i], 0.);
    EXPECT_EQ(bodies.column("qy")[i], 0.);
    const double norm = std::hypot(bodies.column("qw")[i], bodies.column("qz")[i]);
    EXPECT_NEAR(norm, 1., 1e-14);
  }
  EXPECT_EQ(spheres.rows(), rows);  // all there, and they move
  double fastest = 0;
  for (double omega : spheres.column("omegaz")) fastest = std::max(fastest, std::abs(omega));
  EXPECT_GT(fastest, 1e-6);
}

TEST(Planar, RodsStockBodiesAndSpheresNeverLeaveThePlaneByASingleBit) {
  expect_planar_for_1e5_steps({}, 12 * 5 + 6 * 3 + 6);
}

TEST(Planar, NorDoRodsAndSpheresWithAdamsBashforth) {
  expect_planar_for_1e5_steps({{"move_bodies", "multisphere/ab"},
                               {"move_balls", "nve/sphere/ab"},
                               {"mixture", "rods 3 ball 1"}},
                              18 * 5 + 6);
}

TEST(Planar, StaysPlanarOnTwoRanks) {
  const auto run = run_liggghts(deck, {{"steps", "8000"}, {"every", "8000"}}, 2);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  EXPECT_GE(spheres.rows(), 8u);  // two lines
  for (const char* name : {"z", "vz", "omegax", "omegay", "fz"})
    for (double value : spheres.column(name)) ASSERT_EQ(value, 0.) << name;
}

TEST(Planar, WithoutTheFixTheSameSceneLeavesThePlane) {
  // Guards the test above against a scene in which nothing pulls out of the plane.
  const auto run = run_liggghts(deck, {{"steps", "12500"},
                                       {"every", "12500"},
                                       {"enforce", "property/atom dummy scalar no no no 0"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  // plain spheres and stock bodies fall along z by g_z t^2 / 2, g_z = 10 * 0.2 / sqrt(0.3^2 + 1 +
  // 0.2^2) = 1.88 m/s^2: 1 mm in 0.03 s
  const Table spheres = read_dump(run.folder / "spheres.dump");
  double largest = 0;
  for (double z : spheres.column("z")) largest = std::max(largest, z);
  EXPECT_GT(largest, 1e-4);
}

TEST(Planar, RefusesABodyThatLiesAcrossThePlane) {
  const auto run = run_liggghts(Deck().hertz().box("0 0.1 0 0.1 -0.05 0.05").with(R"(
fix rods all particletemplate/multisphere/spherocylinder 7 type 1 aspect_ratio 5 diameter 0.003 surface smooth density 2500
fix mix all particledistribution/discrete 32452843 1 rods 1
fix pack all insert/pack seed 32452867 distributiontemplate mix insert_every once overlapcheck yes orientation random all_in yes particles_in_region 5 region box
fix bodies all multisphere
fix plane all enforce2d/multisphere
run 10
)"));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("off the plane z = 0"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("particles must be put into the plane"), std::string::npos);
}

/// A minimal scene around the line under test.
std::string scene(const std::string& boundary, const std::string& lines) {
  return Deck()
      .hertz()
      .boundary(boundary)
      .box("0 0.1 0 0.1 -0.001 0.001")
      .with(lines + "\nrun 1\n");
}

void expect_error(const std::string& deck_text, const std::string& message) {
  const auto run = run_liggghts(deck_text);
  EXPECT_NE(run.exit_code, 0) << deck_text;
  EXPECT_NE(run.output.find(message), std::string::npos) << message << "\n" << run.output;
}

const std::string rods =
    "fix rods all particletemplate/multisphere/spherocylinder 7 type 1 aspect_ratio 5 diameter "
    "0.003 surface smooth density 2500 planar yes\n"
    "fix lines all insert/line 1 template rods 1 per_line 2 x 0 0.1 y 0.05 z 0 total 2 interval "
    "1\n";

TEST(Planar, RefusesWrongInput) {
  const std::string moving = rods + "fix b all multisphere\n";
  expect_error(scene("f f f", moving + "fix plane all enforce2d/multisphere plane 1"),
               "plane is '1', expected a z in the box");
  expect_error(scene("f f f", rods + "fix plane all enforce2d/multisphere\nfix b all multisphere"),
               "must be defined after fix multisphere (id b)");
  expect_error(scene("f f f", moving + "fix plane all enforce2d/multisphere\nfix m all nve/sphere"),
               "must be defined after fix nve/sphere (id m)");
  expect_error(
      scene("f f p", moving + "fix plane all enforce2d/multisphere"),
      "periodic z needs a box thicker than the thickest particle, 0.003000 m, got '0.002000'");
}

TEST(Planar, RefusesTwoDimensions) {
  expect_error("dimension 2\n" + scene("f f p", "fix plane all enforce2d/multisphere"),
               "dimension is '2', expected 3");
}

}  // namespace

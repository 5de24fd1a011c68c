// SPDX-License-Identifier: GPL-2.0-or-later
// The end of a contact is made good however far the pair has gone in the step in which it parts.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

constexpr double dt = 1.1e-5;
constexpr int spheres = 8;

/// Spheres of 3 mm, one above the other, that fly along x at `speed` towards partners at rest, or
/// towards a wall, and touch at different moments of the time step; their speeds after the
/// collision over that before. The law is linear: these do not depend on the speed.
std::vector<double> rebounds(double speed, const std::string& eta, const std::string& wall,
                             const std::string& run_style, int ranks = 1) {
  const double travel = speed * dt;
  std::string lines = R"(
fix ball all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 &
    aspect_ratio 1 diameter 0.003 surface smooth density constant 2500 planar yes
fix mix all particledistribution/discrete 15485867 1 ball 1.0
)";
  const auto place = [&](const std::string& id, double x, double y, double v) {
    lines += one_particle(id, {x, y, 0},
                          "vel constant " + exact(v) + " 0 0 orientation constant 1 0 0 0");
  };
  for (int k = 0; k < spheres; ++k) {
    // The gap closes after 3.06, 3.19, ... steps.
    const double gap = travel * (3.06 + 0.13 * k), y = 0.008 * (k + 1);
    place("a" + std::to_string(k), -0.0015 - gap, y, speed);
    if (wall.empty()) place("b" + std::to_string(k), 0.0015, y, 0.0);
  }
  lines += wall + R"(
fix motion all multisphere/ab order 3 planar yes
fix plane all enforce2d/multisphere
)" + run_style +
           R"(
thermo 100000000
run 1
run 75
write_dump all multisphere/body end.dump modify format %.17g
)";
  const auto run = run_liggghts(Deck()
                                    .box("-0.05 0.05 -0.01 0.08 -0.01 0.01")
                                    .processors(ranks > 1 ? "1 2 1" : "1 1 1")
                                    .models("model spring_dashpot tangential spring_dashpot")
                                    .timestep(exact(dt))
                                    .damping(eta)
                                    .with(lines),
                                {}, ranks);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const Table end = read_dump(run.folder / "end.dump");
  std::vector<double> result = end.column("vx");
  EXPECT_EQ(result.size(), wall.empty() ? 2u * spheres : 1u * spheres);
  for (double& v : result) v /= speed;
  return result;
}

/// At 16 m/s a sphere goes on by 12 % of its radius in a step, at 0.16 m/s by 0.12 %.
void expect_the_same(const std::string& wall, const std::string& run_style, int ranks = 1,
                     double speed = 16) {
  for (const std::string eta : {"0", "0.05"}) {
    const std::vector<double> slow = rebounds(speed / 100, eta, wall, run_style, ranks);
    const std::vector<double> fast = rebounds(speed, eta, wall, run_style, ranks);
    ASSERT_EQ(slow.size(), fast.size());
    // Places are drawn within 1e-13 m, 6e-8 of the slow one's step.
    for (std::size_t k = 0; k < slow.size(); ++k)
      EXPECT_NEAR(slow[k], fast[k], 1e-6) << "sphere " << k << ", eta " << eta;
    if (eta == "0" && !wall.empty()) {
      EXPECT_NEAR(slow[0], -1.0, 1e-3);
    }
  }
}

const std::string law = "model spring_dashpot tangential spring_dashpot ";
const std::string model = law + "primitive type 1 xplane 0";

/// The plane x = 0 behind the spheres as two triangles, whose common edge is apart from all of them
/// by more than a radius.
std::string mesh_wall(const std::filesystem::path& folder) {
  const auto file = folder / "wall.stl";
  std::ofstream stl(file);
  stl << "solid wall\n";
  for (const char* corners : {"0 -0.009 -0.009\nvertex 0 0.079 -0.009\nvertex 0 0.079 0.009",
                              "0 -0.009 -0.009\nvertex 0 0.079 0.009\nvertex 0 -0.009 0.009"})
    stl << "facet normal 1 0 0\nouter loop\nvertex " << corners << "\nendloop\nendfacet\n";
  stl << "endsolid wall\n";
  return "fix triangles all mesh/surface file " + file.string() +
         " type 1\nfix wall all wall/gran " + law + "mesh n_meshes 1 meshes triangles";
}

}  // namespace

TEST(FastPairs, PairsKeepTheEndOfTheirContact) { expect_the_same("", ""); }

TEST(FastPairs, PairsKeepTheEndOfTheirContactOnTwoRanks) { expect_the_same("", "", 2); }

TEST(FastPairs, PairsKeepTheEndOfTheirContactInThePlanarEngine) {
  expect_the_same("", "run_style verlet/planar");
}

TEST(FastPairs, WallsKeepTheEndOfTheirContact) {
  // 4.4 % of its radius in a step; at 16 m/s it would come out on the other side.
  expect_the_same("fix wall all wall/gran " + model, "", 1, 6);
}

TEST(FastPairs, TrianglesKeepTheEndOfTheirContact) {
  const auto folder = fresh_folder();
  for (const int ranks : {1, 2}) expect_the_same(mesh_wall(folder), "", ranks, 6);
}

TEST(FastPairs, SolidWallsKeepTheEndOfTheirContact) {
  expect_the_same("fix wall all wall/gran/solid " + model + " bound hi", "");
  expect_the_same("fix wall all wall/gran/solid " + model + " bound hi", "run_style verlet/planar");
}

// SPDX-License-Identifier: GPL-2.0-or-later
// The subcommands on dumps of scenes in space: what they write, say and refuse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_run.h"
#include "spatial_scene.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::read_table;
using testing::HasSubstr;
namespace fs = std::filesystem;

class SpaceCommand : public testing::Test {
 protected:
  void SetUp() override {
    const Vector3 size{0.1, 0.1, 0.1};
    put(folder_ / "b.dump",
        rodpack::test::spatial_bodies(rodpack::test::random_places(size, 3000, 5),
                                      rodpack::test::watson_axes(4, 3000, 6), size));
  }
  rodpack::test::Run run(const std::string& arguments) const {
    return rodpack::test::run_rodpack(arguments, folder_);
  }
  void expect_refusal(const std::string& arguments, int exit_code,
                      const std::string& reason) const {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << arguments << result.output;
    EXPECT_THAT(result.output, HasSubstr(reason)) << arguments;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
  void expect_files(const std::vector<std::string>& names) const {
    for (const auto& name : names) EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  }
  fs::path folder_ = fresh_folder();
};

TEST_F(SpaceCommand, OrientationWritesItsTablesAndFigures) {
  const auto result = run("orientation b.dump --vertical z -o o");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("in space, z up; walls: box bounds of b.dump"));
  EXPECT_THAT(result.output, HasSubstr("of as many isotropic particles 0.0"));
  expect_files({"o.png", "o.svg", "o_azimuth.png", "o_azimuth.svg"});
  const auto polar = read_table(folder_ / "o.csv");
  EXPECT_EQ(polar.rows(), 18U);
  double mean = 0;
  for (const double each : polar.column("density_over_isotropic")) mean += each / 18;
  EXPECT_NEAR(mean, 1, 1e-8);
  EXPECT_EQ(read_table(folder_ / "o_azimuth.csv").rows(), 36U);
  const auto order = read_table(folder_ / "o_order.csv");
  const double exact = (3 * rodpack::test::watson_mean_square(4) - 1) / 2;
  EXPECT_NEAR(order.column("order")[0], exact, 4 * order.column("standard_error")[0]);
  EXPECT_GT(order.column("direction_z")[0], 0.99);
  EXPECT_LT(order.column("polar_deg")[0], 4);
}

// The directions turn with the scene: y up is z up with the axes renamed.
TEST_F(SpaceCommand, AnotherVerticalIsTheSameSceneTurned) {
  const Vector3 size{0.1, 0.1, 0.1};
  put(folder_ / "y.dump",
      rodpack::test::spatial_bodies(
          rodpack::test::with_y_up(rodpack::test::random_places(size, 3000, 5)),
          rodpack::test::with_y_up(rodpack::test::watson_axes(4, 3000, 6)), size));
  ASSERT_EQ(run("orientation b.dump --vertical z -o z").exit_code, 0);
  ASSERT_EQ(run("orientation y.dump --vertical y -o y").exit_code, 0);
  const auto z = read_table(folder_ / "z.csv"), y = read_table(folder_ / "y.csv");
  EXPECT_EQ(z.column("count"), y.column("count"));
  EXPECT_EQ(read_table(folder_ / "z_azimuth.csv").column("count"),
            read_table(folder_ / "y_azimuth.csv").column("count"));
}

TEST_F(SpaceCommand, OptionsOfTheOtherKindOfSceneAreRefused) {
  expect_refusal("orientation b.dump", 1, "a scene in space needs --vertical");
  expect_refusal("orientation b.dump --vertical z --walls 0 0.1 0", 2,
                 "--walls: expected in a scene in a plane alone");
  rodpack::test::SyntheticPacking planar;
  planar.fill();
  put(folder_ / "planar.dump", planar.bodies_frame(1));
  expect_refusal("orientation planar.dump --container 0 1 0 1 0 1", 2,
                 "--container: expected in a scene in space alone");
  expect_refusal("orientation planar.dump --cylinder 0 1 1", 2,
                 "--cylinder: expected in a scene in space alone");
  expect_refusal("orientation b.dump --vertical up", 2,
                 "--vertical: expected one of x, y, z, found 'up'");
  expect_refusal("orientation b.dump --vertical z --cylinder 0 0 0", 1,
                 "--cylinder: expected a positive radius, found 0");
}

TEST_F(SpaceCommand, RdfWritesItsTablesAndFigures) {
  const auto result =
      run("rdf b.dump --vertical z --r-max 6 --axial 6 --axial-bin 0.5 --margin 12");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr(" centres further than 12 d_p from walls and surface\n"));
  EXPECT_THAT(
      result.output,
      HasSubstr(" centres further than 11 d_p from walls and surface\nwritten: rdf.csv .png "
                ".svg, rdf_axial.csv .png .svg\n"));
  expect_files({"rdf.png", "rdf.svg", "rdf_axial.png", "rdf_axial.svg"});
  EXPECT_EQ(read_table(folder_ / "rdf.csv").rows(), 60U);
  const auto axial = read_table(folder_ / "rdf_axial.csv");
  EXPECT_EQ(axial.column("along_over_dp")[0], 0.25);
  double pairs = 0;
  for (const double each : axial.column("pairs")) pairs += each;
  EXPECT_GT(pairs, 1000);
}

TEST_F(SpaceCommand, RdfRefusesWhatItCannotMeasure) {
  expect_refusal("rdf b.dump", 1, "a scene in space needs --vertical");
  expect_refusal("rdf b.dump --vertical z --axial 1 --axial-bin 0.6", 2,
                 "--axial: expected at least 2 bins");
  expect_refusal("rdf b.dump --vertical z --axial 100 --axial-bin 0.01", 2,
                 "--axial-bin: expected at most 1000 bins up to --axial, found 10000");
  expect_refusal("rdf b.dump --vertical z --r-max 0.01", 2,
                 "--r-max: expected the width of a bin (--bin), 0.1 d_p, at least, found 0.01");
  expect_refusal("rdf b.dump --vertical z --axial 40", 1,
                 "fewer than 2 particles lie further than");
  rodpack::test::SyntheticPacking planar;
  planar.fill();
  put(folder_ / "planar.dump", planar.bodies_frame(1));
  expect_refusal("rdf planar.dump --axial 3", 2, "--axial: expected in a scene in space alone");
  EXPECT_FALSE(fs::exists(folder_ / "rdf.csv"));
}

// A pile of spheres of 2 mm, in m and SI units, as LIGGGHTS would write it.
class SpaceFields : public SpaceCommand {
 protected:
  void SetUp() override {
    const auto frame = [](const std::string& what, int rows, const std::string& columns) {
      return "ITEM: TIMESTEP\n7\nITEM: NUMBER OF " + what + "\n" + std::to_string(rows) +
             "\nITEM: BOX BOUNDS ff ff ff\n0 0.01\n0 0.01\n0 0.1\nITEM: " + what + " " + columns +
             "\n";
    };
    std::ostringstream bodies, contacts;
    for (int k = 0; k < 5; ++k) {
      const double z = 1e-3 + 2e-3 * k, below = k > 0 ? z - 2e-3 : 0;
      bodies << k + 1 << " 1 0.005 0.005 " << z << " 1 0 0 0 0.001 0.001 0 1e-5 0 0 0\n";
      contacts << k + 1 << ' ' << k << ' ' << (k == 0) << " 0.005 0.005 " << 2e-3 * k << " 0 0 "
               << 9.81e-5 * (5 - k) << " 0.005 0.005 " << z << " 0.005 0.005 " << below << '\n';
    }
    put(folder_ / "bodies.dump",
        frame("ATOMS", 5,
              "id nspheres x y z qw qx qy qz half_length radius curvature mass vx vy vz") +
            bodies.str());
    put(folder_ / "contacts.dump",
        frame("ENTRIES", 5, "body_i body_j wall x y z fx fy fz bix biy biz bjx bjy bjz") +
            contacts.str());
  }
};

TEST_F(SpaceFields, StressWritesTheGridSlicesAndRings) {
  const auto box = run("stress bodies.dump --vertical z --scale 0.001 -o s");
  ASSERT_EQ(box.exit_code, 0) << box.output;
  EXPECT_THAT(box.output, HasSubstr("grid 21 x 21 x "));
  EXPECT_THAT(box.output,
              HasSubstr("written: s.vti .csv, s_pressure.png .svg, s_pressure_across.png .svg\n"));
  expect_files({"s.vti", "s.csv", "s_pressure.png", "s_pressure.svg", "s_pressure_across.png"});
  const auto table = read_table(folder_ / "s.csv");
  // Five of 10 mg in a row: on their line the sum of their Gaussians.
  const auto &x = table.column("x_m"), &y = table.column("y_m"), &z = table.column("z_m");
  int on_line = 0;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (std::abs(x[i] - 0.005) > 1e-9 || std::abs(y[i] - 0.005) > 1e-9) continue;
    ++on_line;
    double density = 0;
    for (int k = 0; k < 5; ++k)
      density += 1e-5 * std::exp(-std::pow((z[i] - 1e-3 - 2e-3 * k) / 1e-3, 2) / 2) /
                 std::pow(2 * std::acos(-1.0) * 1e-6, 1.5);
    EXPECT_NEAR(table.column("mass_density_kg_m3")[i], density, 1e-5 * 1e-5 / 1.6e-8);
  }
  EXPECT_GT(on_line, 10);
  for (const std::string name : {"contact_stress_zz_N_m2", "boundary_force_density_z_N_m3",
                                 "kinetic_stress_xy_N_m2", "coordination_number"})
    EXPECT_EQ(table.column(name).size(), table.rows());

  const auto round = run(
      "stress bodies.dump --vertical z --cylinder 0.005 0.005 0.005 --scale 0.001 --slice z=0.004 "
      "--slice x=0.006 -o r");
  ASSERT_EQ(round.exit_code, 0) << round.output;
  expect_files(
      {"r_rings.csv", "r_pressure_rings.png", "r_pressure_z_0.004.png", "r_pressure_x_0.006.svg"});
  EXPECT_FALSE(fs::exists(folder_ / "r_pressure.png"));
  const auto rings = read_table(folder_ / "r_rings.csv");
  EXPECT_EQ(rings.column("r_over_dp")[0], 0);
  // The pile stands on the axis: all the stress there is upright.
  const auto upright = rings.column("contact_stress_vv_N_m2");
  const auto across = rings.column("contact_stress_rr_N_m2");
  EXPECT_GT(upright[0], 1);
  EXPECT_NEAR(across[0], 0, 1e-9 * upright[0]);
}

TEST_F(SpaceFields, OptionsOfTheOtherKindOfSceneAreRefused) {
  expect_refusal("stress bodies.dump --vertical z --window 0 1 0 1", 2,
                 "--window: expected in a scene in a plane alone");
  expect_refusal("stress bodies.dump --vertical z --slice w=1", 2,
                 "--slice: expected an axis and a place, such as y=0.018, found 'w=1'");
  expect_refusal("stress bodies.dump --vertical z --slice x=1", 1,
                 "slice: expected x of 0 to 0.01 m, found 1");
  expect_refusal("stress bodies.dump --vertical z --kernel lucy --normalise walls", 1,
                 "--normalise: expected the kernel gaussian in space, found lucy");
  fs::remove(folder_ / "contacts.dump");
  expect_refusal("stress bodies.dump --vertical z", 1, "contacts.dump");
  EXPECT_FALSE(fs::exists(folder_ / "stress.csv"));
  rodpack::test::SyntheticPacking planar;
  planar.fill();
  put(folder_ / "planar.dump", planar.bodies_frame(1));
  expect_refusal("solid-fraction planar.dump --slice x=0.1", 2,
                 "--slice: expected in a scene in space alone");
}

// The particles of a run of the same size have the same numbers, but not the same places.
TEST_F(SpaceCommand, ContactsOfAnotherRunAreRefused) {
  put(folder_ / "c.dump",
      "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 0.1\n0 0.1\n"
      "0 0.1\nITEM: ENTRIES body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx "
      "bjy "
      "bjz overlap_n overlap_t nx ny nz\n"
      "1 2 1 2 0 0.05 0.05 0.05 0 0 1 0.05 0.05 0.051 0.05 0.05 0.049 1e-6 0 0 0 1\n");
  for (const std::string command :
       {"forces c.dump --bodies b.dump", "profile b.dump --contacts c.dump"})
    expect_refusal(command + " --vertical z", 1,
                   "its place in b.dump: expected contacts and bodies of one run");
}

}  // namespace

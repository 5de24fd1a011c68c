// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "liggghts_run.h"
#include "reading/table.h"

namespace {

using namespace rodpack::test;

// compare.csv: builtin, rodpack, builtin_sampled, exact of each quantity; NaN where empty.
std::map<std::string, std::vector<double>> read_comparison(const std::filesystem::path& file) {
  const auto table = rodpack::read_table(file.string());
  const auto& quantity = table.words("quantity");
  std::map<std::string, std::vector<double>> rows;
  for (const char* column : {"builtin", "rodpack", "builtin_sampled", "exact"})
    for (std::size_t i = 0; i < table.rows(); ++i)
      rows[quantity[i]].push_back(number_or_nan(table, i, column));
  return rows;
}

// Three lines of rods, until some of them have hit each other.
TEST(Comparison, OneStartStateSameBodiesAndOnlyTheStockTemplateLeavesThePlane) {
  const auto run = run_command("'" RODPACK_BIN
                               "/rodpack' compare out --particles 21 --time 0.06 --limit 1e-5 "
                               "--timed-steps 20 --inputs '" RODPACK_REPOSITORY "/inputs'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto out = run.folder / "out";
  auto rows = read_comparison(out / "compare.csv");
  enum { builtin, rodpack, sampled, exact };

  // Nine spheres of radius r, r apart: neighbours share a lens of 5/12 pi r^3, others only touch,
  // V = (9 4/3 - 8 5/12) pi r^3 = 26/3 pi r^3.
  const double mass = 2500 * 26 / 3. * std::acos(-1.) * std::pow(1.5e-3, 3);
  for (int who : {builtin, rodpack, exact}) EXPECT_NEAR(rows["mass"][who] / mass, 1, 1e-9);
  EXPECT_NEAR(rows["mass"][sampled] / mass, 1, 0.02);
  EXPECT_GT(std::abs(rows["mass"][sampled] / mass - 1), 1e-6);
  for (const char* name : {"inertia_along_the_rod", "inertia_across_1", "inertia_across_2"}) {
    for (int who : {builtin, rodpack})
      EXPECT_NEAR(rows[name][who] / rows[name][exact], 1, 1e-9) << name;
    EXPECT_NEAR(rows[name][sampled] / rows[name][exact], 1, 0.05) << name;
    EXPECT_GT(std::abs(rows[name][sampled] / rows[name][exact] - 1), 1e-6) << name;
  }

  for (const char* name : {"largest_z_from_start", "largest_v_z", "largest_omega_x",
                           "largest_omega_y", "largest_tilt_out_of_the_plane"})
    EXPECT_EQ(rows[name][rodpack], 0.) << name;
  EXPECT_GT(rows["largest_omega_z_for_scale"][rodpack], 1.);  // they hit and turn
  EXPECT_GT(rows["largest_omega_x"][sampled], 0.);            // masks alone do not hold the plane
  EXPECT_GT(rows["largest_tilt_out_of_the_plane"][sampled], 0.);

  // One start state for all, though the stock template needs a restart file of its own.
  const auto exact_start = read_dump(out / "runs" / "rodpack" / "bodies.dump", 0);
  const auto builtin_start = read_dump(out / "runs" / "builtin" / "bodies.dump", 0);
  const auto sampled_start = read_dump(out / "runs" / "builtin_sampled" / "bodies.dump", 0);
  for (const char* name : {"x", "y", "z", "angle", "vx", "vy", "omegaz"}) {
    EXPECT_EQ(builtin_start.column(name), exact_start.column(name)) << name;
    // the sampled axes of inertia lie off the rod by up to 0.01 rad
    const double tolerance = std::string(name) == "angle" ? 0.01 : 1e-12;
    for (std::size_t i = 0; i < exact_start.rows(); ++i)
      EXPECT_NEAR(sampled_start.column(name)[i], exact_start.column(name)[i], tolerance) << name;
  }

  const auto energies = read_table(out / "energies.csv");
  for (const char* name : {"_kinetic_translational_J", "_kinetic_rotational_J", "_elastic_normal_J",
                           "_elastic_tangential_J", "_gravitational_J", "_sphere_contacts"})
    EXPECT_EQ(energies.column("builtin" + std::string(name))[0],
              energies.column("rodpack" + std::string(name))[0])
        << name;
  EXPECT_GT(energies.column("rodpack_kinetic_translational_J")[0], 0.);

  const auto separation = read_table(out / "separation.csv");
  EXPECT_EQ(separation.column("builtin_largest_m")[0], 0.);
  EXPECT_EQ(separation.column("builtin_sampled_largest_m")[0], 0.);
  const double parting = rows["parting_time_from_rodpack"][builtin];
  EXPECT_GT(parting, 0.);
  EXPECT_LT(parting, 0.06);
  // the trajectories end with the frame in which they have parted
  EXPECT_NEAR(read_table(out / "trajectories.csv").column("time_s").back(), parting, 1e-9);
  EXPECT_EQ(read_table(out / "times.csv").rows(), 5u);
  for (const char* name : {"separation.png", "separation.svg", "energies.png", "energies.svg"})
    EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
}

// A bed that falls freely for both methods: no force but gravity, for which either is exact.
TEST(Comparison, FreeFallDoesNotPartTheTrajectories) {
  const auto run = run_command("'" RODPACK_BIN
                               "/rodpack' compare out --particles 2 --time 0.02 --limit 1e-9 "
                               "--timed-steps 20 --inputs '" RODPACK_REPOSITORY "/inputs'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  auto rows = read_comparison(run.folder / "out" / "compare.csv");
  EXPECT_LT(rows["largest_distance_from_rodpack_at_the_end"][0], 3e-12);  // 1e-9 d_p
  EXPECT_EQ(read_table(run.folder / "out" / "trajectories.csv").column("time_s").back(), 0.0209);
}

}  // namespace

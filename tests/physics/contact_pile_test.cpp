// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;
using Vars = std::map<std::string, std::string>;

namespace {

constexpr double gravity = 9.81;
const double mass = 2500 * M_PI / 6 * std::pow(3e-3, 3);  // of a sphere, kg
const char* const pile = "verification/pile/in.pile";

std::size_t row_of(const Table& table, const char* column, double value) {
  const auto& values = table.column(column);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (values[row] == value) return row;
  ADD_FAILURE() << "no " << column << " " << value;
  return 0;
}

/// Net contact force on each sphere: from dump contact/gran, from dump multisphere/sphere, and from
/// the integrator's own net force less the weight. All three are the same to round-off.
void expect_forces_agree(const std::filesystem::path& folder, int frame) {
  const Table contacts = read_dump(folder / "contacts.dump", frame);
  const Table spheres = read_dump(folder / "spheres.dump", frame);
  const Table atoms = read_dump(folder / "atoms.dump", frame);
  ASSERT_EQ(spheres.rows(), 15u);
  ASSERT_GT(contacts.rows(), 4u);
  double scale = 0;
  for (const double sum : spheres.column("fsum")) scale = std::max(scale, sum);

  const std::size_t n = spheres.rows();
  std::vector<double> fx(n), fy(n), fsum(n), floor(n);
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    const double x = contacts.column("fx")[c], y = contacts.column("fy")[c];
    const bool wall = contacts.column("wall")[c] == 1;
    const auto add = [&](const char* side, double sign) {
      const std::size_t row = row_of(spheres, "id", contacts.column(side)[c]);
      fx[row] += sign * x;
      fy[row] += sign * y;
      fsum[row] += std::hypot(x, y);
      if (wall && contacts.column("y")[c] < 1e-4) floor[row] += y;
    };
    add("sphere_i", 1);
    if (!wall) add("sphere_j", -1);
    if (wall) {
      EXPECT_EQ(contacts.column("sphere_j")[c], 0);
      EXPECT_EQ(contacts.column("body_j")[c], 0);
      EXPECT_EQ(contacts.column("bjx")[c], contacts.column("x")[c]);
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    const std::size_t atom = row_of(atoms, "id", spheres.column("id")[row]);
    EXPECT_NEAR(spheres.column("fx")[row], fx[row], 1e-13 * scale);
    EXPECT_NEAR(spheres.column("fy")[row], fy[row], 1e-13 * scale);
    EXPECT_NEAR(spheres.column("fsum")[row], fsum[row], 1e-13 * scale);
    EXPECT_NEAR(atoms.column("fx")[atom], fx[row], 1e-12 * scale);
    EXPECT_NEAR(atoms.column("fy")[atom] + mass * gravity, fy[row], 1e-12 * scale);
    // Listing the contacts leaves the wall force alone that 'store_force yes' keeps.
    EXPECT_NEAR(atoms.column("f_force_floor[2]")[atom], floor[row], 1e-12 * scale);
  }
}

void expect_same_spheres(const Table& a, const Table& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.timestep(), b.timestep());
  for (const char* column : {"x", "y", "vx", "vy", "omegaz"})
    for (std::size_t row = 0; row < a.rows(); ++row)
      EXPECT_NEAR(a.column(column)[row], b.column(column)[row], tolerance) << column << row;
}

}  // namespace

// Under Adams-Bashforth the forces of a step belong to the positions and velocities of its end, so
// a second evaluation gives the same ones, dashpots and sliding contacts included.
TEST(Pile, ContactForcesAddUpToThoseOnTheSpheres) {
  const auto run =
      run_liggghts(pile, {{"order", "3"}, {"ratio", "0"}, {"steps", "8000"}, {"every", "500"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  for (const int frame : {8, 10, 12, 14, 16}) expect_forces_agree(run.folder, frame);
}

TEST(Pile, ContactForcesAddUpOnTwoRanks) {
  const auto run =
      run_liggghts(pile, {{"order", "3"}, {"ratio", "0"}, {"steps", "8000"}, {"every", "500"}}, 2);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  for (const int frame : {8, 10, 12, 14, 16}) expect_forces_agree(run.folder, frame);
}

// Sums in another order differ in the last bits, and a pile of colliding spheres magnifies that.
TEST(Pile, OneAndTwoRanksAgree) {
  for (const char* order : {"0", "3"}) {
    const Vars vars = {{"order", order}, {"ratio", "0"}, {"steps", "3000"}, {"every", "1000"}};
    const auto one = run_liggghts(pile, vars, 1);
    const auto two = run_liggghts(pile, vars, 2);
    ASSERT_EQ(one.exit_code, 0) << one.output;
    ASSERT_EQ(two.exit_code, 0) << two.output;
    expect_same_spheres(read_dump(one.folder / "atoms.dump"), read_dump(two.folder / "atoms.dump"),
                        1e-9);
    EXPECT_EQ(read_dump(one.folder / "contacts.dump").rows(),
              read_dump(two.folder / "contacts.dump").rows());
  }
}

// The springs, the velocities of the multistep formula and the sliding state of every contact are
// in the restart file. (Velocity Verlet cannot be continued exactly: LIGGGHTS starts it with forces
// at the velocity of a full step.)
TEST(Pile, RestartContinuesTheRunOnOneAndTwoRanks) {
  const Vars vars = {{"order", "3"}, {"ratio", "0"}, {"every", "500"}};
  Vars whole = vars;
  whole["steps"] = "5000";
  whole["restart"] = "4000";
  const auto uninterrupted = run_liggghts(pile, whole);
  ASSERT_EQ(uninterrupted.exit_code, 0) << uninterrupted.output;
  const Table expected = read_dump(uninterrupted.folder / "atoms.dump");
  const Table expected_contacts = read_dump(uninterrupted.folder / "contacts.dump");
  ASSERT_GT(read_dump(uninterrupted.folder / "contacts.dump", 8).rows(), 5u);

  for (const int ranks : {1, 2}) {
    Vars rest = vars;
    rest["steps"] = "1000";
    rest["from"] = "4000";
    rest["folder"] = uninterrupted.folder.string();
    const auto resumed = run_liggghts(pile, rest, ranks);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    expect_same_spheres(expected, read_dump(resumed.folder / "atoms.dump"), 1e-10);
    const Table contacts = read_dump(resumed.folder / "contacts.dump");
    ASSERT_EQ(contacts.rows(), expected_contacts.rows());
    double springs = 0, expected_springs = 0;
    for (std::size_t c = 0; c < contacts.rows(); ++c) {
      springs += contacts.column("overlap_t")[c];
      expected_springs += expected_contacts.column("overlap_t")[c];
    }
    EXPECT_NEAR(springs, expected_springs, 1e-13);
    EXPECT_GT(springs, 1e-8);
  }
}

// The run ends at the first check at which E_k <= ratio E_p, the script goes on, thermodynamic
// output is there for the last step, and the pile stands: its weight is on the floor and in the
// friction of the side walls. Vertical acceleration of what still moves: v omega with v^2 <= 2
// ratio E_p / m.
TEST(Pile, HaltEndsTheRunAtRestAndTheWallsCarryTheWeightOnAnyRanks) {
  for (const int ranks : {1, 2}) {
    const auto run =
        run_liggghts(pile, {{"order", "0"}, {"ratio", "1e-6"}, {"steps", "200000"}}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_NE(run.output.find("halted 1 at step"), std::string::npos) << run.output;
    const Table contacts = read_dump(run.folder / "final.dump");
    EXPECT_LT(contacts.timestep(), 200000);
    EXPECT_EQ(contacts.timestep() % 100, 0);
    EXPECT_NE(
        run.output.find("\n" + std::string(8 - std::to_string(contacts.timestep()).size(), ' ') +
                        std::to_string(contacts.timestep()) + " "),
        std::string::npos)
        << "no thermo output of the last step";
    double carried = 0;
    for (std::size_t c = 0; c < contacts.rows(); ++c)
      if (contacts.column("wall")[c] == 1) carried += contacts.column("fy")[c];
    EXPECT_NEAR(carried / (15 * mass * gravity), 1, 0.01);
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
// What lists contacts, with LIGGGHTS's own contact models.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "liggghts_run.h"
#include "stock_models.h"

using namespace rodpack::test;

namespace {

/// Net force and sum of the magnitudes on each sphere, by atom id.
std::map<int, std::array<double, 4>> forces_of(const Table& contacts) {
  std::map<int, std::array<double, 4>> sums;
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    const double f[] = {contacts.column("fx")[c], contacts.column("fy")[c],
                        contacts.column("fz")[c]};
    const auto add = [&](const char* side, double sign) {
      auto& sum = sums[static_cast<int>(contacts.column(side)[c])];
      for (int d = 0; d < 3; ++d) sum[d] += sign * f[d];
      sum[3] += std::hypot(f[0], f[1], f[2]);
    };
    add("sphere_i", 1);
    if (contacts.column("wall")[c] == 0) add("sphere_j", -1);
  }
  return sums;
}

/// The forces of the dumps are those that have moved the spheres, less `weight` along -y. Returns
/// how many contacts there are, and adds up how many of them bridge a gap.
std::size_t expect_forces_of_the_step(const std::filesystem::path& folder, int frame, double weight,
                                      int* bridges = nullptr) {
  const Table atoms = read_dump(folder / "atoms.dump", frame);
  const Table spheres = read_dump(folder / "spheres.dump", frame);
  const Table contacts = read_dump(folder / "contacts.dump", frame);
  auto sums = forces_of(contacts);
  double scale = weight;
  for (const double sum : spheres.column("fsum")) scale = std::max(scale, sum);
  EXPECT_EQ(atoms.rows(), spheres.rows());
  for (std::size_t row = 0; row < atoms.rows(); ++row) {
    EXPECT_EQ(atoms.column("id")[row], spheres.column("id")[row]);
    const auto& sum = sums[static_cast<int>(atoms.column("id")[row])];
    const char* const names[] = {"fx", "fy", "fz"};
    for (int d = 0; d < 3; ++d) {
      const double moved_by = atoms.column(names[d])[row] + (d == 1 ? weight : 0.0);
      EXPECT_NEAR(sum[d], moved_by, 1e-12 * scale) << names[d] << " of " << row << " at " << frame;
      EXPECT_NEAR(spheres.column(names[d])[row], moved_by, 1e-12 * scale);
    }
    EXPECT_NEAR(spheres.column("fsum")[row], sum[3], 1e-12 * scale);
  }
  for (const double overlap : contacts.column("overlap_n"))
    if (bridges && overlap < 0) ++*bridges;
  return contacts.rows();
}

}  // namespace

// R* = R/2 for two equal spheres, R at a plane; E* = E / 2(1 - nu^2):
// F = 4/3 E* sqrt(R* delta) delta. Sphere 2 is 10 um deep in 1, and 20 um in the floor.
TEST(StockModels, HertzPushesWithTheForceOfHertz) {
  const auto folder = fresh_folder();
  for (const bool mesh : {false, true}) {
    const auto run =
        run_liggghts(pressed_spheres("model hertz tangential history", mesh ? &folder : nullptr) +
                     "run 0\nwrite_dump all contact/gran c.dump\n"
                     "write_dump all multisphere/sphere s.dump\n");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table contacts = read_dump(run.folder / "c.dump");
    ASSERT_EQ(contacts.rows(), 2u);
    double up = 0;
    for (std::size_t c = 0; c < 2; ++c) {
      const auto at = [&](const char* name) { return contacts.column(name)[c]; };
      const bool wall = at("wall") == 1;
      const double delta = wall ? 20e-6 : 10e-6;
      const double force = hertz_force(delta, wall ? sphere_radius : 0.5 * sphere_radius);
      EXPECT_NEAR(at("overlap_n"), delta, 1e-16);
      EXPECT_EQ(at("overlap_t"), 0);
      EXPECT_NEAR(at("fx") * at("nx") + at("fy") * at("ny"), force, 1e-9 * force);
      EXPECT_NEAR(std::hypot(at("fx"), at("fy"), at("fz")), force, 1e-9 * force);
      EXPECT_NEAR(at("y"), wall ? -10e-6 : 2 * sphere_radius - 25e-6, 1e-12) << wall;
      if (wall) up = at("fy");
    }
    EXPECT_NEAR(up, hertz_force(20e-6, sphere_radius), 1e-9 * up);
    const Table spheres = read_dump(run.folder / "s.dump");
    const double down = hertz_force(10e-6, 0.5 * sphere_radius);
    EXPECT_NEAR(spheres.column("fy")[1], up - down, 1e-9 * up);
    EXPECT_NEAR(spheres.column("fsum")[1], up + down, 1e-9 * up);
  }
}

// model hooke: k = 16/15 sqrt(R*) E* (15 m* V^2 / 16 sqrt(R*) E*)^(1/5) at the speed V; sjkr pulls
// with the cohesion energy density times the circle in which the spheres cut each other, of radius
// sqrt(R^2 - d^2/4) at a distance d of the centres.
TEST(StockModels, LinearSpringsAndCohesionAddUp) {
  const auto run = run_liggghts(pressed_spheres("model hooke tangential history cohesion sjkr") +
                                "run 0\nwrite_dump all contact/gran c.dump\n");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table contacts = read_dump(run.folder / "c.dump");
  ASSERT_EQ(contacts.rows(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    const bool wall = contacts.column("wall")[c] == 1;
    const double delta = wall ? 20e-6 : 10e-6;
    const double reduced = (wall ? 1 : 0.5) * sphere_radius, mass = (wall ? 1 : 0.5) * sphere_mass;
    const double stiffness = 16.0 / 15 * std::sqrt(reduced) * reduced_modulus *
                             std::pow(15 * mass * hooke_speed * hooke_speed /
                                          (16 * std::sqrt(reduced) * reduced_modulus),
                                      0.2);
    const double distance = wall ? sphere_radius - delta : sphere_radius - delta / 2;
    const double area = M_PI * (sphere_radius * sphere_radius - distance * distance);
    const double force = stiffness * delta - cohesion_density * area;
    EXPECT_NEAR(contacts.column("fx")[c] * contacts.column("nx")[c] +
                    contacts.column("fy")[c] * contacts.column("ny")[c],
                force, 1e-9 * stiffness * delta);
  }
}

// Forces are those of the step, whatever the model remembers and however late the velocities are:
// they are the ones that stock LIGGGHTS has added up. Evaluated once more, tangential history would
// add its dashpot to some of the contacts that slide.
TEST(StockModels, DumpsHaveTheForcesOfTheStepOnOneAndTwoRanks) {
  for (const std::string& models : stock_models()) {
    SCOPED_TRACE(models);
    for (const int ranks : {1, 2}) {
      const auto run = run_liggghts(shaken_spheres(models, listed_every(200)), {}, ranks);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      std::size_t contacts = 0;
      int bridges = 0;
      for (int frame = 1; frame <= 10; ++frame)
        contacts += expect_forces_of_the_step(run.folder, frame, sphere_mass * gravity, &bridges);
      EXPECT_EQ(bridges > 0, models == bridging_model) << bridges;
      EXPECT_GT(contacts, 20u);
    }
  }
}

// Gravity pulls at bodies as wholes: the forces on their spheres are those of contacts alone.
TEST(StockModels, DumpsHaveTheForcesOfTheStepOnBodiesOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    const auto run = run_liggghts(
        falling_rods("model hertz tangential history cohesion sjkr rolling_friction epsd",
                     listed_every(1000)),
        {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table contacts = read_dump(run.folder / "contacts.dump");
    EXPECT_GT(contacts.column("body_i")[0], 0);
    for (const int frame : {6, 8, 10})
      EXPECT_GT(expect_forces_of_the_step(run.folder, frame, 0), 4u);
  }
}

// Listing contacts changes nothing: positions, velocities and spins after the run are the same bits
// with and without, and so they are after a restart.
TEST(StockModels, WhoListsLeavesTheRunAsItIs) {
  for (const std::string& models : stock_models()) {
    SCOPED_TRACE(models);
    const std::string end = "restart 1000 r.*\n";
    const auto silent = run_liggghts(shaken_spheres(models, end));
    const auto listed = run_liggghts(shaken_spheres(models, end + listed_every(7)));
    ASSERT_EQ(silent.exit_code, 0) << silent.output;
    ASSERT_EQ(listed.exit_code, 0) << listed.output;
    const std::string expected = text_of(silent.folder / "end.dump");
    ASSERT_GT(expected.size(), 1000u);
    EXPECT_EQ(text_of(listed.folder / "end.dump"), expected);

    std::string ends[2];
    for (const bool with : {false, true}) {
      const auto rest =
          run_liggghts_in(with ? listed.folder : silent.folder,
                          shaken_spheres(models, with ? listed_every(7) : "", "r.1000", "rest"));
      ASSERT_EQ(rest.exit_code, 0) << rest.output;
      ends[with] = text_of(rest.folder / "rest.dump");
    }
    ASSERT_GT(ends[0].size(), 1000u);
    EXPECT_EQ(ends[1], ends[0]);
  }
}

// Nase et al. as easo/capillary/viscous has it: a bridge of viscosity mu damps by 6 pi mu R* v
// along the normal, over the gap in units of R* or the least separation, here 1.01, and by 6 pi mu
// R* (8/15 ln(1/1.01) + 0.9588) v along the wall; R* = R/2 at a wall.
TEST(StockModels, LiquidBridgesAtWallsFeelTheVelocityOfTheSphere) {
  const auto folder = fresh_folder();
  for (const bool mesh : {false, true}) {
    const auto force_at = [](const std::string& velocity, const std::string& file) {
      return "velocity all set " + velocity + " 0 units box\nrun 0\nwrite_dump all custom " + file +
             " fx fy modify format \"%.17g %.17g\"\n";
    };
    // In contact first, then on its way up, some 30 um above the floor.
    const auto run = run_liggghts(
        column_of(bridging_model, "create_atoms 1 single 0.011 0.00148 0 units box\n",
                  mesh ? &folder : nullptr) +
        "velocity all set 0 0.1 0 units box\nrun 60\nwrite_dump all custom y.dump y\n" +
        force_at("0.02 0.1", "a.dump") + force_at("0 0.3", "b.dump"));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    ASSERT_GT(read_dump(run.folder / "y.dump").column("y")[0], sphere_radius);
    const Table a = read_dump(run.folder / "a.dump"), b = read_dump(run.folder / "b.dump");
    const double stokes = 6 * M_PI * 1e-3 * sphere_radius / 2;
    EXPECT_NEAR(b.column("fy")[0] - a.column("fy")[0], -stokes * 0.2 / 1.01, 1e-9 * stokes);
    const double along = 8.0 / 15 * std::log(1 / 1.01) + 0.9588;
    EXPECT_NEAR(a.column("fx")[0] - b.column("fx")[0], -stokes * along * 0.02, 1e-7 * stokes);
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
// fix check/timestep/multisphere with LIGGGHTS's own contact models.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"
#include "stock_models.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

constexpr double linear_stiffness = 1000, tangential_stiffness = 500;  // of */stiffness, N/m
const double inertia = 0.4 * sphere_mass * sphere_radius * sphere_radius;

/// The deck with another value for all pairs of atom types.
std::string with_property(std::string deck, const std::string& name, const std::string& value) {
  const std::string before = name + " peratomtypepair 1 ";
  const auto at = deck.find(before);
  EXPECT_NE(at, std::string::npos) << name;
  const auto begin = at + before.size();
  return deck.replace(begin, deck.find('\n', begin) - begin, value);
}

/// One sphere above a floor, its centre at this height.
std::string sphere_at(const std::string& models, double y) {
  return column_of(models, "create_atoms 1 single 0.01 " + exact(y) + " 0 units box\n");
}

/// Prints a property of the only atom into v.txt.
std::string printed_every_step(const std::string& property) {
  return "compute p all property/atom " + property +
         "\ncompute sum all reduce sum c_p\nvariable v equal c_sum\n"
         "fix print all print 1 \"${v}\" file v.txt title v screen no\n";
}

/// f_s and f_s[2] at the beginning of a run.
std::vector<double> checked(const std::string& deck, int ranks = 1) {
  const auto run = run_liggghts(deck +
                                    "fix s all check/timestep/multisphere 1\n"
                                    "thermo_style custom step f_s f_s[2]\n"
                                    "thermo_modify format float %.15g\nrun 0\n",
                                {}, ranks);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const Table thermo = read_thermo(run.output);
  return {thermo.column("s")[0], thermo.column("s[2]")[0]};
}

/// omega dt up to which velocity Verlet is stable, as the page of the fix has it.
double verlet_limit(double eta) { return 2 * (std::sqrt(1 + eta * eta) - eta); }

}  // namespace

// Against a small change of the overlap a Hertz contact has the stiffness 3/2 F / delta = 2 E*
// sqrt(R* delta), and stock's dashpot the damping ratio sqrt(5/6) beta at any overlap, with beta =
// -ln e / sqrt(ln^2 e + pi^2).
TEST(StockModelsTimestep, HertzIsLinearisedAtTheContactsThatAreThere) {
  const double dt = 1e-5, restitution = 0.5, log = std::log(restitution);
  const double eta = std::sqrt(5.0 / 6) * -log / std::sqrt(log * log + M_PI * M_PI);
  for (const bool wall : {false, true}) {
    for (const double overlap : {1e-6, 2e-5}) {
      const std::string models = "model hertz tangential history";
      const std::string two =
          "create_atoms 1 single 0.01 0.02 0 units box\n"
          "create_atoms 1 single 0.01 " +
          exact(0.02 + 2 * sphere_radius - overlap) + " 0 units box\n";
      const auto found = checked(
          with_property(wall ? sphere_at(models, sphere_radius - overlap) : column_of(models, two),
                        "coefficientFriction", "0"));
      const double reduced = (wall ? 1 : 0.5) * sphere_radius;
      const double mass = (wall ? 1 : 0.5) * sphere_mass;
      const double omega = std::sqrt(2 * reduced_modulus * std::sqrt(reduced * overlap) / mass);
      EXPECT_NEAR(found[0] / (dt * omega / verlet_limit(eta)), 1, 1e-6) << wall << overlap;
      EXPECT_NEAR(found[1] / (M_PI / (omega * std::sqrt(1 - eta * eta)) / dt), 1, 1e-6);
    }
  }
}

// Without contacts nothing is known of a Hertz stiffness: no limit, no collision.
TEST(StockModelsTimestep, WithoutContactsThereIsNoLimit) {
  EXPECT_EQ(checked(sphere_at("model hertz tangential history", 0.02)),
            (std::vector<double>{0, 0}));
}

// 2 % below and above the limit: an undamped sphere on a Hertz floor,
// nudged, keeps the amplitude that velocity Verlet gives it near its limit (5 to 7 times the
// nudge), or leaves its place.
TEST(StockModelsTimestep, BeyondTheLimitARestingSphereLeavesItsPlace) {
  const double load = sphere_mass * gravity;
  const double overlap =
      std::pow(3 * load / (4 * reduced_modulus * std::sqrt(sphere_radius)), 2.0 / 3);
  const double omega =
      std::sqrt(2 * reduced_modulus * std::sqrt(sphere_radius * overlap) / sphere_mass);
  const double nudge = 1e-4 * overlap;
  for (const double fraction : {0.98, 1.02}) {
    const std::string deck = with_property(
        with_property(sphere_at("model hertz tangential history", sphere_radius - overlap + nudge),
                      "coefficientRestitution", "1"),
        "coefficientFriction", "0");
    const auto run = run_liggghts(
        deck + "timestep " + exact(fraction * 2 / omega) +
        "\nfix s all check/timestep/multisphere 1 error no\n"
        "thermo_style custom step f_s\nthermo_modify format float %.15g lost ignore\n" +
        printed_every_step("y") + "run 2000\n");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_NEAR(read_thermo(run.output).column("s")[0], fraction, 1e-3);
    const Table table = read_table(run.folder / "v.txt");
    double furthest = 0;
    for (const double height : table.column("v"))
      furthest = std::max(furthest, std::fabs(height - (sphere_radius - overlap)));
    if (fraction < 1)
      EXPECT_LT(furthest, 10 * nudge);
    else
      EXPECT_GT(furthest, 100 * nudge);
  }
}

// A sphere on a floor: with the arm a from its centre to the contact, sliding and turning obey
// (m, I) x'' = -[[k_t, k_t a], [k_t a, k_t a^2 + k_r]] x, with k_r = 9/4 k_n (mu_r R)^2 of epsd and
// k_t R^2 of epsd2.
TEST(StockModelsTimestep, RollingFrictionHasASpring) {
  const double mu = 0.4, dt = 1e-5, overlap = 1e-5;
  for (const bool epsd : {true, false}) {
    std::string deck = sphere_at(std::string("model hooke/stiffness tangential history ") +
                                     (epsd ? "rolling_friction epsd" : "rolling_friction epsd2"),
                                 sphere_radius - overlap);
    deck = with_property(deck, "coefficientRollingFriction", "0.4");
    deck = with_property(deck, "coefficientRollingViscousDamping", "0");
    deck = with_property(with_property(deck, "gamman", "0"), "gammat", "0");
    const double arm = sphere_radius - 0.5 * overlap, r2 = sphere_radius * sphere_radius;
    const double kr = epsd ? 2.25 * linear_stiffness * mu * mu * r2 : tangential_stiffness * r2;
    const double a = tangential_stiffness / sphere_mass;
    const double d = (tangential_stiffness * arm * arm + kr) / inertia;
    const double b2 = std::pow(tangential_stiffness * arm, 2) / (sphere_mass * inertia);
    const double squared = 0.5 * (a + d) + std::sqrt(0.25 * (a - d) * (a - d) + b2);
    EXPECT_NEAR(checked(deck)[0] / (0.5 * dt * std::sqrt(squared)), 1, 1e-6) << epsd;
  }
}

// A sphere that is turned on the spot by a little swings about its rolling spring, at the frequency
// that the check has found: mu = 0, so that nothing else holds it, and mu_r = 0.5, for which this
// is its highest one. The period is counted over 20 zeros of the spin.
TEST(StockModelsTimestep, RollingFrictionSwingsAtTheFrequencyThatIsChecked) {
  const double dt = 1e-6, overlap = sphere_mass * gravity / linear_stiffness;
  std::string deck = sphere_at("model hooke/stiffness tangential history rolling_friction epsd",
                               sphere_radius - overlap);
  deck = with_property(deck, "coefficientRollingFriction", "0.5");
  deck = with_property(deck, "coefficientRollingViscousDamping", "0");
  deck = with_property(with_property(deck, "coefficientFriction", "0"), "gamman", "0");
  const auto run = run_liggghts(deck + "timestep 1e-6\nset atom 1 omegaz 0.1\n" +
                                "fix s all check/timestep/multisphere 1\n"
                                "thermo_style custom step f_s\nthermo_modify format float "
                                "%.15g\n" +
                                printed_every_step("omegaz") + "run 12000\n");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const double omega = 2 * read_thermo(run.output).column("s")[0] / dt;
  EXPECT_NEAR(omega * omega, 2.25 * linear_stiffness * 0.25 / 0.4 / sphere_mass,
              1e-6 * omega * omega);
  std::vector<double> zeros;
  double last = 0;
  const Table table = read_table(run.folder / "v.txt");
  for (std::size_t step = 0; zeros.size() < 21 && step < table.rows(); ++step) {
    const double spin = table.column("v")[step];
    if (last * spin < 0) zeros.push_back((static_cast<double>(step) - spin / (spin - last)) * dt);
    last = spin;
  }
  ASSERT_EQ(zeros.size(), 21u);
  EXPECT_NEAR(20 * M_PI / (zeros.back() - zeros.front()) / omega, 1, 1e-4);
}

// The column of Hertz spheres under its weight, on one and two ranks; and where it was meant for.
TEST(StockModelsTimestep, OneAndTwoRanksAgree) {
  std::string spheres;
  double y = 0;
  for (int k = 0; k < 6; ++k) {
    const double load = (6 - k) * sphere_mass * gravity;
    const double reduced = k == 0 ? sphere_radius : 0.5 * sphere_radius;
    y += (k == 0 ? 1 : 2) * sphere_radius -
         std::pow(3 * load / (4 * reduced_modulus * std::sqrt(reduced)), 2.0 / 3);
    spheres += "create_atoms 1 single 0.01 " + exact(y) + " 0 units box\n";
  }
  const std::string deck =
      column_of("model hertz tangential history cohesion sjkr rolling_friction epsd", spheres);
  const auto one = checked(deck), two = checked(deck, 2);
  EXPECT_GT(one[0], 0.01);
  EXPECT_NEAR(two[0], one[0], 1e-12);
  EXPECT_NEAR(two[1], one[1], 1e-9 * one[1]);
}

TEST(StockModelsTimestep, BodiesAreLookedAtWithTheirHertzContacts) {
  const auto run = run_liggghts(falling_rods("model hertz tangential history rolling_friction cdt",
                                             "fix s all check/timestep/multisphere "
                                             "100\nthermo_style custom step f_s f_s[2] "
                                             "f_s[3]\nthermo 1000\n"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table thermo = read_thermo(run.output);
  EXPECT_EQ(thermo.column("s")[2], 0);  // they still fall
  EXPECT_GT(thermo.column("s").back(), 0.001);
  EXPECT_LT(thermo.column("s").back(), 1);
  EXPECT_GT(thermo.column("s[3]").back(), 0);
}

TEST(StockModelsTimestep, WhatHasOtherForcesIsRefused) {
  const auto error_of = [](const std::string& models, const std::string& lines) {
    const auto run = run_liggghts(sphere_at(models, 0.0014) + lines + "run 0\n");
    EXPECT_NE(run.exit_code, 0);
    return run.output;
  };
  const std::string check = "fix s all check/timestep/multisphere 1\n";
  for (const char* models :
       {"model hooke tangential no_history", "model hooke/hysteresis tangential history"})
    EXPECT_THAT(error_of(models, check),
                HasSubstr("fix check/timestep/multisphere needs springs and dashpots, expected "
                          "'model' spring_dashpot, hooke, "));
  // It is asked before the wall is, when the run is set up.
  EXPECT_THAT(error_of("model hertz tangential history",
                       "unfix floor\n" + check +
                           "fix floor all wall/gran model hertz tangential history primitive type "
                           "1 yplane 0\n"),
              HasSubstr("the contacts of fix wall/gran floor are not known yet when the run is set "
                        "up: give what asks for them behind that fix"));
}

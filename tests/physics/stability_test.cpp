// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "liggghts_run.h"
#include "campaigns/stability/stability.h"
#include "rodpack/motion/stability_limit.h"

using namespace rodpack::test;
using rodpack::stability_limit;
using testing::HasSubstr;
using Vars = std::map<std::string, std::string>;

namespace {

const char* const deck = "accuracy/in.stability";
const double radius = 1.5e-3, kn = 1000, kt = 500;
const double mass = 2500 * 4 * M_PI / 3 * std::pow(radius, 3);  // of a sphere
// of a smooth rod of 9 spheres: each pair of neighbours shares a lens of 5/12 pi r^3
const double rod_mass = 2500 * M_PI * std::pow(radius, 3) * (12 - 40.0 / 12);

std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.15g", value);
  return buffer;
}

Run run_at(int order, double eta, double timestep, Vars more = {}, int ranks = 1) {
  more.insert({{"order", std::to_string(order)}, {"eta", text(eta)}, {"timestep", text(timestep)}});
  return run_liggghts(deck, more, ranks);
}

/// Largest excursion of a file, in units of the depth at rest.
double largest(const std::filesystem::path& file) {
  double result = 0;
  const Table table = read_table(file);
  for (const double out : table.column("out")) result = std::max(result, std::fabs(out));
  return result;
}

/// Value of the check at the start of a run.
double checked(const Run& run, const std::string& column) {
  return read_table(run.folder / "check.txt").column(column).at(0);
}

}  // namespace

// Adams-Bashforth of order 3 and the built-in velocity Verlet, from both sides of the limit. Below,
// for a million steps, the excursion (1e-3 at the start) stays; without damping velocity Verlet
// keeps it, within 1 / sqrt(1 - (omega dt / 2)^2).
TEST(Stability, JustBelowTheLimitAMillionStepsStayBounded) {
  for (const int order : {3, 0}) {
    for (const double eta : {0.0, 0.2}) {
      const double dt = 0.995 * stability_limit(order, eta) / std::sqrt(kn / mass);
      const auto run = run_at(order, eta, dt, {{"steps", "1000000"}, {"every", "7"}});
      ASSERT_EQ(run.exit_code, 0) << run.output;
      EXPECT_FALSE(std::filesystem::exists(run.folder / "grown.txt")) << order << ' ' << eta;
      const double late = largest(run.folder / "late.txt");
      if (order == 0 && eta == 0)
        EXPECT_LT(late, 0.011);
      else
        EXPECT_LT(late, 1e-9) << order << ' ' << eta;
    }
  }
}

TEST(Stability, JustAboveTheLimitItBlowsUp) {
  for (const int order : {3, 0}) {
    for (const double eta : {0.0, 0.2}) {
      const double dt = 1.005 * stability_limit(order, eta) / std::sqrt(kn / mass);
      const auto run = run_at(order, eta, dt);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      EXPECT_TRUE(std::filesystem::exists(run.folder / "grown.txt")) << order << ' ' << eta;
    }
  }
}

// A rod that lies flat has nine contacts: omega^2 = 9 k / m, and 3 eta for the damping ratio.
TEST(Stability, ARodThatLiesFlatHasNineContacts) {
  const double limit = stability_limit(3, 0.6) / std::sqrt(9 * kn / rod_mass);
  for (const double fraction : {0.99, 1.01}) {
    const auto run = run_at(3, 0.2, fraction * limit, {{"spheres", "9"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(std::filesystem::exists(run.folder / "grown.txt"), fraction > 1) << fraction;
  }
}

TEST(CheckTimestepMultisphere, PrintsTheFractionOfTheLimitForASphereAndARod) {
  const double dt = 1.1e-5, eta = 0.2;
  for (const int order : {0, 1, 2, 3, 4}) {
    const auto sphere = run_at(order, eta, dt, {{"steps", "10"}});
    ASSERT_EQ(sphere.exit_code, 0) << sphere.output;
    const double own = dt * std::sqrt(kn / mass) / stability_limit(order, eta);
    EXPECT_NEAR(checked(sphere, "fraction") / own, 1, 1e-9) << order;
    EXPECT_EQ(checked(sphere, "contacts"), 1);
    // Two of the lightest: half of the mass.
    const double collision = M_PI / std::sqrt(kn / (0.5 * mass) * (1 - eta * eta));
    EXPECT_NEAR(checked(sphere, "steps_per_collision") * dt / collision, 1, 1e-9);

    const auto rod = run_at(order, eta, dt, {{"steps", "10"}, {"spheres", "9"}});
    ASSERT_EQ(rod.exit_code, 0) << rod.output;
    EXPECT_EQ(checked(rod, "contacts"), 9);
    const double omega = std::sqrt(9 * kn / rod_mass);
    EXPECT_NEAR(checked(rod, "fraction") / (dt * omega / stability_limit(order, 3 * eta)), 1, 1e-9)
        << order;
  }
}

// With friction a sphere is held by 7/2 k_t against sliding, more than by k_n = 2 k_t; the arm of
// the contact is shorter by half of the overlap, 1e-4 / 2.
TEST(CheckTimestepMultisphere, CountsTheStiffnessOfFriction) {
  const double dt = 1.1e-5, eta = 0.2;
  const auto run = run_at(3, eta, dt, {{"steps", "10"}, {"mu", "0.3"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const double arm = radius - 0.5e-4, share = 1 + arm * arm / (0.4 * radius * radius);
  const double expected =
      dt * std::sqrt(share * kt / mass) / stability_limit(3, eta * std::sqrt(share));
  EXPECT_NEAR(checked(run, "fraction") / expected, 1, 1e-3);
  EXPECT_GT(expected, 1.2 * dt * std::sqrt(kn / mass) / stability_limit(3, eta));
}

// Out of the plane a rod could also roll about its axis, I = 2/5 m r^2, which nine springs of
// friction hold the stiffest, and overdamped; in the plane the nine normal ones do.
TEST(CheckTimestepMultisphere, LooksAtMotionsInThePlaneOnlyWhereThereAreNoOthers) {
  const double dt = 1.1e-5, eta = 0.2;
  const auto fraction = [&](const std::string& check) {
    const auto run = run_at(
        3, eta, dt,
        {{"steps", "10"}, {"spheres", "9"}, {"mu", "0.3"}, {"check", check}, {"planar", "no"}});
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return checked(run, "fraction");
  };
  const double in_plane = dt * std::sqrt(9 * kn / rod_mass) / stability_limit(3, 3 * eta);
  EXPECT_NEAR(fraction("10") / in_plane, 1, 0.01);
  EXPECT_NEAR(fraction("10 planar yes") / in_plane, 1, 0.01);
  const double arm = radius - 0.5e-4, share = 9 * (1 + arm * arm / (0.4 * radius * radius));
  const double rolling =
      dt * std::sqrt(share * kt / rod_mass) / stability_limit(3, eta * std::sqrt(share));
  EXPECT_GT(rolling, 1.5 * in_plane);
  EXPECT_NEAR(fraction("10 planar no") / rolling, 1, 0.01);
}

TEST(CheckTimestepMultisphere, EndsTheRunBeyondTheLimitAndNamesTheBody) {
  // The single contact is well below its limit, the nine are not.
  const double limit = stability_limit(3, 0.6) / std::sqrt(9 * kn / rod_mass);
  const Vars vars = {{"spheres", "9"}, {"check", "1000"}};
  const auto beyond = run_at(3, 0.2, 1.02 * limit, vars);
  EXPECT_NE(beyond.exit_code, 0);
  EXPECT_THAT(beyond.output,
              HasSubstr("ERROR: Fix check/timestep/multisphere (id check): time step "
                        "9.668e-05 s is 1.02 of the stability limit 9.479e-05 s of "
                        "Adams-Bashforth of order 3, set by body 1 with its 9 "
                        "contacts"));
  const auto below = run_at(3, 0.2, 0.98 * limit, vars);
  EXPECT_EQ(below.exit_code, 0) << below.output;
}

// Before the first particle is there, the template's mass is held by a single contact.
TEST(CheckTimestepMultisphere, EndsTheRunBeforeTheFirstParticle) {
  const double limit = stability_limit(0, 0.2) / std::sqrt(kn / mass);
  const auto run = run_at(0, 0.2, 1.01 * limit, {{"check", "1000"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output,
              HasSubstr("is 1.01 of the stability limit 0.0003082 s of velocity Verlet, "
                        "set by a single contact of the lightest particle"));
  EXPECT_FALSE(std::filesystem::exists(run.folder / "check.txt"));
}

TEST(CheckTimestepMultisphere, FirstOrderWithoutDampingIsUnstableAtAnyStep) {
  const auto run = run_at(1, 0, 1e-7, {{"check", "1000"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("time step 1e-07 s is unstable, as any is for Adams-Bashforth "
                                    "of order 1 with undamped contacts"));
}

TEST(CheckTimestepMultisphere, WarnsOnceARunAboveTheFraction) {
  const double limit = stability_limit(3, 0.2) / std::sqrt(kn / mass);
  const auto warnings = [&](const std::string& warn) {
    const auto run =
        run_at(3, 0.2, 0.7 * limit, {{"check", "100 warn " + warn}, {"steps", "4000"}});
    EXPECT_EQ(run.exit_code, 0) << run.output;
    int count = 0;
    const std::string what = "s is 0.7 of the stability limit";
    for (auto at = run.output.find(what); at != std::string::npos;
         at = run.output.find(what, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(warnings("0.8"), 0);
  EXPECT_EQ(warnings("0.6"), 6 * 2);  // runs of the deck; screen and log file
}

// A pile of rods on 1, 2 and 4 ranks: the network is the same.
TEST(CheckTimestepMultisphere, IsTheSameOnAnyRanks) {
  double fractions[3], contacts[3];
  int k = 0;
  for (const int ranks : {1, 2, 4}) {
    const auto run = run_liggghts("verification/pile/in.pile", {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table check = read_table(run.folder / "check.txt");
    fractions[k] = check.column("fraction").at(0);
    contacts[k++] = check.column("contacts").at(0);
  }
  for (int other : {1, 2}) {
    EXPECT_NEAR(fractions[other] / fractions[0], 1, 1e-9);
    EXPECT_EQ(contacts[other], contacts[0]);
  }
  EXPECT_GT(contacts[0], 2);
}

// The measurement of the accuracy report, for four of its points: theory within 1 %, as it says.
TEST(Stability, MeasuredLimitsAreThoseOfTheory) {
  rodpack::StabilityOptions options;
  options.liggghts.program = RODPACK_BIN "/liggghts";
  options.decks = RODPACK_REPOSITORY "/inputs";
  options.folder = fresh_folder().string();
  options.orders = {0, 3};
  options.damping_ratios = {0, 0.4};
  int announced = 0;
  const auto limits = rodpack::measure_stability(options, [&](const std::string&) { ++announced; });
  ASSERT_EQ(limits.size(), 4u);
  EXPECT_EQ(announced, 4);
  for (const auto& limit : limits)
    EXPECT_NEAR(limit.limit_measured / limit.limit_theory, 1, 5e-3)
        << limit.order << ' ' << limit.damping_ratio;
}

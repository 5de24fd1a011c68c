// SPDX-License-Identifier: GPL-2.0-or-later
// The advice on time steps: errors of a collision against closed forms of the theory page, limits
// and overlaps against closed forms, a bed's limit against that of one rod on the floor.
#include "timestep/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "campaigns/accuracy/accuracy.h"
#include "liggghts_run.h"
#include "reading/data_error.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/motion/stability_limit.h"
#include "synthetic_packing.h"
#include "timestep/run_network.h"

namespace {

using namespace rodpack;
using test::fresh_folder;
using test::put;
using testing::HasSubstr;

const double pi = std::acos(-1.0);

const Integrator& named(const std::string& name) {
  for (const Integrator& each : integrators())
    if (each.name == name) return each;
  throw std::runtime_error(name);
}

/// Between so many steps per collision and twice as many, both with the fraction of the charts.
double order(const std::string& name, double damping_ratio, int steps) {
  const Integrator& integrator = named(name);
  return std::log2(rebound_error(integrator, damping_ratio, steps + 0.37) /
                   rebound_error(integrator, damping_ratio, 2 * steps + 0.37));
}

TEST(HeadOnCollision, IntegratorsAreThoseOfTheAccuracyCampaign) {
  for (const Integrator& each : integrators())
    EXPECT_EQ(accuracy_method(each.relaxation_steps > 0 ? "leapfrog" : each.name).integrator,
              each.fix);
}

// theory.md, section 4: without its event the dashpot's jump at touch, 2 eta m omega v, acts as if
// it lay half a step before the evaluation that first sees it; over all moments of touch that is
// rms dt / sqrt(12) of it, and both velocity and error then shrink alike until the rebound.
TEST(HeadOnCollision, WithoutEventsTheErrorIsThatOfAJumpAtAnUnknownMoment) {
  for (const double eta : {0.1, 0.2, 0.3})
    EXPECT_NEAR(rebound_error(named("ab3"), eta, 500.37), 2 * eta * pi / 500.37 / std::sqrt(12.0),
                0.02 * eta * pi / 500)
        << eta;
}

TEST(HeadOnCollision, OrdersAreThoseOfTheTheory) {
  EXPECT_NEAR(order("builtin", 0.2, 100), 1, 0.05);
  for (const char* name : {"ab1", "ab2", "ab3"})
    EXPECT_NEAR(order(name, 0.2, 100), 1, 0.05) << name;
  EXPECT_NEAR(order("builtin", 0, 100), 2, 0.1);
  for (const double eta : {0.0, 0.1, 0.2, 0.4}) EXPECT_NEAR(order("ab3e", eta, 100), 3, 0.1) << eta;
  EXPECT_NEAR(order("ab2e", 0.2, 100), 2, 0.1);
  EXPECT_GT(order("ab4e", 0.2, 50), 3);
}

// Leapfrog makes the same steps as velocity Verlet; a dashpot that relaxes within a step errs in
// proportion to it as well.
TEST(HeadOnCollision, LeapfrogIsVelocityVerletAndRelaxationErrsByTheStep) {
  for (const double steps : {20.37, 100.37})
    EXPECT_EQ(rebound_error(named("leapfrog"), 0.2, steps),
              rebound_error(named("builtin"), 0.2, steps));
  EXPECT_NEAR(order("relaxed", 0.2, 100), 1, 0.1);
}

// A dashpot that never forgets the closing speed pushes with a constant force, and takes no energy:
// the rebound speed is the closing speed.
TEST(HeadOnCollision, ADashpotThatNeverRelaxesTakesNothing) {
  Integrator integrator = named("relaxed");
  integrator.relaxation_steps = 1e12;
  const double e = restitution_coefficient(0.2);
  EXPECT_NEAR(rebound_error(integrator, 0.2, 1000.37), 1 / e - 1, 0.01);
}

// A collision at 3 steps per contact is beyond the limit of order 4, 0.43 / omega: 7.3 steps.
TEST(HeadOnCollision, BeyondStabilityTheErrorIsLarge) {
  EXPECT_GT(rebound_error(named("ab4e"), 0, 3.37), 0.3);
}

// Undamped v / omega; critically damped v t exp(-omega t) at omega t = 1; between, by Runge-Kutta.
TEST(Collision, LargestOverlapIsThatOfTheOscillator) {
  const Collision undamped{2000, 0, 1e-4}, critical{2000, 1, 1e-4}, half{2000, 0.5, 1e-4};
  const double omega = std::sqrt(2000 / 1e-4), v = 0.3;
  EXPECT_NEAR(undamped.largest_overlap(v), v / omega, 1e-15);
  EXPECT_NEAR(critical.largest_overlap(v), v / omega / std::exp(1.0), 1e-12);
  EXPECT_NEAR(undamped.duration(), pi / omega, 1e-15);
  double x = 0, u = v, largest = 0;
  const double dt = 1e-4 / omega;
  const auto acceleration = [&](double place, double speed) {
    return -omega * omega * place - omega * speed;  // 2 eta omega
  };
  while (u > 0) {
    const double u2 = u + 0.5 * dt * acceleration(x, u), x2 = x + 0.5 * dt * u;
    x += dt * u2;
    u += dt * acceleration(x2, u2);
    largest = std::max(largest, x);
  }
  EXPECT_NEAR(half.largest_overlap(v), largest, 1e-7 * largest);
}

// Velocity Verlet, 2 (sqrt(1 + N eta^2) - sqrt(N) eta) / (sqrt(N) omega); a smooth rod of AR 5 flat
// on the floor: 9 contacts, 1 / 3.4 of a single one's at order 3 (fix check/timestep/multisphere).
TEST(Advice, LimitFallsWithTheContacts) {
  const Collision collision{2000, 0.2, 1e-4};
  const double omega = std::sqrt(2000 / 1e-4);
  for (const int n : {1, 9, 30})
    EXPECT_NEAR(limit_of_contacts(0, collision, n),
                2 * (std::sqrt(1 + n * 0.04) - std::sqrt(n) * 0.2) / (std::sqrt(n) * omega), 1e-12)
        << n;
  EXPECT_NEAR(limit_of_contacts(3, collision, 1) / limit_of_contacts(3, collision, 9), 3.4, 0.05);
}

// Of a dashpot that relaxes in one step the fastest motion feels tanh(1/2).
TEST(Advice, RelaxationRaisesTheLimit) {
  const Collision collision{2000, 0.2, 1e-4};
  const double omega = std::sqrt(2000 / 1e-4), eta = 0.2 * 6 * std::tanh(0.5);  // of 36 contacts
  const Integrator& relaxed = named("relaxed");
  EXPECT_NEAR(limit_of_contacts(relaxed.order, collision, 36, relaxed.dashpot_share()),
              2 * (std::sqrt(1 + eta * eta) - eta) / (6 * omega), 1e-12);
  EXPECT_EQ(named("leapfrog").dashpot_share(), 1);
}

TEST(Advice, StepsKeepTheErrorAndTheMargin) {
  const Collision collision{2000, 0.2, 1e-4};
  for (const double error : {1e-2, 1e-3, 1e-4})
    for (const int contacts : {1, 30}) {
      const auto limit = [&](const Integrator& of) {
        return limit_of_contacts(of.order, collision, contacts, of.dashpot_share());
      };
      const auto all = advise(collision, error, limit);
      ASSERT_EQ(all.size(), integrators().size());
      const TimestepAdvice* const best = cheapest(all);
      ASSERT_NE(best, nullptr);
      for (const TimestepAdvice& each : all) {
        if (!(each.timestep > 0)) continue;
        EXPECT_LE(each.error, error) << each.integrator.name;
        EXPECT_LE(each.timestep, stability_margin * each.limit * (1 + 1e-12));
        EXPECT_LE(each.timestep, best->timestep);
        EXPECT_NEAR(each.steps_per_collision * each.timestep, collision.duration(), 1e-12);
        // One of the two is used up; the chart's points are 8 % apart, at few steps one step.
        if (each.held_by_stability)
          EXPECT_NEAR(each.timestep, stability_margin * each.limit, 1e-12);
        else
          EXPECT_NEAR(each.steps_per_collision, *each.fewest_steps, 1e-9);
      }
    }
}

// Without events the error is 2 eta pi / (sqrt(12) N), 1.2e-4 with 3000 steps.
TEST(Advice, WhatCannotReachTheErrorHasNoStep) {
  const Collision collision{2000, 0.2, 1e-4};
  const auto all = advise(collision, 1e-5, [&](const Integrator& of) {
    return limit_of_contacts(of.order, collision, 1, of.dashpot_share());
  });
  for (const TimestepAdvice& each : all)
    EXPECT_EQ(each.timestep > 0, each.integrator.events) << each.integrator.name;
  EXPECT_EQ(cheapest({}), nullptr);
}

// A run folder with one smooth rod of AR 5 flat on the floor, on 9 contacts, without friction.
std::filesystem::path rod_on_floor(const std::string& name_of_contacts = "1") {
  const auto run = fresh_folder() / "run";
  put(run / "parameters.json",
      "{\"format\": \"rodpack-run 1\", \"aspect_ratio\": 5, \"overlap\": 0.5, \"curvature_deg\": "
      "0, "
      "\"particle_diameter_m\": 0.003, \"density_kg_m3\": 2500, \"normal_stiffness_N_m\": 2000, "
      "\"tangential_stiffness_N_m\": 1000, \"damping_ratio_normal\": 0.2, "
      "\"damping_ratio_tangential\": 0.2, \"friction\": 0, \"timestep_s\": 1.1e-05, "
      "\"mass_scaling\": 0}\n");
  put(run / "dumps/bodies.000000000007.dump",
      test::frame_head(7, 1, 0.3, 0.3,
                       "id x y z vx vy vz mass nspheres angle half_length radius "
                       "curvature area qw qx qy qz") +
          "1 0.05 0.0015 0 0 0 0 1e-4 9 0 0.0075 0.0015 0 4.15e-5 1 0 0 0\n");
  std::string rows;
  for (int k = -4; k <= 4; ++k) {
    const std::string x = std::to_string(0.05 + 0.0015 * k);
    rows += name_of_contacts + " 0 " + std::to_string(k + 5) + " 0 1 " + x +
            " 0 0 0 1e-4 0 0.05 0.0015 0 " + x + " 0 0 1e-7 0 0 1 0\n";
  }
  put(run / "dumps/contacts.000000000007.dump",
      test::frame_head(7, 9, 0.3, 0.3,
                       "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy "
                       "bjz overlap_n overlap_t nx ny nz") +
          rows);
  return run;
}

// It moves up and down on 9 springs (the turn about its middle is softer: 7.1 of them).
TEST(RunNetwork, OneRodOnTheFloorHasTheLimitOfNineContacts) {
  const RunNetwork network = read_network(rod_on_floor().string());
  EXPECT_EQ(network.lightest, 1e-4);
  EXPECT_EQ(network.timestep, 1.1e-5);
  ASSERT_EQ(network.contacts.size(), 9u);
  const Collision collision{network.stiffness, network.damping_ratio, network.lightest};
  for (const int p : {0, 3, 4})
    EXPECT_NEAR(network_limit(p, network.bodies, network.contacts).timestep,
                limit_of_contacts(p, collision, 9), 1e-9 * limit_of_contacts(p, collision, 9))
        << p;
}

TEST(RunNetwork, AContactOfAnUnknownParticleIsRefused) {
  try {
    read_network(rod_on_floor("4").string());
    FAIL() << "expected a DataError";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("particle 4 is not in"));
  }
}

// Of one body with itself, and in no direction.
TEST(RunNetwork, ContactsThatAreNoneAreRefused) {
  const auto refusal = [](const std::string& found, const std::string& wrong) -> std::string {
    const auto run = rod_on_floor();
    const auto file = run / "dumps/contacts.000000000007.dump";
    std::string text = test::text_of(file);
    const auto at = text.find(found);
    if (at == std::string::npos) return "not there: " + found;
    put(file, text.replace(at, found.size(), wrong));
    try {
      read_network(run.string());
    } catch (const DataError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_THAT(refusal(" 1e-7 0 0 1 0\n", " 1e-7 0 0 0 0\n"),
              HasSubstr("columns nx ny nz: expected a unit vector, found one of length 0 in a "
                        "contact of particle 1"));
  EXPECT_THAT(refusal("1 0 5 0 1 ", "1 1 5 0 0 "),
              HasSubstr("a contact of particle 1 with itself, expected two particles"));
}

TEST(RunNetwork, ParametersOutOfRangeAreRefused) {
  const std::pair<const char*, const char*> wrong[] = {
      {"\"normal_stiffness_N_m\": 2000", "\"normal_stiffness_N_m\": 0"},
      {"\"normal_stiffness_N_m\": 2000", "\"normal_stiffness_N_m\": 1e300"},
      {"\"tangential_stiffness_N_m\": 1000", "\"tangential_stiffness_N_m\": -1"},
      {"\"damping_ratio_normal\": 0.2", "\"damping_ratio_normal\": 1e300"},
      {"\"damping_ratio_tangential\": 0.2", "\"damping_ratio_tangential\": -1"},
      {"\"overlap\": 0.5", "\"overlap\": 1"},
      {"\"curvature_deg\": 0", "\"curvature_deg\": 400"},
      {"\"mass_scaling\": 0", "\"mass_scaling\": -3"}};
  for (const auto& [right, changed] : wrong) {
    const auto run = rod_on_floor();
    std::string text = test::text_of(run / "parameters.json");
    const std::string smooth = "\"friction\": 0,";  // springs across are no use there
    text.replace(text.find(smooth), smooth.size(), "\"friction\": 0.3,");
    text.replace(text.find(right), std::string(right).size(), changed);
    put(run / "parameters.json", text);
    const std::string key = std::string(changed).substr(1, std::string(changed).find('"', 1) - 1);
    try {
      read_network(run.string());
      FAIL() << changed;
    } catch (const DataError& error) {
      EXPECT_THAT(error.what(),
                  HasSubstr("parameters.json: key '" + key + "': expected a number "));
    }
  }
}

TEST(RunNetwork, ARunOfAnotherLawIsRefused) {
  const auto run = rod_on_floor();
  put(run / "parameters.json", "{\"particle_diameter_m\": 0.003, \"youngs_modulus_Pa\": 1e6}\n");
  const auto said = test::run_rodpack("timestep " + run.string(), fresh_folder());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output,
              HasSubstr("parameters.json: expected a deposition's parameters of particles "
                        "and of a linear contact law (model spring_dashpot)"));
}

TEST(TimestepCommand, AdvisesForARunAndForNumbers) {
  const auto run = rod_on_floor();
  const auto of_run = test::run_rodpack("timestep " + run.string(), fresh_folder());
  EXPECT_EQ(of_run.exit_code, 0) << of_run.output;
  EXPECT_THAT(of_run.output, HasSubstr("1 particles, 9 contacts, 9 of the stiffest particle"));
  const auto folder = fresh_folder();
  const auto of_numbers = test::run_rodpack(
      "timestep --kn 2000 --eta 0.2 --mass 1e-4 --contacts 9 --speed 1 -o chart", folder);
  EXPECT_EQ(of_numbers.exit_code, 0) << of_numbers.output;
  EXPECT_THAT(of_numbers.output, HasSubstr("fix ID all multisphere/ab order 3 events yes"));
  // The same scene, so the same table.
  EXPECT_THAT(of_run.output,
              HasSubstr(of_numbers.output.substr(
                  of_numbers.output.find("method"),
                  of_numbers.output.find("written") - of_numbers.output.find("method"))));
  for (const char* name : {"chart.csv", "chart.png", "chart.svg"})
    EXPECT_GT(std::filesystem::file_size(folder / name), 1000u) << name;
}

TEST(TimestepCommand, SaysThatMassScalingIsLeftOut) {
  const auto run = rod_on_floor();
  const auto said = [&] { return test::run_rodpack("timestep " + run.string(), run).output; };
  const std::string without = said();
  std::string text = test::text_of(run / "parameters.json");
  put(run / "parameters.json", text.replace(text.find("ing\": 0"), 7, "ing\": 7"));
  const std::string note =
      "its mass scaling of 7 is left out: limits are those of the particles' own inertia\n";
  std::string with = said();
  ASSERT_THAT(with, HasSubstr(note));
  EXPECT_EQ(with.erase(with.find(note), note.size()), without);
}

TEST(TimestepCommand, AdvisesDashpotsThatRelaxWhereTheyAllowTheLongestStep) {
  const auto said =
      test::run_rodpack("timestep " + rod_on_floor().string() + " --error 0.1", fresh_folder());
  EXPECT_THAT(said.output, HasSubstr("fix ID all multisphere/ab order 0\n           fix ID all "
                                     "property/global dashpotRelaxation scalar "));
}

TEST(TimestepCommand, WantsARunOrAllNumbers) {
  const auto some = test::run_rodpack("timestep --kn 2000 --eta 0.2", fresh_folder());
  EXPECT_EQ(some.exit_code, 2);
  EXPECT_THAT(some.output, HasSubstr("expected a run folder, or all of --kn, --mass and --eta"));
  const auto both =
      test::run_rodpack("timestep " + rod_on_floor().string() + " --kn 2000", fresh_folder());
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.output, HasSubstr("--kn"));
  const auto none = test::run_rodpack("timestep " + fresh_folder().string(), fresh_folder());
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.output, HasSubstr("parameters.json"));
}

}  // namespace

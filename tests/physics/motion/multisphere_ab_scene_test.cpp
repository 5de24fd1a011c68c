// SPDX-License-Identifier: GPL-2.0-or-later
// fix multisphere/ab in a scene with collisions: against built-in multisphere, restarts, ranks,
// changes of the time step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;
using Vars = std::map<std::string, std::string>;

const char* const deck = "verification/two_rods/in.two_rods";
const char* const planar = "multisphere/ab order 3 planar yes";
const Vars in_plane = {{"integrator", planar}, {"tilt", "1 0 0 0"}};

Table state_of(const Run& run) {
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return read_dump(run.folder / "state.dump");
}

/// Row of body `id`.
size_t row(const Table& state, double id) {
  for (size_t i = 0; i < state.rows(); ++i)
    if (state.column("c_id")[i] == id) return i;
  ADD_FAILURE() << "no body " << id;
  return 0;
}

double largest_distance(const Table& a, const Table& b) {
  double largest = 0;
  for (double id : {1., 2.}) {
    double squared = 0;
    for (const char* x : {"c_x[1]", "c_x[2]", "c_x[3]"})
      squared += std::pow(a.column(x)[row(a, id)] - b.column(x)[row(b, id)], 2);
    largest = std::max(largest, std::sqrt(squared));
  }
  return largest;
}

void expect_same(const Table& a, const Table& b, double relative) {
  ASSERT_EQ(a.rows(), b.rows());
  for (const std::string& name : a.names())
    for (double id : {1., 2.}) {
      const double x = a.column(name)[row(a, id)], y = b.column(name)[row(b, id)];
      EXPECT_LE(std::abs(x - y), relative * std::max(std::abs(x), std::abs(y)))
          << name << " of body " << id << ": " << x << " and " << y;
    }
}

}  // namespace

// Both tend to the solution of the same equations. Built-in multisphere gives a new body half a
// step of gravity too much, hence no gravity; without damping the force has only a kink at touch,
// and both methods then converge to second order at least.
TEST(MultisphereAb, TendsToTheTrajectoryOfBuiltInMultisphere) {
  const double time = 0.01;  // the rods meet after 3.3 ms
  double distance[3];
  for (int i = 0; i < 3; ++i) {
    const int steps = 1000 << i;
    Vars vars = {{"timestep", exact(time / steps)},
                 {"steps", std::to_string(steps + 1)},
                 {"gravity", "0"},
                 {"damping", "0"},
                 {"friction", "0"}};
    vars["every"] = vars["steps"];
    const Table ab = state_of(run_liggghts(deck, vars));
    EXPECT_LT(std::abs(ab.column("c_v[1]")[0]), 0.49);  // they did collide
    vars["integrator"] = "multisphere";
    distance[i] = largest_distance(ab, state_of(run_liggghts(deck, vars)));
  }
  EXPECT_LT(distance[1], 0.4 * distance[0]) << distance[0];
  EXPECT_LT(distance[2], 0.4 * distance[1]) << distance[0];
  EXPECT_LT(distance[2], 1e-7);  // m, of 5 mm travelled
}

TEST(MultisphereAb, MomentumOfTwoCollidingBodiesIsConservedToRounding) {
  // equal masses, +-0.5 m/s along x, no outer force: the sum of all velocities stays 0
  const Table state = state_of(run_liggghts(deck, {{"gravity", "0"}}));
  for (const char* v : {"c_v[1]", "c_v[2]", "c_v[3]"}) {
    const auto& velocity = state.column(v);
    EXPECT_NEAR(velocity[0] + velocity[1], 0, 1e-14) << v;
  }
  EXPECT_LT(std::abs(state.column("c_v[1]")[0]), 0.4);  // they did collide
}

// Without friction: the built-in tangential law evaluates a sliding contact differently in set-up.
TEST(MultisphereAb, RestartRepeatsTheUninterruptedRunToTheLastBit) {
  const Vars leapfrog = {{"integrator", "multisphere/ab order 0"}};
  for (Vars vars : {Vars{}, in_plane, leapfrog}) {
    vars["friction"] = "0";
    vars["save"] = "460";  // in the middle of the collision
    const auto whole = run_liggghts(deck, vars);
    const Table expected = state_of(whole);
    vars["save"] = "0";
    vars["from"] = "460";
    const auto continued = run_liggghts_in(whole.folder, deck, vars);
    EXPECT_THAT(continued.output, testing::Not(testing::HasSubstr("starts anew")));
    expect_same(state_of(continued), expected, 0);
  }
}

TEST(MultisphereAb, SecondRunCommandGoesOnAsIfThereWereNone) {
  const Table split = state_of(run_liggghts(deck, {{"friction", "0"}, {"split", "460"}}));
  expect_same(split, state_of(run_liggghts(deck, {{"friction", "0"}})), 0);
}

TEST(MultisphereAb, RanksAgreeWithOneRankToRounding) {
  const Vars leapfrog = {{"integrator", "multisphere/ab order 0"}};
  for (const Vars& vars : {Vars{}, in_plane, leapfrog}) {
    const Table one = state_of(run_liggghts(deck, vars, 1));
    expect_same(state_of(run_liggghts(deck, vars, 2)), one, 1e-9);
  }
}

TEST(MultisphereAb, RestartFromBuiltInMultisphereStartsAnew) {
  const auto built_in = run_liggghts(
      deck, {{"integrator", "multisphere"}, {"save", "200"}, {"steps", "201"}, {"gravity", "0"}});
  ASSERT_EQ(built_in.exit_code, 0) << built_in.output;
  const Vars end = {{"steps", "251"}, {"every", "251"}, {"gravity", "0"}};
  const Table whole = state_of(run_liggghts(deck, end));
  Vars vars = end;
  vars["from"] = "200";
  const auto run = run_liggghts_in(built_in.folder, deck, vars);
  EXPECT_THAT(run.output, testing::HasSubstr("starts anew"));
  // free flight so far: the centres move uniformly whoever integrates them
  EXPECT_LT(largest_distance(state_of(run), whole), 1e-15);
}

TEST(MultisphereAb, AnotherTimestepOrOrderInARestartStartsAnew) {
  const auto first = run_liggghts(deck, {{"save", "300"}, {"steps", "301"}});
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const auto same = run_liggghts_in(first.folder, deck, {{"from", "300"}, {"steps", "302"}});
  EXPECT_THAT(same.output, testing::Not(testing::HasSubstr("starts anew")));
  for (const Vars& change :
       {Vars{{"timestep", "5e-6"}}, Vars{{"integrator", "multisphere/ab order 4"}},
        Vars{{"integrator", "multisphere/ab order 2"}},
        Vars{{"integrator", "multisphere/ab order 0"}}}) {
    Vars vars = change;
    vars["from"] = "300";
    vars["steps"] = "401";
    const auto run = run_liggghts_in(first.folder, deck, vars);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output, testing::HasSubstr("starts anew"));
    EXPECT_EQ(state_of(run).rows(), 2u);
  }
}

TEST(MultisphereAb, WrongInputIsOneLineThatNamesIt) {
  const std::map<std::string, std::string> cases = {
      {"multisphere/ab order 5", "order is '5', expected a whole number in [0, 4], 0 for leapfrog"},
      {"multisphere/ab CAddRhoFluid 1 2", "unknown keyword 'CAddRhoFluid'"},
      {"multisphere/ab planar yes", "body 1: z is not one of its principal axes"},
      {"multisphere\nfix again all multisphere/ab", "only one fix multisphere"}};
  for (const auto& [integrator, message] : cases) {
    std::string text;
    {
      std::ifstream file(std::string(RODPACK_REPOSITORY "/inputs/") + deck);
      text.assign(std::istreambuf_iterator<char>(file), {});
    }
    const std::string variable = "${integrator}";
    text.replace(text.find(variable), variable.size(), integrator);
    for (size_t jump;
         (jump = text.find("jump")) != std::string::npos;) {  // needs a file to jump in
      const size_t line = text.rfind('\n', jump) + 1;
      text.erase(line, text.find('\n', jump) - line);
    }
    text.erase(text.find("read_restart"), sizeof("read_restart  restart.${from}") - 1);
    const auto run = run_liggghts(text);
    EXPECT_NE(run.exit_code, 0) << integrator;
    EXPECT_THAT(run.output, testing::HasSubstr(message)) << integrator;
  }
}

TEST(MultisphereAb, PlanarRefusesAMotionOutOfThePlane) {
  const auto run = run_liggghts("verification/free_flight/in.free_flight",
                                {{"integrator", planar}, {"orientation", "1 0 0 0"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, testing::HasSubstr("body 1: it moves out of the x-y plane"));
}

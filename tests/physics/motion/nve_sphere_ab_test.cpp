// SPDX-License-Identifier: GPL-2.0-or-later
// fix nve/sphere/ab: plain spheres. Numbers as in the deck's header.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;
using Vars = std::map<std::string, std::string>;

const char* const deck = "verification/bouncing_spheres/in.bouncing_spheres";

Table end_of(const Run& run) {
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return read_dump(run.folder / "end.dump");
}

double of(const Table& state, const std::string& column, double id) {
  for (size_t i = 0; i < state.rows(); ++i)
    if (state.column("id")[i] == id) return state.column(column)[i];
  ADD_FAILURE() << "no sphere " << id;
  return 0;
}

void expect_same(const Table& a, const Table& b, double relative) {
  ASSERT_EQ(a.rows(), 2u);
  ASSERT_EQ(b.rows(), 2u);
  for (const std::string& name : a.names())
    for (double id : {1., 2.}) {
      const double x = of(a, name, id), y = of(b, name, id);
      EXPECT_LE(std::abs(x - y), relative * std::max(std::abs(x), std::abs(y)))
          << name << " of sphere " << id << ": " << x << " and " << y;
    }
}

Table bounce(int order, int steps) {
  return end_of(run_liggghts(deck, {{"integrator", "nve/sphere/ab order " + std::to_string(order)},
                                    {"timestep", exact(2e-3 / steps)},
                                    {"steps", std::to_string(steps + 1)}}));
}

}  // namespace

TEST(NveSphereAb, SphereOnAnElasticFloorIsOfTheOrderAsked) {
  const double r = 2e-3, k = 1000, g = 981, time = 2e-3, pi = std::acos(-1.0);
  const double m = 2500 * 4. / 3 * pi * r * r * r;
  const double rest = r - m * g / k, start = 1.99e-3;
  const double phase = std::sqrt(k / m) * time;
  for (int order = 1; order <= 3; ++order) {
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      const Table state = bounce(order, fine ? 400 : 200);
      error[fine] =
          std::abs(of(state, "vy", 1) + (start - rest) * std::sqrt(k / m) * std::sin(phase));
    }
    EXPECT_NEAR(observed_order(error[0], error[1]), order, 0.15) << error[0] << " " << error[1];
  }
}

TEST(NveSphereAb, FreeFallIsExactAndSpinConstant) {
  const Table state = bounce(3, 500);
  EXPECT_NEAR(of(state, "vy", 2), 1 - 981 * 2e-3, 1e-12);
  EXPECT_NEAR(of(state, "y", 2), 0.05 + 2e-3 - 0.5 * 981 * 4e-6, 1e-12);
  EXPECT_NEAR(of(state, "x", 2), 0.019 + 2 * 2e-3 - 0.04, 1e-12);  // wrapped once
  EXPECT_EQ(of(state, "omegax", 2), 3);
  EXPECT_EQ(of(state, "omegaz", 2), 5);
}

TEST(NveSphereAb, RestartRepeatsTheUninterruptedRunToTheLastBit) {
  const auto whole = run_liggghts(deck, {{"save", "500"}});
  const Table expected = end_of(whole);
  const auto continued = run_liggghts_in(whole.folder, deck, {{"from", "500"}});
  EXPECT_THAT(continued.output, testing::Not(testing::HasSubstr("starts anew")));
  expect_same(end_of(continued), expected, 0);
  const auto other_step =
      run_liggghts_in(whole.folder, deck, {{"from", "500"}, {"timestep", "5e-7"}});
  EXPECT_THAT(other_step.output, testing::HasSubstr("starts anew"));
}

TEST(NveSphereAb, RanksAgreeWithOneRankToRounding) {
  // ranks draw other places within 1e-13 m at birth
  expect_same(end_of(run_liggghts(deck, {}, 2)), end_of(run_liggghts(deck, {}, 1)), 1e-9);
}

TEST(NveSphereAb, PlanarSceneStaysInItsPlane) {
  const Table state = end_of(run_liggghts(deck, {{"flat", "1"}}));
  for (double id : {1., 2.})
    for (const char* name : {"z", "vz", "omegax", "omegay"})
      EXPECT_EQ(of(state, name, id), 0) << name << " " << id;
  EXPECT_EQ(of(state, "omegaz", 2), 5);
}

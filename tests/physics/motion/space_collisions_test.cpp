// SPDX-License-Identifier: GPL-2.0-or-later
// multisphere/ab in space as in the plane: order through collisions with friction, momentum,
// restarts, ranks, and the limit of the time step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "rodpack/motion/stability_limit.h"
#include "table.h"

using namespace rodpack::test;

namespace {

using Vars = std::map<std::string, std::string>;

const char* const bodies_in_space[] = {"vx", "vy", "vz", "omegax", "omegay", "omegaz"};

Table end_of(const std::string& deck, const Vars& vars = {}, int ranks = 1) {
  const auto run = run_liggghts(deck, vars, ranks);
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  return read_dump(run.folder / "end.dump");
}

/// Root mean square over the bodies of the differences in velocity, angular velocities times 5 mm.
double distance(const Table& a, const Table& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rows(); ++i)
    for (const std::string name : bodies_in_space)
      sum += std::pow((name[0] == 'o' ? 5e-3 : 1.0) * (a.column(name)[i] - b.column(name)[i]), 2);
  return std::sqrt(sum / static_cast<double>(a.rows()));
}

/// Order between two steps, one four times the other, against a far finer one.
double order_of(const std::function<Table(int steps)>& end, int steps, double& coarse) {
  const Table reference = end(32 * steps);
  coarse = distance(end(steps), reference);
  const double fine = distance(end(4 * steps), reference);
  std::printf("%.2e %.2e, order %.2f\n", coarse, fine, observed_order(coarse, fine, 4));
  return observed_order(coarse, fine, 4);
}

/// Rods that fall on an end, across all planes: the axis at 70 degrees to the floor's plane in an
/// upright plane that is turned by 35 degrees, moving along x and spinning about all axes.
Vars falling_rods(const std::string& events) {
  const double half_up = 35 * M_PI / 180, half_around = 17.5 * M_PI / 180;
  const double c = std::cos(half_around), s = std::sin(half_around);
  return {{"integrator", "multisphere/ab order 3 planar no events " + events},
          {"planar", "0"},
          {"rods", "6"},
          {"vx", "0.2"},
          {"omega", "30 20 -15"},
          {"gravity", "9.81"},
          // About z, then about y: the product of (c, 0, s, 0) and (cos, 0, 0, sin).
          {"orientation", exact(c * std::cos(half_up)) + " " + exact(s * std::sin(half_up)) + " " +
                              exact(s * std::cos(half_up)) + " " + exact(c * std::sin(half_up))}};
}

std::string in_rods_on_ranks() {
  std::ifstream stream(RODPACK_REPOSITORY "/inputs/accuracy/in.rods");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string one = "processors      1 1 1";
  const auto at = text.find(one);
  if (at == std::string::npos) throw std::runtime_error("in.rods says nothing of ranks");
  return text.replace(at, one.size(), "processors * 1 1");
}

/// Pairs of crossed rods, 40 mm apart, that fly into each other in midair, off their centres, one
/// of them spinning about all axes; each pair a little later than the one before. `restart`: a file
/// to go on from.
std::string crossed_rods(double dt, const std::string& after, const std::string& events,
                         const std::string& restart = "", const std::string& friction = "0.3",
                         const std::string& cap = "off") {
  const auto rod = [](int number, double x, double y, double z, const std::string& how) {
    return one_particle(std::to_string(number), {x, y, z}, how);
  };
  std::string bodies;
  if (restart.empty()) {
    for (int pair = 0; pair < 3; ++pair) {
      const double x = 0.04 * (pair - 1), y = 3.3e-3 + 7.3e-6 * pair;
      bodies += rod(2 * pair, x - 2e-3, 0, 0,
                    "vel constant 0.05 0.5 0 omega constant 0 0 0 orientation constant 1 0 0 0");
      bodies += rod(2 * pair + 1, x, y, 1e-3,
                    "vel constant 0 -0.5 0.1 omega constant 20 -30 40 orientation constant " +
                        exact(std::cos(M_PI / 6)) + " 0 " + exact(std::sin(M_PI / 6)) + " 0");
    }
    bodies += "run 1\n";
  }
  return Deck()
      .box("-0.08 0.08 -0.03 0.03 -0.03 0.03")
      .processors("* 1 1")
      .restart(restart)
      .friction(friction)
      .models("model spring_dashpot tangential spring_dashpot multistepOrder 4 totalForceCap " +
              cap)
      .timestep(exact(dt))
      .with(
          "fix rod all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 "
          "aspect_ratio 5 diameter 0.003 surface smooth density constant 2500 planar no\n"
          "fix mix all particledistribution/discrete 15485867 1 rod 1.0\n"
          "fix motion all multisphere/ab order 3 planar no events " +
          events + "\n" + bodies + after +
          "\nwrite_dump all multisphere/body end.dump modify format %.17g\n");
}

const double crossing_time = 2.4e-3;  // s: they meet after some 0.4 ms and part before its end

std::string crossing(int steps, const std::string& events, const std::string& friction = "0.3",
                     const std::string& cap = "off") {
  return crossed_rods(crossing_time / steps, "run " + std::to_string(steps), events, "", friction,
                      cap);
}

/// Rounding is amplified by the collisions: 1e-9 of the largest component of place, velocity, spin.
void expect_close(const Table& a, const Table& b) {
  ASSERT_EQ(a.rows(), b.rows());
  for (const std::string kind : {"", "v", "omega"}) {
    double worst = 0, scale = 0;
    for (const std::string axis : {"x", "y", "z"})
      for (std::size_t i = 0; i < a.rows(); ++i) {
        const double one = a.column(kind + axis)[i], other = b.column(kind + axis)[i];
        worst = std::max(worst, std::fabs(one - other));
        scale = std::max(scale, std::fabs(one));
      }
    EXPECT_LE(worst, 1e-9 * scale) << kind;
  }
}

}  // namespace

namespace {

std::function<Table(int)> fall(const std::string& events, const std::string& friction) {
  return [events, friction](int steps) {
    auto vars = falling_rods(events);
    vars["dt"] = exact(3e-3 / steps);
    vars["steps"] = std::to_string(steps);
    vars["mu"] = friction;
    return end_of("accuracy/in.rods", vars);
  };
}

std::function<Table(int)> cross_over(const std::string& events, const std::string& friction,
                                     const std::string& cap = "off") {
  return [=](int steps) { return end_of(crossing(steps, events, friction, cap)); };
}

}  // namespace

// The reference is the same method at a step 32 times finer. Without friction, and where it holds
// from touch to end; without events the dashpot makes a collision of first order.
TEST(CollisionsInSpace, RodsThatFallOnAFloorAreOfThirdOrderWithEvents) {
  for (const std::string friction : {"0", "1e6"}) {
    double with = 0, without = 0;
    EXPECT_GT(order_of(fall("yes", friction), 120, with), 2.6) << friction;
    EXPECT_LT(order_of(fall("no", friction), 120, without), 1.6) << friction;
    EXPECT_LT(10 * with, without) << friction;
  }
}

TEST(CollisionsInSpace, CrossedRodsAreOfThirdOrderWithEvents) {
  double with = 0, without = 0;
  EXPECT_GT(order_of(cross_over("yes", "0"), 200, with), 2.6);
  EXPECT_LT(order_of(cross_over("no", "0"), 200, without), 1.6);
  EXPECT_LT(10 * with, without);
  // Held by friction, where spheres of both touch and part within the same steps: 2.4.
  EXPECT_GT(order_of(cross_over("yes", "1e6"), 200, with), 2);
  EXPECT_LT(order_of(cross_over("no", "1e6"), 200, without), 1.6);
  EXPECT_LT(10 * with, without);
}

// In space the direction of sliding turns. Crossed rods that end their slide under a falling cap
// have no limit of small steps, in space as in the plane (gran_model_spring_dashpot.md): these
// slide throughout. The rods that fall at a friction of 0.3 stick meanwhile, and slide again: the
// moment of that is known to second order.
TEST(CollisionsInSpace, SlidingThatTurnsIsOfThirdOrderWithEvents) {
  double with = 0, without = 0;
  for (const std::string friction : {"0.02", "0.1"}) {
    EXPECT_GT(order_of(fall("yes", friction), 120, with), 2.6) << friction;
    EXPECT_LT(order_of(fall("no", friction), 120, without), 1.6) << friction;
    EXPECT_LT(10 * with, without);
  }
  EXPECT_GT(order_of(fall("yes", "0.3"), 240, with), 2);
  EXPECT_LT(with, 2e-5);
  EXPECT_GT(order_of(cross_over("yes", "0.02"), 200, with), 2.6);
  EXPECT_GT(order_of(cross_over("yes", "0.05", "on"), 200, with), 2.6);
}

TEST(CollisionsInSpace, CrossedRodsKeepTheirMomentumToRounding) {
  const Table found = cross_over("yes", "0.3")(100);
  ASSERT_EQ(found.rows(), 6U);
  const double start[3] = {0.05, 0, 0.1};  // m/s, of a pair together
  const char* const velocity[3] = {"vx", "vy", "vz"};
  for (std::size_t i = 0; i < found.rows(); i += 2) {
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(found.column(velocity[d])[i] + found.column(velocity[d])[i + 1], start[d], 1e-14);
    EXPECT_LT(found.column("vy")[i], 0.4);  // it has collided
  }
}

// The ranks' border at x = 0 lies across the middle pair.
TEST(CollisionsInSpace, RanksAgreeWithOneRankToRounding) {
  const auto rods = in_rods_on_ranks();
  expect_close(end_of(rods, falling_rods("yes"), 2), end_of(rods, falling_rods("yes")));
  const Table one = end_of(crossing(100, "yes"));
  for (const int ranks : {2, 4}) expect_close(end_of(crossing(100, "yes"), {}, ranks), one);
}

// Broken off in the middle of the collision.
TEST(CollisionsInSpace, ARestartRepeatsTheUninterruptedRunToTheLastBitOnOneAndTwoRanks) {
  const double dt = crossing_time / 200;
  for (const int ranks : {1, 2}) {
    const auto whole =
        run_liggghts(crossed_rods(dt, "restart 90 rest.*\nrun 200 upto", "yes"), {}, ranks);
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    const Table expected = read_dump(whole.folder / "end.dump");
    const auto rest = run_liggghts_in(
        whole.folder, crossed_rods(dt, "run 200 upto", "yes", "rest.90"), {}, ranks);
    ASSERT_EQ(rest.exit_code, 0) << rest.output;
    const Table found = read_dump(whole.folder / "end.dump");
    for (const std::string& name : expected.names())
      EXPECT_EQ(found.column(name), expected.column(name)) << name << ' ' << ranks;
  }
}

namespace {

/// A smooth rod of nine spheres rests on a floor, pressed in by 0.1 mm, across any direction of the
/// horizontal, and turns about its own axis by so little that friction always holds it.
struct RodAtRest {
  double eta = 0.2, friction = 0.3, timestep = 1.1e-5;
  bool floor_across_z = false;

  Table run(int steps) const {
    const double depth = 1e-4, radius = 1.5e-3;
    const double gravity = 9 * 1000 * depth / mass();
    const std::string up = floor_across_z ? "z" : "y";
    const double height = radius - depth;
    // About the vertical by 60 degrees, so that the axis lies along none of the box.
    const std::string half = exact(std::cos(M_PI / 6)), other = exact(std::sin(M_PI / 6));
    const std::string turn = floor_across_z ? half + " 0 0 " + other : half + " 0 " + other + " 0";
    const double spin = 0.05;
    const double along = spin * std::cos(M_PI / 3), aside = spin * std::sin(M_PI / 3);
    const std::string omega = floor_across_z ? exact(along) + " " + exact(aside) + " 0"
                                             : exact(along) + " 0 " + exact(-aside);
    const auto finished = run_liggghts(
        Deck()
            .box("-0.02 0.02 -0.02 0.02 -0.02 0.02")
            .damping(exact(eta))
            .friction(exact(friction))
            .timestep(exact(timestep))
            .with("fix gravity all gravity " + exact(gravity) + " vector 0 " +
                  (floor_across_z ? "0 -1" : "-1 0") +
                  "\nfix floor all wall/gran model spring_dashpot tangential spring_dashpot "
                  "primitive type 1 " +
                  up +
                  "plane 0\nfix body all particletemplate/multisphere/spherocylinder 1 atom_type 1 "
                  "type 1 aspect_ratio 5 diameter 0.003 surface smooth density constant 2500 "
                  "planar no\nfix mix all particledistribution/discrete 15485867 1 body 1.0\n" +
                  one_particle("rest",
                               {0, floor_across_z ? 0 : height, floor_across_z ? height : 0},
                               "omega constant " + omega + " orientation constant " + turn) +
                  "fix motion all multisphere/ab order 3 events no\n"
                  "fix check all check/timestep/multisphere 20 warn 1e9 error no\n"
                  "compute ep all contact/energy\nthermo_style custom step f_check[1] "
                  "c_ep[2]\nthermo_modify norm no lost error format float %.12g\nthermo 20\n"
                  "run 1\nrun " +
                  std::to_string(steps) + "\n"));
    if (finished.exit_code != 0) throw std::runtime_error(finished.output);
    return read_thermo(finished.output, -1);
  }
  static double mass() { return 2500 * M_PI * std::pow(1.5e-3, 3) * (12 - 40.0 / 12); }
  /// Of rolling against the springs of friction of nine contacts: I = 2/5 m r^2, and the arm is
  /// shorter than r by half of the overlap.
  double limit() const {
    const double radius = 1.5e-3, arm = radius - 0.5e-4;
    const double share = 9 * (1 + arm * arm / (0.4 * radius * radius));
    return rodpack::stability_limit(3, eta * std::sqrt(share)) / std::sqrt(share * 500 / mass());
  }
};

}  // namespace

TEST(TimestepInSpace, TheCheckFindsTheStiffestMotionWhateverItsDirection) {
  for (const bool across_z : {false, true}) {
    RodAtRest rod;
    rod.floor_across_z = across_z;
    const auto fraction = rod.run(20).column("check[1]");
    EXPECT_NEAR(fraction.front() * rod.limit() / rod.timestep, 1, 0.01) << across_z;
  }
}

// Below the limit the rolling that friction's springs hold dies out, and leaves what they hold
// against each other; above it grows, until they slide.
TEST(TimestepInSpace, RollingIsStableBelowTheLimitAndNotAboveIt) {
  for (const double fraction : {0.97, 1.03}) {
    RodAtRest rod;
    rod.timestep = fraction * rod.limit();
    const auto energy = rod.run(4000).column("ep[2]");
    ASSERT_GT(energy[1], 0);
    if (fraction < 1)
      EXPECT_LT(energy.back(), energy[1]);
    else
      EXPECT_GT(energy.back(), 100 * energy[1]);
  }
}

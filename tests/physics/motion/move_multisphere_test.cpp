// SPDX-License-Identifier: GPL-2.0-or-later
// fix move/multisphere: bodies that are held fixed or moved as prescribed, and what hits them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"
#include "rodpack/contact/contact_law.h"
#include "table.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

const double diameter = 3e-3;    // m
const double timestep = 1.1e-5;  // s

/// A body that is inserted in the first step, at rest but for a velocity along x. Bodies and their
/// spheres are numbered as they are put.
std::string put(int number, const std::string& kind, double x, double y, double vx = 0,
                double angle = 0) {
  const std::string n = std::to_string(number), twice_vx = exact(vx) + " " + exact(vx),
                    twice_angle = exact(angle) + " " + exact(angle);
  return "fix put" + n + " all insert/line " + n + " template " + kind + " 1 per_line 1 x " +
         exact(x - 0.01) + " " + exact(x + 0.01) + " y " + exact(y) +
         " total 1 interval 1 velocity " + twice_vx + " angle " + twice_angle + "\n";
}

std::string number_format(int numbers) {
  std::string format;
  for (int k = 0; k < numbers; ++k) format += " %.17g";
  return format;
}

/// Balls, rods of nine spheres in a row, and balls of the rods' density.
struct Scene {
  std::string integrator = "order 3 planar yes", damping = "0.2", friction = "0.3",
              boundary = "f f f", density = "2500", restart;

  /// `bodies` are born in the first step, unless the deck goes on from a restart file; then comes
  /// `after`. All spheres and bodies are listed after each step.
  std::string with(const std::string& bodies, const std::string& after) const {
    const auto declare = [](const std::string& name, const std::string& type_and_aspect_ratio,
                            const std::string& of_density) {
      return "fix " + name +
             " all particletemplate/multisphere/spherocylinder 1 atom_type 1 type " +
             type_and_aspect_ratio + " diameter 0.003 surface smooth planar yes density " +
             of_density + "\n";
    };
    return Deck()
        .processors("* 1 1")
        .boundary(boundary)
        .damping(damping)
        .friction(friction)
        .restart(restart)
        .models("model spring_dashpot tangential spring_dashpot multistepOrder 4")
        .timestep(exact(timestep))
        .with(declare("ball", "1 aspect_ratio 1", "2500") +
              declare("rod", "2 aspect_ratio 5", density) +
              declare("heavy", "3 aspect_ratio 1", density) + "fix motion all multisphere/ab " +
              integrator + "\n" + bodies + (restart.empty() ? "run 1\n" : "") +
              "dump bodies all multisphere/body 1 bodies.dump\n"
              "dump_modify bodies format %.17g first yes\n"
              "dump spheres all custom 1 spheres.dump id x y z vx vy vz omegax omegay omegaz fx fy "
              "fz "
              "tqx tqy tqz\n"
              "dump_modify spheres sort id first yes format \"%d" +
              number_format(15) + "\"\n" +
              "thermo 1\nthermo_modify norm no lost error format float %.17g\n" + after + "\n");
  }
};

const std::string forces =
    "thermo_style custom step f_hold[1] f_hold[2] f_hold[3] f_hold[4] f_hold[5] f_hold[6]\n"
    "thermo_modify norm no lost error format float %.17g\n";

std::string hold(const std::string& spheres, const std::string& motion = "") {
  return "group held id " + spheres + "\nfix hold held move/multisphere " + motion + "\n" + forces;
}

Run finished(const std::string& deck, int ranks = 1) {
  auto run = run_liggghts(deck, {}, ranks);
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  return run;
}

Table bodies_of(const Run& run, int frame = -1) {
  return read_dump(run.folder / "bodies.dump", frame);
}
Table spheres_of(const Run& run, int frame = -1) {
  return read_dump(run.folder / "spheres.dump", frame);
}

/// The first thermo table with this column.
Table thermo_of(const Run& run, const std::string& column) {
  const auto at = run.output.rfind("Step", run.output.find(column));
  return read_thermo(run.output.substr(at));
}
Table forces_in(const Run& run) { return thermo_of(run, " hold[1]"); }

/// A ball that flies into a held one, whose centre is at (0.05, 0.05), from the left.
std::string bounce(const Scene& scene, const std::string& motion = "", double offset = 0,
                   double speed = 0.5) {
  const double gap = 1e-3 * speed;  // 91 steps
  return scene.with(
      put(1, "heavy", 0.05, 0.05) + put(2, "ball", 0.05 - diameter - gap, 0.05 + offset, speed),
      hold("1", motion) + "run 200");
}

const char* const motion_columns[] = {"x", "y", "vx", "vy", "omegaz"};

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Rodrigues' formula.
Vector turned(const Vector& v, const Vector& axis, double angle) {
  const Vector side = cross(axis, v);
  const double along = axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2];
  Vector result;
  for (int d = 0; d < 3; ++d)
    result[d] = v[d] * std::cos(angle) + side[d] * std::sin(angle) +
                axis[d] * along * (1 - std::cos(angle));
  return result;
}

Vector place(const Table& table, std::size_t row) {
  return {table.column("x")[row], table.column("y")[row], table.column("z")[row]};
}
Vector velocity(const Table& table, std::size_t row) {
  return {table.column("vx")[row], table.column("vy")[row], table.column("vz")[row]};
}

}  // namespace

// A held ball is a wall to the other one: infinitely heavy, whatever its own mass. The rebound is
// that of the closed form e(eta) with the mass of the ball that moves; with the effective mass of
// two equal balls it would be e(eta / sqrt(2)).
TEST(MoveMultisphere, AHeldBodyIsInfinitelyHeavyInACollision) {
  const double expected = rodpack::restitution_coefficient(0.2);
  for (const char* integrator :
       {"order 2 planar yes", "order 3 planar yes", "order 4 planar yes", "order 3 planar no"}) {
    Scene scene;
    scene.integrator = integrator;
    const auto light = finished(bounce(scene));
    const Table end = bodies_of(light);
    EXPECT_NEAR(-end.column("vx")[1] / 0.5, expected, 1e-3) << integrator;
    for (const char* name : {"vx", "vy", "omegaz"}) EXPECT_EQ(end.column(name)[0], 0) << name;
    EXPECT_EQ(end.column("x")[0], 0.05);
    EXPECT_EQ(end.column("y")[0], 0.05);

    scene.density = "1e6";
    const Table heavy = bodies_of(finished(bounce(scene)));
    for (const char* name : motion_columns)
      EXPECT_EQ(heavy.column(name), end.column(name)) << name << " " << integrator;

    const std::string wall =
        "fix wall all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 "
        "xplane 0.0485 multistepOrder 4\nrun 200";
    const Table at_wall = bodies_of(finished(scene.with(put(1, "ball", 0.0465, 0.05, 0.5), wall)));
    EXPECT_NEAR(at_wall.column("vx")[0] / end.column("vx")[1], 1, 1e-10) << integrator;
  }
}

// The deck moved_bodies. Relative to a prescribed body the ball rebounds with e(eta), so that it
// ends with V + e (V + e v0); the centre of the rod turns about p(t) = p(0) + A sin(2 pi t / T).
TEST(MoveMultisphere, ABallBetweenAHeldAndAFollowingOneMeetsTheClosedForm) {
  const double e = rodpack::restitution_coefficient(0.2), v0 = 0.5, follower = 0.2;
  const double expected = follower + e * (follower + e * v0);
  const double turn = 40, swing = 1e-3, period = 7e-3, pivot[2] = {0.03, 0.07};
  const auto error = [&](int order, int refinement) {
    const double dt = timestep / refinement;
    const int moves = 945 * refinement;
    const std::string steps = std::to_string(moves + 1);
    const auto run = run_liggghts(
        "verification/moved_bodies/in.moved_bodies",
        {{"order", std::to_string(order)}, {"dt", exact(dt)}, {"steps", steps}, {"every", steps}});
    if (run.exit_code != 0) throw std::runtime_error(run.output);
    const Table end = bodies_of(run);
    const double t = moves * dt, c = std::cos(turn * t), s = std::sin(turn * t);
    const double shift = swing * std::sin(2 * M_PI * t / period);
    EXPECT_NEAR(end.column("x")[3], pivot[0] + shift + c * 0.01 - s * 0.005, 1e-14);
    EXPECT_NEAR(end.column("y")[3], pivot[1] + shift + s * 0.01 + c * 0.005, 1e-14);
    EXPECT_EQ(end.column("x")[0], 0.05);
    EXPECT_NEAR(end.column("x")[1], 0.0413 + follower * t, 1e-15);
    return end.column("vx")[2] / expected - 1;
  };
  EXPECT_LT(std::fabs(error(3, 1)), 1e-3);
  for (const int order : {2, 3})
    EXPECT_NEAR(observed_order(error(order, 2), error(order, 8), 4), order, 0.2) << order;
  EXPECT_LT(std::fabs(error(4, 8)), std::fabs(error(4, 1)) / (8 * 8 * 8));
}

// In every step, also of events, what the held body bears is what it does to the other one.
TEST(MoveMultisphere, TheForceIsOppositeToThatOnTheOther) {
  for (const char* motion : {"", "velocity 0.1 -0.05 0 omega 0 0 200"}) {
    const auto run = finished(bounce(Scene(), motion, 1e-3));
    const Table force = forces_in(run);
    ASSERT_EQ(force.rows(), 201u);
    int touching = 0;
    for (int step = 0; step <= 200; ++step) {
      const Table spheres = spheres_of(run, step);
      const double fx = spheres.column("fx")[1], fy = spheres.column("fy")[1];
      touching += fx != 0;
      EXPECT_EQ(force.column("hold[1]")[step], -fx);
      EXPECT_EQ(force.column("hold[2]")[step], -fy);
      // Both balls turn the same way under the tangential force, by equal levers of r - delta/2.
      EXPECT_NEAR(force.column("hold[6]")[step], spheres.column("tqz")[1],
                  1e-12 * std::hypot(fx, fy) * diameter);
    }
    EXPECT_GT(touching, 30);
  }
}

// Torque about another point: T' = T + (x - p) x F.
TEST(MoveMultisphere, TheTorqueRefersToTheOriginThatIsGiven) {
  const auto torque = [](const std::string& motion) {
    const auto run = finished(bounce(Scene(), motion, 1e-3));
    const Table force = forces_in(run);
    return std::array<double, 3>{force.column("hold[1]")[140], force.column("hold[2]")[140],
                                 force.column("hold[6]")[140]};
  };
  const auto own = torque(""), about = torque("origin 0.02 0.01 0");
  EXPECT_GT(std::fabs(own[0]), 1e-3);
  EXPECT_NEAR(about[2], own[2] + 0.03 * own[1] - 0.04 * own[0], 1e-12 * 0.05 * std::fabs(own[0]));
}

// The laws of nature are the same for one who moves along: a rod that moves steadily does to the
// ball what one at rest does, plus the velocity.
TEST(MoveMultisphere, AMovingBodyIsOneAtRestSeenByOneWhoMoves) {
  const auto end = [](const std::string& integrator, double vx, double vy) {
    Scene scene;
    scene.integrator = integrator;
    // The rod lies along y; the ball hits it obliquely after a while in which both move.
    const std::string motion = "velocity " + exact(vx) + " " + exact(vy) + " 0";
    return bodies_of(finished(
        scene.with(put(1, "rod", 0.05, 0.05, 0, 90) + put(2, "ball", 0.0465, 0.0503, 0.5 + vx),
                   hold("1:9", motion) + "run 250")));
  };
  for (const char* integrator : {"order 3 planar yes", "order 4 planar no"}) {
    const double v = 0.3;
    const Table rest = end(integrator, 0, 0), moving = end(integrator, v, 0);
    EXPECT_GT(std::fabs(rest.column("omegaz")[1]), 1);
    const double way = v * 250 * timestep;
    EXPECT_NEAR(moving.column("x")[0], 0.05 + way, 1e-16);
    EXPECT_NEAR(moving.column("x")[1] - rest.column("x")[1], way, 1e-12);
    EXPECT_NEAR(moving.column("vx")[1] - rest.column("vx")[1], v, 1e-10);
    EXPECT_NEAR(moving.column("y")[1], rest.column("y")[1], 1e-13);
    EXPECT_NEAR(moving.column("vy")[1], rest.column("vy")[1], 1e-10);
    EXPECT_NEAR(moving.column("omegaz")[1], rest.column("omegaz")[1], 1e-7);
  }
}

// A ball hits a held one that turns. Springs alone (eta = 0) give the normal impulse 2 m u; the
// surface of the held one moves by omega r across it, so fast that all the contact slides, and
// friction passes mu times that on: v_t = 2 mu u along the surface's motion, and the spin
// 5/2 v_t / r. So slow that overlap and way along the surface are below 4e-4 of the ball.
TEST(MoveMultisphere, ATurningBodyDragsWhatItTouches) {
  Scene scene;
  scene.damping = "0";
  const double u = 0.005, mu = 0.3, omega = 200;
  // The contact point is on the left of the held ball: omega x (-r, 0) = (0, -omega r).
  const Table end = bodies_of(finished(bounce(scene, "omega 0 0 " + exact(omega), 0, u)));
  EXPECT_NEAR(end.column("vx")[1] / -u, 1, 1e-3);
  EXPECT_NEAR(end.column("vy")[1] / (-2 * mu * u), 1, 1e-3);
  EXPECT_NEAR(end.column("omegaz")[1] / (-2.5 * 2 * mu * u / (0.5 * diameter)), 1, 1e-3);
  EXPECT_EQ(end.column("omegaz")[0], omega);
}

// What the contact sees is the difference of the surfaces' velocities: of equal balls it does not
// matter which of the two turns. The contact sticks, and slides at its ends.
TEST(MoveMultisphere, ItDoesNotMatterWhichOfTwoBallsTurns) {
  for (const char* order : {"2", "3", "4"}) {
    Scene scene;
    scene.integrator = "order " + std::string(order) + " planar yes";
    const double omega = 100;
    const auto collide = [&](double held, double free) {
      // The one that turns freely is set going by being moved so for a step.
      const std::string spin =
          "group free id 2\nfix spin free move/multisphere velocity 0.5 0 0 omega 0 0 " +
          exact(free) + "\nrun 1\nunfix spin\n";
      return bodies_of(
          finished(scene.with(put(1, "heavy", 0.05, 0.05) + put(2, "ball", 0.0465, 0.05, 0.5),
                              hold("1", "omega 0 0 " + exact(held)) + spin + "run 200")));
    };
    const Table of_held = collide(omega, 0), of_free = collide(0, omega);
    EXPECT_GT(std::fabs(of_held.column("vy")[1]), 0.01);
    for (const char* name : {"x", "y", "vx", "vy"})
      EXPECT_NEAR(of_held.column(name)[1], of_free.column(name)[1], 1e-10) << name << order;
    EXPECT_NEAR(of_held.column("omegaz")[1] + omega, of_free.column("omegaz")[1], 1e-7) << order;
  }
}

// All at once, in space and through periodic boundaries: the closed form by Rodrigues' formula,
//   x = p(t) + R(omega t) (x0 - p(0)), p = origin + v t + A sin(2 pi t / T),
// of each sphere, and v = p' + omega x (x - p), to rounding after 20000 steps.
TEST(MoveMultisphere, TheMotionIsTheClosedFormToRounding) {
  Scene scene;
  scene.integrator = "order 3 planar no";
  scene.boundary = "p p p";
  const Vector v = {0.7, -0.45, 0.05}, w = {30, -20, 50}, amplitude = {1e-3, 2e-3, -1e-3},
               origin = {0.047, 0.052, 0.001};
  const double period = 0.07, w_length = std::sqrt(30. * 30 + 20 * 20 + 50 * 50);
  const std::string common =
      "velocity 0.7 -0.45 0.05 omega 30 -20 50 amplitude 1e-3 2e-3 -1e-3 period 0.07";
  for (const bool about_origin : {false, true}) {
    // Of 20000 steps the first and the last are listed.
    const auto run = finished(scene.with(
        put(1, "rod", 0.05, 0.05, 0, 20),
        hold("1:9", common + (about_origin ? " origin 0.047 0.052 0.001" : "")) +
            "undump bodies\nthermo 20000\ndump_modify spheres every 20000\nrun 0\nrun 20000 upto\n"
            "run 1"));
    const Table start = spheres_of(run, 0), ended = spheres_of(run, 1);
    const double t = 19999 * timestep, phase = 2 * M_PI * t / period;
    ASSERT_EQ(ended.timestep(), 20000);
    const Vector axis = {w[0] / w_length, w[1] / w_length, w[2] / w_length};
    const Vector centre = place(start, 4);  // of the middle sphere, the centre of mass
    for (std::size_t i = 0; i < 9; ++i) {
      Vector p0, p, arm, rate;
      for (int d = 0; d < 3; ++d) {
        p0[d] = about_origin ? origin[d] : centre[d];
        p[d] = p0[d] + v[d] * t + amplitude[d] * std::sin(phase);
        rate[d] = v[d] + amplitude[d] * 2 * M_PI / period * std::cos(phase);
        arm[d] = place(start, i)[d] - p0[d];
      }
      arm = turned(arm, axis, w_length * t);
      const Vector swing = cross(w, arm);
      const double box[3] = {0.1, 0.1, 0.01};
      for (int d = 0; d < 3; ++d) {
        const double off = place(ended, i)[d] - (p[d] + arm[d]);
        EXPECT_NEAR(off - box[d] * std::round(off / box[d]), 0, 1e-14) << i << " " << d;
        EXPECT_NEAR(velocity(ended, i)[d], rate[d] + swing[d], 1e-12) << i << " " << d;
      }
      EXPECT_EQ(ended.column("omegaz")[i], w[2]);
    }
  }
}

// Cut in the middle of the contact, with all that a motion can have; on the same ranks to the bit.
TEST(MoveMultisphere, RestartOnAsManyRanksRepeatsTheRunToTheLastBit) {
  const std::string motion =
      "velocity 0.05 0.02 0 omega 0 0 100 origin 0.049 0.05 0 amplitude 1e-4 0 0 period 3e-3";
  const std::pair<const char*, int> cases[] = {
      {"order 3 planar yes", 1}, {"order 3 planar yes", 2}, {"order 4 planar no", 1}};
  for (const auto& [integrator, ranks] : cases) {
    Scene scene;
    scene.integrator = integrator;
    const std::string bodies = put(1, "rod", 0.05, 0.05, 0, 60) + put(2, "ball", 0.046, 0.051, 0.5);
    const auto whole =
        finished(scene.with(bodies, hold("1:9", motion) + "restart 121 half.*\nrun 220"), ranks);
    const Table spheres = spheres_of(whole), expected = bodies_of(whole);
    scene.restart = "half.121";
    const auto on = run_liggghts_in(
        whole.folder,
        scene.with("", "fix hold held move/multisphere " + motion + "\n" + forces + "run 100"), {},
        ranks);
    ASSERT_EQ(on.exit_code, 0) << on.output;
    EXPECT_EQ(bodies_of(on).timestep(), 221);
    for (const char* name : {"x", "y", "z", "vx", "vy", "omegaz"}) {
      EXPECT_EQ(bodies_of(on).column(name), expected.column(name)) << name << ranks;
      EXPECT_EQ(spheres_of(on).column(name), spheres.column(name)) << name << ranks;
    }
  }
}

TEST(MoveMultisphere, AnotherMotionInARestartBeginsWhereTheBodiesAre) {
  Scene scene;
  const auto first = finished(scene.with(
      put(1, "rod", 0.05, 0.05), hold("1:9", "velocity 1 0 0") + "run 100\nwrite_restart half"));
  scene.restart = "half";
  const auto on = run_liggghts_in(
      first.folder,
      scene.with("", "fix hold held move/multisphere velocity 0 2 0\n" + forces + "run 100"));
  ASSERT_EQ(on.exit_code, 0) << on.output;
  EXPECT_NEAR(bodies_of(on).column("x")[0], 0.05 + 100 * timestep, 1e-16);
  EXPECT_NEAR(bodies_of(on).column("y")[0], 0.05 + 200 * timestep, 1e-16);
}

// The rod lies across the borders of the ranks, the balls hit it on both sides of them.
TEST(MoveMultisphere, RanksAgreeWithOneRankToRounding) {
  const std::string deck =
      Scene().with(put(1, "rod", 0.05, 0.05) + put(2, "ball", 0.046, 0.0535, 0.2) +
                       put(3, "ball", 0.053, 0.0466),
                   hold("1:9", "velocity 0.02 0.03 0 omega 0 0 20 origin 0.04 0.05 0") +
                       "fix weight all gravity 20 vector 0 -1 0\nrun 1500");
  const auto one = finished(deck);
  EXPECT_GT(std::fabs(bodies_of(one).column("omegaz")[1]), 1);
  for (const int ranks : {2, 4}) {
    const auto several = finished(deck, ranks);
    for (const char* name : motion_columns)
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(bodies_of(several).column(name)[i], bodies_of(one).column(name)[i], 1e-8)
            << name << i << ranks;
    const Table expected = forces_in(one), found = forces_in(several);
    for (const char* name : {"hold[1]", "hold[2]", "hold[6]"})
      for (std::size_t step = 0; step < expected.rows(); ++step)
        EXPECT_NEAR(found.column(name)[step], expected.column(name)[step], 1e-9) << name << ranks;
  }
}

// Set free, a body goes on with the velocity that it has, as one that is born then.
TEST(MoveMultisphere, ABodyThatIsSetFreeFliesOn) {
  const auto run = finished(Scene().with(put(1, "rod", 0.05, 0.05),
                                         hold("1:9", "velocity 0.3 0.2 0 omega 0 0 40") +
                                             "run 100\nunfix hold\nthermo_style custom step atoms\n"
                                             "fix weight all gravity 9.81 vector 0 -1 0\nrun 200"));
  const double t = 300 * timestep, free = 200 * timestep;
  const Table end = bodies_of(run);
  EXPECT_NEAR(end.column("x")[0], 0.05 + 0.3 * t, 1e-14);
  EXPECT_NEAR(end.column("y")[0], 0.05 + 0.2 * t - 0.5 * 9.81 * free * free, 1e-14);
  EXPECT_NEAR(end.column("vy")[0], 0.2 - 9.81 * free, 1e-13);
  EXPECT_NEAR(end.column("angle")[0], 40 * t, 1e-12);
}

// The mass of a prescribed body has no meaning, so it has no kinetic energy, and its lightness no
// part in the limit of the time step: that of a ball on an infinitely heavy one.
TEST(MoveMultisphere, ItHasNoKineticEnergyAndNoPartInTheStabilityLimit) {
  const auto values = [](const std::string& density) {
    Scene scene;
    scene.density = density;
    const auto run = finished(scene.with(
        put(1, "rod", 0.05, 0.05, 0, 90) + put(2, "ball", 0.04699, 0.05, 0.5),
        hold("1:9", "velocity 0.2 0 0 omega 0 0 3") +
            "compute e all multisphere/ke\nfix stable all check/timestep/multisphere 1 error no\n"
            "thermo_style custom step f_stable c_e[1] c_e[2]\n"
            "thermo_modify norm no lost error format float %.17g\nrun 20"));
    return thermo_of(run, " e[1]");
  };
  const Table light = values("1e-3"), heavy = values("1e4");
  const double mass = 2500 * M_PI / 6 * std::pow(diameter, 3);
  EXPECT_NEAR(light.column("e[1]")[0] / (0.5 * mass * 0.25), 1, 1e-12);
  EXPECT_EQ(light.column("e[2]")[0], 0);
  EXPECT_EQ(light.column("stable").back(), heavy.column("stable").back());  // in contact
  EXPECT_LT(light.column("stable").back(), 0.2);
}

// A floor of glued rods, and one that moves along and turns, under rods that fall.
TEST(MoveMultisphere, ThePlanarEngineMovesThemAlikeOnAnyRanks) {
  const auto run = [](const std::string& style, const std::string& integrator, int ranks) {
    Scene scene;
    scene.integrator = integrator;
    return finished(
        scene.with(put(1, "rod", 0.035, 0.03) + put(2, "rod", 0.0505, 0.0302) +
                       put(3, "rod", 0.066, 0.03) + put(4, "rod", 0.04, 0.0375, 0, 30) +
                       put(5, "rod", 0.064, 0.0425, -0.1, 100) + put(6, "rod", 0.052, 0.048, 0, 10),
                   "fix weight all gravity 9.81 vector 0 -1 0\n"
                   "group plank id 10:18\nfix turn plank move/multisphere velocity 0.01 0 0 omega "
                   "0 0 5\n" +
                       hold("1:9 19:27") + "run_style " + style +
                       "\nthermo 500\ndump_modify bodies every 500\ndump_modify spheres every "
                       "500\nrun 3000"),
        ranks);
  };
  for (const char* integrator : {"order 3 planar yes", "order 4 planar yes events no"}) {
    const auto expected = run("verlet", integrator, 1);
    for (const int ranks : {1, 2}) {
      const auto engine = run("verlet/planar", integrator, ranks);
      EXPECT_THAT(engine.output, HasSubstr("Planar engine: 99"));
      const Table a = bodies_of(expected), b = bodies_of(engine);
      for (const char* name : motion_columns)
        for (std::size_t i = 0; i < 6; ++i)
          EXPECT_NEAR(a.column(name)[i], b.column(name)[i], 1e-8) << name << i << ranks;
      const std::vector<double> forces = forces_in(expected).column("hold[2]"),
                                of_engine = forces_in(engine).column("hold[2]");
      ASSERT_EQ(of_engine.size(), forces.size());
      EXPECT_LT(*std::min_element(forces.begin(), forces.end()), -0.1);
      for (std::size_t k = 0; k < forces.size(); ++k) EXPECT_NEAR(of_engine[k], forces[k], 1e-7);
    }
  }
}

TEST(MoveMultisphere, WhatCannotBeIsOneLineThatNamesIt) {
  const std::string rods = put(1, "rod", 0.05, 0.05) + put(2, "ball", 0.05, 0.06);
  struct Case {
    std::string bodies, after, message;
  };
  const Case cases[] = {
      {rods, "fix hold nobody move/multisphere", "nobody"},
      {rods, "group none id 99\nfix hold none move/multisphere\nrun 1",
       "ERROR: Fix move/multisphere (id hold): group none has no spheres, expected those of bodies "
       "that are there"},
      {rods, "group part id 1:4\nfix hold part move/multisphere\nrun 1",
       "group part has 4 of the 9 spheres of body 1, expected all of them or none"},
      {rods +
           "fix plain all particletemplate/sphere 15485863 atom_type 1 density constant 2500 "
           "radius constant 0.0015\nfix single all nve/sphere/ab\n" +
           put(3, "plain", 0.08, 0.08),
       "fix hold all move/multisphere\nrun 1", "group all has sphere 11 of no body"},
      {rods,
       "group a id 1:9\ngroup b id 1:10\nfix hold a move/multisphere\nfix move b move/multisphere "
       "velocity 1 0 0\nrun 1",
       "Fix move/multisphere (id move): body 1 is moved by fix hold already, expected one of the "
       "two"},
      {rods, "group a id 1:9\nfix hold a move/multisphere velocity 0 0 1\nrun 1",
       "Fix move/multisphere (id hold): moves bodies out of the x-y plane"},
      {rods, "group a id 1:9\nfix hold a move/multisphere amplitude 0 1 0\nrun 1",
       "Fix move/multisphere (id hold): keyword period is missing, expected once"},
      {rods, "group a id 1:9\nfix hold a move/multisphere period 1\nrun 1",
       "keyword amplitude is missing, expected once"},
      {rods, "fix hold all move/multisphere\n" + put(3, "ball", 0.07, 0.07) + "run 5",
       "has come into group all during the run, expected all of its bodies before"},
      {rods,
       "group a id 1:9\nfix hold a move/multisphere omega 0 0 1 origin 0 0 0\nrun_style "
       "verlet/planar\nrun 100",
       "run_style verlet/planar: fix move/multisphere (id hold) swings bodies or turns them about "
       "one point"},
      {rods, "group a id 1:9\nfix hold a move/multisphere\nreset_timestep 0",
       "Cannot reset timestep with a time-dependent fix defined"},
  };
  for (const Case& wrong : cases) {
    const auto run = run_liggghts(Scene().with(wrong.bodies, wrong.after));
    EXPECT_EQ(run.exit_code, 1) << wrong.after;
    EXPECT_THAT(run.output, HasSubstr(wrong.message)) << wrong.after;
  }
  std::string stock = Scene().with(rods, "group a id 1:9\nfix hold a move/multisphere\nrun 1");
  const std::string ours = "multisphere/ab order 3 planar yes";
  stock.replace(stock.find(ours), ours.size(), "multisphere");
  EXPECT_THAT(run_liggghts(stock).output,
              HasSubstr("moves bodies of fix multisphere/ab, expected"));
}

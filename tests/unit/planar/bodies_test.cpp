// SPDX-License-Identifier: GPL-2.0-or-later
// What the planar engine keeps of its bodies.
#include "planar/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "heap.h"
#include "planar/events.h"
#include "planar/blocks.h"
#include "planar_lists/neighbours.h"

namespace rodpack {
namespace {

PlanarBodyStates bodies_of(const PlanarSettings& settings, const std::vector<PlanarBody>& all) {
  return PlanarBodyStates(settings, PlanarParts{static_cast<int>(all.size()), 4}, all);
}

/// The lists of bodies, which note how far these go.
struct Lists {
  PlanarBlocks blocks;
  PlanarDependencies dependencies;
  PlanarNeighbours neighbours;

  Lists(const PlanarSettings& settings, const PlanarBodyStates& bodies)
      : blocks(bodies.size(), 3),
        dependencies(PlanarParts{bodies.size(), 4}),
        neighbours(settings, bodies, PlanarParts{bodies.size(), 4}, blocks, dependencies) {
    neighbours.set_longest_reach(bodies.longest_reach());
    neighbours.list_all();
  }
};

void expect_same_rates(const PlanarRates& a, const PlanarRates& b, double tolerance) {
  for (int d = 0; d < 2; ++d) {
    EXPECT_NEAR(a.velocity[d], b.velocity[d], tolerance);
    EXPECT_NEAR(a.acceleration[d], b.acceleration[d], tolerance);
  }
  EXPECT_NEAR(a.angular_velocity, b.angular_velocity, tolerance);
  EXPECT_NEAR(a.angular_acceleration, b.angular_acceleration, tolerance);
}

}  // namespace

TEST(PlanarBodyStates, TellWhatTheyWereGiven) {
  PlanarSettings settings = settings_of();
  PlanarBody body = moving(rod(5, 0.1, 0.2, 0.3), 1.0, 2.0, 3.0);
  body.tag = 17;
  body.evaluations = 2;
  for (int d = 0; d < 3; ++d) {
    body.load[d] = 0.1 * (d + 1);
    body.missed_displacement[d] = 1e-6 * (d + 1);
    body.missed_velocity[d] = 1e-3 * (d + 1);
  }
  body.past[0] = {{1.0, 2.0}, 3.0, {4.0, 5.0}, 6.0};
  body.past[1] = {{-1.0, -2.0}, -3.0, {-4.0, -5.0}, -6.0};
  const PlanarBodyStates bodies = bodies_of(settings, {rod(2, 0, 0, 0), body});
  EXPECT_EQ(bodies.tag(0), 0) << "its index, where none is given";
  const PlanarBody told = bodies.state(1, 0);
  EXPECT_EQ(told.tag, 17);
  EXPECT_EQ(told.mass, body.mass);
  EXPECT_EQ(told.moment, body.moment);
  ASSERT_EQ(told.spheres.size(), body.spheres.size());
  for (std::size_t k = 0; k < body.spheres.size(); ++k)
    EXPECT_EQ(told.spheres[k].x, body.spheres[k].x);
  EXPECT_EQ(told.position[1], 0.2);
  EXPECT_EQ(told.sine, body.sine);
  EXPECT_EQ(told.evaluations, 2);
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(told.velocity[d], body.velocity[d]);
    EXPECT_EQ(told.load[d], body.load[d]);
    EXPECT_EQ(told.missed_displacement[d], body.missed_displacement[d]);
    EXPECT_EQ(told.missed_velocity[d], body.missed_velocity[d]);
  }
  for (int k = 0; k < 2; ++k) expect_same_rates(told.past[k], body.past[k], 0.0);
}

// The end of a straight chain of length L = AR d, turning at w about its centre that moves at v:
// |v| + |w| L/2 in a second, at most.
TEST(PlanarBodyStates, StepDisplacementIsThatOfTheEndOfARod) {
  PlanarSettings settings = settings_of();
  const PlanarBodyStates bodies = bodies_of(settings, {moving(rod(5, 0, 0, 1), 0.3, -0.4, -20)});
  const double reach = 2.5 * diameter;
  EXPECT_NEAR(bodies.info(0).reach, reach, 1e-14 * reach);
  EXPECT_NEAR(bodies.longest_reach(), reach, 1e-14 * reach);
  EXPECT_NEAR(bodies.step_displacement(0), (0.5 + 20 * reach) * settings.dt, 1e-18);
}

// Missed motion is made at the beginning of the next step: a displacement turns the rod too. It is
// a part of the path: the end of the rod, 2.5 d from its centre, goes on an arc of that radius.
TEST(PlanarBodyStates, MissedMotionIsMadeOnce) {
  PlanarSettings settings = settings_of();
  PlanarBody body = moving(rod(5, 0.1, 0.2, 0.3), 1.0, 2.0, 3.0);
  body.evaluations = 4;
  const double displacement[3] = {1e-6, -2e-6, 0.01}, velocity[3] = {0.1, 0.2, -0.5};
  std::copy_n(displacement, 3, body.missed_displacement);
  std::copy_n(velocity, 3, body.missed_velocity);
  PlanarBodyStates bodies = bodies_of(settings, {body});
  Lists lists(settings, bodies);
  for (int times = 0; times < 2; ++times) {
    bodies.prepare(0, 0, lists.neighbours);
    EXPECT_NEAR(lists.neighbours.travelled()[0],
                2e-6 + (std::sqrt(2.0) - 1.0) * 1e-6 + 0.01 * 2.5 * diameter, 1e-14);
    const PlanarKinematics& kinematics = bodies.kinematics(0);
    EXPECT_NEAR(kinematics.x, 0.1 + 1e-6, 1e-16);
    EXPECT_NEAR(kinematics.y, 0.2 - 2e-6, 1e-16);
    EXPECT_NEAR(kinematics.cosine, std::cos(0.31), 1e-15);
    EXPECT_NEAR(kinematics.sine, std::sin(0.31), 1e-15);
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(kinematics.velocity[d], body.velocity[d] + velocity[d], 1e-15);
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ(bodies.state(0, 0).missed_displacement[d], 0.0);
      EXPECT_EQ(bodies.state(0, 0).missed_velocity[d], 0.0);
    }
  }
}

// Before its first step a body is taken to have moved under its load at birth, held constant:
// v(-k dt) = v - k dt F/m; forces before birth are 0, as the start-up of the multistep formula
// wants it (rigid_motion.h).
TEST(PlanarBodyStates, TheNewbornGetAPastOfConstantAcceleration) {
  PlanarSettings settings = settings_of();
  PlanarBody body = moving(rod(5, 0, 0, 0), 1.0, 2.0, 3.0);
  const double load[3] = {1e-3, -2e-3, 1e-7};
  std::copy_n(load, 3, body.load);
  PlanarBodyStates bodies = bodies_of(settings, {body});
  Lists lists(settings, bodies);
  bodies.prepare(0, 0, lists.neighbours);
  const PlanarBody told = bodies.state(0, 0);
  for (int k = 1; k <= 2; ++k) {
    const double age = k * settings.dt;
    expect_same_rates(told.past[k - 1],
                      {{1.0 - age * load[0] / body.mass, 2.0 - age * load[1] / body.mass},
                       3.0 - age * load[2] / body.moment,
                       {0.0, 0.0},
                       0.0},
                      1e-15);
  }
}

namespace {

/// A body with a record of every past step, all of them different.
PlanarBody with_past(int order) {
  PlanarBody body = moving(rod(5, 0.01, 1.4e-3, 0), 0.1, 0.2, 3.0);
  body.evaluations = order + 1;
  for (int k = 0; k < order - 1; ++k)
    body.past[k] = {{1.0 + k, 2.0 + k}, 3.0 + k, {4.0 + k, 5.0 + k}, 6.0 + k};
  return body;
}

/// Makes the step from `step` on, of the only part.
void advance(PlanarBodyStates& bodies, PlanarNeighbours& neighbours, long step) {
  std::vector<int> to_list;
  bodies.prepare(0, step, neighbours);
  bodies.advance(0, step, planar_kernel(PlanarInstructions::baseline, false), neighbours, 0,
                 to_list);
}

}  // namespace

// Each step adds the velocity and the acceleration F/m, T/I with which it began, and makes the
// others older by one. The loads are kept different from step to step by gravity that is not the
// load before.
TEST(PlanarBodyStates, PastIsThatOfTheStepsBefore) {
  for (const int order : {2, 3, 4}) {
    PlanarSettings settings = settings_of();
    settings.order = order;
    settings.gravity[1] = -9.81;
    PlanarBody body = with_past(order);
    const double load[3] = {1e-3, -2e-3, 1e-7};
    std::copy_n(load, 3, body.load);
    const PlanarParts parts = {1, 4};
    PlanarBodyStates bodies(settings, parts, {body});
    Lists lists(settings, bodies);
    for (long step = 0; step < 4; ++step) {
      const PlanarBody before = bodies.state(0, step);
      advance(bodies, lists.neighbours, step);
      const PlanarBody after = bodies.state(0, step + 1);
      expect_same_rates(after.past[0],
                        {{before.velocity[0], before.velocity[1]},
                         before.velocity[2],
                         {before.load[0] / body.mass, before.load[1] / body.mass},
                         before.load[2] / body.moment},
                        1e-12);
      for (int k = 1; k < order - 1; ++k) expect_same_rates(after.past[k], before.past[k - 1], 0.0);
    }
  }
}

// A constant force F has begun s ago at the contact of a sphere, at the end of an arm along x, with
// the floor: with the torque T = lever x F. The step lacks the velocity F s/m and the displacement
// F s^2/(2 m). Continued backwards, the force is F at all times, and the velocity that it makes of
// 0 at its beginning is F (s - t)/m at a time t ago; the same of the torque and the rotation.
TEST(PlanarBodyStates, AnEventCorrectsThePastAndLeavesWhatWasMissed) {
  for (const int order : {2, 3, 4})
    for (const long step : {0, 1, 2}) {
      PlanarSettings settings = settings_of();
      settings.order = order;
      const PlanarParts parts = {1, 4};
      PlanarBodyStates bodies(settings, parts, {with_past(order)});
      PlanarEvents events(parts);
      events.resize(1);
      PlanarContact contact = PlanarContact();
      contact.body_i = 0;
      contact.radi = 0.5 * diameter;
      contact.offset_i[0] = 4e-3;
      PlanarKinematics at_rest = bodies.kinematics(0);
      std::fill_n(at_rest.velocity, 3, 0.0);
      place_wall(contact, at_rest, PlanarWall{1, 0.0, 0});
      const double s = 0.3 * settings.dt, force[3] = {0.02, 0.05, 0.0};
      const double lever[2] = {4e-3,
                               -0.5 * (0.5 * diameter + 1.4e-3)};  // to the middle of the lens
      const double torque = lever[0] * force[1] - lever[1] * force[0];
      events.add(contact, linear_change(force, {0, 0, 0}, s), true);

      const PlanarBody before = bodies.state(0, step);
      bodies.apply_events(0, step, events);
      const PlanarBody after = bodies.state(0, step);
      const double acceleration[3] = {force[0] / before.mass, force[1] / before.mass,
                                      torque / before.moment};
      ASSERT_TRUE(events.jumped(0));
      for (int d = 0; d < 3; ++d) {
        const double a = acceleration[d];
        EXPECT_NEAR(after.missed_velocity[d], a * s, 1e-12 * std::fabs(a * s));
        EXPECT_NEAR(after.missed_displacement[d], a * s * s / 2, 1e-12 * std::fabs(a * s * s));
        EXPECT_NEAR(events.jump(0).acceleration[d], a, 1e-12 * std::fabs(a));
      }
      for (int k = 0; k < order - 1; ++k) {
        const double share = s - (k + 1) * settings.dt;
        const PlanarRates& old = before.past[k];
        expect_same_rates(
            after.past[k],
            {{old.velocity[0] + share * acceleration[0], old.velocity[1] + share * acceleration[1]},
             old.angular_velocity + share * acceleration[2],
             {old.acceleration[0] + acceleration[0], old.acceleration[1] + acceleration[1]},
             old.angular_acceleration + acceleration[2]},
            1e-9);
      }
      events.each_changed(0, [](int body, bool) { ADD_FAILURE() << body << " was corrected"; });
    }
}

TEST(PlanarBodyStates, LoadsBeginWithTheWeight) {
  PlanarSettings settings = settings_of();
  settings.gravity[0] = 1.0;
  settings.gravity[1] = -9.81;
  PlanarBody body = rod(5, 0, 0, 0);
  body.load[2] = 1.0;
  PlanarBodyStates bodies = bodies_of(settings, {body});
  bodies.begin_loads();
  const PlanarBody told = bodies.state(0, 0);
  EXPECT_EQ(told.load[0], body.mass);
  EXPECT_EQ(told.load[1], -9.81 * body.mass);
  EXPECT_EQ(told.load[2], 0.0);
}

// Spheres of ghosts lie behind those of the bodies of the rank, and are given anew with them.
TEST(PlanarBodyStates, GhostsComeAndGo) {
  PlanarSettings settings = settings_of();
  PlanarBodyStates bodies = bodies_of(settings, {rod(2, 0, 0, 0), rod(3, 0.1, 0, 0)});
  bodies.resize(4);
  const auto ghost_of = [](int tag, double aspect_ratio) {
    PlanarBody body = moving(rod(aspect_ratio, 0.2, 0.01 * tag, 0.5), 1.0, 0.0);
    body.tag = tag;
    return body;
  };
  bodies.set_ghost(2, ghost_of(20, 5));
  bodies.set_ghost(3, ghost_of(30, 4));
  EXPECT_EQ(bodies.owned(), 2);
  EXPECT_EQ(bodies.size(), 4);
  bodies.forget_ghost_spheres();
  bodies.clear_ghost(2);
  bodies.set_ghost(3, ghost_of(30, 4));
  EXPECT_EQ(bodies.info(2).count, 0);
  EXPECT_TRUE(bodies.comes_first(1, 3));
  const PlanarBody told = bodies.present(3), expected = ghost_of(30, 4);
  ASSERT_EQ(told.spheres.size(), 7u);
  for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(told.spheres[k].x, expected.spheres[k].x);
  EXPECT_EQ(told.position[1], expected.position[1]);
  PlanarKinematics moved = bodies.kinematics(3);
  moved.x = 0.3;
  moved.radius = 0.0;
  bodies.move_ghost(3, moved);
  EXPECT_EQ(bodies.kinematics(3).x, 0.3);
  EXPECT_EQ(bodies.kinematics(3).radius, 0.5 * diameter) << "a message does not tell it";
}

}  // namespace rodpack

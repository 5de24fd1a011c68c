// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/friction_step.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace rodpack;

namespace {

// stiffness 100 N/m, damping 2 kg/s, cap 1 N at the end of a step of 1 ms and growing by 50 N/s
FrictionStep contact() {
  FrictionStep step = {};
  step.stiffness = 100;
  step.damping = 2;
  step.cap = 1;
  step.cap_rate = 50;
  step.dt = 1e-3;
  step.known = 3;
  return step;
}

void set_velocities(FrictionStep& step, double now, double before, double earlier) {
  step.velocity[0][0] = now;
  step.velocity[1][0] = before;
  step.velocity[2][0] = earlier;
}

}  // namespace

TEST(FrictionStep, SticksBelowTheCap) {
  FrictionStep step = contact();
  set_velocities(step, 0.01, 0.01, 0.01);
  double spring[3] = {5e-3, 0, 0};
  const FrictionForce f = friction_force(step, spring);
  EXPECT_FALSE(f.slides);
  EXPECT_FALSE(f.changed);
  EXPECT_DOUBLE_EQ(f.force[0], -(100 * 5e-3 + 2 * 0.01));
  EXPECT_DOUBLE_EQ(spring[0], 5e-3);
}

// While the surface still moves against the force, it goes on sliding, even where spring and
// dashpot would fit under the cap that has grown meanwhile.
TEST(FrictionStep, SlidesUntilTheVelocityVanishes) {
  FrictionStep step = contact();
  step.slid = true;
  step.spring_before[0] = 9.5e-3;  // carried the cap of 0.95 N one step ago
  set_velocities(step, 0.01, 0.02, 0.03);
  double spring[3] = {9.515e-3, 0, 0};  // |force| would be 0.9715 N
  const FrictionForce f = friction_force(step, spring);
  EXPECT_TRUE(f.slides);
  EXPECT_FALSE(f.changed);
  EXPECT_DOUBLE_EQ(f.force[0], -1);
  EXPECT_DOUBLE_EQ(spring[0], 1e-2);
}

// v(t) = -10 t + 2000 t^2, t in s before and after standstill at t = 0; the step ends at 0.4 ms.
// The spring is what carried the cap at standstill, 1 - 50 * 0.4e-3 = 0.98 N, and the way since,
// int v dt = -8e-7 m to leading order.
TEST(FrictionStep, SticksFromTheMomentOfStandstill) {
  FrictionStep step = contact();
  step.slid = true;
  step.spring_before[0] = 9.5e-3;
  const auto v = [](double t) { return -10 * t + 2000 * t * t; };
  set_velocities(step, v(0.4e-3), v(-0.6e-3), v(-1.6e-3));
  double spring[3] = {9.51e-3, 0, 0};
  const FrictionForce f = friction_force(step, spring);
  EXPECT_FALSE(f.slides);
  EXPECT_TRUE(f.changed);
  EXPECT_FALSE(f.jumps);
  EXPECT_NEAR(f.since, 0.4e-3, 1e-12);
  EXPECT_NEAR(spring[0], 0.98 / 100 - 8e-7, 3e-7);
  EXPECT_NEAR(f.force[0], -(100 * spring[0] + 2 * v(0.4e-3)), 1e-15);
  EXPECT_NEAR(f.gain[0], f.force[0] + 1, 1e-15);  // the slide would go on with -1 N
  // -(k v + c dv/dt), and the cap's -50 N/s no more
  EXPECT_NEAR(f.gain_rate[0], -100 * v(0.4e-3) - 2 * (v(0.4e-3) - v(-0.6e-3)) / 1e-3 + 50, 1e-9);
}

// The force grows from 0.90 N under a cap of 0.95 N to 1.04 N, beyond the cap of 1 N: it crossed
// where the excess, from -0.05 N to 0.04 N, was 0.
TEST(FrictionStep, FindsTheMomentAtWhichTheCapIsReached) {
  FrictionStep step = contact();
  step.spring_before[0] = 8e-3;
  set_velocities(step, 0.06, 0.05, 0.04);
  double spring[3] = {9.2e-3, 0, 0};
  const FrictionForce f = friction_force(step, spring);
  EXPECT_TRUE(f.slides);
  EXPECT_TRUE(f.changed);
  EXPECT_NEAR(f.since, 1e-3 * 0.04 / 0.09, 1e-15);
  EXPECT_NEAR(f.force[0], -1, 1e-15);
  EXPECT_NEAR(f.gain[0], 0.04, 1e-15);
  EXPECT_NEAR(f.gain_rate[0], 0.09 / 1e-3, 1e-9);  // from nothing at the change
}

// A cap drop: the cap falls below the force while the spring moves the surfaces (velocity along the
// force). Until then the spring carried the cap and the dashpot, 2 * 0.05 N against it; now it is
// shortened to what carries the cap. So the force falls by those 0.1 N at once, whenever the drop
// was, and by no more later, since the spring stays short by the same length.
TEST(FrictionStep, CapDropTakesTheDashpotsShareFromTheSpring) {
  FrictionStep step = contact();
  step.cap_rate = -60;  // 1.06 N one step ago
  step.spring_before[0] = 11.5e-3;
  set_velocities(step, -0.05, -0.05, -0.05);
  double spring[3] = {11.45e-3, 0, 0};  // 1.045 N
  const FrictionForce f = friction_force(step, spring);
  EXPECT_FALSE(f.slides);
  EXPECT_TRUE(f.changed);
  EXPECT_TRUE(f.jumps);
  // excess before: 1.05 - 1.06, now 1.045 - 1
  const double since = 1e-3 * 0.045 / (0.045 + 0.01);
  EXPECT_NEAR(f.since, since, 1e-12);
  EXPECT_NEAR(spring[0], (1 + 60 * since) / 100 - 0.05 * since, 1e-12);
  EXPECT_NEAR(f.force[0], -(100 * spring[0] - 2 * 0.05), 1e-12);
  EXPECT_NEAR(f.gain[0], 2 * 0.05, 1e-12);
  EXPECT_NEAR(f.gain[0], f.force[0] + (100 * 11.45e-3 - 2 * 0.05), 1e-12);  // over no drop at all
  EXPECT_EQ(f.gain_rate[0], 0);
}

// In space the surface may move across the force when it stands along it: the dashpot of that
// motion acts at once, whenever the change was, and its rate has to stay bounded.
TEST(FrictionStep, AVelocityAcrossTheForceMakesItJump) {
  for (const double now : {5e-3, 1e-4, 1e-6, 1e-8}) {
    const double across = 0.5 * std::sqrt(now);
    FrictionStep step = contact();
    step.slid = true;
    step.spring_before[0] = 9.5e-3;
    set_velocities(step, -now, 0.01 - now, 0.02 - now);
    for (auto& velocity : step.velocity) velocity[1] = across;
    double spring[3] = {9.5e-3, 0, 0};
    const FrictionForce f = friction_force(step, spring);
    EXPECT_TRUE(f.changed && f.jumps && !f.slides);
    EXPECT_NEAR(f.since, 1e-3 * now / 0.01, 1e-9);
    EXPECT_NEAR(f.gain[1] / (-2 * across - 100 * across * f.since), 1, 1e-9);
    EXPECT_NEAR(f.gain_rate[1], -100 * across, 1e-9);
  }
}

// The spring that carries the cap of 1 N and the dashpot of a velocity across it make more than the
// cap, if they are not relieved by 2 N s/m times the velocity along: 2 v^2 > 2 * v_x, so that the
// contact cannot stick; the same where the cap drops.
TEST(FrictionStep, ItCannotStickWhereTheVelocityAcrossIsTooLarge) {
  for (const bool slid : {false, true})
    for (const double across : {0.09, 0.11}) {
      const double along = 0.01;  // with the force; 0.1^2 + 0.01^2 is the limit, but for 1 %
      FrictionStep step = contact();
      step.slid = slid;
      step.spring_before[0] = 1e-2;
      for (auto& velocity : step.velocity) {
        velocity[0] = -along;
        velocity[1] = across;
      }
      if (slid) set_velocities(step, -along, along, 3 * along);
      double spring[3] = {1.2e-2, -0.02 * across, 0};  // the trial force lies along x
      const FrictionForce f = friction_force(step, spring);
      EXPECT_EQ(f.slides, across > 0.1) << slid;
      EXPECT_LE(std::hypot(f.force[0], f.force[1]), 1 + 1e-14);
    }
}

// The slide goes on against the velocity, which has turned; the cap of 1 N over the damping of 2
// kg/s is 0.5 m/s.
TEST(FrictionStep, AFastSlideActsAgainstTheVelocity) {
  FrictionStep step = contact();
  step.slid = true;
  step.spring_before[0] = 9.5e-3;
  for (const double speed : {0.5, 1.0, 20.0}) {
    step.velocity[0][0] = 0.6 * speed;
    step.velocity[0][2] = 0.8 * speed;
    double spring[3] = {9.6e-3, 0, 0};
    const FrictionForce f = friction_force(step, spring);
    EXPECT_TRUE(f.slides && !f.changed);
    EXPECT_NEAR(f.force[0], -0.6, 1e-15);
    EXPECT_NEAR(f.force[2], -0.8, 1e-15);
    EXPECT_NEAR(spring[0], 0.6 / 100, 1e-17);
    EXPECT_NEAR(spring[2], 0.8 / 100, 1e-17);
  }
}

// Across the slide the force grows with the velocity by the cap over the speed, as the direction
// does, and never by more than its bodies bear: the dashpot of 2 kg/s, or a mass of 80 g over
// twenty steps.
TEST(FrictionStep, TheForceAcrossASlideIsNoStifferThanTheBodiesBear) {
  for (const double mass : {0.0, 0.08})
    for (const double speed : {1e-6, 1e-3, 0.1, 0.24, 0.26, 0.49, 0.51, 4.0}) {
      FrictionStep step = contact();
      step.mass = mass;
      step.slid = true;
      step.spring_before[0] = 1e-2;
      step.velocity[0][0] = speed;
      step.velocity[0][1] = 1e-6 * speed;
      double spring[3] = {1e-2, 0, 0};
      const FrictionForce f = friction_force(step, spring);
      EXPECT_NEAR(f.force[1] / (-1e-6 * speed), std::min(mass > 0 ? 4.0 : 2.0, 1 / speed), 1e-6);
    }
}

// The spring pulls with 0.3 N against x, the dashpot with 1 N against y, where the surface moves:
// the slide begins against the velocity alone.
TEST(FrictionStep, ASlideThatBeginsAcrossTheForceMakesItJump) {
  FrictionStep step = contact();
  step.spring_before[0] = 3e-3;
  for (auto& velocity : step.velocity) velocity[1] = 0.5;
  step.cap_rate = 0;
  double spring[3] = {3e-3, 0.5e-3, 0};
  const FrictionForce f = friction_force(step, spring);
  EXPECT_TRUE(f.slides && f.changed && f.jumps);
  EXPECT_NEAR(f.force[0], 0, 1e-15);
  EXPECT_NEAR(f.force[1], -1, 1e-15);
  EXPECT_NEAR(f.gain[0], 0.3, 1e-15);  // over -100 s - 2 v
  EXPECT_NEAR(f.gain[1], -1 + 1.05, 1e-15);
  EXPECT_NEAR(f.gain_rate[0], 0, 1e-12);
  EXPECT_NEAR(f.gain_rate[1], 100 * 0.5, 1e-9);  // the trial force would have grown by k v
}

// Whatever the law does, the force stays under the cap.
TEST(FrictionStep, ForceNeverExceedsTheCap) {
  for (const bool slid : {false, true})
    for (const double v : {-0.4, -0.05, 0.0, 0.05, 0.4})
      for (const double s : {-3e-2, -5e-3, 0.0, 5e-3, 3e-2})
        for (const double cap : {0.0, 0.3, 1.0}) {
          FrictionStep step = contact();
          step.slid = slid;
          step.cap = cap;
          step.spring_before[0] = s;
          set_velocities(step, v, -v, v);
          double spring[3] = {s + 1e-3 * v, 0, 0};
          EXPECT_LE(std::fabs(friction_force(step, spring).force[0]), cap * (1 + 1e-14));
        }
}

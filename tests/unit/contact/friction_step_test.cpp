// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/friction_step.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

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
  step.normal[2] = 1;
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
// force). Until then the spring carried the cap and the dashpot, 2 * 0.15 N against it; now it is
// shortened to what carries the cap. So the force falls by those 0.3 N at once, whenever the drop
// was, and by no more later, since the spring stays short by the same length.
TEST(FrictionStep, CapDropTakesTheDashpotsShareFromTheSpring) {
  FrictionStep step = contact();
  step.cap_rate = -60;  // 1.06 N one step ago
  step.spring_before[0] = 13.5e-3;
  set_velocities(step, -0.15, -0.15, -0.15);
  double spring[3] = {13.35e-3, 0, 0};  // 1.035 N
  const FrictionForce f = friction_force(step, spring);
  EXPECT_FALSE(f.slides);
  EXPECT_TRUE(f.changed);
  EXPECT_TRUE(f.jumps);
  // excess before: 1.05 - 1.06, now 1.035 - 1
  const double since = 1e-3 * 0.035 / (0.035 + 0.01);
  EXPECT_NEAR(f.since, since, 1e-12);
  EXPECT_NEAR(spring[0], (1 + 60 * since) / 100 - 0.15 * since, 1e-12);
  EXPECT_NEAR(f.force[0], -(100 * spring[0] - 2 * 0.15), 1e-12);
  EXPECT_NEAR(f.gain[0], 2 * 0.15, 1e-12);
  EXPECT_NEAR(f.gain[0], f.force[0] + (100 * 13.35e-3 - 2 * 0.15), 1e-12);  // over no drop at all
  EXPECT_EQ(f.gain_rate[0], 0);
}

// Under a cap that falls on, the force goes up to it again: the cap falls by 60 N/s and the force
// by k v, so that the 2 v that a drop takes off it last for 2 v / (60 - 100 v) s. Drops that come
// sooner than every fourth step are made, but not followed; those of contacts that have just
// touched are in any case.
TEST(FrictionStep, CapDropsAreFollowedIfTheirTeethLastFourSteps) {
  for (const double teeth : {0.5, 3.99, 4.01, 30.0}) {
    const double v = 60 * teeth * 1e-3 / (2 + 100 * teeth * 1e-3);
    for (const bool just_touched : {false, true}) {
      FrictionStep step = contact();
      step.cap_rate = -60;
      step.since_touch = just_touched ? 0.5e-3 : 0;
      step.spring_before[0] = (1.06 + 2 * v) / 100;  // no excess one step ago
      set_velocities(step, -v, -v, -v);
      double spring[3] = {step.spring_before[0] - 1e-3 * v, 0, 0};
      const FrictionForce f = friction_force(step, spring);
      EXPECT_EQ(f.changed, just_touched || teeth > 4) << teeth;
      EXPECT_EQ(f.jumps, f.changed) << teeth;
      EXPECT_FALSE(f.slides);
      // The spring carried the cap at the beginning of the step, and has moved since; it carries
      // that of now where the tooth is shorter than the step.
      const double spring_force = std::min(1.06 - 100e-3 * v, teeth < 1 ? 1.0 : 2.0);
      EXPECT_NEAR(f.force[0], -(spring_force - 2 * v), 1e-12) << teeth;
    }
  }
}

// In space the surface may move across the force when it stands along it. The slide ends where
// spring and dashpot together have come down to the cap: (1 N + c v_x)^2 + c^2 v_y^2 = 1 N^2 with
// v_x = -10 (t - t0), so that there is no jump, whenever the change was.
TEST(FrictionStep, ASlideWithAVelocityAcrossEndsWhereTheLoadIsTheCap) {
  const double across = 0.05, aside = 2 * across * across / 2;  // c v_y^2 / (2 cap), m/s, nearly
  for (const double now : {5e-3, 1e-4}) {
    FrictionStep step = contact();
    step.cap_rate = 0;
    step.stiffness = 1e-3;  // the spring turns by no more than 1e-7
    step.slid = true;
    step.spring_before[0] = 1 / step.stiffness;
    const double at_change = -0.5 * (1 - std::sqrt(1 - std::pow(2 * across, 2)));
    set_velocities(step, at_change - now, at_change - now + 0.01, at_change - now + 0.02);
    for (auto& velocity : step.velocity) velocity[1] = across;
    double spring[3] = {1 / step.stiffness, 0, 0};
    const FrictionForce f = friction_force(step, spring);
    EXPECT_TRUE(f.changed && !f.jumps && !f.slides);
    EXPECT_NEAR(at_change, -aside, 0.01 * aside);
    EXPECT_NEAR(f.since, 1e-3 * now / 0.01, 1e-9);
    const double sliding = std::hypot(1 + 2 * (at_change - now), 2 * across);
    EXPECT_NEAR(f.force[0], -(1 + 2 * (at_change - now)), 1e-6);
    EXPECT_NEAR(f.gain[1], -2 * across * (1 - 1 / sliding), 1e-6);
    // The slide's force only turns, by c dv/dt across it.
    EXPECT_NEAR(f.gain_rate[0], 20 - 20 * std::pow(2 * across / sliding, 2) / sliding, 1e-3);
  }
}

// The spring that carries the cap of 1 N and the dashpot of a velocity across it make more than the
// cap, if they are not relieved by 2 N s/m times the velocity along: 2 v^2 > 2 * v_x, so that the
// contact cannot stick; the same where the cap drops, but that the force jumps then. Where it can,
// the drop is too small to be followed.
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
      EXPECT_EQ(f.jumps, !slid && f.slides) << across;
      EXPECT_LE(std::hypot(f.force[0], f.force[1]), 1 + 1e-14);
    }
}

namespace {

/// The spring of a slide under this velocity for `time`, in `steps` steps, from the direction x.
struct Slide {
  double damping = 0, speed = 0.5, angle = 1.2, cap = 1, stiffness = 100;
  double turn_of_velocity = 0;  // 1/s

  double spring_angle(double time, int steps) const {
    double spring[3] = {cap / stiffness, 0, 0};
    for (int k = 1; k <= steps; ++k) {
      FrictionStep step = contact();
      step.stiffness = stiffness;
      step.damping = damping;
      step.cap = cap;
      step.cap_rate = 0;
      step.dt = time / steps;
      step.slid = true;
      std::copy(spring, spring + 3, step.spring_before);
      for (int back = 0; back < 3; ++back) {
        const double now = angle + turn_of_velocity * (k - back) * step.dt;
        step.velocity[back][0] = speed * std::cos(now);
        step.velocity[back][1] = speed * std::sin(now);
      }
      turn_slide(step, spring);
      EXPECT_NEAR(std::hypot(spring[0], spring[1]), cap / stiffness, 1e-16);
    }
    return std::atan2(spring[1], spring[0]);
  }
};

}  // namespace

// Under a constant velocity the angle x between it and the spring has dx/dt = -k v sin(x) / N, with
// N = cap and no dashpot: tan(x / 2) falls with exp(-k v t / cap), in third order of the step. With
// c v far above the cap it is exp(-k t / c).
TEST(SlideTurning, TheSpringTurnsTowardsTheVelocityAsTheClosedFormHasIt) {
  Slide slide;
  const auto error = [&](int steps) {
    const double left = std::tan(0.6) * std::exp(-100 * 0.5 * 0.03);
    return std::fabs(slide.spring_angle(0.03, steps) - (1.2 - 2 * std::atan(left)));
  };
  EXPECT_NEAR(std::log2(error(16) / error(32)), 3, 0.2);
  EXPECT_LT(error(32), 1e-6);
  slide.damping = 2e8;
  const double left = std::tan(0.6) * std::exp(-1.0);
  EXPECT_NEAR(slide.spring_angle(2e6, 64), 1.2 - 2 * std::atan(left), 1e-6);
}

// While the velocity turns at w, the spring follows with the lag x that sin(x) = w N / (k v) makes
// steady: N = cap without dashpot. That holds where the surfaces slip by many of the spring's
// lengths in a step, too.
TEST(SlideTurning, TheSpringLagsBehindAVelocityThatTurnsByTheSameWayInAnyStep) {
  Slide slide;
  slide.turn_of_velocity = 5;
  const double lag = std::asin(5 * 1 / (100 * 0.5));
  for (const int steps : {300, 30})
    EXPECT_NEAR(slide.spring_angle(0.3, steps), 1.2 + 5 * 0.3 - lag, 1e-5) << steps;
  slide.stiffness = 1e9;
  EXPECT_NEAR(slide.spring_angle(0.3, 30), 1.2 + 5 * 0.3 - 1e-8, 1e-10);
}

namespace {

/// A contact alone, whose velocity and cap are given: it slides, turns, sticks at 0.4709 s, and
/// slides again from 0.8064 s on.
struct GivenMotion {
  double stiffness = 1000, damping = 2;
  static void velocity(double t, double (&v)[3]) {
    v[0] = 0.1 * std::cos(3 * t) - 0.12 * t;
    v[1] = 0.06 * std::sin(5 * t);
    v[2] = 0;
  }
  static double cap(double t) { return 20 + 5 * std::sin(2 * t); }

  /// The spring at `end`, how often the branch has changed, and when for the last time.
  std::array<double, 4> run(double end, int steps) const {
    std::array<double, 4> result{};
    double spring[3] = {cap(0) / stiffness, 0, 0};
    bool slid = true;
    for (int n = 1; n <= steps; ++n) {
      const double dt = end / steps, t = n * dt;
      FrictionStep step = contact();
      step.stiffness = stiffness;
      step.damping = damping;
      step.cap = cap(t);
      step.cap_rate = 10 * std::cos(2 * t);
      step.cap_curvature = -20 * std::sin(2 * t);
      step.dt = dt;
      step.slid = slid;
      for (int k = 0; k < 3; ++k) velocity(t - k * dt, step.velocity[k]);
      std::copy(spring, spring + 3, step.spring_before);
      double now[3], middle[3], before[3];
      velocity(t, now);
      velocity(t - 0.5 * dt, middle);
      velocity(t - dt, before);
      for (int d = 0; d < 3; ++d) spring[d] += dt / 6 * (before[d] + 4 * middle[d] + now[d]);
      const FrictionForce f = friction_force(step, spring);
      slid = f.slides;
      if (!f.changed) continue;
      EXPECT_FALSE(f.jumps);
      result[2] += 1;
      result[3] = t - f.since;
    }
    result[0] = spring[0];
    result[1] = spring[1];
    return result;
  }
};

}  // namespace

// Against steps 64 times as fine. A spring that a slide leaves behind is there for good.
TEST(FrictionStep, InSpaceBothChangesOfBranchAreOfThirdOrder) {
  const GivenMotion motion;
  for (const double end : {0.6, 1.0}) {
    const int changes = end < 0.8 ? 1 : 2;
    const auto exact = motion.run(end, 64 * 46);
    EXPECT_EQ(exact[2], changes);
    EXPECT_NEAR(exact[3], changes == 1 ? 0.4709 : 0.8064, 1e-4);
    double errors[2];
    for (const int finer : {0, 1}) {
      const auto found = motion.run(end, finer ? 92 : 23);
      EXPECT_EQ(found[2], changes);
      errors[finer] = std::hypot(found[0] - exact[0], found[1] - exact[1]);
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]) / 2, 2.6) << end;
    EXPECT_LT(errors[0], 2e-6);  // m, of a spring of 25 mm
  }
}

// What a velocity across the slide does to the force in a step: no more than the dashpot and the
// spring of a contact that sticks, c and k dt, however slow the slide.
TEST(FrictionStep, TheForceAcrossASlideIsNoStifferThanThatOfAStuckContact) {
  for (const double speed : {1e-6, 1e-3, 0.1, 0.5, 4.0, 1e3}) {
    FrictionStep step = contact();
    step.slid = true;
    step.spring_before[0] = 1e-2;
    step.velocity[0][0] = step.velocity[1][0] = step.velocity[2][0] = speed;
    step.velocity[0][1] = 1e-6 * speed;
    double spring[3] = {1e-2, 0, 0};
    const FrictionForce f = friction_force(step, spring);
    EXPECT_TRUE(f.slides && !f.changed);
    const double dashpot = -f.force[1] / (1e-6 * speed);
    EXPECT_LT(dashpot, 2 + 100 * 1e-3);
    EXPECT_GT(dashpot, 2 / (1 + 2 * speed));  // F_cap c / (F_cap + c v), of the dashpot alone
  }
}

// The spring pulls with 0.6 N against x and the dashpot with 0.2 N; that against y, where the
// surface moves ever faster, makes the cap with 0.6 N. The force goes on from there.
TEST(FrictionStep, ASlideThatBeginsAcrossTheForceGoesOnContinuously) {
  for (const double beyond : {1e-3, 1e-2, 2e-2}) {
    FrictionStep step = contact();
    step.stiffness = 1e-6;  // the spring turns by no more than 1e-9
    step.cap_rate = 0;
    step.spring_before[0] = 0.6 / step.stiffness;
    for (int back = 0; back < 3; ++back) {
      step.velocity[back][0] = 0.1;
      step.velocity[back][1] = 0.3 + beyond - 0.02 * back;
    }
    double spring[3] = {0.6 / step.stiffness, 0, 0};
    const FrictionForce f = friction_force(step, spring);
    EXPECT_TRUE(f.slides && f.changed && !f.jumps);
    EXPECT_NEAR(f.since, 1e-3 * beyond / 0.02, 1e-9);
    // The spring stays as it is while the slide goes on: u with u + c v along the trial force,
    // (0.8, 0.6), at its begin, with c v = 0.52 along it and 0.36 across.
    const double load = 0.52 + std::sqrt(1 - 0.36 * 0.36);
    const double u[2] = {0.8 * load - 0.2, 0.6 * load - 0.6};
    EXPECT_NEAR(spring[0] * step.stiffness, u[0], 1e-8);
    EXPECT_NEAR(spring[1] * step.stiffness, u[1], 1e-8);
    const double x = u[0] + 0.2, y = u[1] + 0.6 + 2 * beyond, length = std::hypot(x, y);
    EXPECT_NEAR(f.force[0], -x / length, 1e-8);
    EXPECT_NEAR(f.force[1], -y / length, 1e-8);
    EXPECT_NEAR(f.gain[1], f.force[1] + 0.6 + 2 * beyond, 1e-8);
    EXPECT_NEAR(f.gain_rate[1], 2 * 20 * (1 - x * x / std::pow(length, 3)), 1e-3);
  }
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

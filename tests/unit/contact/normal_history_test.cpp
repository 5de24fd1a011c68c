// SPDX-License-Identifier: GPL-2.0-or-later
// Each event of the normal force of a contact against its closed form: touch, the cut-off at 0 and
// its end, jumps of the bodies, the end of the contact.
#include "rodpack/contact/normal_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_contact.h"

namespace rodpack {
namespace {

const double dt = 1e-5, k = 1000, c = 0.4;

SampleContact damped(double overlap, double separation) {
  SampleContact contact = on_floor(overlap, 0.07, separation);
  contact.kn = k;
  contact.gamman = c;
  return contact;
}

double force_of(const SampleContact& contact) {
  return viscoelastic_force(k, contact.deltan, c, contact.vn);
}

/// The normal is y; nothing may happen along x and z.
void expect_change(const ForceChange& change, double now, double rate, double impulse,
                   double integral) {
  expect_component(change, 1, 1e-12, now, rate, impulse, integral);
  for (int d : {0, 2}) {
    EXPECT_EQ(change.now[d], 0);
    EXPECT_EQ(change.impulse[d], 0);
  }
}

}  // namespace

// The gap closes at the speed w, the overlap w s shows that this was s ago. Since then the force
// k w t + c w has acted in place of none: its integral over t from 0 to s, and that once more.
TEST(NormalHistory, TouchMissesTheForceSinceThen) {
  const double w = 0.2, s = 0.6 * dt;
  const SampleContact contact = damped(w * s, -w);
  NormalHistory history;
  RecordedEvents told;
  follow_normal_force(contact, history, force_of(contact), false, dt, &told);
  ASSERT_EQ(told.events.size(), 1u);
  expect_change(told.events[0].on_i, k * w * s + c * w, k * w, k * w * s * s / 2 + c * w * s,
                k * w * s * s * s / 6 + c * w * s * s / 2);
  EXPECT_TRUE(told.events[0].jumps);  // by c w, from nothing
  EXPECT_TRUE(history.just_touched);
  EXPECT_DOUBLE_EQ(history.touch_rate, k * w);
  EXPECT_DOUBLE_EQ(history.viscoelastic, k * w * s + c * w);
}

TEST(NormalHistory, WithoutADashpotTheForceGrowsFromNothing) {
  SampleContact contact = damped(1e-6, -0.2);
  contact.gamman = 0;
  NormalHistory history;
  RecordedEvents told;
  follow_normal_force(contact, history, k * 1e-6, false, dt, &told);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_FALSE(told.events[0].jumps);
}

// What is inserted with an overlap has not touched, and nothing is missed.
TEST(NormalHistory, AContactThatWasMadeWithAnOverlapHasNoTouch) {
  const SampleContact contact = damped(1e-5, -0.2);  // the step closes 2e-6 m
  NormalHistory history;
  RecordedEvents told;
  follow_normal_force(contact, history, force_of(contact), false, dt, &told);
  EXPECT_TRUE(told.events.empty());
  EXPECT_FALSE(history.just_touched);
  EXPECT_DOUBLE_EQ(history.viscoelastic, force_of(contact));
}

// The force before the cut-off goes on a straight line from a > 0 to -b < 0 and crosses 0 at s =
// dt b / (a + b) before the end of the step. The integrator's records continue that line; the force
// itself has stayed at 0 since: D(t) = (b/s) t from there, with integrals b s / 2 and b s^2 / 6.
// Where the force comes back, from -b to a, D is that force itself, a (t/s).
TEST(NormalHistory, CutOffAndReturnAreFoundOnTheStraightLine) {
  const double overlap = 2e-6, pull = 0.003;
  for (const bool returns : {false, true}) {
    const double before = returns ? -0.001 : 0.001;
    const double now = returns ? pull : -pull;
    // the speed at which spring and dashpot are just that
    const SampleContact contact = damped(overlap, (k * overlap - now) / c);
    ASSERT_NEAR(force_of(contact), now, 1e-15);
    NormalHistory history;
    history.viscoelastic = before;
    RecordedEvents told;
    follow_normal_force(contact, history, now, true, dt, &told);
    ASSERT_EQ(told.events.size(), 1u);
    const double b = pull, s = dt * 0.003 / 0.004;
    expect_change(told.events[0].on_i, b, b / s, b * s / 2, b * s * s / 6);
    EXPECT_FALSE(told.events[0].jumps);
    EXPECT_EQ(history.viscoelastic, now);
  }
}

TEST(NormalHistory, AContactThatPushesOnHasNoEvent) {
  const SampleContact contact = damped(2e-6, -0.1);
  NormalHistory history;
  history.viscoelastic = 0.03;
  RecordedEvents told;
  follow_normal_force(contact, history, force_of(contact), true, dt, &told);
  EXPECT_TRUE(told.events.empty());
}

// The bodies' motion along the normal has jumped in the step before, by the acceleration a, the
// velocity v and the way x at its end: the dashpot has felt -c (v + a t) in this step and has -c x
// of impulse to make good. What the bodies do across the normal does not concern it.
TEST(NormalHistory, TheDashpotFeelsJumpsOfItsBodiesAlongTheNormal) {
  const SampleContact contact = damped(2e-6, -0.1);
  NormalHistory history;
  history.viscoelastic = 0.03;
  RecordedEvents told;
  told.moved = true;
  const double a = 300, v = 2e-3, x = 1e-8;
  told.jump = {{77, a, 5}, {1, v, 2}, {3, x, 4}};
  follow_normal_force(contact, history, force_of(contact), true, dt, &told);
  ASSERT_EQ(told.events.size(), 1u);
  expect_change(told.events[0].on_i, -c * (v + a * dt), -c * a, -c * (x + v * dt + a * dt * dt / 2),
                -c * (x * dt + v * dt * dt / 2 + a * dt * dt * dt / 6));
  EXPECT_FALSE(told.events[0].jumps);
}

// The last evaluation found spring and dashpot to push with u; the jump, which it did not know of,
// has made them pull, so that the force ended before it, where u + r t = c (v + a t), t = 0 at the
// evaluation. Until then the dashpot misses c (v + a t), from then on the records miss -(u + r t).
TEST(NormalHistory, AJumpEndsTheForceMoreThanAStepBack) {
  const double u = 0.001, r = -100, a = 900, v = 0.01, x = 4e-8;
  const double end = -(u - c * v) / (r - c * a);
  ASSERT_LT(end, 0);
  ASSERT_GT(end, -dt);
  const double now = u + r * dt - c * (v + a * dt), overlap = 2e-6;
  const SampleContact contact = damped(overlap, (k * overlap - now) / c);
  NormalHistory history;
  history.viscoelastic = u;
  RecordedEvents told;
  told.moved = true;
  told.jump.acceleration[1] = a;
  told.jump.velocity[1] = v;
  told.jump.displacement[1] = x;
  follow_normal_force(contact, history, now, true, dt, &told);
  ASSERT_EQ(told.events.size(), 2u);
  ForceChange sum = told.events[0].on_i;
  sum += told.events[1].on_i;
  EXPECT_NEAR(sum.now[1], -(u + r * dt), 1e-12);
  EXPECT_NEAR(sum.rate[1], -r, 1e-6);
  const auto integral = [](double constant, double slope, double from, double to) {
    return constant * (to - from) + slope * (to * to - from * from) / 2;
  };
  EXPECT_NEAR(sum.impulse[1], -c * (x - integral(v, a, end, 0)) - integral(u, r, end, dt), 1e-18);
}

// The other way: it was cut off, and the jump has made it push again, from where -u + r t = c (v +
// a t). What the records miss is all of the force; the dashpot was not in them.
TEST(NormalHistory, AJumpBringsTheForceBackMoreThanAStepBack) {
  const double before = 0.003, slope = 500, overlap = 2e-6, now = before + slope * dt;
  const SampleContact contact = damped(overlap, (k * overlap - now) / c);
  NormalHistory history;
  history.viscoelastic = -0.001;
  RecordedEvents told;
  told.moved = true;
  told.jump.velocity[1] = -0.01;  // -c v = 0.004 N
  told.jump.acceleration[1] = -900;
  follow_normal_force(contact, history, now, true, dt, &told);
  ASSERT_EQ(told.events.size(), 1u);
  const double since = dt + before / slope;
  expect_change(told.events[0].on_i, now, slope, slope * since * since / 2,
                slope * since * since * since / 6);
}

TEST(NormalHistory, AForceThatStaysCutOffHasNoDashpotToFeelAJump) {
  const double overlap = 2e-6, now = -0.002;
  NormalHistory history;
  history.viscoelastic = -0.001;
  RecordedEvents told;
  told.moved = true;
  told.jump.velocity[1] = 0.01;
  follow_normal_force(damped(overlap, (k * overlap - now) / c), history, now, true, dt, &told);
  EXPECT_TRUE(told.events.empty());
}

// One step after touch the rate of the force is known from two evaluations; at touch k w was
// assumed, and the jump of touch has changed that by -c a. The difference r has acted since the
// touch's evaluation: r t over a step, with integrals r dt^2 / 2 and r dt^3 / 6.
TEST(NormalHistory, TheRateGuessedAtTouchIsMadeGoodOneStepLater) {
  const double w = 0.2, at_touch = 0.081, a = -120, v = -4e-4;
  NormalHistory history;
  history.viscoelastic = at_touch;
  history.touch_rate = k * w;
  history.just_touched = true;
  const SampleContact contact = damped(3e-6, -0.199);
  RecordedEvents told;
  told.moved = true;
  told.jump.acceleration[1] = a;
  told.jump.velocity[1] = v;
  follow_normal_force(contact, history, force_of(contact), true, dt, &told);
  ASSERT_EQ(told.events.size(), 2u);
  const double r = (force_of(contact) - (at_touch - c * v)) / dt - (k * w - c * a);
  expect_change(told.events[1].on_i, r * dt, r, r * dt * dt / 2, r * dt * dt * dt / 6);
  EXPECT_TRUE(told.events[1].jumps);
  EXPECT_FALSE(history.just_touched);
}

// The contact opens within the step: spring and dashpot, continued beyond, pull with k g + c v.
// Their line from a > 0 crosses 0 at s before the end, and D is what they would have pulled.
TEST(NormalHistory, EndOfAContactTakesBackThePull) {
  const double gap = 1e-6, v = 0.05, a = 0.03;
  const SampleContact open = damped(-gap, v);
  NormalHistory history;
  history.viscoelastic = a;
  RecordedEvents told;
  end_normal_force(open, history, dt, told);
  ASSERT_EQ(told.events.size(), 1u);
  const double b = k * gap + c * v, s = dt * b / (a + b);
  expect_change(told.events[0].on_i, b, b / s, b * s / 2, b * s * s / 6);
  EXPECT_FALSE(told.events[0].jumps);

  // Cut off before, it has had its event.
  history.viscoelastic = -0.01;
  RecordedEvents nothing;
  end_normal_force(open, history, dt, nothing);
  EXPECT_TRUE(nothing.events.empty());
}

}  // namespace rodpack

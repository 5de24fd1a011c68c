// SPDX-License-Identifier: GPL-2.0-or-later
// The tangential spring over the life of a contact, and each event of its force against a closed
// form: touch, slide, stick, jumps of the bodies, the end of the contact.
#include "rodpack/contact/tangential_history.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sample_contact.h"

namespace rodpack {
namespace {

const double dt = 1e-5, kt = 500, gamma_t = 0.3, friction = 300;  // mu k_n
const int slots = 3;
const TangentialStep step = {3, 1000, dt};

/// On the floor y = 0; it moves along x.
SampleContact sheared(double overlap, double vx, double vy = 0) {
  SampleContact contact = on_floor(overlap, vx, vy);
  contact.kt = kt;
  contact.gammat = gamma_t;
  return contact;
}

/// Of a contact that was evaluated in the last step, and has moved along x at these velocities,
/// newest first.
TangentialHistory history_of(double spring, double v1, double v2, double v3) {
  TangentialHistory history(slots);
  history.spring[0] = spring;
  const double velocities[3] = {v1, v2, v3};
  for (int k = 0; k < slots; ++k) history.velocity[k][0] = velocities[k];
  history.known = slots + 1;
  history.step = step.now - 1;
  history.friction = friction;
  history.stiffness = kt;
  history.damping = gamma_t;
  return history;
}

TangentialForce evaluate(const SampleContact& contact, TangentialHistory& history,
                         RecordedEvents& told) {
  return tangential_contact_force(contact, history, ElasticCap{friction}, true, step,
                                  static_cast<const RecordedEvents*>(&told), &told);
}

void expect_change(const ForceChange& change, double now, double rate, double impulse,
                   double integral, double tolerance = 1e-9) {
  EXPECT_NEAR(change.now[0], now, tolerance * std::fabs(now));
  EXPECT_NEAR(change.rate[0], rate, tolerance * std::fabs(rate));
  EXPECT_NEAR(change.impulse[0], impulse, tolerance * std::fabs(impulse));
  EXPECT_NEAR(change.impulse_integral[0], integral, tolerance * std::fabs(integral));
  for (int d : {1, 2}) EXPECT_NEAR(change.now[d], 0, 1e-15);
}

}  // namespace

// The velocity is a polynomial of second degree in time; three of its values give the integral over
// the step exactly: v = a + b t + c t^2 from -dt to 0 is a dt - b dt^2/2 + c dt^3/3.
TEST(TangentialHistory, SpringIsTheIntegralOfTheVelocity) {
  const double a = 0.01, b = 300, c = 4e7;
  const auto v = [&](int k) { return a - b * k * dt + c * k * k * dt * dt; };
  TangentialHistory history = history_of(1e-6, v(1), v(2), v(3));
  RecordedEvents told;
  evaluate(sheared(1e-4, v(0)), history, told);
  EXPECT_NEAR(history.spring[0], 1e-6 + a * dt - b * dt * dt / 2 + c * dt * dt * dt / 3, 1e-19);
  EXPECT_NEAR(history.velocity[0][0], v(0), 1e-16);
  EXPECT_NEAR(history.velocity[1][0], v(1), 1e-16);
  EXPECT_NEAR(history.velocity[2][0], v(2), 1e-16);
  EXPECT_EQ(history.known, slots + 1);
  EXPECT_EQ(history.step, step.now);
  EXPECT_TRUE(told.events.empty());
}

// Spring and velocities lie in the plane of contact and turn with it, at their lengths.
TEST(TangentialHistory, SpringTurnsWithTheContact) {
  const double angle = 1e-3;
  TangentialHistory history(slots);
  history.spring[0] = 2e-6;
  history.known = slots + 1;
  history.step = step.now - 1;
  SampleContact contact = sheared(1e-4, 0);
  contact.delta[0] = -std::sin(angle) * contact.r;  // the normal was y
  contact.delta[1] = std::cos(angle) * contact.r;
  contact.complete();
  RecordedEvents told;
  evaluate(contact, history, told);
  EXPECT_NEAR(history.spring[0], 2e-6 * std::cos(angle), 1e-18);
  EXPECT_NEAR(history.spring[1], 2e-6 * std::sin(angle), 1e-18);
}

// Closed at the speed w, s ago, on a wall: since then spring and dashpot have grown as kt v t +
// gamma v, in place of no force; the integrals over t from 0 to s.
// Two spheres turn about each other with constant angular velocity, the spring at 45 degrees to the
// plane of the turn: what lies in that plane turns exactly with the normal, the rest stays. The
// turn over one step is known to its third order.
TEST(TangentialHistory, SpringTurnsWithTheContactInSpace) {
  double errors[2];
  for (const int halved : {0, 1}) {
    const double angle = halved ? 0.01 : 0.02;  // in one step
    SampleContact contact;
    contact.radi = contact.radj = 1e-3;
    const double distance = 1.99e-3;
    contact.delta[0] = distance * std::cos(angle);
    contact.delta[1] = distance * std::sin(angle);
    contact.v_i[0] = -angle / dt * contact.delta[1];
    contact.v_i[1] = angle / dt * contact.delta[0];
    contact.complete();
    // They roll on each other, so that the spring does not grow.
    contact.vtr1 = contact.vtr2 = contact.vtr3 = 0;
    TangentialHistory history = history_of(0, 0, 0, 0);
    history.spring[1] = history.spring[2] = 1e-6;  // the plane of contact was that of y and z
    advance_spring(contact, history, step, static_cast<const RecordedEvents*>(nullptr));
    const double expected[3] = {-1e-6 * std::sin(angle), 1e-6 * std::cos(angle), 1e-6};
    double squared = 0;
    for (int d = 0; d < 3; ++d) squared += std::pow(history.spring[d] - expected[d], 2);
    errors[halved] = std::sqrt(squared) / 1e-6;
    EXPECT_NEAR(dot(history.spring, history.spring), 2e-12, 1e-24);
    EXPECT_NEAR(dot(history.spring, contact.en), 0, 1e-20);
  }
  EXPECT_LT(errors[0], std::pow(0.02, 3));
  EXPECT_LT(errors[1], errors[0] / 7);
}

TEST(TangentialHistory, TouchMissesTheForceSinceThen) {
  const double v = 1e-3, w = 0.2, s = 0.7 * dt;
  TangentialHistory history(slots);
  RecordedEvents told;
  const TangentialForce force = evaluate(sheared(w * s, v, -w), history, told);
  EXPECT_FALSE(force.sliding);
  EXPECT_NEAR(history.spring[0], v * s, 1e-12 * v * s);
  EXPECT_NEAR(history.since, s, 1e-9 * s);
  EXPECT_EQ(history.known, 1);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_TRUE(told.events[0].jumps);  // by the dashpot's force
  expect_change(told.events[0].on_i, -(kt * v * s + gamma_t * v), -kt * v,
                -(kt * v * s * s / 2 + gamma_t * v * s),
                -(kt * v * s * s * s / 6 + gamma_t * v * s * s / 2));
}

// Too fast to stick: the force is the cap, mu k_n w t, which grows from nothing.
TEST(TangentialHistory, TouchThatSlidesGrowsWithTheCap) {
  const double w = 0.2, s = 0.7 * dt;
  TangentialHistory history(slots);
  RecordedEvents told;
  EXPECT_TRUE(evaluate(sheared(w * s, 5, -w), history, told).sliding);
  EXPECT_TRUE(history.sliding);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_FALSE(told.events[0].jumps);
  const double cap = friction * w * s;
  expect_change(told.events[0].on_i, -cap, -cap / s, -cap * s / 2, -cap * s * s / 6);
}

// Two spheres that pass each other: the spring at the first evaluation is the integral of the
// tangential velocity since touch, which turns meanwhile. Against Simpson's rule over the flight;
// the mean of begin and end is wrong by O(s^3), an eighth at half the time since touch.
TEST(TangentialHistory, TouchOfTwoSpheresFollowsTheirFlight) {
  const auto flight = [](double t) {  // touches at t = 0
    SampleContact c;
    c.radi = 1e-3;
    c.radj = 0.5e-3;
    c.v_i[0] = 5;
    c.v_i[1] = -9;
    c.omega_i[2] = 900;
    c.delta[0] = 0.9e-3 + c.v_i[0] * t;
    c.delta[1] = 1.2e-3 + c.v_i[1] * t;
    c.kt = kt;
    c.complete();
    return c;
  };
  const auto error = [&](double s) {
    const auto speed = [&](double t) {  // along the tangent
      const SampleContact c = flight(t);
      return c.en[0] * c.vtr2 - c.en[1] * c.vtr1;
    };
    const double exact = s / 6 * (speed(0) + 4 * speed(0.5 * s) + speed(s));
    const SampleContact c = flight(s);
    TangentialHistory history(slots);
    const TangentialStep long_step = {3, 1000, 1e-4};
    RecordedEvents told;
    tangential_contact_force(c, history, ElasticCap{1e9}, true, long_step,
                             static_cast<const RecordedEvents*>(&told), &told);
    return std::fabs(c.en[0] * history.spring[1] - c.en[1] * history.spring[0] - exact);
  };
  EXPECT_NEAR(std::log2(error(1e-5) / error(5e-6)), 3, 0.2);
  EXPECT_LT(error(1e-5), 1e-3 * 9 * 1e-5);  // of the way since touch, at some 9 m/s
}

// Sheared at the constant speed v, the force kt (s0 + v t) + gamma v reaches the cap within the
// step, where it exceeds the cap by e at the end: e / (kt v) ago. Since then the excess kt v t is
// missing: integrals e s / 2 and e s^2 / 6.
TEST(TangentialHistory, SlideTakesBackTheExcessSinceTheCapWasReached) {
  const double v = 0.02, overlap = 1e-4, cap = friction * overlap, e = 0.4 * kt * v * dt;
  const double spring_now = (cap + e - gamma_t * v) / kt;
  TangentialHistory history = history_of(spring_now - v * dt, v, v, v);
  RecordedEvents told;
  const TangentialForce force = evaluate(sheared(overlap, v), history, told);
  EXPECT_TRUE(force.sliding && history.sliding);
  EXPECT_NEAR(force.force[0], -cap, 1e-12 * cap);
  EXPECT_NEAR(history.spring[0], cap / kt, 1e-12 * cap / kt);  // it alone carries the cap
  ASSERT_EQ(told.events.size(), 1u);
  const double s = 0.4 * dt;
  expect_change(told.events[0].on_i, e, kt * v, e * s / 2, e * s * s / 6);
  EXPECT_FALSE(told.events[0].jumps);
}

// The surfaces move at v along the force, kt (spring) - gamma v, so that it falls by kt v per
// second under a cap that falls faster, by mu k_n vn. Where it exceeds the cap by e at the end of
// the step, it reached the cap s = e / (mu k_n vn - kt v) ago. There the spring is shortened to
// what carries the cap alone, by gamma v / kt: from then on the force lacks gamma v, with the
// integrals gamma v s and gamma v s^2 / 2.
TEST(TangentialHistory, CapDropLosesTheExcessAtOnce) {
  const double v = 0.02, vn = 0.5, overlap = 1e-4, cap = friction * overlap, s = 0.4 * dt;
  const double e = s * (friction * vn - kt * v), spring_now = (cap + e + gamma_t * v) / kt;
  TangentialHistory history = history_of(spring_now + v * dt, -v, -v, -v);
  RecordedEvents told;
  const TangentialForce force = evaluate(sheared(overlap, -v, vn), history, told);
  EXPECT_FALSE(force.sliding || history.sliding);
  EXPECT_NEAR(history.spring[0], spring_now - gamma_t * v / kt, 1e-12 * spring_now);
  EXPECT_NEAR(force.force[0], -(cap + e) + gamma_t * v, 1e-12 * cap);
  ASSERT_EQ(told.events.size(), 1u);
  const double gain = gamma_t * v;
  expect_change(told.events[0].on_i, gain, 0, gain * s, gain * s * s / 2);
  EXPECT_TRUE(told.events[0].jumps);
}

// The cap falls by mu k_n vn dt in a step, fifty times what the dashpot carries: the force falls
// with it, but for the dashpot's share, and there is nothing to follow.
TEST(TangentialHistory, AForceThatFallsWithTheCapHasNoEvents) {
  const double v = 1e-4, vn = 0.5;
  double overlap = 1e-4;
  TangentialHistory history = history_of(friction * overlap / kt, -v, -v, -v);
  for (int k = 0; k < 10; ++k) {
    overlap -= vn * dt;
    history.step = step.now - 1;
    RecordedEvents told;
    const TangentialForce force = evaluate(sheared(overlap, -v, vn), history, told);
    EXPECT_NEAR(force.force[0], -friction * overlap + gamma_t * v, 1e-12);
    EXPECT_TRUE(told.events.empty());
  }
}

// A slide at the speed v(t) = -a t stands still s before the end of the step. From the spring that
// carried the cap the surface then moves back by a s^2 / 2: the force falls below the cap, D(t) =
// gamma a t + kt a t^2 / 2. The event takes D as linear, from its value and its rate now, so that
// it knows the impulse but for kt a s^3 / 6.
TEST(TangentialHistory, StickBeginsAtTheStandstill) {
  const double a = 2000, overlap = 1e-4, cap = friction * overlap, s = 0.3 * dt;
  const auto v = [&](int k) { return -a * (s - k * dt); };
  TangentialHistory history = history_of(cap / kt, v(1), v(2), v(3));
  history.sliding = true;
  RecordedEvents told;
  const TangentialForce force = evaluate(sheared(overlap, v(0)), history, told);
  EXPECT_FALSE(force.sliding || history.sliding);
  EXPECT_NEAR(history.spring[0], cap / kt - a * s * s / 2, 1e-12 * cap / kt);
  EXPECT_NEAR(force.force[0], -cap + kt * a * s * s / 2 + gamma_t * a * s, 1e-12 * cap);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_FALSE(told.events[0].jumps);
  const ForceChange& change = told.events[0].on_i;
  EXPECT_NEAR(change.now[0], kt * a * s * s / 2 + gamma_t * a * s, 1e-12 * cap);
  EXPECT_NEAR(change.rate[0], kt * a * s + gamma_t * a, 1e-6 * gamma_t * a);
  const double exact = gamma_t * a * s * s / 2 + kt * a * s * s * s / 6;
  EXPECT_NEAR(change.impulse[0], exact, 1.01 * kt * a * s * s * s / 6);
}

// While it slid, the overlap was d - w t + g t^2 / 2, t seconds ago, and the cap mu k_n times that:
// the spring that stays is what carried the cap at the standstill, which is found from the spring
// of one step ago, overlap and closing speed of now. With the cap's rate alone it would be short by
// mu k_n g s^2 / 2.
TEST(TangentialHistory, StickKeepsTheSpringOfACurvedCap) {
  const double a = 2000, d = 1e-4, w = 0.4, g = 3e5, s = 0.6 * dt;
  const auto overlap = [&](double t) { return d - w * t + g * t * t / 2; };
  const auto v = [&](int k) { return -a * (s - k * dt); };
  TangentialHistory history = history_of(friction * overlap(dt) / kt, v(1), v(2), v(3));
  history.sliding = true;
  RecordedEvents told;
  evaluate(sheared(d, v(0), -w), history, told);
  EXPECT_FALSE(history.sliding);
  const double at_standstill = friction * overlap(s) / kt;
  EXPECT_NEAR(history.spring[0], at_standstill - a * s * s / 2, 1e-12 * at_standstill);
}

// As above, but the slide was stopped by a jump in the step before, which the evaluation at its end
// did not know of: the velocity -a (t - t0), as it should have been, is against the slide there
// already.
TEST(TangentialHistory, AJumpMakesAContactStickMoreThanAStepBack) {
  const double a = 2000, overlap = 1e-4, cap = friction * overlap, s = 1.4 * dt;
  const double unseen = 0.02;
  TangentialHistory history = history_of(cap / kt, unseen - 0.4 * a * dt, 0.03, 0.04);
  history.sliding = true;
  RecordedEvents told;
  told.moved = true;
  told.jump = {{-500, 0, 0}, {-unseen, 0, 0}, {-3e-8, 0, 0}};
  const TangentialForce force = evaluate(sheared(overlap, -a * s), history, told);
  EXPECT_FALSE(force.sliding);
  EXPECT_NEAR(history.spring[0], cap / kt - a * s * s / 2, 1e-12 * cap / kt);
  ASSERT_EQ(told.events.size(), 1u);  // the slide had no dashpot
  const ForceChange& change = told.events[0].on_i;
  EXPECT_NEAR(change.now[0], kt * a * s * s / 2 + gamma_t * a * s, 1e-12 * cap);
  const double exact = gamma_t * a * s * s / 2 + kt * a * s * s * s / 6;
  EXPECT_NEAR(change.impulse[0], exact, 1.01 * kt * a * s * s * s / 6);
}

// A dashpot alone (k_t next to 0), at the velocity V, below the cap at the last evaluation; with
// the jump, v + a t more, it was beyond from t0 < 0 on: gamma (V + v + a t0) is the cap. Until then
// the records miss -gamma (v + a t), from then on the cap takes the place of gamma V.
TEST(TangentialHistory, AJumpMakesAContactSlideMoreThanAStepBack) {
  const double overlap = 1e-6, cap = friction * overlap, V = 0.9 * cap / gamma_t;
  const double v = 0.2 * cap / gamma_t, a = v / (1.2 * dt), x = 0.5 * v * 1.2 * dt;
  const double begin = (cap / gamma_t - V - v) / a;
  ASSERT_LT(begin, 0);
  ASSERT_GT(begin, -dt);
  TangentialHistory history = history_of(0, V, V, V);
  RecordedEvents told;
  told.moved = true;
  told.jump = {{a, 0, 0}, {v, 0, 0}, {x, 0, 0}};
  SampleContact contact = sheared(overlap, V + v + a * dt);
  contact.kt = 1e-9;
  EXPECT_TRUE(evaluate(contact, history, told).sliding);
  ASSERT_EQ(told.events.size(), 2u);
  ForceChange sum = told.events[0].on_i;
  sum += told.events[1].on_i;
  EXPECT_NEAR(sum.now[0], gamma_t * V - cap, 1e-9 * cap);
  EXPECT_NEAR(sum.rate[0], 0, 1e-6 * cap / dt);
  const double until = x + v * begin + a * begin * begin / 2;
  EXPECT_NEAR(sum.impulse[0], -gamma_t * until + (gamma_t * V - cap) * (dt - begin),
              1e-9 * cap * dt);
}

// Jumps of the bodies move the surface along by x, and its velocities of the past by v - k dt a: as
// if they had been known of. What they do along the normal has no part in it.
TEST(TangentialHistory, SpringAndPastFollowJumpsOfTheBodies) {
  const double v0 = 1e-3, a = 80, v = 5e-4, x = 2e-9;
  TangentialHistory history = history_of(1e-6, v0, v0, v0);
  RecordedEvents told;
  told.moved = true;
  told.jump = {{a, 55, 0}, {v, 66, 0}, {x, 77, 0}};
  evaluate(sheared(1e-4, v0), history, told);
  for (int k = 1; k < slots; ++k)
    EXPECT_NEAR(history.velocity[k][0], v0 + v - (k - 1) * dt * a, 1e-15);
  // The integral over the step that has gone by, with the velocities v0 + v + a t from its begin.
  EXPECT_NEAR(history.spring[0], 1e-6 + x + (v0 + v) * dt + a * dt * dt / 2, 1e-18);
  // The dashpot has felt the jump for a step: -gamma (v + a t), and -gamma x before.
  ASSERT_EQ(told.events.size(), 1u);
  expect_change(told.events[0].on_i, -gamma_t * (v + a * dt), -gamma_t * a,
                -gamma_t * (x + v * dt + a * dt * dt / 2),
                -gamma_t * (x * dt + v * dt * dt / 2 + a * dt * dt * dt / 6));
  EXPECT_FALSE(told.events[0].jumps);
}

// One step after touch, s before the end of its step, two evaluations give the rate of the force;
// kt v and what the jump did were assumed. The difference r has acted since touch, but the first
// evaluation was right: D(t) = r t, t from the first evaluation, in -s .. dt. Integrals: r (dt^2 -
// s^2) / 2, and that of (dt - t) D: r (dt^3/6 - s^2 (dt/2 + s/3)).
TEST(TangentialHistory, TheRateGuessedAtTouchIsMadeGoodOneStepLater) {
  const double v0 = 1e-3, v1 = 1.3e-3, s = 0.4 * dt, a = 5;
  TangentialHistory history = history_of(v0 * s, v0, 0, 0);
  history.known = 1;
  history.since = s;
  RecordedEvents told;
  told.moved = true;
  told.jump.acceleration[0] = a;
  const TangentialForce force = evaluate(sheared(1e-4, v1), history, told);
  ASSERT_EQ(told.events.size(), 2u);
  const double r = (force.force[0] + kt * v0 * s + gamma_t * v0) / dt - (-kt * v0 - gamma_t * a);
  expect_change(told.events[1].on_i, r * dt, r, r * (dt * dt - s * s) / 2,
                r * (dt * dt * dt / 6 - s * s * (dt / 2 + s / 3)));
  EXPECT_TRUE(told.events[1].jumps);
}

// A stuck contact opens s before the end of the step. Continued, spring and dashpot would pull with
// -(kt (s0 + v t) + gamma v); that they do not is D, which jumps.
TEST(TangentialHistory, EndOfAStuckContactLetsGoOfTheSpring) {
  const double v = 1e-3, vn = 0.1, s = 0.35 * dt, s0 = 2e-6;
  TangentialHistory history = history_of(s0, v, v, v);
  RecordedEvents told;
  end_tangential_force(sheared(-vn * s, v, vn), history, ElasticCap{friction}, step, told);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_TRUE(told.events[0].jumps);
  const double now = kt * (s0 + v * dt) + gamma_t * v, rate = kt * v;
  expect_change(told.events[0].on_i, now, rate, now * s - rate * s * s / 2,
                now * s * s / 2 - rate * s * s * s / 3, 1e-8);
}

// That of a sliding one has fallen to 0 with the cap, mu k_n vn t before it; continued it would
// have changed its sign: D = mu k_n vn t along the force.
TEST(TangentialHistory, EndOfASlideGoesOnAtZero) {
  const double v = 0.5, vn = 0.1, s = 0.35 * dt;
  TangentialHistory history = history_of(1e-9, v, v, v);
  history.sliding = true;
  RecordedEvents told;
  end_tangential_force(sheared(-vn * s, v, vn), history, ElasticCap{friction}, step, told);
  ASSERT_EQ(told.events.size(), 1u);
  EXPECT_FALSE(told.events[0].jumps);
  const double now = -friction * vn * s;
  expect_change(told.events[0].on_i, now, now / s, now * s / 2, now * s * s / 6);
}

// Evaluated again at the same time, without a trace: the same force.
TEST(TangentialHistory, ASecondEvaluationLeavesNoTrace) {
  for (const double v : {1e-3, 5.0}) {
    TangentialHistory history = history_of(5e-5, v, v, v);
    RecordedEvents told;
    const SampleContact contact = sheared(1e-4, v);
    const TangentialForce first = evaluate(contact, history, told);
    const std::size_t events = told.events.size();
    const double spring = history.spring[0];
    const TangentialForce again =
        tangential_contact_force(contact, history, ElasticCap{friction}, false, step,
                                 static_cast<const RecordedEvents*>(&told), &told);
    EXPECT_EQ(again.force[0], first.force[0]);
    EXPECT_EQ(history.spring[0], spring);
    EXPECT_EQ(told.events.size(), events);
  }
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/force_change.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rodpack/contact/contact_law.h"
#include "rodpack/motion/multistep.h"

using namespace rodpack;

namespace {

/// Simpson's rule, exact for cubics.
double integral(const std::function<double(double)>& f, double from, double to) {
  return (to - from) / 6 * (f(from) + 4 * f(0.5 * (from + to)) + f(to));
}

constexpr double now[3] = {2, -1, 0.5}, rate[3] = {30, 7, -11};
constexpr double since = 0.04;
// D(t), t = 0 at the end of the step
double linear(int d, double t) { return now[d] + t * rate[d]; }

}  // namespace

TEST(ForceChange, MomentsAreTheIntegralsSinceTheEvent) {
  const ForceChange change = linear_change(now, rate, since);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(change.impulse[d], integral([=](double t) { return linear(d, t); }, -since, 0),
                1e-15);
    // int int D = int (0 - t) D dt
    EXPECT_NEAR(change.impulse_integral[d],
                integral([=](double t) { return -t * linear(d, t); }, -since, 0), 1e-15);
  }
}

// The records of the past continue the new branch backwards: the force, and the momentum that this
// force has made since the event, negative before it.
TEST(ForceChange, RecordsOfThePastContinueTheNewBranch) {
  const ForceChange change = linear_change(now, rate, since);
  for (const double age : {0.0, 0.01, 0.1, 0.2})
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(change.past_force(d, age), linear(d, -age), 1e-14);
      EXPECT_NEAR(change.past_momentum(d, age),
                  integral([=](double t) { return linear(d, t); }, -since, -age), 1e-14);
    }
}

TEST(ForceChange, TorqueFollowsAMovingLever) {
  const double lever[3] = {0.3, 0.2, -0.1}, lever_rate[3] = {5, -3, 2};
  const ForceChange torque = torque_change(lever, lever_rate, linear_change(now, rate, since));
  const auto at = [&](int d, double t) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    return (lever[e] + t * lever_rate[e]) * linear(f, t) -
           (lever[f] + t * lever_rate[f]) * linear(e, t);
  };
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(torque.now[d], at(d, 0), 1e-15);
    EXPECT_NEAR(torque.rate[d], (at(d, 1e-6) - at(d, -1e-6)) / 2e-6, 1e-8);
    EXPECT_NEAR(torque.impulse[d], integral([&](double t) { return at(d, t); }, -since, 0), 1e-15);
  }
  // The integral of the impulse is to leading order in the time since the event: exact for a lever
  // at rest.
  const double at_rest[3] = {0, 0, 0};
  const ForceChange still = torque_change(lever, at_rest, linear_change(now, rate, since));
  for (int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    const auto moment = [&](double t) {
      return -t * (lever[e] * linear(f, t) - lever[f] * linear(e, t));
    };
    EXPECT_NEAR(still.impulse_integral[d], integral(moment, -since, 0), 1e-15);
  }
}

// Both are of one text; the plane has the z component alone.
TEST(ForceChange, PlanarTorqueIsTheSpatialOne) {
  const double lever[3] = {0.3, -0.2, 0}, lever_rate[3] = {-2, 5, 0};
  const ForceChange force = linear_change({1.5, 0.7, 0}, {-20, 11, 0}, 0.03);
  const PlanarTorqueChange spatial = about_z(torque_change(lever, lever_rate, force));
  const PlanarTorqueChange planar = torque_change({0.3, -0.2}, {-2, 5}, in_plane(force));
  for (const auto part : {&PlanarTorqueChange::now, &PlanarTorqueChange::rate,
                          &PlanarTorqueChange::impulse, &PlanarTorqueChange::impulse_integral}) {
    EXPECT_NEAR((planar.*part)[0], (spatial.*part)[0], 1e-15 * std::fabs((spatial.*part)[0]));
    EXPECT_NE((planar.*part)[0], 0);
  }
}

// Of a force the plane has x and y, of a torque z.
TEST(ForceChange, ThePlaneTakesItsComponents) {
  const ForceChange change = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}};
  const PlanarForceChange force = in_plane(change);
  const PlanarTorqueChange torque = about_z(change);
  for (int d : {0, 1}) {
    EXPECT_EQ(force.now[d], 1 + d);
    EXPECT_EQ(force.rate[d], 4 + d);
    EXPECT_EQ(force.impulse[d], 7 + d);
    EXPECT_EQ(force.impulse_integral[d], 10 + d);
  }
  EXPECT_EQ(torque.now[0], 3);
  EXPECT_EQ(torque.rate[0], 6);
  EXPECT_EQ(torque.impulse[0], 9);
  EXPECT_EQ(torque.impulse_integral[0], 12);
}

// The velocity has jumped by v, the acceleration by a and the position by x, and a step has gone by
// since: the dashpot's force, -c times the velocity, has changed by -c (v + a t) at the time t in
// it, and its impulse by -c (x + v t + a t^2 / 2), as x was missed before.
TEST(ForceChange, DashpotTakesTheChangedVelocity) {
  const double c = 3, dt = 0.1, a[3] = {2, 0, -1}, v[3] = {0.1, 0.2, 0}, x[3] = {0.01, 0, 0.02};
  const ForceChange change = dashpot_change(c, a, v, x, dt);
  for (int d = 0; d < 3; ++d) {
    const auto velocity = [&](double t) { return v[d] + a[d] * t; };
    EXPECT_NEAR(change.now[d], -c * velocity(dt), 1e-15);
    EXPECT_NEAR(change.rate[d], -c * a[d], 1e-15);
    EXPECT_NEAR(change.impulse[d], -c * (x[d] + integral(velocity, 0, dt)), 1e-15);
    EXPECT_NEAR(
        change.impulse_integral[d],
        integral([&](double t) { return -c * (x[d] + v[d] * t + 0.5 * a[d] * t * t); }, 0, dt),
        1e-15);
  }
}

TEST(ForceChange, ZeroIsFoundOnTheStraightLine) {
  EXPECT_NEAR(time_since_zero(-3, 1, 0.4), 0.1, 1e-15);
  EXPECT_NEAR(time_since_zero(1, -3, 0.4), 0.3, 1e-15);
}

// A mass on a spring and a dashpot, begun at touch, after a free flight: Adams-Bashforth of third
// order that is told of the touch by these formulas alone, in the order in which a step knows them.
// The motion within the contact, x(t) = e^(-eta t) sin(w t) / w, shows third order; not told,
// first.
TEST(ForceChange, AdamsBashforthKeepsThirdOrderThroughTouch) {
  const double eta = 0.3, c = 2 * eta, w = std::sqrt(1 - eta * eta), end = 1.2;
  const auto error = [&](int steps, double phase, bool told) {
    const double dt = end / steps;
    // the touch falls `phase` of a step before the fifth evaluation
    double x = -(5 - phase) * dt, v = 1;
    double velocity[3] = {0, 1, 1}, acceleration[3] = {0, 0, 0}, rate_at_touch = 0, before = 0;
    ForceChange last = {};
    int in_touch = 0;
    for (int n = 0; n < steps + 5; ++n) {
      const double force = x > 0 ? -(x + c * v) : 0;
      ForceChange sum = {};
      if (x > 0 && told) {
        ++in_touch;
        if (in_touch == 1) {
          rate_at_touch = -v;
          sum = linear_change({force, 0, 0}, {rate_at_touch, 0, 0}, x / v);
        } else if (in_touch == 2) {
          sum = dashpot_change(c, last.now, last.impulse, last.impulse_integral, dt);
          const double missed =
              (force - (before - c * last.impulse[0])) / dt - (rate_at_touch - c * last.now[0]);
          sum += linear_change({missed * dt, 0, 0}, {missed, 0, 0}, dt);
        }
      }
      before = force;
      last = sum;
      if (n == steps + 5 - 1) {
        const double t = (steps - 1 + phase) * dt;
        return std::fabs(x + sum.impulse_integral[0] - std::exp(-eta * t) * std::sin(w * t) / w);
      }
      velocity[0] = v + sum.impulse[0];
      acceleration[0] = force;
      for (int k = 1; k < 3; ++k) {
        velocity[k] += sum.past_momentum(0, k * dt);
        acceleration[k] += sum.past_force(0, k * dt);
      }
      const auto& weights = adams_bashforth_weights(3);
      x += sum.impulse_integral[0] +
           multistep_increment(weights, 3, dt, [&](int k) { return velocity[k]; });
      v = velocity[0] + multistep_increment(weights, 3, dt, [&](int k) { return acceleration[k]; });
      for (int k = 2; k > 0; --k) {
        velocity[k] = velocity[k - 1];
        acceleration[k] = acceleration[k - 1];
      }
    }
    return 0.0;
  };
  const auto rms = [&](int steps, bool told) {
    double sum = 0;
    for (int p = 0; p < 10; ++p) sum += std::pow(error(steps, (p + 0.5) / 10, told), 2);
    return std::sqrt(sum / 10);
  };
  EXPECT_NEAR(std::log2(rms(100, true) / rms(200, true)), 3, 0.15);
  EXPECT_NEAR(std::log2(rms(100, false) / rms(200, false)), 1, 0.15);
  EXPECT_LT(rms(100, true), 1e-5);
}

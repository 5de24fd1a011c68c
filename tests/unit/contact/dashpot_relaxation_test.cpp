// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/dashpot_relaxation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rodpack/contact/contact_law.h"
#include "rodpack/motion/stability_limit.h"
#include "table.h"

namespace rodpack {
namespace {

/// Largest |x| in the last tenth of `steps` steps of leapfrog, dt = 1, on
///   x'' = -y^2 x - 2 eta y u,  tau u' = x' - u,
/// from the motion that changes its sign in every step.
double late_amplitude(double y, double eta, double tau, int steps) {
  double x = 1.0, v = -2.0, u = -2.0 * share_in_fastest_motion(tau, 1.0), late = 0.0;
  const double kept = kept_in_step(tau, 1.0);
  for (int n = 0; n < steps; ++n) {
    u = relaxed_velocity(u, v, kept);
    v -= y * y * x + 2.0 * eta * y * u;
    x += v;
    if (!(std::fabs(x) < 1e100)) return std::fabs(x);
    if (10 * n >= 9 * steps) late = std::max(late, std::fabs(x));
  }
  return late;
}

/// Rebound over approach of two unit masses with k = 1/2 (omega_0 = 1) by leapfrog.
double restitution(double eta, double tau, double dt) {
  const double kept = kept_in_step(tau, dt);
  double x = 0.0, v = -1.0, u = v;  // gap and its rate, at touch
  v -= 0.5 * dt * 2.0 * eta * u;    // the first kick lasts half a step
  while (true) {
    x += dt * v;
    u = relaxed_velocity(u, v, kept);
    const double force = -x - 2.0 * eta * u;
    if (!(force > 0.0)) return v;
    v += dt * force;
  }
}

/// The same by the classical Runge-Kutta method.
double reference_restitution(double eta, double tau) {
  typedef std::array<double, 3> State;  // x, v, u
  const double dt = 1e-4;
  const auto moved = [](const State& y, double h, const State& rate) {
    return State{y[0] + h * rate[0], y[1] + h * rate[1], y[2] + h * rate[2]};
  };
  const auto rate = [&](const State& y) {
    return State{y[1], -y[0] - 2.0 * eta * y[2], (y[1] - y[2]) / tau};
  };
  State y = {0.0, -1.0, -1.0};
  while (rate(y)[1] > 0.0) {
    const State a = rate(y), b = rate(moved(y, 0.5 * dt, a)), c = rate(moved(y, 0.5 * dt, b)),
                d = rate(moved(y, dt, c));
    y = moved(moved(moved(moved(y, dt / 6, a), dt / 3, b), dt / 3, c), dt / 6, d);
  }
  return y[1];
}

}  // namespace

TEST(DashpotRelaxation, WithoutATimeADashpotFeelsTheVelocityOfNow) {
  EXPECT_EQ(kept_in_step(0.0, 1e-5), 0.0);
  EXPECT_EQ(share_in_fastest_motion(0.0, 1e-5), 1.0);
  EXPECT_EQ(relaxed_velocity(3.0, -0.7, 0.0), -0.7);
}

// v = cos(w t) from rest: u = (cos(w t) + w tau sin(w t) - exp(-t/tau)) / (1 + (w tau)^2), of
// first order: the velocity of a step's end stands for the whole step.
TEST(DashpotRelaxation, WhatIsFeltFollowsTheVelocity) {
  const double w = 3.0, tau = 0.2, t = 1.0;
  const double exact =
      (std::cos(w * t) + w * tau * std::sin(w * t) - std::exp(-t / tau)) / (1 + w * w * tau * tau);
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const int steps = 400 << i;
    double u = 0.0;
    for (int n = 1; n <= steps; ++n)
      u = relaxed_velocity(u, std::cos(w * t * n / steps), kept_in_step(tau, t / steps));
    error[i] = std::fabs(u - exact);
  }
  EXPECT_NEAR(test::observed_order(error[0], error[1]), 1, 0.05);
  EXPECT_LT(error[1], 2e-3);
}

TEST(DashpotRelaxation, OfAMotionThatChangesItsSignInEveryStepItFeelsTheTangens) {
  for (double tau : {0.1, 1.0, 5.0}) {
    double u = 0.0;
    for (int n = 0; n < 1000; ++n)
      u = relaxed_velocity(u, n % 2 == 0 ? 1.0 : -1.0, kept_in_step(tau, 1.0));
    EXPECT_NEAR(-u, share_in_fastest_motion(tau, 1.0), 1e-12) << tau;
  }
}

// y^2 + 4 eta y tanh(dt / 2 tau) <= 4: the limit of velocity Verlet with so much of the dashpot.
TEST(DashpotRelaxation, TheLimitIsThatWithTheShareOfTheFastestMotion) {
  for (double tau : {0.3, 1.0, 3.0})
    for (double eta : {0.2, 1.0, 3.0}) {
      const double limit = stability_limit(0, share_in_fastest_motion(tau, 1.0) * eta);
      EXPECT_LT(late_amplitude(0.99 * limit, eta, tau, 3000), 1e-3) << tau << ' ' << eta;
      EXPECT_GT(late_amplitude(1.01 * limit, eta, tau, 3000), 1e3) << tau << ' ' << eta;
      EXPECT_GT(limit, stability_limit(0, eta));
    }
}

// Against Runge-Kutta's steps of the same equations. To first order in tau the rebound is slower
// than without, by the share 2 eta^2 tau of its decay, and shorter by eta tau.
TEST(DashpotRelaxation, ReboundsAreThoseOfTheStandardLinearSolid) {
  const double eta = 0.2;
  EXPECT_NEAR(restitution(eta, 0.0, 1e-4), restitution_coefficient(eta), 2e-4);
  for (double tau : {0.05, 0.15, 0.5}) {
    EXPECT_NEAR(restitution(eta, tau, 1e-4), reference_restitution(eta, tau), 2e-4) << tau;
    EXPECT_LT(std::fabs(reference_restitution(eta, tau) - restitution_coefficient(eta)), 0.1 * tau);
  }
}

}  // namespace rodpack

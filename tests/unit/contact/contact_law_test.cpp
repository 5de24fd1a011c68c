// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_law.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "rodpack/motion/multistep.h"
#include "table.h"

namespace rodpack {
namespace {

const double pi = std::acos(-1.0);

// Two masses on a spring k vibrate as one mass m at a wall would, k / m = k / m_i + k / m_j.
TEST(ContactLaw, EffectiveMassIsThatOfTheRelativeMotion) {
  EXPECT_DOUBLE_EQ(effective_mass(2, 2), 1);
  EXPECT_DOUBLE_EQ(1 / effective_mass(2, 6), 1.0 / 2 + 1.0 / 6);
  EXPECT_NEAR(effective_mass(2, 1e12), 2, 1e-11);
}

TEST(ContactLaw, DampingRatioOneIsCritical) {
  // m x'' + c x' + k x = 0 is critically damped at c^2 = 4 m k.
  EXPECT_DOUBLE_EQ(damping_coefficient(1, 3, 12), std::sqrt(4 * 3.0 * 12));
  EXPECT_DOUBLE_EQ(damping_coefficient(0.2, 3, 12), 0.2 * 12);
}

TEST(ContactLaw, NormalForceIsSpringPlusDashpot) {
  const NormalForce f = normal_force(1000, 0.5, 2e-5, -0.01);  // approaching
  EXPECT_DOUBLE_EQ(f.elastic, 0.02);
  EXPECT_DOUBLE_EQ(f.total, 0.025);
}

TEST(ContactLaw, NormalForceNeverAttracts) {
  const NormalForce f = normal_force(1000, 0.5, 2e-5, 0.05);  // 0.02 N - 0.025 N
  EXPECT_EQ(f.total, 0.0);
  EXPECT_DOUBLE_EQ(f.elastic, 0.02);  // what the Coulomb cap uses
}

TEST(ContactLaw, TangentialForceOpposesSpringAndSlip) {
  double spring[3] = {1e-5, 0, -2e-5}, force[3];
  const double velocity[3] = {0.01, 0.02, 0};
  EXPECT_FALSE(tangential_force(500.0, 0.1, 1.0, spring, velocity, force));
  EXPECT_DOUBLE_EQ(force[0], -(500 * 1e-5 + 0.1 * 0.01));
  EXPECT_DOUBLE_EQ(force[1], -0.1 * 0.02);
  EXPECT_DOUBLE_EQ(force[2], 500 * 2e-5);
  EXPECT_EQ(spring[2], -2e-5);
}

TEST(ContactLaw, CoulombCapKeepsTheDirectionAndShortensTheSpring) {
  // Uncapped force -(3, 4) N; cap 2 N: force -(1.2, 1.6) N, spring alone carries it.
  double spring[2] = {2e-3, 4e-3}, force[2];
  const double velocity[2] = {10, 0};
  EXPECT_TRUE(tangential_force(1000.0, 0.1, 2.0, spring, velocity, force));
  EXPECT_DOUBLE_EQ(force[0], -1.2);
  EXPECT_DOUBLE_EQ(force[1], -1.6);
  EXPECT_DOUBLE_EQ(spring[0], 1.2e-3);
  EXPECT_DOUBLE_EQ(spring[1], 1.6e-3);
  // At rest with the shortened spring the force is the cap, no longer limited.
  const double rest[2] = {0, 0};
  EXPECT_FALSE(tangential_force(1000.0, 0.1, 2.0 * (1 + 1e-15), spring, rest, force));
  EXPECT_DOUBLE_EQ(std::hypot(force[0], force[1]), 2.0);
}

TEST(ContactLaw, WithoutFrictionThereIsNoTangentialForce) {
  double spring[2] = {1e-3, 0}, force[2];
  const double velocity[2] = {0.1, 0.2};
  EXPECT_TRUE(tangential_force(1000.0, 0.1, 0.0, spring, velocity, force));
  EXPECT_EQ(std::hypot(force[0], force[1]), 0.0);
  EXPECT_EQ(std::hypot(spring[0], spring[1]), 0.0);
}

TEST(ContactLaw, DashpotAloneIsCappedToo) {
  double spring[2] = {0, 0}, force[2];
  const double velocity[2] = {0.1, 0};
  EXPECT_TRUE(tangential_force(0.0, 100.0, 3.0, spring, velocity, force));
  EXPECT_DOUBLE_EQ(force[0], -3.0);
  EXPECT_EQ(spring[0], 0.0);
}

TEST(Restitution, ClosedFormIsThatOfTheContactWithoutTension) {
  // delta'' + 2 eta w delta' + w^2 delta = 0 from delta = 0, delta' = 1; the contact ends where
  // delta'' = 0: tan(w_d t) = -2 eta s / (1 - 2 eta^2), s = sqrt(1 - eta^2); e = -delta' there.
  for (double eta : {0.05, 0.2, 0.4, 0.7, 0.9}) {
    const double s = std::sqrt(1 - eta * eta);
    const double phase = std::atan2(2 * eta * s, 2 * eta * eta - 1);  // in (0, pi)
    const double e = -std::exp(-eta / s * phase) * (std::cos(phase) - eta / s * std::sin(phase));
    EXPECT_NEAR(restitution_coefficient(eta), e, 1e-14) << eta;
    EXPECT_GT(e, std::exp(-pi * eta / s));
  }
  EXPECT_NEAR(restitution_coefficient(0.2), 0.5717, 5e-5);
  EXPECT_EQ(restitution_coefficient(0), 1.0);
}

TEST(Restitution, IsContinuousThroughCriticalDamping) {
  // Critical: delta = t exp(-t), delta'' = (t - 2) exp(-t) = 0 at t = 2, -delta' = exp(-2).
  EXPECT_NEAR(restitution_coefficient(1), std::exp(-2.0), 1e-15);
  for (double side : {-1.0, 1.0}) {
    const double inside = restitution_coefficient(1 + side * 0.999e-5);
    const double outside = restitution_coefficient(1 + side * 1.001e-5);
    EXPECT_NEAR(inside, outside, 1e-8);
  }
  // Overdamped, eta = 2: delta ~ exp(-a t) - exp(-b t) with a, b = 2 -+ sqrt(3), a b = 1. delta'' =
  // 0 at t = 2 ln(b/a) / (b - a) and -delta' = (a exp(-a t) - b exp(-b t)) / (b - a).
  const double a = 2 - std::sqrt(3.0), b = 2 + std::sqrt(3.0), t = 2 * std::log(b / a) / (b - a);
  EXPECT_NEAR(restitution_coefficient(2), (a * std::exp(-a * t) - b * std::exp(-b * t)) / (b - a),
              1e-14);
}

TEST(Restitution, RefusesNegativeDamping) {
  EXPECT_THROW(restitution_coefficient(-0.1), std::invalid_argument);
  EXPECT_THROW(restitution_coefficient(std::nan("")), std::invalid_argument);
}

// Both directions (1 - eta^2 loses three digits at 0.999); the values of the page of the contact
// models, rounded there to four digits.
TEST(Restitution, HasAnInverse) {
  for (double eta : {0.0, 1e-6, 0.05, 0.2, 0.5, 0.9, 0.999, 1.0})
    EXPECT_NEAR(damping_ratio_for(restitution_coefficient(eta)), eta, 1e-13) << eta;
  for (double e : {0.14, 0.3, 0.5, 0.9, 0.99})
    EXPECT_NEAR(restitution_coefficient(damping_ratio_for(e)), e, 1e-15) << e;
  EXPECT_NEAR(damping_ratio_for(0.95), 0.0165, 5e-5);
  EXPECT_NEAR(damping_ratio_for(0.5), 0.2553, 5e-5);
  EXPECT_NEAR(damping_ratio_for(0.2), 0.7312, 5e-5);
  EXPECT_EQ(damping_ratio_for(1.0), 0.0);
  for (double e : {1.001, 0.135, 0.0, -0.5, std::nan("")})
    EXPECT_THROW(damping_ratio_for(e), std::invalid_argument) << e;
}

// A body that flies against a wall, integrated as in a simulation: Adams-Bashforth of third order
// with a history that was long free of force when the contact began somewhere within a step.
double simulated_restitution(double damping_ratio, int steps_per_contact, double begin) {
  const double mass = 2.3e-4, stiffness = 2000, speed = 0.5;
  const double damping = damping_coefficient(damping_ratio, mass, stiffness);
  const double dt = pi * std::sqrt(mass / stiffness) / steps_per_contact;
  double overlap = -begin * speed * dt, velocity = speed;  // of penetration
  const auto& w = adams_bashforth_weights(3);
  std::array<double, 3> v = {speed, speed, speed}, a = {0, 0, 0};  // newest first
  for (bool touched = false; !touched || overlap > 0;) {
    const double force =
        overlap > 0 ? normal_force(stiffness, damping, overlap, -velocity).total : 0.0;
    touched = touched || overlap > 0;
    v = {velocity, v[0], v[1]};
    a = {-force / mass, a[0], a[1]};
    overlap += multistep_increment(w, 3, dt, [&](int k) { return v[k]; });
    velocity += multistep_increment(w, 3, dt, [&](int k) { return a[k]; });
  }
  return -velocity / speed;
}

TEST(Restitution, SimulatedCollisionApproachesTheClosedForm) {
  // The force jumps to c v at first touch, within a step: with damping the error is of first order
  // in dt, whatever the integrator; without, the force sets in with a kink and it is of second
  // order. Its size depends on where in the step the contact begins: 0.5 % of e at 60 steps per
  // contact.
  for (double eta : {0.0, 0.1, 0.2, 0.4}) {
    const int steps[3] = {60, 600, 6000};
    double worst[3] = {0, 0, 0};
    for (int i = 0; i < 3; ++i)
      for (double begin : {0.05, 0.35, 0.65, 0.95})
        worst[i] = std::max(worst[i], std::fabs(simulated_restitution(eta, steps[i], begin) -
                                                restitution_coefficient(eta)));
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(test::observed_order(worst[i], worst[i + 1], 10), eta == 0.0 ? 2 : 1, 0.1) << eta;
    EXPECT_LT(worst[2], 1e-4) << eta;
  }
}

}  // namespace
}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/power_law.h"

#include <gtest/gtest.h>

#include <cmath>

// The force c delta^p summed over small changes of the overlap, and its slope, by Simpson's rule
// and a central difference.
TEST(PowerLaw, EnergyIsTheIntegralAndStiffnessTheSlopeOfTheForce) {
  const double c = 1234.0, overlap = 2e-4;
  for (const double exponent : {1.0, 1.5, 2.0}) {
    const auto force = [&](double delta) { return c * std::pow(delta, exponent); };
    const int n = 2000;
    double integral = 0.0;
    for (int k = 0; k < n; ++k) {
      const double a = overlap * k / n, b = overlap * (k + 1) / n;
      integral += (b - a) / 6 * (force(a) + 4 * force(0.5 * (a + b)) + force(b));
    }
    const double secant = force(overlap) / overlap;
    EXPECT_NEAR(rodpack::elastic_energy(secant, overlap, exponent) / integral, 1, 1e-7);
    const double h = 1e-4 * overlap;
    const double slope = (force(overlap + h) - force(overlap - h)) / (2 * h);
    EXPECT_NEAR(rodpack::tangent_stiffness(secant, exponent) / slope, 1, 1e-8);
  }
}

// pi sqrt(m / k (1 - eta^2)) with the dashpot 2 eta sqrt(m k); from the critical one on, never.
TEST(PowerLaw, HalfAPeriodOfADampedSpring) {
  const double k = 1000, mass = 3.5e-5;
  for (const double eta : {0.0, 0.2, 0.9})
    EXPECT_NEAR(rodpack::half_period(k, 2 * eta * std::sqrt(mass * k), mass) /
                    (M_PI * std::sqrt(mass / (k * (1 - eta * eta)))),
                1, 1e-12);
  EXPECT_TRUE(std::isinf(rodpack::half_period(k, 2.01 * std::sqrt(mass * k), mass)));
}

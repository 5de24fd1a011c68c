// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/stability_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <limits>
#include <stdexcept>

#include "rodpack/motion/multistep.h"

namespace rodpack {
namespace {

const std::initializer_list<double> damping_ratios = {0.0, 0.01, 0.05, 0.2, 0.5,
                                                      0.9, 1.0,  1.5,  3.0};

// z^2 - (2 - y^2 - 2 eta y) z + 1 - 2 eta y has both roots within the unit circle as long as its
// value at -1, 4 - 4 eta y - y^2, is not negative: y = 2 (sqrt(1 + eta^2) - eta).
TEST(StabilityLimit, VelocityVerletWithLaggedVelocityIsTheClosedForm) {
  for (const double eta : damping_ratios)
    EXPECT_NEAR(stability_limit(0, eta), 2 * (std::sqrt(1 + eta * eta) - eta), 1e-7) << eta;
}

// z = 1 + lambda dt: |z|^2 = 1 - 2 eta y + y^2 while the motion oscillates, |1 - y (eta +
// sqrt(eta^2 - 1))| when it does not.
TEST(StabilityLimit, FirstOrderIsTheClosedForm) {
  for (const double eta : damping_ratios)
    EXPECT_NEAR(stability_limit(1, eta), eta <= 1 ? 2 * eta : 2 / (eta + std::sqrt(eta * eta - 1)),
                1e-9)
        << eta;
}

// For a slow oscillation order 2 gains |z| - 1 = y^4 / 4 per step and loses eta y: y^3 = 4 eta.
TEST(StabilityLimit, SecondOrderVanishesAsTheCubeRootOfTheDamping) {
  EXPECT_NEAR(stability_limit(2, 1e-6) / std::cbrt(4e-6), 1, 1e-2);
  EXPECT_EQ(stability_limit(2, 0), 0.0);
  EXPECT_EQ(stability_limit(1, 0), 0.0);
}

// Where the boundary z = exp(i t) of the region of stability meets the imaginary axis first:
// lambda dt = (z - 1) / sum w_k z^-k, whose real part changes sign there.
TEST(StabilityLimit, ImaginaryAxis) {
  for (const int order : {3, 4}) {
    const auto boundary = [order](double t) {
      const std::complex<double> z = std::polar(1.0, t);
      std::complex<double> sum = 0;
      for (int k = 0; k < order; ++k) sum += adams_bashforth_weights(order)[k] * std::pow(z, -k);
      return (z - 1.0) / sum;
    };
    double first = 10;
    const double step = 1e-5;
    for (double t = 0.2; t < 3.1; t += step)
      if (boundary(t).real() * boundary(t + step).real() < 0)
        first = std::min(first, std::fabs(boundary(t).imag()));
    EXPECT_NEAR(stability_limit(order, 0), first, 1e-4) << order;
  }
  EXPECT_NEAR(stability_limit(3, 0), 0.7236, 5e-5);
  EXPECT_NEAR(stability_limit(4, 0), 0.4300, 5e-5);
}

// On the real axis z = -1 comes first: lambda dt = -2 / sum w_k (-1)^k.
TEST(StabilityLimit, RealAxis) {
  const double axis[] = {2, 2, 1, 6.0 / 11, 3.0 / 10};
  for (int order = 1; order <= 4; ++order) {
    EXPECT_NEAR(stability_limit(order, 1), axis[order], 1e-6) << order;
    const double eta = 20, fast = eta + std::sqrt(eta * eta - 1);
    EXPECT_NEAR(stability_limit(order, eta) * fast, axis[order], 1e-6) << order;
  }
}

TEST(StabilityLimit, AmplificationIsOneAtTheLimitAndMoreBeyond) {
  for (int order = 0; order <= 4; ++order) {
    for (const double eta : {0.05, 0.2, 0.9, 2.0}) {
      const double limit = stability_limit(order, eta);
      EXPECT_NEAR(amplification(order, eta, limit), 1, 1e-9) << order << ' ' << eta;
      EXPECT_LT(amplification(order, eta, 0.99 * limit), 1) << order << ' ' << eta;
      EXPECT_GT(amplification(order, eta, 1.01 * limit), 1 + 1e-5) << order << ' ' << eta;
    }
  }
}

// The oscillator itself, step by step as the integrators go.
TEST(StabilityLimit, AmplificationIsTheGrowthOfTheOscillator) {
  for (int order = 0; order <= 4; ++order) {
    for (const double eta : {0.0, 0.2, 0.6}) {
      const double y = 1.1 * std::max(0.3, stability_limit(order, eta));
      const auto acceleration = [&](double x, double v) { return -x - 2 * eta * v; };
      const auto& w = adams_bashforth_weights(std::max(order, 1));
      double x = 1, velocity = 0.3;
      std::array<double, 4> v{velocity, velocity, velocity, velocity}, a{};
      const auto size = [&] { return std::hypot(x, velocity); };
      double log_before = 0, log_size = 0;
      const int steps = 4000;
      for (int n = 0; n < steps; ++n) {
        if (order == 0) {
          velocity += y * acceleration(x, velocity);
          x += y * velocity;
        } else {
          v = {velocity, v[0], v[1], v[2]};
          a = {acceleration(x, velocity), a[0], a[1], a[2]};
          x += multistep_increment(w, order, y, [&](int k) { return v[k]; });
          velocity += multistep_increment(w, order, y, [&](int k) { return a[k]; });
        }
        const double scale = size();
        log_size += std::log(scale);
        x /= scale;
        velocity /= scale;
        for (double& past : v) past /= scale;
        for (double& past : a) past /= scale;
        if (n == steps / 2 - 1) log_before = log_size;
      }
      // The phase of an oscillation leaves a rest that falls with the number of steps.
      const double growth = std::exp((log_size - log_before) / (steps / 2));
      EXPECT_NEAR(growth, amplification(order, eta, y), 2e-3) << order << ' ' << eta;
    }
  }
}

TEST(StabilityLimit, RefusesOtherOrdersAndNegativeDamping) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(stability_limit(-1, 0.2), std::invalid_argument);
  EXPECT_THROW(stability_limit(5, 0.2), std::invalid_argument);
  EXPECT_THROW(stability_limit(3, -0.1), std::invalid_argument);
  EXPECT_THROW(stability_limit(3, nan), std::invalid_argument);
  EXPECT_THROW(amplification(3, 0.2, -1), std::invalid_argument);
  EXPECT_THROW(amplification(3, 0.2, nan), std::invalid_argument);
  EXPECT_NO_THROW(stability_limit(0, 0));
}

// All motions at one frequency and one delay: the scalar limit.
TEST(TimestepLimit, OfOneMotionIsTheScalarLimit) {
  const double omega = 5000;
  for (int order = 0; order <= 4; ++order) {
    for (const double eta : {0.1, 0.6, 1.5}) {
      const double delay = 2 * eta / omega;
      const MotionBounds motion = {omega * omega, 2 * eta * omega, delay, delay};
      EXPECT_NEAR(timestep_limit(order, motion) * omega / stability_limit(order, eta), 1, 1e-12);
    }
  }
}

// Whatever motion the bounds allow is stable.
TEST(TimestepLimit, IsSafeForAllMotionsWithinTheBounds) {
  const MotionBounds bounds = {1.0, 1.5, 0.2, 3.0};
  for (int order = 0; order <= 4; ++order) {
    const double dt = timestep_limit(order, bounds);
    double least = 1e300;
    for (int a = 1; a <= 100; ++a) {
      for (int b = 2; b <= 30; ++b) {
        const double kappa = 0.01 * a, c = 0.1 * b * kappa, omega = std::sqrt(kappa);
        if (c > bounds.damping * (1 + 1e-12)) continue;
        least = std::min(least, stability_limit(order, 0.5 * c / omega) / omega);
      }
    }
    EXPECT_LE(dt, least * (1 + 1e-9)) << order;
    EXPECT_GT(dt, 0.98 * least) << order;  // and not much below
  }
}

TEST(TimestepLimit, RefusesWhatIsNoBound) {
  EXPECT_THROW(timestep_limit(3, {0, 1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(timestep_limit(3, {1, -1, 0, 1}), std::invalid_argument);
  EXPECT_THROW(timestep_limit(3, {1, 1, -1, 1}), std::invalid_argument);
  EXPECT_THROW(timestep_limit(3, {1, 1, 2, 1}), std::invalid_argument);
  EXPECT_THROW(timestep_limit(5, {1, 1, 1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/multistep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "table.h"

namespace rodpack {
namespace {

using test::observed_order;

// Integral over [from, to] of the Lagrange basis polynomial that is 1 at nodes[i], 0 at the others.
long double lagrange_integral(const std::vector<int>& nodes, std::size_t i, int from, int to) {
  std::vector<long double> c = {1};  // coefficients, lowest power first
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (j == i) continue;
    c.push_back(0);
    const long double span = nodes[i] - nodes[j];
    for (std::size_t p = c.size() - 1; p > 0; --p) c[p] = (c[p - 1] - nodes[j] * c[p]) / span;
    c[0] *= -nodes[j] / span;
  }
  long double sum = 0;
  for (std::size_t p = 0; p < c.size(); ++p)
    sum += c[p] * (std::pow(1.0L * to, p + 1.0L) - std::pow(1.0L * from, p + 1.0L)) / (p + 1);
  return sum;
}

TEST(Multistep, BeyondTheStartTheWeightsIntegrateTheInterpolant) {
  for (int order = 1; order <= max_multistep_order; ++order) {
    std::vector<int> nodes;
    for (int k = 0; k < order; ++k) nodes.push_back(-k);
    for (int evaluations : {order + 1, order + 2, 1000000}) {
      const auto& w = multistep_weights(order, evaluations);
      for (int k = 0; k < max_multistep_order; ++k)
        EXPECT_NEAR(w[k], k < order ? lagrange_integral(nodes, k, 0, 1) : 0, 1e-14);
    }
    EXPECT_EQ(&adams_bashforth_weights(order), &multistep_weights(order, order + 1));
  }
}

// A force that jumps from 0 to 1 within a step, unnoticed, is known from the end of that step on.
// Once it fills the formula it has given the momentum of half a step more than there were steps
// since then, where what was left of the step of the jump should have: on average a half.
TEST(Multistep, AJumpThatGoesUnnoticedIsHalfAStepEarly) {
  for (int order = 2; order <= max_multistep_order; ++order) {
    const auto& w = adams_bashforth_weights(order);
    double momentum = 0;
    for (int step = 0; step < order; ++step)
      for (int k = 0; k <= step; ++k) momentum += w[k];
    EXPECT_NEAR(momentum, order + 0.5, 1e-14) << order;
  }
}

TEST(Multistep, StartUpRepairsWhatTheLowerOrdersMissed) {
  // Step n: the interpolant of f_0..f_n from 0 to n+1, less that of f_0..f_{n-1} from 0 to n.
  for (int order = 1; order <= max_multistep_order; ++order) {
    for (int n = 0; n < order; ++n) {
      std::vector<int> now, before;
      for (int i = 0; i <= n; ++i) now.push_back(i);
      for (int i = 0; i < n; ++i) before.push_back(i);
      for (int k = 0; k < max_multistep_order; ++k) {
        long double expected = 0;
        if (k <= n) expected += lagrange_integral(now, n - k, 0, n + 1);
        if (k >= 1 && k <= n) expected -= lagrange_integral(before, n - k, 0, n);
        EXPECT_NEAR(multistep_weights(order, n + 1)[k], expected, 1e-14) << order << n << k;
      }
    }
  }
}

// Integrates y' = f(t, y) from t = 0, y = y0; returns the values at the steps' ends.
std::vector<double> integrate(int order, double dt, int steps, double y0,
                              const std::function<double(double, double)>& f) {
  std::vector<double> y = {y0}, rates;
  for (int n = 0; n < steps; ++n) {
    rates.push_back(f(n * dt, y.back()));
    const auto increment =
        multistep_increment(multistep_weights(order, n + 1), std::min(order, n + 1), dt,
                            [&](int k) { return rates[n - k]; });
    y.push_back(y.back() + increment);
  }
  return y;
}

TEST(Multistep, PolynomialsBelowTheOrderAreExactOnceStarted) {
  // f = (t - 0.3)^(order-1), y = t-integral of it, from step `order` on.
  for (int order = 1; order <= max_multistep_order; ++order) {
    const auto y = integrate(order, 0.1, 20, 0,
                             [order](double t, double) { return std::pow(t - 0.3, order - 1); });
    for (int n = order; n <= 20; ++n) {
      const double expected = (std::pow(0.1 * n - 0.3, order) - std::pow(-0.3, order)) / order;
      EXPECT_NEAR(y[n], expected, 1e-14) << order << " " << n;
    }
  }
}

TEST(Multistep, ForceKnownInTimeShowsTheFullOrderFromTheStart) {
  // y' = cos(3t): y = sin(3t)/3. The largest error of all steps from `order` on, start-up included.
  for (int order = 1; order <= max_multistep_order; ++order) {
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int steps = 200 << fine;
      const double dt = 1.0 / steps;
      const auto y =
          integrate(order, dt, steps, 0, [](double t, double) { return std::cos(3 * t); });
      error[fine] = 0;
      for (int n = order; n <= steps; ++n)
        error[fine] = std::max(error[fine], std::fabs(y[n] - std::sin(3 * n * dt) / 3));
    }
    EXPECT_NEAR(observed_order(error[0], error[1]), order, 0.1) << order;
  }
}

TEST(Multistep, ForceThatDependsOnTheSolutionReachesOrderThree) {
  // y' = -y. The first step misses dt^2/2 y''; until the second step repairs it f_1 carries that
  // error, which leaves O(dt^3) in y for good: orders 1, 2, 3, and 3 for order 4.
  const int expected[] = {1, 2, 3, 3};
  for (int order = 1; order <= max_multistep_order; ++order) {
    double error[2];
    for (int fine = 0; fine < 2; ++fine) {
      const int steps = 400 << fine;
      const auto y = integrate(order, 1.0 / steps, steps, 1, [](double, double v) { return -v; });
      error[fine] = y.back() - std::exp(-1.0);
    }
    EXPECT_NEAR(observed_order(std::fabs(error[0]), std::fabs(error[1])), expected[order - 1], 0.1)
        << order;
  }
}

}  // namespace
}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/claims/histogram_tests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace {
using namespace rodpack;
const double degree = std::acos(-1.0) / 180;

// A density over `range` degrees in bins of 5 degrees, with one standard error for all bins.
EnsembleCurve density(double range, double sem, int n, const std::function<double(double)>& shape) {
  EnsembleCurve curve;
  for (double g = 0; g < range; g += 5) {
    curve.x.push_back(g);
    curve.y.push_back({shape(g * degree) / range, sem, n});
  }
  return curve;
}

// Means over `n` histograms of `particles` independent angles each.
EnsembleCurve drawn(std::mt19937& random, double range, int n, int particles,
                    const std::function<double(double)>& shape) {
  const auto bins = static_cast<std::size_t>(range / 5);
  std::vector<double> weights;
  for (std::size_t k = 0; k < bins; ++k) weights.push_back(shape(5 * double(k) * degree));
  std::discrete_distribution<std::size_t> bin(weights.begin(), weights.end());
  std::vector<double> sum(bins), squares(bins);
  for (int run = 0; run < n; ++run) {
    std::vector<double> count(bins);
    for (int k = 0; k < particles; ++k) ++count[bin(random)];
    for (std::size_t k = 0; k < bins; ++k) {
      const double value = count[k] / particles / 5;
      sum[k] += value;
      squares[k] += value * value;
    }
  }
  EnsembleCurve curve;
  for (std::size_t k = 0; k < bins; ++k) {
    curve.x.push_back(5 * double(k));
    const double variance = (squares[k] - sum[k] * sum[k] / n) / (n - 1);
    curve.y.push_back({sum[k] / n, std::sqrt(std::max(0.0, variance) / n), n});
  }
  return curve;
}

double smooth_shape(double g) { return 1 + 0.6 * std::cos(2 * g) + 0.1 * std::sin(4 * g); }

TEST(NarrowPeaks, SmoothDistributionsHaveNone) {
  const auto departure = narrow_peaks(density(180, 1e-4, 4, smooth_shape));
  ASSERT_TRUE(departure);
  EXPECT_NEAR(departure->mean_square, 0, 1e-20);
  EXPECT_EQ(departure->above, 31);   // 36 bins, 5 amplitudes
  EXPECT_EQ(departure->below, 108);  // 36 bins, 3 degrees of freedom each
  EXPECT_EQ(departure->relative(), 0);
}

TEST(NarrowPeaks, SixthHarmonicOnAnIsotropicGroundHasAClosedForm) {
  // Residuals 0.3 m cos 6g: sum of squares over 36 bins 18 (0.3 m)^2, over 31 degrees of freedom
  // and m; the noise is sem^2 / m.
  const double m = 1.0 / 180, sem = 1e-4;
  const auto departure =
      narrow_peaks(density(180, sem, 4, [](double g) { return 1 + 0.3 * std::cos(6 * g); }));
  ASSERT_TRUE(departure);
  EXPECT_NEAR(departure->noise, sem * sem / m, 1e-15);
  EXPECT_NEAR(departure->relative_square(), 0.09 * 18 / 31 - sem * sem / (m * m), 1e-12);
  EXPECT_GT(departure->sigmas(), 5);
}

TEST(NarrowPeaks, NoiseAloneIsSignificantAsOftenAsItSays) {
  // Beyond 2 on one side: 2.3 %, in 500 trials +- 0.7 %; F has mean b / (b - 2) = 1.03.
  std::mt19937 random(5);
  int beyond = 0;
  double mean = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const auto departure = narrow_peaks(drawn(random, 180, 3, 2000, smooth_shape));
    ASSERT_TRUE(departure);
    mean += departure->f() / 500;
    if (departure->sigmas() > 2) ++beyond;
  }
  EXPECT_LT(beyond / 500.0, 0.05);
  EXPECT_NEAR(mean, 1.03, 0.05);
}

TEST(Asymmetry, FirstHarmonicHasAClosedForm) {
  // p = (1 + e cos g) / 360: a pair differs by 2 e cos g of a sum of 2. Over the 35 pairs from -85
  // to 85 degrees the sum of cos^2 is 18.
  const double m = 1.0 / 360, sem = 2e-5;
  const auto departure =
      asymmetry(density(360, sem, 5, [](double g) { return 1 + 0.2 * std::cos(g); }));
  ASSERT_TRUE(departure);
  EXPECT_EQ(departure->above, 35);
  EXPECT_NEAR(departure->relative_square(), 0.04 * 18 / 35 - sem * sem / (2 * m * m), 1e-12);
}

TEST(Asymmetry, LeftAndRightMayDiffer) {
  // sin 2g changes its sign under g -> 180 - g, sin g does not.
  const auto left =
      asymmetry(density(360, 2e-5, 5, [](double g) { return 1 + 0.3 * std::sin(g); }));
  const auto both =
      asymmetry(density(360, 2e-5, 5, [](double g) { return 1 + 0.3 * std::sin(2 * g); }));
  EXPECT_NEAR(left->mean_square, 0, 1e-20);
  EXPECT_GT(both->sigmas(), 5);
}

TEST(Asymmetry, NoiseAloneIsSignificantAsOftenAsItSays) {
  std::mt19937 random(7);
  int beyond = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const auto departure =
        asymmetry(drawn(random, 360, 3, 2000, [](double g) { return 1 + 0.8 * std::cos(2 * g); }));
    ASSERT_TRUE(departure);
    if (departure->sigmas() > 2) ++beyond;
  }
  EXPECT_LT(beyond / 500.0, 0.05);
}

TEST(HistogramTests, SingleRunsHaveNoScatter) {
  auto curve = density(180, 1e-4, 1, smooth_shape);
  for (auto& value : curve.y) value.sem.reset();
  EXPECT_FALSE(narrow_peaks(curve));
  EXPECT_FALSE(asymmetry(curve));
}

}  // namespace

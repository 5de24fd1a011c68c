// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {
using namespace rodpack;

// 1, 2, 3, 6: mean 3, squared deviations 4 + 1 + 0 + 9 = 14, so the variance is 14/3 and that of
// the mean 14/12.
TEST(MeanOverRuns, MatchesHandComputedValues) {
  const auto mean = mean_over_runs({1.0, 2.0, std::nullopt, 3.0, 6.0});
  EXPECT_EQ(mean.mean, 3);
  EXPECT_EQ(mean.n, 4);
  EXPECT_NEAR(mean.sem.value(), std::sqrt(14.0 / 12), 1e-15);
}

TEST(MeanOverRuns, ASingleRunHasNoErrorAndNoRunNoMean) {
  const auto single = mean_over_runs({std::nullopt, 0.1});
  EXPECT_EQ(single.mean, 0.1);
  EXPECT_FALSE(single.sem);
  EXPECT_EQ(single.n, 1);
  const auto none = mean_over_runs({std::nullopt, std::nan("")});
  EXPECT_EQ(none.n, 0);
  EXPECT_TRUE(std::isnan(none.mean));
}

// Three times 0.1 divided by three is not 0.1 in floating point.
TEST(MeanOverRuns, EqualValuesHaveThatMeanAndNoError) {
  const auto mean = mean_over_runs({0.1, 0.1, 0.1});
  EXPECT_EQ(mean.mean, 0.1);
  EXPECT_EQ(mean.sem.value(), 0);
}

// An axis at 179 degrees is 4 degrees from one at 3; deviations -2 and 2 from 1 degree, variance 8.
TEST(MeanAxisOverRuns, DirectionsAcrossTheEndOfTheRangeAreClose) {
  const auto mean = mean_axis_over_runs({179.0, 3.0});
  EXPECT_NEAR(mean.mean, 1, 1e-12);
  EXPECT_NEAR(mean.sem.value(), std::sqrt(8.0 / 2), 1e-12);
  EXPECT_NEAR(mean_axis_over_runs({178.0, 0.0}).mean, 179, 1e-12);
}

TEST(MeanAxisOverRuns, AwayFromTheEndItIsThePlainMean) {
  const auto axis = mean_axis_over_runs({80.0, 90.0, 100.0}),
             plain = mean_over_runs({80.0, 90.0, 100.0});
  EXPECT_NEAR(axis.mean, plain.mean, 1e-12);
  EXPECT_NEAR(axis.sem.value(), plain.sem.value(), 1e-12);
}

FunctionOfRuns mean_of(const std::vector<double>& values) {
  return [values](const std::vector<std::size_t>& runs) -> std::optional<double> {
    double sum = 0;
    for (const auto run : runs) sum += values[run];
    return sum / static_cast<double>(runs.size());
  };
}

// The mean of n values drawn from n has the variance of a single draw over n, sum (x - m)^2 / n^2:
// sem^2 (n - 1) / n. Times n / (n - 1) it is the standard error of the mean.
TEST(Bootstrap, OfAPlainMeanIsItsStandardError) {
  for (const std::vector<double>& values :
       {std::vector<double>{1, 4}, {1, 2, 6}, {0.3, 0.5, 0.4, 0.9}}) {
    ValuesOfRuns known(values.begin(), values.end());
    const auto expected = mean_over_runs(known);
    const auto found = bootstrap_over_runs(values.size(), mean_of(values));
    EXPECT_NEAR(found.mean, expected.mean, 1e-14);
    EXPECT_NEAR(found.sem.value(), expected.sem.value(), 1e-12) << values.size() << " runs";
    EXPECT_EQ(found.n, expected.n);
  }
}

// Random resamples: their standard deviation is itself known to 1 / sqrt(2 resamples) = 2.2 %.
TEST(Bootstrap, OfManyRunsIsClose) {
  std::vector<double> values;
  for (int k = 0; k < 30; ++k) values.push_back(std::sin(1.7 * k));
  const auto expected = mean_over_runs(ValuesOfRuns(values.begin(), values.end()));
  const auto found = bootstrap_over_runs(values.size(), mean_of(values));
  EXPECT_NEAR(found.sem.value() / expected.sem.value(), 1,
              4 / std::sqrt(2.0 * bootstrap_resamples));
  EXPECT_EQ(found.sem.value(), bootstrap_over_runs(values.size(), mean_of(values)).sem.value())
      << "another result the second time";
}

// The larger of two draws from {0, 1} is 0, 1, 1, 1: variance 3/16, times 2 / (2 - 1).
TEST(Bootstrap, OfAMaximumMatchesAllItsResamples) {
  const auto found = bootstrap_over_runs(2, [](const std::vector<std::size_t>& runs) {
    return std::optional<double>(static_cast<double>(*std::max_element(runs.begin(), runs.end())));
  });
  EXPECT_EQ(found.mean, 1);
  EXPECT_NEAR(found.sem.value(), std::sqrt(3.0 / 8), 1e-14);
}

TEST(Bootstrap, WhatHardlyExistsHasNoError) {
  // Exists where run 0 was drawn: in 19 of 27 resamples.
  const auto often_missing = [](const std::vector<std::size_t>& runs) -> std::optional<double> {
    if (!std::count(runs.begin(), runs.end(), 0U)) return std::nullopt;
    return 1.0;
  };
  EXPECT_EQ(bootstrap_over_runs(3, often_missing).n, 3);
  EXPECT_FALSE(bootstrap_over_runs(3, often_missing).sem);
  EXPECT_FALSE(bootstrap_over_runs(1, mean_of({5})).sem);
  EXPECT_EQ(bootstrap_over_runs(0, mean_of({})).n, 0);
}

// Bins at 1 and 2: the runs' own means are 3, 5 and 10: mean 6, squared deviations 9 + 1 + 16 = 26,
// over 2 and 3. Were the bins independent, the error would be smaller.
TEST(SumOverRanges, TakesARunForOneValueHoweverManyBinsItHas) {
  const double none = std::nan("");
  EnsembleCurve curve{"x", {0, 1, 2, 3}, {}, {{9, 2, 4, 9}, {9, 4, 6, 9}, {none, 9, 11, 9}}};
  const auto mean = sum_over_ranges(curve, {{1, 1, 2}});
  EXPECT_NEAR(mean.mean, 6, 1e-14);
  EXPECT_NEAR(mean.sem.value(), std::sqrt(26.0 / 6), 1e-14);
  EXPECT_EQ(mean.n, 3);
  EXPECT_NEAR(sum_over_ranges(curve, {{1, 0, 2}}).mean, 6, 1e-14) << "the third run has no 0";
  EXPECT_EQ(sum_over_ranges(curve, {{1, 0, 0}}).n, 0);
  EXPECT_EQ(sum_over_ranges(curve, {{1, 1, 2}, {1, 5, 6}}).n, 0);
  EXPECT_EQ(sum_over_ranges({"x", {0, 1}, {{1, {}, 1}, {2, {}, 1}}, {}}, {{1, 0, 1}}).n, 0);
}

// All runs grow by 2 from bin 1 to bin 2, wherever they begin: the growth has no error.
TEST(SumOverRanges, OfADifferenceNoiseThatIsCommonToARunFallsOut) {
  EnsembleCurve curve{"x", {1, 2}, {}, {{2, 4}, {4, 6}, {9, 11}}};
  const auto growth = sum_over_ranges(curve, {{1, 2, 2}, {-1, 1, 1}});
  EXPECT_NEAR(growth.mean, 2, 1e-14);
  EXPECT_NEAR(growth.sem.value(), 0, 1e-14);
}

}  // namespace

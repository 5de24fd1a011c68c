// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/claims/significance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {
using namespace rodpack;
const double pi = std::acos(-1.0);

EnsembleMean drawn(std::mt19937& random, double mean, double deviation, int n) {
  std::normal_distribution<double> normal(mean, deviation);
  double sum = 0, squares = 0;
  for (int k = 0; k < n; ++k) {
    const double value = normal(random);
    sum += value;
    squares += value * value;
  }
  const double variance = (squares - sum * sum / n) / (n - 1);
  return {sum / n, std::sqrt(variance / n), n};
}

TEST(StudentTail, OneAndTwoDegreesOfFreedomHaveClosedForms) {
  // dof 1 is Cauchy's distribution, 1/2 - atan(t)/pi; dof 2: 1/2 (1 - t / sqrt(2 + t^2)).
  for (const double t : {-3.0, -0.4, 0.0, 0.7, 2.0, 30.0}) {
    EXPECT_NEAR(student_tail(t, 1), 0.5 - std::atan(t) / pi, 1e-12);
    EXPECT_NEAR(student_tail(t, 2), 0.5 * (1 - t / std::sqrt(2 + t * t)), 1e-12);
  }
}

TEST(StudentTail, ManyDegreesOfFreedomAreNormal) {
  // Corrections are of order t^3 / dof.
  EXPECT_NEAR(student_tail(2, 1e7), 0.5 * std::erfc(2 / std::sqrt(2.0)), 1e-6);
}

TEST(FTail, TwoDegreesOfFreedomAboveHaveAClosedForm) {
  // P(F > f) = (1 + 2 f / b)^(-b/2).
  for (const double below : {3.0, 8.0, 40.0})
    for (const double f : {0.2, 1.0, 4.5})
      EXPECT_NEAR(f_tail(f, 2, below), std::pow(1 + 2 * f / below, -below / 2), 1e-12);
}

TEST(FTail, OneDegreeOfFreedomAboveIsTheSquareOfStudentsT) {
  EXPECT_NEAR(f_tail(2.25, 1, 7), 2 * student_tail(1.5, 7), 1e-12);
}

TEST(SigmasOf, InvertsTheTailOfTheNormalDistribution) {
  for (const double sigmas : {-3.0, 0.0, 1.0, 2.0, 8.0})
    EXPECT_NEAR(sigmas_of(0.5 * std::erfc(sigmas / std::sqrt(2.0))), sigmas, 1e-6);
}

TEST(Contrast, DifferenceHasErrorsInSquaresAndWelchsDegreesOfFreedom) {
  const auto difference = contrast_of({{1, {5, 0.3, 4}}, {-1, {3, 0.4, 9}}});
  ASSERT_TRUE(difference);
  EXPECT_NEAR(difference->value, 2, 1e-12);
  EXPECT_NEAR(difference->error, 0.5, 1e-12);
  // (0.09 + 0.16)^2 / (0.09^2 / 3 + 0.16^2 / 8)
  EXPECT_NEAR(difference->dof, 0.0625 / (0.0027 + 0.0032), 1e-9);
}

TEST(Contrast, NeedsRepetitions) {
  EXPECT_FALSE(contrast_of({{1, {5, std::nullopt, 1}}, {-1, {3, 0.4, 9}}}));
}

TEST(Slope, OfThreeEquallyPreciseMeansIsHalfTheDifferenceOfTheOuterOnes) {
  // Weights (x - 1) / 2 of x = 0, 1, 2: -1/2, 0, 1/2; error s / sqrt 2.
  const auto slope = slope_of({0, 1, 2}, {{1, 0.2, 3}, {7, 0.2, 3}, {4, 0.2, 3}});
  ASSERT_TRUE(slope);
  EXPECT_NEAR(slope->value, 1.5, 1e-12);
  EXPECT_NEAR(slope->error, 0.2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(slope->dof, 4, 1e-9);  // two means of 3 runs each count
}

TEST(Contrast, EqualMeansSeemDifferentAsOftenAsTheSignificanceSays) {
  // Two sides beyond 2: 4.55 %, in 6000 trials +- 0.27 %, if the degrees of freedom were 4. Welch's
  // are fewer where the two errors differ by chance, and the rate for three runs is lower.
  std::mt19937 random(3);
  int beyond = 0;
  for (int trial = 0; trial < 6000; ++trial) {
    const auto difference =
        contrast_of({{1, drawn(random, 0.8, 0.01, 3)}, {-1, drawn(random, 0.8, 0.01, 3)}});
    if (std::fabs(difference->sigmas_above()) > 2) ++beyond;
  }
  EXPECT_GT(beyond / 6000.0, 0.02);
  EXPECT_LT(beyond / 6000.0, 0.0455 + 0.0054);
}

}  // namespace

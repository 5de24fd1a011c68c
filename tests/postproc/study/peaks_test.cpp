// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/peaks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace {
using namespace rodpack;

EnsembleCurve curve_of(double sem, int n, const std::function<double(double)>& shape) {
  EnsembleCurve curve;
  for (int k = 0; k < 100; ++k) {
    const double r = 0.05 + 0.1 * k;
    curve.x.push_back(r);
    curve.y.push_back({shape(r), sem, n});
  }
  return curve;
}

// A parabola of this height, 0 from 0.35 d_p beside its place.
double bump(double r, double place, double height) {
  const double t = (r - place) / 0.35;
  return std::max(0.0, height * (1 - t * t));
}

TEST(Peaks, VertexOfAParabolaIsFoundBetweenTheBins) {
  const auto peaks = find_peaks(curve_of(0.01, 3, [](double r) { return 1 + bump(r, 1.738, 2); }));
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].position, 1.738, 1e-9);
  // The highest bin is at 1.75.
  EXPECT_NEAR(peaks[0].height.mean, 1 + bump(1.75, 1.738, 2), 1e-12);
  EXPECT_NEAR(peaks[0].prominence, bump(1.75, 1.738, 2), 1e-12);
  EXPECT_NEAR(peaks[0].prominence_error, 0.01 * std::sqrt(2.0), 1e-12);
}

TEST(Peaks, ErrorOfTheirPositionIsThatOfTheVertexToFirstOrder) {
  // A peak on a bin: a = c, so that dx = w (dc - da) / (2 |a - 2 b + c|); a - 2 b + c = -2 h w^2 /
  // 0.35^2, and both errors are s.
  const double s = 0.01, h = 2, w = 0.1;
  const auto peaks = find_peaks(curve_of(s, 3, [&](double r) { return bump(r, 2.05, h); }));
  ASSERT_EQ(peaks.size(), 1U);
  EXPECT_NEAR(peaks[0].position_error, w * s * std::sqrt(2.0) * 0.35 * 0.35 / (4 * h * w * w),
              1e-9);
}

TEST(Peaks, HaveToStandOutOfTheNoise) {
  const double s = 0.02, limit = 5 * s * std::sqrt(2.0);
  const auto with = [&](double height) {
    return find_peaks(curve_of(s, 3, [&](double r) { return 1 + bump(r, 4.05, height); }));
  };
  EXPECT_TRUE(with(0.95 * limit).empty());
  EXPECT_EQ(with(1.05 * limit).size(), 1U);
}

TEST(Peaks, NoiseAloneHasNone) {
  // Means of three runs of noise; by a simulation of its own one curve in 200 has a peak.
  std::mt19937 random(17);
  std::normal_distribution<double> normal(1, 0.1);
  int curves_with_peaks = 0;
  for (int trial = 0; trial < 400; ++trial) {
    auto curve = curve_of(0, 3, [](double) { return 1; });
    for (auto& value : curve.y) {
      const double a = normal(random), b = normal(random), c = normal(random);
      value.mean = (a + b + c) / 3;
      value.sem = std::sqrt((std::pow(a - value.mean, 2) + std::pow(b - value.mean, 2) +
                             std::pow(c - value.mean, 2)) /
                            6);
    }
    curves_with_peaks += find_peaks(curve).empty() ? 0 : 1;
  }
  EXPECT_LE(curves_with_peaks, 8);
}

TEST(Peaks, TwoBinsApartAreTwoWithAValleyBetween) {
  // As at sqrt 3 and 2 d_p in packings of coarse particles.
  auto curve = curve_of(0.02, 3, [](double) { return 0.5; });
  curve.y[17].mean = 2.1;  // 1.75
  curve.y[18].mean = 0.8;
  curve.y[19].mean = 2.2;  // 1.95
  const auto peaks = find_peaks(curve);
  ASSERT_EQ(peaks.size(), 2U);
  EXPECT_NEAR(peaks[0].prominence, 2.1 - 0.8, 1e-12);
  EXPECT_NEAR(peaks[1].prominence, 2.2 - 0.5, 1e-12);
}

TEST(Peaks, SingleRunsHaveNone) {
  auto curve = curve_of(0.01, 1, [](double r) { return 1 + bump(r, 1.75, 2); });
  for (auto& value : curve.y) value.sem.reset();
  EXPECT_TRUE(find_peaks(curve).empty());
}

}  // namespace

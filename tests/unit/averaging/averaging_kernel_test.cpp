// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/averaging_kernel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "rodpack/averaging/line_rule.h"

using namespace rodpack;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

constexpr KernelShape shapes[] = {KernelShape::gaussian, KernelShape::lucy, KernelShape::heaviside};

/// Moment of phi times r^power over all space, by Simpson's rule along the radius.
double radial_moment(const AveragingKernel& kernel, int power) {
  const int n = 4000;
  const double h = kernel.cutoff() / n;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double r = std::min(k * h, kernel.cutoff() * (1 - 1e-15));
    const double shell = kernel.dimension() == 2 ? 2 * M_PI * r : 4 * M_PI * r * r;
    const double weight = k == 0 || k == n ? 1 : k % 2 ? 4 : 2;
    sum += weight * shell * std::pow(r, power) * kernel(r * r);
  }
  return sum * h / 3;
}

}  // namespace

TEST(AveragingKernel, IntegratesToOneWhateverTheCutoff) {
  for (const int dimension : {2, 3}) {
    for (const auto shape : shapes) EXPECT_NEAR(radial_moment({shape, dimension, 0.7}, 0), 1, 1e-9);
    for (const double cutoff : {1.0, 2.0, 3.0, 5.0, 8.0})
      EXPECT_NEAR(radial_moment({KernelShape::gaussian, dimension, 0.7, cutoff}, 0), 1, 1e-9);
  }
}

// <r^2> = D w^2 when the variance along each axis is w^2.
TEST(AveragingKernel, HasTheVarianceOfItsScaleAlongEachAxis) {
  for (const int dimension : {2, 3})
    for (const auto shape : shapes)
      EXPECT_NEAR(radial_moment({shape, dimension, 0.7, 10}, 2), dimension * 0.49, 1e-8);
}

TEST(AveragingKernel, CutoffLeavesTheStatedShareOutside) {
  // 2D: exp(-c^2/2). 3D: erfc(c/sqrt 2) + sqrt(2/pi) c exp(-c^2/2).
  for (const double share : {0.1, 1e-3, 1e-6, 1e-12}) {
    const double c = gaussian_cutoff(share, 2);
    EXPECT_NEAR(std::exp(-c * c / 2) / share, 1, 1e-12);
    const double b = gaussian_cutoff(share, 3);
    const double outside =
        std::erfc(b / std::sqrt(2.0)) + std::sqrt(2 / M_PI) * b * std::exp(-b * b / 2);
    EXPECT_NEAR(outside / share, 1, 1e-10);
  }
}

// Integrals of phi(r - a - s b) and s phi over s in [0, 1], w = 0.9, in 50-digit arithmetic
// (mpmath.quad over the definition of each kernel, R from the variance).
TEST(AveragingKernel, LineIntegralMatchesFiftyDigitReference) {
  const double from_a[] = {0.5 - 0.3, 0.4 + 0.2, -0.1 - 0.25};
  const double branch[] = {1.1, 0.7, -0.6};
  const struct {
    KernelShape shape;
    int dimension;
    double mean, moment;
  } cases[] = {
      {KernelShape::gaussian, 2, 0.16151020601439769192, 0.077506687992341874726},
      {KernelShape::lucy, 2, 0.14721402956721269026, 0.071112364723983822307},
      {KernelShape::gaussian, 3, 0.070217649831278006229, 0.033916100310573276375},
      {KernelShape::lucy, 3, 0.057578896843398911635, 0.028017042266896047511},
  };
  for (const auto& [shape, dimension, mean, moment] : cases) {
    const auto line = AveragingKernel(shape, dimension, 0.9, 12).along(from_a, branch);
    EXPECT_NEAR(line.mean, mean, 1e-12 * mean);
    EXPECT_NEAR(line.moment, moment, 1e-12 * moment);
  }
}

// A line across the disc at distance p = 0.3 R: the part inside has the length 2 sqrt(R^2 - p^2).
TEST(AveragingKernel, HeavisideMeasuresTheChordInside) {
  const AveragingKernel kernel(KernelShape::heaviside, 2, 1);
  const double R = kernel.cutoff(), p = 0.3 * R, length = 10 * R;
  const double from_a[] = {4 * R, p}, branch[] = {length, 0};
  const double chord = 2 * std::sqrt(R * R - p * p);
  const auto line = kernel.along(from_a, branch);
  EXPECT_NEAR(line.mean, chord / length / (M_PI * R * R), 1e-14);
  EXPECT_NEAR(line.moment, 0.4 * line.mean, 1e-14);  // the chord's middle is at s = 0.4
}

TEST(AveragingKernel, LineIntegralIsAdditiveAndSymmetric) {
  for (const int dimension : {2, 3})
    for (const auto shape : shapes) {
      const AveragingKernel kernel(shape, dimension, 0.5, 3);
      const double from_a[] = {0.9, -0.4, 0.2}, branch[] = {2.3, 0.6, -0.7};
      const auto whole = kernel.along(from_a, branch);
      double half[3], from_middle[3], from_end[3], back[3];
      for (int d = 0; d < 3; ++d) {
        half[d] = branch[d] / 2;
        from_middle[d] = from_a[d] - half[d];
        from_end[d] = from_a[d] - branch[d];
        back[d] = -branch[d];
      }
      const auto first = kernel.along(from_a, half), second = kernel.along(from_middle, half);
      EXPECT_NEAR((first.mean + second.mean) / 2, whole.mean, 1e-13);
      EXPECT_NEAR((first.moment + second.moment + second.mean) / 4, whole.moment, 1e-13);
      const auto reversed = kernel.along(from_end, back);
      EXPECT_NEAR(reversed.mean, whole.mean, 1e-13);
      EXPECT_NEAR(reversed.moment, whole.mean - whole.moment, 1e-13);
      // The limit of a short branch is the kernel itself.
      const double nothing[] = {1e-12, 0, 0};
      const double squared = dimension == 2 ? 0.97 : 1.01;
      EXPECT_NEAR(kernel.along(from_a, nothing).mean, kernel(squared), 1e-13);
    }
}

TEST(AveragingKernel, WrongSettingsAreNamed) {
  EXPECT_THAT([] { AveragingKernel(KernelShape::lucy, 4, 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("dimension is 4")));
  EXPECT_THAT([] { AveragingKernel(KernelShape::lucy, 2, 0); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("scale is 0")));
  EXPECT_THAT([] { AveragingKernel(KernelShape::gaussian, 2, 1, -1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("cutoff is -1")));
  EXPECT_THAT([] { kernel_shape("box"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("kernel is 'box'")));
  EXPECT_THAT([] { gaussian_cutoff(2, 2); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("tolerance is 2")));
}

namespace {

/// Largest error of a rule over positions beside and beyond a branch of `length` w, in units of the
/// kernel's maximum.
double worst_error(const std::vector<LineNode>& nodes, double length) {
  const AveragingKernel kernel(KernelShape::gaussian, 2, 1, 30);
  const double branch[] = {length, 0};
  double worst = 0;
  for (double x = -4; x <= length + 4; x += 0.05)
    for (const double y : {0.0, 0.5, 1.5}) {
      const double place[] = {x, y};
      double sum = 0;
      for (const auto& node : nodes) {
        const double dx = x - node.s * length;
        sum += node.weight * kernel(dx * dx + y * y);
      }
      worst = std::max(worst, std::fabs(sum - kernel.along(place, branch).mean));
    }
  return worst / kernel.norm();
}

}  // namespace

// The bound's derivative is at its largest at x = 0 only, and the rule averages over the branch, so
// that the error comes close to the bound for a short branch and stays below it for a long one.
TEST(LineRule, ErrorBoundHoldsAndIsClose) {
  for (const int points : {1, 2, 3, 4})
    for (const double length : {0.3, 0.6, 1.0, 2.0}) {
      const auto nodes = line_nodes({points, 1e-6}, KernelShape::gaussian, length);
      const double bound = gauss_legendre_error(points, length), error = worst_error(nodes, length);
      EXPECT_LE(error, bound * 1.0000001 + 1e-14) << points << ' ' << length;
      if (length <= 1 && bound > 1e-12) {
        EXPECT_GE(error, 0.3 * bound) << points << ' ' << length;
      }
    }
}

TEST(LineRule, AutomaticKeepsItsToleranceForEveryLength) {
  for (const double tolerance : {1e-4, 1e-6, 1e-10})
    for (const int degree : {0, 1})
      for (const double length : {0.0, 0.001, 0.1, 0.33, 0.7, 1.5, 5.0, 20.0}) {
        const auto nodes =
            line_nodes({LineRule::automatic, tolerance}, KernelShape::gaussian, length, degree);
        EXPECT_LE(worst_error(nodes, length), tolerance + 1e-14) << tolerance << ' ' << length;
        double sum = 0, first = 0;
        for (const auto& node : nodes) {
          sum += node.weight;
          first += node.weight * node.s;
        }
        EXPECT_NEAR(sum, 1, 1e-14);
        EXPECT_NEAR(first, 0.5, 1e-14);
      }
}

// The paper's scale, w = 3 AR d_p: no branch is longer than AR d_p = w / 3, and two points do.
TEST(LineRule, TwoPointsDoAtThePapersScale) {
  EXPECT_EQ(line_nodes(LineRule::named("auto", 1e-6), KernelShape::gaussian, 1.0 / 3).size(), 2u);
}

TEST(LineRule, NamesAndWhatTheyMean) {
  EXPECT_EQ(LineRule::named("exact", 1e-6).points, LineRule::exact);
  EXPECT_EQ(LineRule::named("3", 1e-6).points, 3);
  EXPECT_TRUE(line_nodes(LineRule::named("exact", 1e-6), KernelShape::gaussian, 1).empty());
  // Kernels that are not smooth have no cheap rule: closed form.
  EXPECT_TRUE(line_nodes(LineRule::named("auto", 1e-6), KernelShape::lucy, 1).empty());
  for (const std::string name : {"0", "5", "", "fine"})
    EXPECT_THAT([&] { LineRule::named(name, 1e-6); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("line is '" + name + "'")));
}

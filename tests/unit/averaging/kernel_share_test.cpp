// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/averaging/kernel_share.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using namespace rodpack;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr KernelShape shapes[] = {KernelShape::gaussian, KernelShape::lucy, KernelShape::heaviside};

// The kernel about (x, y) summed over midpoints of small squares inside the container, which has a
// corner at (0, 0) and ends at (2, 3).
double summed_share(const AveragingKernel& kernel, double x, double y) {
  const double step = 0.002;
  double sum = 0;
  for (int i = 0; i < 1000; ++i)
    for (int j = 0; j < 1500; ++j) {
      const double dx = (i + 0.5) * step - x, dy = (j + 0.5) * step - y;
      sum += kernel(dx * dx + dy * dy);
    }
  return sum * step * step;
}

const Field& named(const std::vector<Field>& fields, const std::string& name) {
  for (const auto& field : fields)
    if (field.name == name) return field;
  throw std::out_of_range(name);
}

}  // namespace

TEST(KernelShare, IsTheKernelsIntegralOverTheContainer) {
  const Rectangle container{0, 2, 0, 3};
  for (const auto shape : shapes) {
    const AveragingKernel kernel(shape, 2, 0.5, 6);
    // The sum errs by step^2 for smooth kernels; at Heaviside's rim by its area of squares, a
    // circumference of 6 times the step over the area of 3, with random signs.
    const double error = shape == KernelShape::heaviside ? 3e-4 : 1e-5;
    for (const double x : {-0.3, 0.0, 0.4, 1.0})
      for (const double y : {0.0, 0.2, 1.5, 2.9})
        EXPECT_NEAR(kernel_share(kernel, x, y, container), summed_share(kernel, x, y), error)
            << static_cast<int>(shape) << ' ' << x << ' ' << y;
  }
}

// By symmetry; and at a distance h from one wall of the Gaussian (1 + erf(h / w sqrt 2)) / 2, of
// the Heaviside disc 1 - (acos(h/R) - h/R sqrt(1 - h^2/R^2)) / pi. Lucy's integral over the half
// plane has with q = h / R the one-dimensional density 2 int_0^sqrt(R^2-u^2) phi dv, which
// Simpson's rule integrates here.
TEST(KernelShare, OneWallAndACorner) {
  const Rectangle wall{0, endless, -endless, endless}, corner{0, endless, 0, endless};
  const double w = 0.7;
  for (const auto shape : shapes) {
    const AveragingKernel kernel(shape, 2, w, 6);
    EXPECT_NEAR(kernel_share(kernel, 0, 5, wall), 0.5, 1e-9);
    EXPECT_NEAR(kernel_share(kernel, 0, 0, corner), 0.25, 1e-9);
    EXPECT_NEAR(kernel_share(kernel, 8, 8, corner), 1, 1e-9);
    EXPECT_NEAR(kernel_share(kernel, -8, 8, corner), 0, 1e-9);
    for (const double h : {0.1, 0.5, 1.0})
      EXPECT_NEAR(kernel_share(kernel, h, 0, wall) + kernel_share(kernel, -h, 0, wall), 1, 1e-9);
  }
  const double h = 0.4;
  EXPECT_NEAR(kernel_share({KernelShape::gaussian, 2, w, 6}, h, 0, wall),
              0.5 * (1 + std::erf(h / (w * std::sqrt(2.0)))), 1e-15);
  const double R = 2 * w, c = h / R;
  EXPECT_NEAR(kernel_share({KernelShape::heaviside, 2, w}, h, 0, wall),
              1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / M_PI, 1e-14);
  const AveragingKernel lucy(KernelShape::lucy, 2, w);
  const int n = 400;
  double beyond = 0;  // from the wall outwards
  for (int i = 0; i <= n; ++i) {
    const double u = h + (lucy.cutoff() - h) * i / n;
    const double half = std::sqrt(std::max(0.0, lucy.cutoff() * lucy.cutoff() - u * u));
    double line = 0;
    for (int j = 0; j <= n; ++j) {
      const double v = half * j / n;
      line += (j == 0 || j == n ? 1 : j % 2 ? 4 : 2) * lucy(u * u + v * v) * half / (3 * n);
    }
    beyond += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * 2 * line * (lucy.cutoff() - h) / (3 * n);
  }
  EXPECT_NEAR(kernel_share(lucy, h, 0, wall), 1 - beyond, 1e-9);
}

TEST(KernelShare, ARectangleTakesTwoDimensionsAndSpaceAGaussianOfThree) {
  EXPECT_THAT(
      [] {
        kernel_share({KernelShape::gaussian, 3, 1}, 0, 0, Rectangle{0, 1, 0, 1});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("kernel of 3 dimensions")));
  const UprightContainer cube{{{0, 0, 0}}, {{1, 1, 1}}};
  for (const AveragingKernel& kernel :
       {AveragingKernel(KernelShape::gaussian, 2, 1), AveragingKernel(KernelShape::lucy, 3, 1)})
    EXPECT_THAT(
        [&] {
          kernel_share(kernel, Vector{{0, 0, 0}}, cube);
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("a gaussian of 3 dimensions")));
}

// On a face, an edge and a corner of an octant a half, a quarter and an eighth; within a cylinder
// on its axis 1 - exp(-R^2 / 2 w^2), on a wall of next to no curvature a half, and elsewhere the
// sum over midpoints of small squares of its cross-section.
TEST(KernelShare, BoxAndCylinderInSpace) {
  const double w = 0.5;
  const AveragingKernel kernel(KernelShape::gaussian, 3, w, 6);
  const UprightContainer octant{{{0, 0, 0}}, {{endless, endless, endless}}};
  EXPECT_NEAR(kernel_share(kernel, {{9, 0, 9}}, octant), 0.5, 1e-15);
  EXPECT_NEAR(kernel_share(kernel, {{0, 9, 0}}, octant), 0.25, 1e-15);
  EXPECT_NEAR(kernel_share(kernel, {{0, 0, 0}}, octant), 0.125, 1e-15);

  // Upright along y, so that its axis stands at z = 1, x = 2.
  UprightContainer cylinder{{{0, 0, 0}}, {{0, endless, 0}}, 1, true, {{1, 2}}, 0.8};
  EXPECT_NEAR(kernel_share(kernel, {{2, 9, 1}}, cylinder), 1 - std::exp(-0.32 / (w * w)), 1e-13);
  EXPECT_NEAR(kernel_share(kernel, {{2, 0, 1}}, cylinder), 0.5 - 0.5 * std::exp(-0.32 / (w * w)),
              1e-13);
  const double step = 1e-3;
  for (const double off : {0.3, 0.8, 1.1}) {
    double sum = 0;
    for (double a = -0.8 + step / 2; a < 0.8; a += step)
      for (double b = -0.8 + step / 2; b < 0.8; b += step)
        if (a * a + b * b < 0.64)
          sum += std::exp(-((a - off) * (a - off) + b * b) / (2 * w * w)) * step * step;
    EXPECT_NEAR(kernel_share(kernel, {{2 + off, 9, 1}}, cylinder), sum / (2 * M_PI * w * w), 1e-4)
        << off;
  }
  cylinder.radius = 1e4 * w;
  EXPECT_NEAR(kernel_share(kernel, {{2 + cylinder.radius, 9, 1}}, cylinder), 0.5, 1e-4);
  EXPECT_TRUE(cylinder.contains({{2, 0, 1}}));
  EXPECT_FALSE(cylinder.contains({{2, -0.1, 1}}));
  EXPECT_TRUE(cylinder.contains({{2, -0.1, 1}}, 0.2));
  EXPECT_FALSE(cylinder.contains({{2 + 1.1 * cylinder.radius, 1, 1}}));
}

// Particles at the middles of small cubes that fill a cylinder, each with the share of its cube
// that lies inside taken as all or nothing: the solid fraction comes out flat up to the wall, to
// the roughness of the rim, a tenth of the cube's edge in w.
TEST(KernelShare, AUniformCylinderIsFlatUpToItsWall) {
  const double a = 0.1;
  const AveragingKernel kernel(KernelShape::gaussian, 3, 1, 6);
  const UprightContainer cylinder{{{0, 0, 0}}, {{0, 0, 4}}, 2, true, {{0, 0}}, 2};
  CoarseGraining averages(
      kernel, std::vector<Vector>{{{0, 0, 0}}, {{2, 0, 2}}, {{1.2, 1.2, 4}}, {{2.5, 0, 1}}});
  for (double x = -2 + a / 2; x < 2; x += a)
    for (double y = -2 + a / 2; y < 2; y += a)
      for (double z = a / 2; z < 4; z += a)
        if (x * x + y * y < 4)
          averages.add(Particle{{{x, y, z}}, {{0, 0, 0}}, 1, 0.6 * a * a * a, {}});
  auto fields = averages.fields();
  normalise_by_share(averages, cylinder, fields);
  const auto& phi = named(fields, "solid_fraction").values[0];
  for (const std::size_t k : {0U, 1U, 2U}) EXPECT_NEAR(phi[k], 0.6, 6e-3) << k;
  EXPECT_EQ(phi[3], 0);
}

// Particles at the middles of small squares that fill the container, with a uniform velocity: a sum
// by the midpoint rule, exact to (a / w)^2 / 24 times the second derivative of the Gaussian, below
// 0.05^2 / 24 = 1e-4 of it at a wall. The densities come out flat up to the walls; the velocity and
// what is outside are not touched by the division.
TEST(KernelShare, AUniformSceneIsFlatUpToItsWalls) {
  const double a = 0.05;
  for (const auto shape : {KernelShape::gaussian, KernelShape::lucy}) {
    const AveragingKernel kernel(shape, 2, 1, 6);
    const Grid grid = filling_grid(2, {{0, 0, 0}}, {{12, 9, 0}}, 1);
    CoarseGraining averages(kernel, grid);
    for (int i = 0; i < 240; ++i)
      for (int j = 0; j < 160; ++j)
        averages.add(
            Particle{{{(i + 0.5) * a, (j + 0.5) * a, 0}}, {{2, 0, 0}}, 3, 0.8 * a * a, {}});
    auto fields = averages.fields();
    const auto plain = fields;
    normalise_by_share(averages, Rectangle{0, 12, 0, 8}, fields);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const bool outside = grid.place(i)[1] > 8.5;
      EXPECT_NEAR(named(fields, "solid_fraction").values[0][i], outside ? 0 : 0.8, 1e-4);
      EXPECT_NEAR(named(fields, "mass_density").values[0][i], outside ? 0 : 3 / (a * a), 0.15);
      EXPECT_NEAR(named(fields, "velocity").values[0][i], outside ? 0 : 2, 1e-12);
    }
    EXPECT_NEAR(named(plain, "solid_fraction").values[0][0], 0.2, 1e-3);  // in the corner
  }
}

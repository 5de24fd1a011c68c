// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/mass_properties.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rodpack {
namespace {

const double pi = std::acos(-1.0);
const double d_p = 3e-3, r = d_p / 2, density = 2500;

void expect_inertia(const MassProperties& p, double x, double y, double z, double tolerance) {
  EXPECT_NEAR(p.inertia[0], x, tolerance * x);
  EXPECT_NEAR(p.inertia[1], y, tolerance * y);
  EXPECT_NEAR(p.inertia[2], z, tolerance * z);
}

TEST(MassProperties, ReferenceMassIsThatOfTheSmoothStraightChain) {
  // 9 spheres r apart: two half balls and 16 slabs of thickness h = r/2.
  const double h = r / 2;
  const double mass = density * (4.0 / 3 * pi * r * r * r + 16 * pi * (r * r * h - h * h * h / 3));
  EXPECT_NEAR(mass, 2.2973e-4, 0.5e-8);  // shared measurement notes: exact 2.2973e-4 kg
  for (double f : {0.0, 0.5, 0.8})
    for (double theta : {0.0, 1.0, 2 * pi / 3}) {
      const auto p = mass_properties({5, d_p, f, theta, d_p}, density, MassRule::reference, false);
      EXPECT_NEAR(p.mass, mass, 1e-12 * mass);
    }
}

TEST(MassProperties, ReferenceInertiaIsTheParallelAxisSumOfTheCoarseChain) {
  // Spheres of M/5 at -2d..2d: sum of squares (4 + 1 + 0 + 1 + 4) d^2 = 10 d^2.
  for (double f : {0.0, 0.5}) {
    const auto p = mass_properties({5, d_p, f, 0, d_p}, density, MassRule::reference, false);
    const double own = 0.4 * p.mass * r * r, across = p.mass / 5 * 10 * d_p * d_p;
    expect_inertia(p, own, own + across, own + across, 1e-12);
  }
}

TEST(MassProperties, InertiaAboutTheThinnestChainIsNotRounding) {
  // Two spheres side by side, both at the height of their centre of mass.
  const double thin = 1.001e-5 * 2 * d_p;
  const auto p = mass_properties({2, d_p, 0, 0.5, thin}, density, MassRule::own, true);
  EXPECT_NEAR(p.inertia[0], 0.1 * p.mass * thin * thin, 1e-6 * p.inertia[0]);
}

TEST(MassProperties, ReferenceInertiaOfACurvedChainIsThatOfTheBentCoarseChain) {
  // AR = 3 on a half circle of radius R = 2 d / pi: (+-R, 0) and (0, R) about their mean (0, R/3):
  // sum x^2 = 2 R^2, sum y^2 = (1/9 + 1/9 + 4/9) R^2 = 2/3 R^2, each with M/3.
  const double R = 2 * d_p / pi;
  const auto p = mass_properties({3, d_p, 0.5, pi, d_p}, density, MassRule::reference, false);
  const double own = 0.4 * p.mass * r * r, x2 = 2 * R * R * p.mass / 3, y2 = x2 / 3;
  expect_inertia(p, own + y2, own + x2, own + x2 + y2, 1e-12);
}

TEST(MassProperties, NonIntegerAspectRatioSpreadsTheMassEvenly) {
  // AR = 2.4: 3 spheres of M/3 at 0 and +-0.7 d.
  const auto p = mass_properties({2.4, d_p, 0.5, 0, d_p}, density, MassRule::reference, false);
  const double own = 0.4 * p.mass * r * r, across = p.mass / 3 * 2 * 0.49 * d_p * d_p;
  expect_inertia(p, own, own + across, own + across, 1e-12);
}

TEST(MassProperties, SphereIsASphereUnderEitherRule) {
  const double mass = density * 4.0 / 3 * pi * r * r * r, inertia = 0.4 * mass * r * r;
  for (MassRule rule : {MassRule::reference, MassRule::own}) {
    const auto p = mass_properties({1, d_p, 0.5, 0, d_p}, density, rule, false);
    EXPECT_NEAR(p.mass, mass, 1e-13 * mass);
    expect_inertia(p, inertia, inertia, inertia, 1e-12);
  }
}

TEST(MassProperties, OwnRuleOnTangentSpheresIsTheirParallelAxisSum) {
  const double ball = density * 4.0 / 3 * pi * r * r * r;
  const auto p = mass_properties({4, d_p, 0, 0, d_p}, density, MassRule::own, false);
  EXPECT_NEAR(p.mass, 4 * ball, 1e-12 * ball);
  // at +-d/2, +-3d/2: sum of squares 5 d^2
  const double own = 4 * 0.4 * ball * r * r, across = ball * 5 * d_p * d_p;
  expect_inertia(p, own, own + across, own + across, 1e-12);
}

TEST(MassProperties, OwnRuleTendsToTheSpherocylinder) {
  // Cylinder of length L = 4 d and two half balls of mass m, whose flat faces lie L/2 from the
  // middle and whose centroids 3r/8 further: about a face 2/5 m r^2, about the middle of the rod m
  // (2/5 r^2 + 2 (L/2) (3r/8) + L^2/4).
  const double L = 4 * d_p;
  const double cylinder = density * pi * r * r * L, caps = density * 4.0 / 3 * pi * r * r * r;
  const double axial = cylinder * r * r / 2 + caps * 0.4 * r * r;
  const double across =
      cylinder * (r * r / 4 + L * L / 12) + caps * (0.4 * r * r + L * L / 4 + 3.0 / 8 * L * r);
  const auto p = mass_properties({5, d_p, 0.999, 0, d_p}, density, MassRule::own, false);
  // The ridge between neighbours is s^2/8r high for a spacing s = 0.001 d: below 1e-6 of r.
  EXPECT_NEAR(p.mass, cylinder + caps, 1e-6 * p.mass);
  expect_inertia(p, axial, across, across, 1e-6);
}

TEST(MassProperties, DrawnSizeCountsOnlyWhenFollowed) {
  const ChainShape drawn{5, d_p, 0.5, 1, 1.05 * d_p}, nominal{5, d_p, 0.5, 1, d_p};
  for (MassRule rule : {MassRule::reference, MassRule::own}) {
    const auto kept = mass_properties(drawn, density, rule, false);
    const auto same = mass_properties(nominal, density, rule, false);
    EXPECT_EQ(kept.mass, same.mass);
    EXPECT_EQ(kept.inertia, same.inertia);
    EXPECT_GT(mass_properties(drawn, density, rule, true).mass, kept.mass);
  }
  // Followed, straight: 5 spheres of radius 1.05 r, spaced (5 - 1.05) d / 4; M from 9 such spheres
  // with slabs of half the spacing (5 - 1.05) d / 8.
  const ChainShape straight{5, d_p, 0.0, 0, 1.05 * d_p};
  const auto p = mass_properties(straight, density, MassRule::reference, true);
  const double R = 1.05 * r, h = 3.95 * d_p / 16;
  const double mass = density * (4.0 / 3 * pi * R * R * R + 16 * pi * (R * R * h - h * h * h / 3));
  EXPECT_NEAR(p.mass, mass, 1e-12 * mass);
  const double own = 0.4 * mass * R * R;
  const double across = mass / 5 * 10 * std::pow(3.95 / 4 * d_p, 2);
  expect_inertia(p, own, own + across, own + across, 1e-12);
}

TEST(MassProperties, RefusesADensityThatIsNotPositive) {
  for (double bad : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(mass_properties({5, d_p, 0.5, 0, d_p}, bad, MassRule::own, false),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rodpack

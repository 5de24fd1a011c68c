// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_contact.h"

namespace rodpack {
namespace {

/// Two spheres of unequal size that fly past each other and spin, at the time t.
SampleContact two_spheres(double t = 0) {
  SampleContact contact;
  contact.radi = 0.3;
  contact.radj = 0.2;
  const double delta[3] = {0.30, -0.25, 0.28};
  const double v_i[3] = {1.0, -0.4, 0.3}, v_j[3] = {-0.2, 0.5, 0.1};
  const double omega_i[3] = {2, -1, 3}, omega_j[3] = {-4, 1, 0.5};
  for (int d = 0; d < 3; ++d) {
    contact.delta[d] = delta[d] + t * (v_i[d] - v_j[d]);
    contact.v_i[d] = v_i[d];
    contact.v_j[d] = v_j[d];
    contact.omega_i[d] = omega_i[d];
    contact.omega_j[d] = omega_j[d];
  }
  contact.complete();
  return contact;
}

const double step = 1e-6;

}  // namespace

// The contact point lies half-way into the overlap, so that the levers of both spheres end in it:
// -l_i n + l_j n = -(r n), r the distance of the centres.
TEST(ContactMotion, LeversMeetInTheContactPoint) {
  const SampleContact c = two_spheres();
  EXPECT_NEAR(c.deltan, 0.5 - std::sqrt(0.30 * 0.30 + 0.25 * 0.25 + 0.28 * 0.28), 1e-15);
  EXPECT_NEAR(c.cri, 0.3 - 0.5 * c.deltan, 1e-15);
  const double turn[3] = {0, 0, 0};
  double of_i[3], of_j[3], rate[3];
  contact_lever(c, turn, 1, of_i, rate);
  contact_lever(c, turn, -1, of_j, rate);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(c.delta[d] + of_i[d], of_j[d], 1e-15);
}

// u = (v_i + omega_i x l_i) - (v_j + omega_j x l_j), split along the normal and across it.
TEST(ContactMotion, SurfacesMoveAsTheirBodiesDoAtTheContactPoint) {
  const SampleContact c = two_spheres();
  const double turn[3] = {0, 0, 0};
  double l_i[3], l_j[3], rate[3], u_i[3], u_j[3], u[3];
  contact_lever(c, turn, 1, l_i, rate);
  contact_lever(c, turn, -1, l_j, rate);
  velocity_at(c.v_i, c.omega_i, l_i, u_i);
  velocity_at(c.v_j, c.omega_j, l_j, u_j);
  for (int d = 0; d < 3; ++d) u[d] = u_i[d] - u_j[d];
  const double across[3] = {c.vtr1, c.vtr2, c.vtr3};
  EXPECT_NEAR(c.vn, dot(u, c.en), 1e-15);
  EXPECT_NEAR(dot(across, c.en), 0, 1e-15);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(across[d], u[d] - c.vn * c.en[d], 1e-15);
}

// By central differences over the flight of the two centres.
TEST(ContactMotion, NormalAndLeversTurnAsTheCentresPassEachOther) {
  const SampleContact before = two_spheres(-step), now = two_spheres(), after = two_spheres(step);
  double turn[3], lever[3], rate[3], lever_before[3], lever_after[3], unused[3];
  normal_turning_rate(now, turn);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(turn[d], (after.en[d] - before.en[d]) / (2 * step), 1e-9);
  for (const double side : {1.0, -1.0}) {
    contact_lever(now, turn, side, lever, rate);
    contact_lever(before, turn, side, lever_before, unused);
    contact_lever(after, turn, side, lever_after, unused);
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR(rate[d], (lever_after[d] - lever_before[d]) / (2 * step), 1e-9) << side;
  }
}

// A force that keeps its components along the normal n and a tangent t that turns with it, within
// the plane of n and dn/dt: n' = w t, t' = -w n, so F = a n + b t grows by a w t - b w n.
TEST(ContactMotion, AForceInTheFrameOfTheContactTurnsWithIt) {
  const SampleContact c = two_spheres();
  double turn[3];
  normal_turning_rate(c, turn);
  const double w = std::sqrt(dot(turn, turn)), a = 3, b = -2;
  double force[3], own[3], rate[3];
  for (int d = 0; d < 3; ++d) {
    const double t = turn[d] / w;
    force[d] = a * c.en[d] + b * t;
    own[d] = 5 * c.en[d] + 7 * t;  // grows within the frame
  }
  rate_in_space(c, force, own, rate);
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(rate[d], own[d] + a * turn[d] - b * w * c.en[d], 1e-13);
}

// A wall stands still: its normal does not turn, the sphere's lever changes with the overlap alone.
TEST(ContactMotion, TheNormalOfAWallDoesNotTurn) {
  const SampleContact c = on_floor(1e-5, 0.3, -0.2);
  EXPECT_NEAR(c.deltan, 1e-5, 1e-18);
  EXPECT_EQ(c.crj, 0);
  EXPECT_EQ(c.vn, -0.2);
  EXPECT_EQ(c.vtr1, 0.3);
  double turn[3], lever[3], rate[3];
  normal_turning_rate(c, turn);
  contact_lever(c, turn, 1, lever, rate);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(turn[d], 0);
  EXPECT_NEAR(lever[1], -(1e-3 - 0.5e-5), 1e-18);
  EXPECT_NEAR(rate[1], 0.5 * 0.2, 1e-16);  // half the closing speed, upwards
}

// A rolling sphere, v = omega R with the lever R - delta/2: slips by omega delta / 2.
TEST(ContactMotion, ARollingSphereSlipsByItsOverlapAlone) {
  SampleContact c = on_floor(2e-5, 0, 0);
  c.v_i[0] = 5.0 * 1e-3;
  c.omega_i[2] = -5.0;
  c.complete();
  EXPECT_NEAR(c.vtr1, 5.0 * 1e-5, 1e-17);
}

// At a closing speed w, a step dt closes an overlap of w dt at most; the factor of 1.5 leaves room
// for a speed that changes.
TEST(ContactMotion, WhatOverlapsMoreThanAStepClosesHasNotTouchedInIt) {
  const double dt = 1e-5;
  EXPECT_TRUE(touched_in_step(on_floor(0.9e-6, 0, -0.1), dt));
  EXPECT_TRUE(touched_in_step(on_floor(1.4e-6, 0, -0.1), dt));
  EXPECT_FALSE(touched_in_step(on_floor(1.6e-6, 0, -0.1), dt));
  EXPECT_FALSE(touched_in_step(on_floor(1e-7, 0, 0.1), dt));
}

}  // namespace rodpack

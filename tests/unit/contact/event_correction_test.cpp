// SPDX-License-Identifier: GPL-2.0-or-later
// What events do to bodies, and these to their other contacts, against closed forms.
#include "rodpack/contact/event_correction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sample_contact.h"

namespace rodpack {
namespace {

ForceChange constant_force(double x, double y, double z, double since) {
  return linear_change({x, y, z}, {0, 0, 0}, since);
}

const double pi = std::acos(-1.0);

}  // namespace

// Both sides get opposite forces at one point, so that neither momentum nor, about any point,
// angular momentum is made: x_i x F + l_i x F - (x_j x F + l_j x F) = 0 as x_i + l_i = x_j + l_j.
TEST(EventCorrection, SharesOfBothSidesAddUpToNothing) {
  SampleContact contact;
  contact.radi = 0.3;
  contact.radj = 0.2;
  const double delta[3] = {0.3, -0.25, 0.28}, x_j[3] = {0.7, 0.1, -0.4};
  for (int d = 0; d < 3; ++d) contact.delta[d] = delta[d];
  contact.complete();
  const ForceChange on_i = linear_change({2, -1, 0.5}, {30, 7, -11}, 0.04);
  ForceChange force = {}, torque = {};
  share_change(
      contact, on_i,
      [&](int side, const ForceChange& part, const double(&lever)[3], const double(&rate)[3]) {
        force += part;
        double arm[3];
        for (int d = 0; d < 3; ++d) arm[d] = lever[d] + x_j[d] + (side > 0 ? delta[d] : 0.0);
        torque += torque_change(arm, rate, part);
      });
  for (const auto part : {&ForceChange::now, &ForceChange::impulse})
    for (int d = 0; d < 3; ++d) {
      EXPECT_EQ((force.*part)[d], 0);
      EXPECT_NEAR((torque.*part)[d], 0, 1e-15);
    }
}

// On a wall there is one side.
// A force along a tangent that turns at the rate q with the contact, of magnitude D(t) = n + r t up
// to now, since s: the component along the present tangent, and what the turning puts along the
// normal, by the integral over t from -s to 0 of D(t) times the turn q t.
TEST(EventCorrection, AChangeAlongADirectionTurnsWithTheContact) {
  SampleContact contact;
  contact.radi = contact.radj = 1e-3;
  contact.delta[1] = 1.99e-3;
  contact.v_i[0] = 3;
  contact.complete();
  const double q = 3 / 1.99e-3, n = 0.7, r = 4e3, s = 6e-6;
  const double tangent[3] = {1, 0, 0};
  const ChangeOf<1> along = linear_change<1>({n}, {r}, s);
  const ForceChange change = change_along(contact, along, tangent);
  // the normal turns towards x, the tangent x against it
  const double turn[3] = {0, -q, 0};
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(change.now[d], n * tangent[d], 1e-15);
    EXPECT_NEAR(change.rate[d], r * tangent[d] + n * turn[d], 1e-9);
    EXPECT_NEAR(
        change.impulse[d],
        (n * s - r * s * s / 2) * tangent[d] - (n * s * s / 2 - r * s * s * s / 3) * turn[d],
        1e-18);
    EXPECT_NEAR(change.impulse_integral[d], (n * s * s / 2 - r * s * s * s / 3) * tangent[d],
                1e-24);
  }
  const ChangeOf<1> back = component(change, tangent);
  EXPECT_EQ(back.now[0], along.now[0]);
  EXPECT_EQ(back.rate[0], along.rate[0]);
  EXPECT_EQ(back.impulse[0], along.impulse[0]);
  EXPECT_EQ(back.impulse_integral[0], along.impulse_integral[0]);
}

TEST(EventCorrection, AWallGetsNoShare) {
  int sides = 0;
  share_change(on_floor(1e-5, 0, 0), constant_force(1, 0, 0, 1e-6),
               [&](int side, const ForceChange&, const double(&)[3], const double(&)[3]) {
                 EXPECT_EQ(side, 1);
                 ++sides;
               });
  EXPECT_EQ(sides, 1);
}

// A body at rest on which a constant force and torque have acted since s, unknown to the step. With
// what it has missed, F s / m and F s^2 / 2m, and records that continue the force backwards, the
// next step of order 2 to 4 ends exactly at F (s + dt) / m and F (s + dt)^2 / 2m.
TEST(EventCorrection, TheNextStepIsThatOfAForceThatWasKnownAllTheTime) {
  const double mass = 0.7, moment = 0.03, s = 0.4e-2, dt = 1e-2;
  const PlanarBodyChange change =
      in_plane(BodyChange{constant_force(2, -3, 0, s), constant_force(0, 0, 0.5, s)});
  const PlanarCorrection correction = {mass, moment};
  const PlanarJump missed = correction.missed(change);
  const double acceleration[3] = {2 / mass, -3 / mass, 0.5 / moment};
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(missed.acceleration[d], acceleration[d], 1e-14 * std::fabs(acceleration[d]));
    EXPECT_NEAR(missed.velocity[d], acceleration[d] * s, 1e-14);
    EXPECT_NEAR(missed.displacement[d], acceleration[d] * s * s / 2, 1e-16);
  }
  for (int order = 2; order <= 4; ++order) {
    PlanarMotion motion = {{missed.displacement[0], missed.displacement[1]},
                           {missed.velocity[0], missed.velocity[1]},
                           missed.velocity[2],
                           {1, 0, 0, 0}};
    rotate_about_z(missed.displacement[2], motion.quaternion);
    PlanarRates history[max_multistep_order] = {};
    for (int k = 1; k < order; ++k) history[order - 1 - k] = correction.past(change, k * dt);
    PlanarRates& now = history[order - 1];
    now = {{motion.velocity[0], motion.velocity[1]},
           motion.angular_velocity,
           {acceleration[0], acceleration[1]},
           acceleration[2]};
    advance(motion, history, order, order + 1, dt);
    const double t = s + dt;
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(motion.position[d], acceleration[d] * t * t / 2, 1e-15) << order;
      EXPECT_NEAR(motion.velocity[d], acceleration[d] * t, 1e-14) << order;
    }
    EXPECT_NEAR(motion.angular_velocity, acceleration[2] * t, 1e-14) << order;
    EXPECT_NEAR(2 * std::atan2(motion.quaternion[3], motion.quaternion[0]),
                acceleration[2] * t * t / 2, 1e-15)
        << order;
  }
}

// In space the change of the angular velocity solves I w = L in the frame of the body: with R the
// rotation to space, R^T L = diag(I) R^T w.
TEST(EventCorrection, InSpaceTheInertiaTurnsWithTheBody) {
  SpatialCorrection correction = {2, {0.1, 0.4, 0.25}, {0.5, 0.1, -0.7, 0.3}};
  normalise(correction.quaternion);
  BodyChange change;
  change.force = linear_change({1, 2, 3}, {4, 5, 6}, 0.1);
  change.torque = linear_change({0.3, -0.2, 0.5}, {2, 1, -3}, 0.1);
  const SpatialJump missed = correction.missed(change);
  double momentum[3], turn[3];
  rotate(correction.quaternion, change.torque.impulse, true, momentum);
  rotate(correction.quaternion, missed.angular_velocity, true, turn);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(momentum[d], correction.inertia[d] * turn[d], 1e-15);
    EXPECT_DOUBLE_EQ(missed.velocity[d], change.force.impulse[d] / 2);
    EXPECT_DOUBLE_EQ(missed.displacement[d], change.force.impulse_integral[d] / 2);
  }
  // dq/dt = (0, w) q / 2 keeps the length of q, and rotates: q + dq turns a vector u by w x u.
  const SpatialRates past = correction.past(change, 0.05);
  const double e = 1e-7;
  double q[4], w[3], l[3], along = 0;
  for (int d = 0; d < 4; ++d) {
    along += correction.quaternion[d] * past.quaternion_rate[d];
    q[d] = correction.quaternion[d] + e * past.quaternion_rate[d];
  }
  EXPECT_NEAR(along, 0, 1e-15);
  for (int d = 0; d < 3; ++d) l[d] = change.torque.past_momentum(d, 0.05);
  angular_velocity(correction.quaternion, l, correction.inertia, w);
  const double body_vector[3] = {0.3, -0.8, 0.5};
  double before[3], after[3], moved[3];
  rotate(correction.quaternion, body_vector, false, before);
  rotate(q, body_vector, false, after);
  cross(w, before, moved);
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR((after[d] - before[d]) / e, moved[d], 1e-6);
    EXPECT_DOUBLE_EQ(past.torque[d], change.torque.past_force(d, 0.05));
    EXPECT_DOUBLE_EQ(past.acceleration[d], change.force.past_force(d, 0.05) / 2);
  }
}

// A body in planar motion is one in space whose z axis is a principal one.
TEST(EventCorrection, PlanarMotionIsMotionInSpace) {
  BodyChange change;
  change.force = linear_change({2, -3, 0}, {50, 9, 0}, 0.01);
  change.torque = linear_change({0, 0, 0.4}, {0, 0, -7}, 0.01);
  SpatialCorrection spatial = {0.7, {0.02, 0.05, 0.03}, {1, 0, 0, 0}};
  rotate_about_z(0.8, spatial.quaternion);
  const PlanarCorrection planar = {0.7, 0.03};
  const SpatialJump a = spatial.missed(change), b = to_space(planar.missed(in_plane(change)));
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(a.acceleration[d], b.acceleration[d], 1e-14);
    EXPECT_NEAR(a.angular_acceleration[d], b.angular_acceleration[d], 1e-13);
    EXPECT_NEAR(a.angular_velocity[d], b.angular_velocity[d], 1e-15);
    EXPECT_NEAR(a.rotation[d], b.rotation[d], 1e-17);
  }
  const PlanarJump back = to_plane(b);
  for (int d = 0; d < 3; ++d)
    EXPECT_EQ(back.velocity[d], planar.missed(in_plane(change)).velocity[d]);
}

// A body that turns about its centre at the rate w: a point at the arm r has gained w x r.
TEST(EventCorrection, PointsOfABodyJumpAsItTurns) {
  SpatialJump jump = {};
  jump.velocity[0] = 1;
  jump.angular_velocity[2] = 3;
  jump.angular_acceleration[1] = 5;
  const double arm[3] = {0.2, 0.4, 0.1};
  const SpatialJump there = jump_at(jump, arm);
  EXPECT_DOUBLE_EQ(there.velocity[0], 1 - 3 * 0.4);
  EXPECT_DOUBLE_EQ(there.velocity[1], 3 * 0.2);
  EXPECT_DOUBLE_EQ(there.acceleration[0], 5 * 0.1);
  EXPECT_DOUBLE_EQ(there.acceleration[2], -5 * 0.2);
  EXPECT_EQ(there.angular_velocity[2], 3);
}

// i's surface jumps with i, j's against it; for a sphere at an arm of its body, by way of its
// centre or straight from that of the body.
TEST(EventCorrection, ContactsSeeTheDifferenceOfBothSurfaces) {
  SampleContact contact;
  contact.radi = 1e-3;
  contact.radj = 2e-3;
  contact.delta[0] = 2.9e-3 * std::cos(0.6);
  contact.delta[1] = 2.9e-3 * std::sin(0.6);
  contact.complete();
  const double offset[2] = {4e-3, -1e-3}, angle = pi / 5;
  const PlanarJump jump = {
      {3, -2, 700}, {0.1, 0.3, 20}, {1e-6, 2e-6, -4e-5}, std::cos(angle), std::sin(angle)};
  const double arm[3] = {std::cos(angle) * offset[0] - std::sin(angle) * offset[1],
                         std::sin(angle) * offset[0] + std::cos(angle) * offset[1], 0};
  for (const double side : {1.0, -1.0}) {
    ContactJump planar = {}, spatial = {};
    add_jump(contact, side, jump, offset, planar);
    add_jump(contact, side, jump_at(to_space(jump), arm), spatial);
    const double length = side > 0 ? contact.cri : -contact.crj;
    const double x = arm[0] - length * contact.en[0], y = arm[1] - length * contact.en[1];
    EXPECT_NEAR(planar.velocity[0], side * (0.1 - 20 * y), 1e-15);
    EXPECT_NEAR(planar.velocity[1], side * (0.3 + 20 * x), 1e-15);
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(planar.acceleration[d], spatial.acceleration[d], 1e-14);
      EXPECT_NEAR(planar.velocity[d], spatial.velocity[d], 1e-15);
      EXPECT_NEAR(planar.displacement[d], spatial.displacement[d], 1e-20);
    }
  }
}

// A surface of velocity u(t) = 0.2 - 30 t gains the acceleration a at t = -s, before the end of the
// step at t = 0: from then on its velocity is u + a (t + s), and so it is to have been at t = -k
// dt; it has come farther by the integral from -s to 0, a s^2 / 2.
TEST(EventCorrection, HistoryFollowsAJumpAsIfItHadAlwaysBeen) {
  const double a = 500, s = 3e-6, dt = 1e-5;
  ContactJump jump = {};
  for (int d : {0, 1}) {  // along (0.6, 0.8)
    const double axis = d == 0 ? 0.6 : 0.8;
    jump.acceleration[d] = axis * a;
    jump.velocity[d] = axis * a * s;
    jump.displacement[d] = axis * a * s * s / 2;
  }
  double spring = 1e-6, velocity[3];
  for (int k = 0; k < 3; ++k) velocity[k] = 0.2 + 30 * k * dt;
  const JumpAlong<double> along = component(jump, {0.6, 0.8, 0});
  for (int k = 0; k < 3; ++k) velocity[k] = velocity_after(along, k * dt, velocity[k]);
  EXPECT_EQ(spring_after(along, true, spring), spring) << "a slide carries the cap";
  spring = spring_after(along, false, spring);
  EXPECT_NEAR(spring, 1e-6 + a * s * s / 2, 1e-20);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(velocity[k], 0.2 + 30 * k * dt + a * (s - k * dt), 1e-15);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/prescribed_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rodpack/geometry/vector3.h"
#include "rodpack/motion/rigid_motion.h"

namespace rodpack {
namespace {

const BodyPose start = {{0.03, -0.02, 0.5}, {0.8, 0.0, 0.36, 0.48}};

PrescribedMotion all_at_once() {
  PrescribedMotion motion;
  for (int d = 0; d < 3; ++d) {
    motion.velocity[d] = 0.3 - 0.2 * d;
    motion.amplitude[d] = 0.01 * (d + 1);
    motion.angular_velocity[d] = 3.0 * (1 - d) + 1.0;
    motion.origin[d] = 0.1 * d;
  }
  motion.period = 0.7;
  return motion;
}

TEST(PrescribedMotion, ABodyThatIsHeldStaysToTheLastBit) {
  PrescribedMotion motion;
  motion.about_origin = true;  // of no rotation
  motion.origin[0] = 0.1;
  const PrescribedState now = motion.at(start, 0.3, 1e9);
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(now.pose.position[d], start.position[d]);
    EXPECT_EQ(now.velocity[d], 0.0);
  }
  for (int d = 0; d < 4; ++d) EXPECT_EQ(now.pose.quaternion[d], start.quaternion[d]);
}

// x = x0 + v t exactly: nothing adds up over the steps that lead there.
TEST(PrescribedMotion, ASteadyOneIsTheProductOfVelocityAndTime) {
  PrescribedMotion motion;
  motion.velocity[1] = 0.1;
  EXPECT_DOUBLE_EQ(motion.at(start, 0.0, 12345.0).pose.position[1],
                   start.position[1] + 0.1 * 12345.0);
  EXPECT_TRUE(motion.is_steady());
  EXPECT_TRUE(motion.is_in_plane());
}

// The velocity is the derivative of the position, and omega that of the orientation: central
// differences, whose error is h^2/6 of the third derivative, at most some 1e3 here.
TEST(PrescribedMotion, VelocitiesAreTheDerivatives) {
  PrescribedMotion motion = all_at_once();
  const double t = 0.43, h = 1e-5, began = 0.1;
  for (const bool about_origin : {false, true}) {
    motion.about_origin = about_origin;
    const PrescribedState before = motion.at(start, began, t - h), now = motion.at(start, began, t),
                          after = motion.at(start, began, t + h);
    for (int d = 0; d < 3; ++d)
      EXPECT_NEAR((after.pose.position[d] - before.pose.position[d]) / (2 * h), now.velocity[d],
                  1e-7);
    double rate[4];
    half_product(motion.angular_velocity, now.pose.quaternion, rate);
    for (int d = 0; d < 4; ++d)
      EXPECT_NEAR((after.pose.quaternion[d] - before.pose.quaternion[d]) / (2 * h), rate[d], 1e-7);
  }
}

// Two bodies that turn about one point are one rigid body: what joins their centres turns with
// each of them.
TEST(PrescribedMotion, BodiesAboutOneOriginTurnAsOne) {
  PrescribedMotion motion = all_at_once();
  motion.about_origin = true;
  BodyPose other = start;
  for (int d = 0; d < 3; ++d) other.position[d] += 0.01 * (d + 1);
  const double began = 0.2, t = 3.1;
  const PrescribedState a = motion.at(start, began, t), b = motion.at(other, began, t);
  double joined[3], in_body[3], expected[3];
  for (int d = 0; d < 3; ++d) joined[d] = other.position[d] - start.position[d];
  rotate(start.quaternion, joined, true, in_body);
  rotate(a.pose.quaternion, in_body, false, expected);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(b.pose.position[d] - a.pose.position[d], expected[d], 1e-15);
  EXPECT_FALSE(motion.is_steady());
  EXPECT_FALSE(motion.is_in_plane());
}

// A full turn about z, to where it was; the quaternion of a rotation about z keeps x = y = 0.
TEST(PrescribedMotion, AFullTurnInThePlaneLeadsBack) {
  PrescribedMotion motion;
  motion.angular_velocity[2] = 2 * M_PI;
  motion.about_origin = true;
  const BodyPose flat = {{0.3, 0.4, 0.0}, {0.6, 0.0, 0.0, 0.8}};
  const PrescribedState quarter = motion.at(flat, 0.0, 0.25), full = motion.at(flat, 0.0, 1.0);
  EXPECT_NEAR(quarter.pose.position[0], -0.4, 1e-15);
  EXPECT_NEAR(quarter.pose.position[1], 0.3, 1e-15);
  EXPECT_NEAR(full.pose.position[0], 0.3, 1e-15);
  EXPECT_NEAR(full.pose.quaternion[0], -0.6, 1e-15);
  EXPECT_EQ(full.pose.quaternion[1], 0.0);
  EXPECT_EQ(full.pose.quaternion[2], 0.0);
  EXPECT_NEAR(full.velocity[1], 2 * M_PI * 0.3, 1e-14);
}

}  // namespace
}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
// The law of a contact that lasts, which single contacts and registers share; here for one contact.
#include "rodpack/contact/contact_law.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rodpack {
namespace {

/// kn = 1000 N/m, kt = 500 N/m; pressed in by 10 um without motion along the normal: 0.01 N, a cap
/// of 0.003 N. It moves along the tangent at 1 mm/s, against 0.1 kg/s.
LastingContact<OneContact> contact(double spring, bool slid) {
  LastingContact<OneContact> c;
  c.normal_stiffness = 1000;
  c.normal_damping = 0.2;
  c.overlap = 1e-5;
  c.separation_velocity = 0;
  c.viscoelastic_before = 0.01;
  c.tangential_stiffness = 500;
  c.inverse_stiffness.inverse = 1.0 / 500;
  c.tangential_damping = 0.1;
  c.tangential_velocity = 1e-3;
  c.spring = spring;
  c.spring_before = spring;
  c.friction = 0.3 * 1000;
  c.slid = slid;
  return c;
}

}  // namespace

TEST(LastingForce, SticksBelowTheCap) {
  const LastingForce<OneContact> force =
      lasting_force<ElasticLoad>(contact(4e-6, false), 0.0, true);
  EXPECT_FALSE(force.slides || force.changes);
  EXPECT_DOUBLE_EQ(force.normal, 0.01);
  EXPECT_DOUBLE_EQ(force.tangential, -(500 * 4e-6 + 0.1 * 1e-3));
  EXPECT_EQ(force.spring, 4e-6);
}

// It slides on for as long as the velocity stretches the spring, even where spring and dashpot
// would fit under the cap; the spring then alone carries the cap.
TEST(LastingForce, SlidesOnWhileTheVelocityStretchesTheSpring) {
  for (const double sign : {1.0, -1.0}) {
    LastingContact<OneContact> c = contact(5e-6 * sign, true);
    c.tangential_velocity *= sign;
    const LastingForce<OneContact> force = lasting_force<ElasticLoad>(c, 0.0, true);
    EXPECT_TRUE(force.slides);
    EXPECT_FALSE(force.changes);
    EXPECT_DOUBLE_EQ(force.tangential, -0.003 * sign);
    EXPECT_DOUBLE_EQ(force.spring, 0.003 / 500 * sign);
  }
}

// Sticking under more than the cap, sliding backwards, pulling after pushing, and pushing after
// pulling: something has happened within the step, which this law leaves to others.
TEST(LastingForce, EveryChangeOfBranchIsSeen) {
  EXPECT_TRUE(lasting_force<ElasticLoad>(contact(6e-6, false), 0.0, true).changes);  // 0.0031 N
  EXPECT_TRUE(lasting_force<ElasticLoad>(contact(-5e-6, true), 0.0, true).changes);
  LastingContact<OneContact> pulls = contact(4e-6, false);
  pulls.separation_velocity = 0.06;  // 0.01 N - 0.012 N
  EXPECT_TRUE(lasting_force<ElasticLoad>(pulls, 0.0, true).changes);
  pulls.viscoelastic_before = -0.001;
  const LastingForce<OneContact> cut = lasting_force<ElasticLoad>(pulls, 0.0, true);
  EXPECT_FALSE(cut.changes || cut.pushes);
  EXPECT_EQ(cut.normal, 0);
  EXPECT_NEAR(cut.viscoelastic, -0.002, 1e-17);
  LastingContact<OneContact> pushes = contact(4e-6, false);
  pushes.viscoelastic_before = -0.001;
  EXPECT_TRUE(lasting_force<ElasticLoad>(pushes, 0.0, true).changes);
}

// Without a dashpot, or where changes are not followed, each step decides anew, as
// tangential_force() does.
TEST(LastingForce, DecidesAnewWhereNothingIsFollowed) {
  for (const bool follows : {false, true})
    for (const bool slid : {false, true})
      for (const double spring : {-8e-6, -4e-6, 4e-6, 8e-6}) {
        LastingContact<OneContact> c = contact(spring, slid);
        if (follows) c.tangential_damping = 0;
        const LastingForce<OneContact> force = lasting_force<ElasticLoad>(c, 0.0, follows);
        double one_spring[1] = {spring}, one_force[1];
        const double velocity[1] = {c.tangential_velocity};
        const bool slides =
            tangential_force(500.0, c.tangential_damping, 0.003, one_spring, velocity, one_force);
        EXPECT_FALSE(force.changes);
        EXPECT_EQ(force.slides, slides);
        EXPECT_DOUBLE_EQ(force.tangential, one_force[0]);
        EXPECT_NEAR(force.spring, one_spring[0], 1e-20);
      }
}

// mu times spring and dashpot, 0.3 (0.01 N + 0.2 kg/s u) at the closing speed u.
TEST(LastingForce, TheWholeLoadHasTheDashpotInTheCap) {
  for (const double closing : {0.02, 0.0, -0.02}) {
    LastingContact<OneContact> c = contact(8e-6, true);
    c.friction = 0.3;
    c.separation_velocity = -closing;
    const LastingForce<OneContact> force = lasting_force<WholeLoad>(c, 0.0, true);
    EXPECT_TRUE(force.slides);
    EXPECT_FALSE(force.changes);
    EXPECT_NEAR(force.tangential, -0.3 * (0.01 + 0.2 * closing), 1e-17) << closing;
    EXPECT_NEAR(force.spring, 0.3 * (0.01 + 0.2 * closing) / 500, 1e-19) << closing;
  }
}

// Where the normal force was cut off and friction with it, there is no slide that could go on.
TEST(LastingForce, FrictionThatBeginsAnewUnderTheWholeLoadIsAChange) {
  LastingContact<OneContact> c = contact(1e-9, true);
  c.friction = 0.3;
  c.viscoelastic_before = -0.001;
  c.spring_before = 0;
  EXPECT_TRUE(lasting_force<WholeLoad>(c, 0.0, true).changes);
  c.separation_velocity = 0.06;  // cut off now too
  EXPECT_TRUE(lasting_force<WholeLoad>(c, 0.0, true).changes);
  c.tangential_damping = 0;  // each step decides by itself: no force
  const LastingForce<OneContact> none = lasting_force<WholeLoad>(c, 0.0, true);
  EXPECT_FALSE(none.changes);
  EXPECT_EQ(none.tangential, 0);
  EXPECT_EQ(none.spring, 0);
}

// Two points of a body that moves and turns, and back: the relative velocity is that of the other
// body's spin taken the other way.
TEST(ContactFormulas, VelocityOfAPointIsThatOfTheCentreAndTheTurn) {
  const Vector2<double> lever = {0.3, -0.2}, centre = {1.0, 2.0};
  const Vector2<double> v = velocity_at(centre, 5.0, lever);  // + 5 z x lever
  EXPECT_DOUBLE_EQ(v.x, 1 + 5 * 0.2);
  EXPECT_DOUBLE_EQ(v.y, 2 + 5 * 0.3);
  const Vector2<double> back = velocity_at(v, -5.0, lever);
  EXPECT_DOUBLE_EQ(back.x, 1);
  EXPECT_DOUBLE_EQ(back.y, 2);
}

// (n, z x n) is a frame of its own: what is put together there has these components.
TEST(ContactFormulas, ComponentsAlongNormalAndTangentMakeTheVector) {
  const Vector2<double> n = {0.6, 0.8};
  const Vector2<double> force = in_space(n, 3.0, -2.0);
  EXPECT_NEAR(dot(force, n), 3, 1e-15);
  EXPECT_NEAR(cross_z(n, force), -2, 1e-15);
  const Vector2<double> quarter = turned(0.0, 1.0, n);
  EXPECT_DOUBLE_EQ(quarter.x, -0.8);
  EXPECT_DOUBLE_EQ(quarter.y, 0.6);
}

// Half-way into the overlap, against the normal for i and along it for j.
TEST(ContactFormulas, LeverEndsHalfWayIntoTheOverlap) {
  const Vector2<double> arm = {1.0, 0.5}, n = {0.6, 0.8};
  const double length = lever_length(0.4, 0.1);
  EXPECT_DOUBLE_EQ(length, 0.35);
  const Vector2<double> of_i = lever_in_plane(arm, length, n);
  const Vector2<double> of_j = lever_in_plane(arm, -length, n);
  EXPECT_DOUBLE_EQ(of_i.x, 1 - 0.35 * 0.6);
  EXPECT_DOUBLE_EQ(of_i.y, 0.5 - 0.35 * 0.8);
  EXPECT_DOUBLE_EQ(of_j.x, 1 + 0.35 * 0.6);
}

}  // namespace rodpack

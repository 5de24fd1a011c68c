// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_history.h"
#include "rodpack/contact/planar_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rodpack {

TEST(ContactHistory, NormalOneIsStoredInFourDoubles) {
  NormalHistory history;
  history.viscoelastic = -0.25;
  history.touch_rate = 3e4;
  history.just_touched = true;
  history.next_step = 123456789012;
  std::vector<double> stored(stored_normal_values, NAN);
  pack(history, stored.data());
  EXPECT_THAT(stored, testing::ElementsAre(-0.25, 3e4, 1.0, 123456789012.0));
  const NormalHistory back = unpack_normal(stored.data());
  EXPECT_EQ(back.viscoelastic, history.viscoelastic);
  EXPECT_EQ(back.touch_rate, history.touch_rate);
  EXPECT_TRUE(back.just_touched);
  EXPECT_EQ(back.next_step, history.next_step);
}

TEST(ContactHistory, WithARelaxationTimeTheVelocityTakesThePlaceOfTheRate) {
  NormalHistory history;
  history.viscoelastic = 0.5;
  history.touch_rate = 3e4;
  history.relaxes = true;
  history.felt_velocity = -0.125;
  history.next_step = 7;
  std::vector<double> stored(stored_normal_values, NAN);
  pack(history, stored.data());
  EXPECT_THAT(stored, testing::ElementsAre(0.5, -0.125, 2.0, 7.0));
  const NormalHistory back = unpack_normal(stored.data());
  EXPECT_TRUE(back.relaxes);
  EXPECT_EQ(back.felt_velocity, history.felt_velocity);
  EXPECT_EQ(back.touch_rate, 0.0);
}

TEST(ContactHistory, ThatOfTheTotalCapIsStoredInSevenDoubles) {
  CapHistory history;
  history.normal.viscoelastic = -0.25;
  history.normal.touch_rate = 3e4;
  history.normal.just_touched = true;
  history.stiffness = 1000;
  history.damping = 0.4;
  history.earlier = -0.5;
  history.has_earlier = true;
  std::vector<double> stored(stored_cap_values, NAN);
  pack(history, stored.data());
  EXPECT_THAT(stored, testing::ElementsAre(-0.25, 3e4, 1.0, 1000, 0.4, -0.5, 1.0));
  std::vector<double> again(stored_cap_values, NAN);
  pack(unpack_cap(stored.data()), again.data());
  EXPECT_EQ(again, stored);
}

// The layout of restart files: spring, velocities, evaluations (negative while sliding), step, time
// since touch, constants.
TEST(ContactHistory, TangentialOneIsStoredAsItStandsInRestartFiles) {
  for (int slots = 1; slots <= max_multistep_order; ++slots)
    for (const bool sliding : {false, true}) {
      TangentialHistory history(slots);
      std::vector<double> expected;
      for (int d = 0; d < 3; ++d) expected.push_back(history.spring[d] = 0.1 + d);
      for (int k = 0; k < slots; ++k)
        for (int d = 0; d < 3; ++d) expected.push_back(history.velocity[k][d] = -10 * k - d);
      history.known = slots + 1;
      history.sliding = sliding;
      history.step = 4711;
      history.since = 2.5e-6;
      history.friction = 300;
      history.stiffness = 500;
      history.damping = 0.1;
      const double rest[6] = {sliding ? -slots - 1.0 : slots + 1.0, 4711, 2.5e-6, 300, 500, 0.1};
      expected.insert(expected.end(), rest, rest + 6);

      std::vector<double> stored(stored_tangential_values(slots), NAN);
      pack(history, stored.data());
      EXPECT_EQ(stored, expected);
      const TangentialHistory back = unpack_tangential(stored.data(), slots);
      EXPECT_EQ(back.known, slots + 1);
      EXPECT_EQ(back.sliding, sliding);
      EXPECT_EQ(back.step, 4711);
      std::vector<double> again(stored.size(), NAN);
      pack(back, again.data());
      EXPECT_EQ(again, expected);
    }
}

// LIGGGHTS clears the history of what is no contact to zeros.
TEST(ContactHistory, ZerosAreNoContact) {
  const std::vector<double> zeros(stored_history_values(3), 0.0);
  EXPECT_EQ(zeros.size(), 4u + 3u * 4u + 6u);
  EXPECT_EQ(unpack_normal(zeros.data()).next_step, 0);
  const TangentialHistory none = unpack_tangential(zeros.data() + stored_normal_values, 3);
  EXPECT_EQ(none.known, 0);
  EXPECT_FALSE(none.sliding);
  std::vector<double> stored(zeros.size(), NAN);
  pack(NormalHistory(), stored.data());
  pack(TangentialHistory(3), stored.data() + stored_normal_values);
  EXPECT_EQ(stored, zeros);
}

// Along the tangent (-0.8, 0.6) of the normal (0.6, 0.8), and back.
TEST(ContactHistory, InThePlaneVectorsHaveOneComponent) {
  const Vector2<double> normal = {0.6, 0.8};
  NormalHistory normal_force;
  normal_force.viscoelastic = -2;
  normal_force.touch_rate = 7;
  normal_force.just_touched = true;
  TangentialHistory friction(2);
  const double spring[3] = {-0.8 * 5, 0.6 * 5, 0}, velocity[3] = {0.8 * 3, -0.6 * 3, 0};
  std::copy(spring, spring + 3, friction.spring);
  std::copy(velocity, velocity + 3, friction.velocity[1]);
  friction.known = 3;
  friction.sliding = true;
  friction.since = 0.25;
  const PlanarHistory planar = to_plane(normal_force, friction, normal);
  EXPECT_DOUBLE_EQ(planar.spring, 5);
  EXPECT_EQ(planar.velocity[0], 0);
  EXPECT_DOUBLE_EQ(planar.velocity[1], -3);
  EXPECT_EQ(planar.viscoelastic, -2);
  EXPECT_TRUE(planar.sliding && planar.just_touched);

  NormalHistory normal_back;
  TangentialHistory back(2);
  to_space(planar, normal, normal_back, back);
  for (int d = 0; d < 3; ++d) {
    EXPECT_DOUBLE_EQ(back.spring[d], spring[d]);
    EXPECT_DOUBLE_EQ(back.velocity[1][d], velocity[d]);
  }
  EXPECT_EQ(back.known, 3);
  EXPECT_TRUE(back.sliding && normal_back.just_touched);
  EXPECT_EQ(back.since, 0.25);
  EXPECT_EQ(normal_back.viscoelastic, -2);
  EXPECT_EQ(normal_back.touch_rate, 7);
  // i and j change places: the normal turns round, and LIGGGHTS changes the sign of vectors.
  for (int d = 0; d < 3; ++d) friction.spring[d] = -friction.spring[d];
  EXPECT_DOUBLE_EQ(to_plane(normal_force, friction, {-0.6, -0.8}).spring, 5);
}

}  // namespace rodpack

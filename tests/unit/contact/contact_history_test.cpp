// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_history.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/order_by_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace rodpack {
namespace {

using testing::ElementsAre;

TEST(OrderByPlace, SpreadsBits) {
  EXPECT_EQ(spread_bits(0b1011), 0b1000101u);
  EXPECT_EQ(spread_bits(0xffffffffu), 0x5555555555555555u);
}

TEST(OrderByPlace, FollowsMortonsCurveWhereverTheBodiesAre) {
  // quadrants: low left, low right, high left, high right
  for (const double x : {-3.0, 0.0, 1e3})
    EXPECT_THAT(order_by_place({{x + 1, 1, 0}, {x, 1, 1}, {x + 1, 0, 2}, {x, 0, 3}}),
                ElementsAre(3, 2, 1, 0));
}

TEST(OrderByPlace, GoesByTagsWherePlacesAreEqual) {
  EXPECT_THAT(order_by_place({{1, 2, 7}, {1, 2, 5}, {1, 2, 6}}), ElementsAre(1, 2, 0));
  EXPECT_TRUE(order_by_place({}).empty());
}

// Bodies of a square lattice in rows: a lattice of n x n has neighbours n places apart then, along
// the curve most of them are near.
TEST(OrderByPlace, KeepsNeighboursTogether) {
  const int n = 64;
  std::vector<TaggedPlace> places;
  for (int k = 0; k < n * n; ++k)
    places.push_back({static_cast<double>(k % n), static_cast<double>(k / n), k});
  const std::vector<int> order = order_by_place(places);
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<int>(k);
  int near = 0, pairs = 0;
  for (int k = 0; k + n < n * n; ++k, ++pairs)
    if (std::abs(position[k] - position[k + n]) < n) ++near;
  EXPECT_GT(near, 0.8 * pairs);
}

}  // namespace
}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/order_by_place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rodpack {
namespace {

using testing::ElementsAre;

TEST(OrderByPlace, FollowsStripsAcrossTheLargerExtentWhereverTheBodiesAre) {
  for (const double far : {-3.0, 0.0, 1e3}) {
    // of thickness 1 along x, then along y
    EXPECT_THAT(
        order_by_place({{far + 2.5, 0, 0}, {far + 0.1, 1, 1}, {far + 0.9, 0, 2}, {far, 2, 3}}, 1),
        ElementsAre(2, 1, 3, 0));
    EXPECT_THAT(
        order_by_place({{0, far + 2.5, 0}, {1, far + 0.1, 1}, {0, far + 0.9, 2}, {2, far, 3}}, 1),
        ElementsAre(2, 1, 3, 0));
  }
}

TEST(OrderByPlace, GoesOutwardsFromTheMiddle) {
  // along x from 0 to 8; the middle is 4
  EXPECT_THAT(
      order_by_place({{0, 0, 0}, {8, 1, 1}, {4.5, 2, 2}, {3.5, 1, 3}, {2.5, 1, 4}}, 1, true),
      ElementsAre(3, 2, 4, 0, 1));
}

TEST(OrderByPlace, GoesByTagsWherePlacesAreEqual) {
  EXPECT_THAT(order_by_place({{1, 2, 7}, {1, 2, 5}, {1, 2, 6}}, 0.5), ElementsAre(1, 2, 0));
  EXPECT_TRUE(order_by_place({}, 0.5).empty());
}

// In a lattice that is 8 wide, whatever its length, neighbours are at most a strip apart.
TEST(OrderByPlace, KeepsNeighboursTogetherHoweverLongThePacking) {
  const int width = 8;
  for (const int length : {16, 1000}) {
    std::vector<TaggedPlace> places;
    for (int k = 0; k < width * length; ++k)
      places.push_back({0.5 + k % width, 0.5 + std::floor(k * 1.0 / width), k * 7 % 5});
    const std::vector<int> order = order_by_place(places, 2.0);
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position[order[k]] = static_cast<int>(k);
    int farthest = 0;
    for (int k = 0; k + width < width * length; ++k) {
      farthest = std::max(farthest, std::abs(position[k] - position[k + width]));
      if (k % width > 0) farthest = std::max(farthest, std::abs(position[k] - position[k - 1]));
    }
    EXPECT_LE(farthest, 2 * width);
  }
}

}  // namespace
}  // namespace rodpack

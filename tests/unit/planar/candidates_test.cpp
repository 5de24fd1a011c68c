// SPDX-License-Identifier: GPL-2.0-or-later
// Which pairs of spheres become candidates for a contact, and the gap that they are told to have.
#include "planar_lists/candidates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "heap.h"

namespace rodpack {
namespace {

struct Chain {
  PlanarBody body;
  PlanarBox box;
  PlanarReference at;

  Chain(const PlanarBody& of, double skin)
      : body(of), box(box_of(body.spheres.data(), static_cast<int>(body.spheres.size()))) {
    double reach = 0.0;
    for (const PlanarSphere& sphere : body.spheres)
      reach = std::max(reach, std::hypot(sphere.x, sphere.y) + body.radius);
    at = {body.position[0], body.position[1], body.cosine, body.sine, reach, skin};
  }
  PlanarChain view() const {
    return {body.spheres.data(), static_cast<int>(body.spheres.size()), body.radius, box, at};
  }
  double x(int k) const {
    return at.x + at.cosine * body.spheres[k].x - at.sine * body.spheres[k].y;
  }
  double y(int k) const {
    return at.y + at.sine * body.spheres[k].x + at.cosine * body.spheres[k].y;
  }
};

std::vector<PlanarCandidate> candidates_of(const Chain& i, const Chain& j) {
  std::vector<PlanarCandidate> found;
  find_candidates(i.view(), j.view(), found);
  return found;
}

}  // namespace

// Discs whose surfaces are 1 mm apart, with skins of 0.4 mm and a bit more or less than 0.6 mm.
TEST(PlanarCandidates, TwoDiscsAreCandidatesWithinTheSkinsOfBoth) {
  const Chain i(rod(1, 0.0, 0.0, 0.3), 4e-4);
  const double away = diameter + 1e-3;
  const PlanarBody other = rod(1, away * std::cos(1.0), away * std::sin(1.0), 2.0);
  EXPECT_TRUE(candidates_of(i, Chain(other, 5.9999e-4)).empty());
  const std::vector<PlanarCandidate> found = candidates_of(i, Chain(other, 6.0001e-4));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].gap, 1e-3, 1e-12 * diameter);
}

// The same by the distances of all spheres in space, for rods in all positions to each other.
TEST(PlanarCandidates, OfTwoRodsAreAllSpheresThatAreClose) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int close = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto draw = [&](double aspect_ratio, double skin) {
      return Chain(
          rod(aspect_ratio, 0.01 * share(random), 0.01 * share(random), 3.15 * share(random), 2.0),
          skin);
    };
    const Chain i = draw(5, 3e-4), j = draw(3, 7e-4);
    std::vector<PlanarCandidate> expected;
    for (std::size_t k = 0; k < i.body.spheres.size(); ++k)
      for (std::size_t l = 0; l < j.body.spheres.size(); ++l) {
        const int a = static_cast<int>(k), b = static_cast<int>(l);
        const double gap = std::hypot(i.x(a) - j.x(b), i.y(a) - j.y(b)) - diameter;
        if (gap < 1e-3) expected.push_back({gap, a, b});
      }
    const std::vector<PlanarCandidate> found = candidates_of(i, j);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].sphere_i, expected[k].sphere_i);
      EXPECT_EQ(found[k].sphere_j, expected[k].sphere_j);
      EXPECT_NEAR(found[k].gap, expected[k].gap, 1e-12 * diameter);
      ++close;
    }
  }
  EXPECT_GT(close, 1000);
}

// The arc of 90 degrees of radius R spans R sqrt(2) along its chord and R (1 - cos 45) across it.
TEST(PlanarCandidates, BoxesHoldAllCentresOfAChain) {
  const double quarter = 0.5 * std::acos(-1.0), radius = 4 * diameter / quarter;
  const PlanarBody arc = rod(5, 0.0, 0.0, 0.0, quarter);
  const PlanarBox box = box_of(arc.spheres.data(), static_cast<int>(arc.spheres.size()));
  EXPECT_NEAR(box.half_length, 0.5 * radius * std::sqrt(2.0), 1e-9 * diameter);
  EXPECT_NEAR(box.half_width, 0.5 * radius * (1.0 - std::cos(0.5 * quarter)), 1e-9 * diameter);
  for (const PlanarSphere& sphere : arc.spheres) {
    const double x = sphere.x - box.x, y = sphere.y - box.y;
    EXPECT_LE(std::fabs(box.cosine * x + box.sine * y), box.half_length + 1e-9 * diameter);
    EXPECT_LE(std::fabs(box.cosine * y - box.sine * x), box.half_width + 1e-9 * diameter);
  }
  const PlanarBody disc = rod(1, 0.0, 0.0, 0.0);
  EXPECT_EQ(box_of(disc.spheres.data(), 1).half_length, 0.0);
}

// Rods side by side, or one behind the other, with 1 mm between them.
TEST(PlanarCandidates, BoxesTellRodsApartByTheirSkins) {
  const double gap = 1e-3, angle = 0.7;
  const Chain i(rod(5, 0.0, 0.0, angle), 4e-4);
  for (const bool beside : {true, false}) {
    const double away = gap + (beside ? diameter : 5 * diameter),
                 towards = beside ? angle + 0.5 * std::acos(-1.0) : angle;
    const PlanarBody other = rod(5, away * std::cos(towards), away * std::sin(towards), angle);
    EXPECT_FALSE(are_close(i.view(), Chain(other, 5.9999e-4).view()));
    EXPECT_TRUE(are_close(i.view(), Chain(other, 6.0001e-4).view()));
  }
}

TEST(PlanarCandidates, BodiesWithCandidatesAreClose) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  int apart = 0, with_candidates = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto draw = [&](double aspect_ratio, double curvature) {
      return Chain(rod(aspect_ratio, 0.012 * share(random), 0.012 * share(random),
                       3.15 * share(random), curvature),
                   5e-4);
    };
    const Chain i = draw(5, trial % 2 * 2.1), j = draw(3, trial % 3 * 1.0);
    const bool close = are_close(i.view(), j.view());
    EXPECT_EQ(close, are_close(j.view(), i.view()));
    apart += !close;
    if (candidates_of(i, j).empty()) continue;
    EXPECT_TRUE(close);
    ++with_candidates;
  }
  EXPECT_GT(apart, 300);
  EXPECT_GT(with_candidates, 300);
}

// A rod of nine spheres, half a diameter apart, at angle a to a wall 2 mm under its centre: sphere
// k is (k - 4) d/2 sin(a) + 2 mm - d/2 above it.
TEST(PlanarCandidates, OfARodWithAWallAreTheSpheresWithinItsSkin) {
  const double angle = 0.4, skin = 6e-4;
  const Chain i(rod(5, 0.02, 2e-3, angle), skin);
  std::vector<PlanarCandidate> found;
  find_candidates(i.view(), PlanarWall{1, 0.0, 0, 1}, found);
  std::vector<PlanarCandidate> expected;
  for (int k = 0; k < 9; ++k) {
    const double gap = 0.5 * diameter * (k - 4) * std::sin(angle) + 2e-3 - 0.5 * diameter;
    if (gap < skin) expected.push_back({gap, k, 0});
  }
  ASSERT_EQ(found.size(), expected.size());
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t k = 0; k < found.size(); ++k) {
    EXPECT_EQ(found[k].sphere_i, expected[k].sphere_i);
    EXPECT_NEAR(found[k].gap, expected[k].gap, 1e-12 * diameter);
  }
}

// A wall without a free side pushes a sphere to the side of its centre; one with it, to that side.
TEST(PlanarCandidates, BehindASolidWallGapsAreNegative) {
  const Chain behind(rod(1, -2e-3, 0.0, 0.0), 1e-3);
  std::vector<PlanarCandidate> found;
  find_candidates(behind.view(), PlanarWall{0, 0.0, 0, 1}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].gap, -2e-3 - 0.5 * diameter, 1e-12 * diameter);
  found.clear();
  find_candidates(behind.view(), PlanarWall{0, 0.0, 0, 0}, found);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].gap, 2e-3 - 0.5 * diameter, 1e-12 * diameter);
}

TEST(PlanarCandidates, AreSortedByGapThenBySpheres) {
  std::vector<PlanarCandidate> all = {{2.0, 0, 0}, {1.0, 3, 1}, {1.0, 3, 0}, {1.0, 2, 5}};
  sort_candidates(all);
  const std::vector<std::vector<double>> expected = {{1, 2, 5}, {1, 3, 0}, {1, 3, 1}, {2, 0, 0}};
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_EQ((std::vector<double>{all[k].gap, double(all[k].sphere_i), double(all[k].sphere_j)}),
              expected[k]);
}

}  // namespace rodpack

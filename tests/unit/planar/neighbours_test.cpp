// SPDX-License-Identifier: GPL-2.0-or-later
// Neighbour lists of single bodies: which sphere pairs are in them, and when they are made anew.
#include "planar_lists/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "heap.h"
#include "planar/blocks.h"
#include "planar/bodies.h"

namespace rodpack {
namespace {

/// Bodies and their lists.
struct Scene {
  PlanarSettings settings;
  PlanarParts parts;
  PlanarBodyStates bodies;
  PlanarBlocks blocks;
  PlanarDependencies dependencies;
  PlanarNeighbours neighbours;

  Scene(const PlanarSettings& given, const std::vector<PlanarBody>& all)
      : settings(given),
        parts{static_cast<int>(all.size()), 16},
        bodies(settings, parts, all),
        blocks(bodies.size(), 3),
        dependencies(parts),
        neighbours(settings, bodies, parts, blocks, dependencies) {
    neighbours.set_longest_reach(bodies.longest_reach());
  }

  double gap(int i, int k, int j, int l) const {
    const auto centre = [&](int body, int sphere, double& x, double& y) {
      const PlanarKinematics& kinematics = bodies.kinematics(body);
      const PlanarSphere& at = bodies.spheres(body)[sphere];
      x = kinematics.x + kinematics.cosine * at.x - kinematics.sine * at.y;
      y = kinematics.y + kinematics.sine * at.x + kinematics.cosine * at.y;
    };
    double xi, yi, xj, yj;
    centre(i, k, xi, yi);
    centre(j, l, xj, yj);
    return std::hypot(xi - xj, yi - yj) - bodies.info(i).radius - bodies.info(j).radius;
  }

  /// The smallest gap between the spheres that a block of two bodies pairs, m.
  double least_gap(int place) const {
    const PlanarBlockHead& head = blocks.pairs().head(place);
    const PlanarBlockColdData& cold = blocks.pairs().cold(place);
    double least = 1.0;
    for (int lane = 0; lane < planar_lanes; ++lane)
      least = std::min(least, gap(head.i, cold.sphere_i[lane], head.j, cold.sphere_j[lane]));
    return least;
  }

  /// Bodies and spheres of all lanes that are in use.
  std::set<std::vector<int>> listed() const {
    std::set<std::vector<int>> all;
    for (int place = 0; place < blocks.pairs().size(); ++place)
      for (int lane = 0; lane < planar_lanes; ++lane) {
        if (!(blocks.pairs().head(place).used & 1 << lane)) continue;
        PlanarLaneState state;
        blocks.pairs().save(place, lane, state);
        EXPECT_TRUE(all.insert({state.i, state.sphere_i, state.j, state.sphere_j}).second);
      }
    return all;
  }
};

std::vector<PlanarBody> cloud(int count) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  std::vector<PlanarBody> bodies;
  for (int k = 0; k < count; ++k)
    bodies.push_back(
        moving(rod(k % 2 ? 5 : 2, 0.06 * share(random), 0.06 * share(random), 3.15 * share(random)),
               share(random), share(random)));
  return bodies;
}

}  // namespace

// All sphere pairs by their gaps; skins are 80 steps at the present speed, within their bounds.
TEST(PlanarNeighbours, AllSpheresWithinTheSkinsOfTheirBodiesAreListed) {
  PlanarSettings settings = settings_of();
  const std::vector<PlanarBody> bodies = cloud(120);
  Scene scene(settings, bodies);
  scene.neighbours.list_all();
  const auto skin = [&](int b) {
    const double speed = std::hypot(bodies[b].velocity[0], bodies[b].velocity[1]);
    return std::min(1e-3, std::max(1e-4, 80.0 * speed * settings.dt));
  };
  std::set<std::vector<int>> expected;
  for (int i = 0; i < 120; ++i)
    for (int j = i + 1; j < 120; ++j)
      for (int k = 0; k < scene.bodies.info(i).count; ++k)
        for (int l = 0; l < scene.bodies.info(j).count; ++l)
          if (scene.gap(i, k, j, l) < skin(i) + skin(j)) expected.insert({i, k, j, l});
  EXPECT_GT(expected.size(), 500u);
  EXPECT_EQ(scene.listed(), expected);
}

// Heads bound the gaps of their lanes from below, in single precision.
TEST(PlanarNeighbours, ABlockKnowsItsSmallestGap) {
  Scene scene(settings_of(), cloud(120));
  scene.neighbours.list_all();
  const PlanarBlockPool& pairs = scene.blocks.pairs();
  for (int place = 0; place < pairs.size(); ++place) {
    const PlanarBlockHead& head = pairs.head(place);
    if (head.used == 0) continue;
    const double least = scene.least_gap(place);
    EXPECT_LE(head.gap, least + 1e-16);
    EXPECT_NEAR(head.gap, least, 3e-7 * std::fabs(least));
  }
}

TEST(PlanarNeighbours, ABodyThatIsListedAnewHasTheListsOfWhereItIs) {
  Scene scene(settings_of(), cloud(60)), fresh(settings_of(), cloud(60));
  scene.neighbours.list_all();
  fresh.neighbours.list_all();
  std::vector<int> all;
  for (int b = 59; b >= 0; b -= 2) all.push_back(b);
  scene.neighbours.list_anew(all);
  EXPECT_EQ(scene.listed(), fresh.listed());
  EXPECT_EQ(scene.neighbours.listings(), 30);
}

// Bodies that wander are listed anew one after the other. All sphere pairs within both skins are
// always there; a block may keep further ones, but no gap is taken for larger than it is, and none
// is empty of what is near.
TEST(PlanarNeighbours, ListsFollowBodiesThatWander) {
  Scene scene(settings_of(), cloud(60));
  scene.neighbours.list_all();
  std::mt19937 random(4);
  std::normal_distribution<double> shift(0.0, 2e-4);
  int kept = 0, made = 0;
  for (int round = 0; round < 10; ++round)
    for (int b = 0; b < 60; ++b) {
      PlanarKinematics moved = scene.bodies.kinematics(b);
      moved.x += shift(random);
      moved.y += shift(random);
      scene.bodies.move_ghost(b, moved);
      const std::vector<int> before = scene.blocks.pairs().of_body(b);
      scene.neighbours.list_anew({b});
      const std::vector<int>& after = scene.blocks.pairs().of_body(b);
      for (const int place : after)
        ++(std::find(before.begin(), before.end(), place) != before.end() ? kept : made);
    }
  EXPECT_GT(kept, 1000);
  EXPECT_GT(made, 50);
  const std::set<std::vector<int>> listed = scene.listed();
  for (int i = 0; i < 60; ++i)
    for (int j = i + 1; j < 60; ++j)
      for (int k = 0; k < scene.bodies.info(i).count; ++k)
        for (int l = 0; l < scene.bodies.info(j).count; ++l)
          if (scene.gap(i, k, j, l) < 2 * scene.settings.min_skin) {
            EXPECT_EQ(listed.count({i, k, j, l}), 1u);
          }
  const PlanarBlockPool& pairs = scene.blocks.pairs();
  for (int place = 0; place < pairs.size(); ++place) {
    const PlanarBlockHead& head = pairs.head(place);
    if (head.used == 0) continue;
    const double least = scene.least_gap(place);
    EXPECT_LE(head.gap, least + 1e-15);
    EXPECT_LT(least, 2 * scene.settings.max_skin);
  }
}

TEST(PlanarNeighbours, ContactsKeepTheirHistoryWhenABodyIsListedAnew) {
  Scene scene(settings_of(), cloud(60));
  scene.neighbours.list_all();
  std::vector<PlanarLaneState> contacts;
  for (const std::vector<int>& key : scene.listed()) {
    PlanarLaneState contact = PlanarLaneState();
    contact.i = key[0];
    contact.sphere_i = static_cast<std::uint16_t>(key[1]);
    contact.j = key[2];
    contact.sphere_j = static_cast<std::uint16_t>(key[3]);
    contact.history.known = 3;
    contact.history.sliding = contacts.size() % 2 == 0;
    contact.history.spring = 1e-6 * static_cast<double>(contacts.size());
    contact.history.velocity[2] = 1.0 + static_cast<double>(contacts.size());
    EXPECT_TRUE(scene.blocks.restore(contact));
    contacts.push_back(contact);
  }
  ASSERT_GT(contacts.size(), 100u);
  std::vector<int> all;
  for (int b = 0; b < 60; ++b) all.push_back(b);
  scene.neighbours.list_anew(all);
  EXPECT_EQ(scene.blocks.pairs().contacts(), contacts.size());
  for (const PlanarLaneState& contact : contacts) {
    const std::pair<int, int> at =
        scene.blocks.pairs().find(contact.i, contact.sphere_i, contact.j, contact.sphere_j);
    ASSERT_GE(at.first, 0);
    PlanarLaneState kept;
    scene.blocks.pairs().save(at.first, at.second, kept);
    EXPECT_EQ(kept.history.spring, contact.history.spring);
    EXPECT_EQ(kept.history.velocity[2], contact.history.velocity[2]);
    EXPECT_EQ(kept.history.sliding, contact.history.sliding);
  }
}

// A contact that has no lane of its own is not put into another one.
TEST(PlanarNeighbours, SpheresThatAreFarAreNoCandidates) {
  Scene scene(settings_of(), {rod(5, 0, 0, 0), rod(5, 0.1, 0, 0)});
  scene.neighbours.list_all();
  PlanarLaneState contact = PlanarLaneState();
  contact.j = 1;
  EXPECT_FALSE(scene.blocks.restore(contact));
}

// With walls at y = 0 and x = 0 and skins of 0.1 mm, a disc in the corner has one block with each.
TEST(PlanarNeighbours, WallsHaveBlocksOfTheirOwn) {
  PlanarSettings settings = settings_of();
  settings.walls = {{1, 0.0, 0}, {0, 0.0, 0}, {0, 1.0, 0}};
  Scene scene(settings, {rod(1, 0.5 * diameter + 9e-5, 0.5 * diameter, 0),
                         rod(1, 0.5, 0.5 * diameter + 1.1e-4, 0)});
  scene.neighbours.list_all();
  const PlanarBlockPool& at_walls = scene.blocks.at_walls();
  EXPECT_EQ(at_walls.filled(), 2);
  EXPECT_EQ(scene.blocks.pairs().filled(), 0);
  EXPECT_GE(at_walls.find(0, 0, -1, 0).first, 0);
  EXPECT_GE(at_walls.find(0, 0, -2, 0).first, 0);
  EXPECT_EQ(at_walls.find(0, 0, -3, 0).first, -1);
  EXPECT_EQ(at_walls.find(1, 0, -1, 0).first, -1);
}

// The dashpots of a pair: 2 eta sqrt(m k), m the effective mass, at a wall the mass of the body.
TEST(PlanarNeighbours, BlocksHaveTheDashpotsOfTheirBodies) {
  PlanarSettings settings = settings_of();
  settings.walls = {{1, 0.0, 0}};
  PlanarBody light = rod(1, 0.0, 0.5 * diameter, 0), heavy = rod(1, diameter, 0.5 * diameter, 0);
  light.mass = 1e-6;
  heavy.mass = 3e-6;
  Scene scene(settings, {light, heavy});
  scene.neighbours.list_all();
  const auto expect_gammas = [&](const PlanarBlockPool& pool, int i, int j, double mass) {
    const int place = pool.find(i, 0, j, 0).first;
    ASSERT_GE(place, 0);
    const double* const gammas = pool.values(place) + planar_gammas;
    const double normal = 2 * 0.2 * std::sqrt(mass * 1000.0);
    const double tangential = 2 * 0.2 * std::sqrt(mass * 500.0);
    EXPECT_NEAR(gammas[0], normal, 1e-14 * normal);
    EXPECT_NEAR(gammas[1], tangential, 1e-14 * tangential);
  };
  expect_gammas(scene.blocks.pairs(), 0, 1, 0.75e-6);
  expect_gammas(scene.blocks.at_walls(), 0, -1, 1e-6);
  expect_gammas(scene.blocks.at_walls(), 1, -1, 3e-6);
}

// A disc at 1 m/s and with a skin of 0.3 mm: the bound on how far it has moved may be 1/cos(pi/8)
// times too large, and it is listed 2 % before; 0.98 * 0.3 mm / (1.0824 * 11 um) = 24.7 steps. At 4
// m/s 6.2, at 10 m/s 2.5, and at 100 m/s at least one.
TEST(PlanarNeighbours, StepsWithinSkinsAreThoseOfTheFastestBody) {
  PlanarSettings settings = settings_of();
  settings.min_skin = settings.max_skin = 3e-4;
  const auto steps = [&](double speed) {
    Scene scene(settings, {rod(1, 0.1, 0, 0), moving(rod(1, 0, 0, 0), speed, 0)});
    scene.neighbours.list_all();
    return scene.neighbours.steps_within_skins();
  };
  EXPECT_EQ(steps(1.0), most_steps_in_pass);
  EXPECT_EQ(steps(4.0), 6);
  EXPECT_EQ(steps(10.0), 2);
  EXPECT_EQ(steps(100.0), 1);
}

// Seen from the frame of the slow body beside it the fast one goes 22 um in a step, more than its
// skin of 10 um, and is listed before it has left; not where both rest, or fly together.
TEST(PlanarNeighbours, BodiesAreListedWhenANewFrameLetsThemLeaveTheirSkins) {
  PlanarSettings settings = settings_of();
  settings.min_skin = settings.max_skin = 1e-5;
  const auto listings = [&](double slow, double fast) {
    Scene scene(settings, {moving(rod(1, 0, 0, 0), slow, 0), moving(rod(1, 0.004, 0, 0), fast, 0)});
    scene.neighbours.list_all();
    EXPECT_EQ(scene.neighbours.begin_pass(1), 1);
    return scene.neighbours.listings();
  };
  EXPECT_EQ(listings(0.01, 2.0), 1);
  EXPECT_EQ(listings(0.0, 0.0), 0);
  EXPECT_EQ(listings(0.2, 0.2), 0);
}

// After a renewal, those alone count that have been listed since the one before.
TEST(PlanarNeighbours, StepsWithinSkinsForgetWhoHasSlowedDown) {
  PlanarSettings settings = settings_of();
  settings.min_skin = settings.max_skin = 3e-4;
  Scene scene(settings, {moving(rod(1, 0, 0, 0), 6.0, 0), moving(rod(1, 0.1, 0, 0), 4.0, 0)});
  scene.neighbours.list_all();
  EXPECT_EQ(scene.neighbours.steps_within_skins(), 4);
  scene.neighbours.renew_steps_within_skins();
  EXPECT_EQ(scene.neighbours.steps_within_skins(), 4);
  scene.neighbours.list_anew({1});
  scene.neighbours.renew_steps_within_skins();
  EXPECT_EQ(scene.neighbours.steps_within_skins(), 6);
}

// A ghost is listed anew when 98 % of its skin may have gone by: the bound for a translation by a
// along x is a. The path there and back is twice as long.
TEST(PlanarNeighbours, AGhostIsListedAnewWhenItLeavesItsSkin) {
  PlanarSettings settings = settings_of();
  settings.min_skin = settings.max_skin = 1e-3;
  Scene scene(settings, {rod(5, 0, 0, 0)});
  scene.bodies.resize(2);
  scene.neighbours.resize(2);
  const PlanarBody body = rod(5, 0.016, 0, 0);
  scene.bodies.set_ghost(1, body);
  scene.neighbours.add_ghost(1);
  const auto moves_to = [&](double x) {  // whether it leaves its skin
    const PlanarKinematics before = scene.bodies.kinematics(1);
    PlanarKinematics kinematics = before;
    kinematics.x = x;
    scene.bodies.move_ghost(1, kinematics);
    return scene.neighbours.follow_ghost(1, before);
  };
  const double* const moved = scene.neighbours.moved();
  const double* const travelled = scene.neighbours.travelled();
  EXPECT_FALSE(moves_to(0.016)) << "there are no lists yet";
  scene.neighbours.list_all();
  EXPECT_GT(scene.blocks.pairs().filled(), 0);
  EXPECT_FALSE(moves_to(0.016 - 0.97e-3));
  EXPECT_NEAR(moved[1], 0.97e-3, 1e-12);
  EXPECT_FALSE(moves_to(0.016));
  EXPECT_NEAR(moved[1], 0.0, 1e-15);
  EXPECT_NEAR(travelled[1], 2 * 0.97e-3, 1e-12);
  EXPECT_TRUE(moves_to(0.016 - 0.99e-3));
  scene.neighbours.list_anew({1});
  EXPECT_EQ(travelled[1], 0.0);
  EXPECT_FALSE(moves_to(0.016 - 0.99e-3));
  scene.neighbours.remove_ghost(1);
  EXPECT_EQ(scene.blocks.pairs().filled(), 0);
}

// Two ghosts are the affair of the ranks that own them.
TEST(PlanarNeighbours, GhostsAreNotListedWithEachOther) {
  Scene scene(settings_of(), {rod(1, 0, 0, 0)});
  scene.bodies.resize(3);
  scene.neighbours.resize(3);
  for (int ghost : {1, 2}) {
    PlanarBody body = rod(1, ghost * diameter, 0, 0);
    body.tag = ghost;
    scene.bodies.set_ghost(ghost, body);
    scene.neighbours.add_ghost(ghost);
  }
  scene.neighbours.list_all();
  EXPECT_EQ(scene.listed(), (std::set<std::vector<int>>{{0, 0, 1, 0}}));
}

}  // namespace rodpack

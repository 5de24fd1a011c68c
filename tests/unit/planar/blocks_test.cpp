// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks of candidate pairs: what their lanes remember, and where they lie.
#include "planar/blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "planar/pipeline.h"

namespace rodpack {
namespace {

const int slots = 3;

PlanarBlockHead head_of(int i, int j, int lanes = 2) {
  PlanarBlockHead head = PlanarBlockHead();
  head.i = i;
  head.j = j;
  head.used = static_cast<std::uint8_t>((1 << lanes) - 1);
  return head;
}

/// A block of the spheres (0, 1) and (2, 3) of both bodies.
int add_block(PlanarBlockPool& pool, const PlanarParts& parts, int i, int j, int lanes = 2) {
  PlanarBlockColdData cold = PlanarBlockColdData();
  for (int lane = 0; lane < planar_lanes; ++lane) {
    cold.sphere_i[lane] = static_cast<std::uint16_t>(2 * lane);
    cold.sphere_j[lane] = static_cast<std::uint16_t>(2 * lane + 1);
  }
  return pool.add(parts.of_pair(i, j), head_of(i, j, lanes), 0, cold);
}

PlanarLaneState state_of(double seed) {
  PlanarLaneState state = PlanarLaneState();
  PlanarHistory& history = state.history;
  history.sliding = true;
  history.just_touched = true;
  history.known = 2;
  history.spring = seed;
  for (int k = 0; k < slots; ++k) history.velocity[k] = seed + 0.1 * (k + 1);
  history.viscoelastic = seed + 1.0;
  history.touch_rate = seed + 2.0;
  history.since = seed + 3.0;
  return state;
}

PlanarLaneState saved(const PlanarBlockPool& pool, int place, int lane) {
  PlanarLaneState state;
  pool.save(place, lane, state);
  return state;
}

void expect_same_history(const PlanarLaneState& a, const PlanarLaneState& b) {
  EXPECT_EQ(a.full_history, b.full_history);
  EXPECT_EQ(a.history.sliding, b.history.sliding);
  EXPECT_EQ(a.history.just_touched, b.history.just_touched);
  EXPECT_EQ(a.history.known, b.history.known);
  EXPECT_EQ(a.history.spring, b.history.spring);
  for (int k = 0; k < slots; ++k) EXPECT_EQ(a.history.velocity[k], b.history.velocity[k]) << k;
  EXPECT_EQ(a.history.viscoelastic, b.history.viscoelastic);
  EXPECT_EQ(a.history.earlier, b.history.earlier);
  EXPECT_EQ(a.history.touch_rate, b.history.touch_rate);
  EXPECT_EQ(a.history.felt_velocity, b.history.felt_velocity);
  EXPECT_EQ(a.history.since, b.history.since);
}

/// Squared distance of the spheres that a lane names, were both bodies at the origin.
double square_of_lane(const PlanarBlockPool& pool, int place, int lane) {
  const double* const values = pool.values(place) + lane;
  return std::pow(values[planar_xi] - values[planar_xj], 2) +
         std::pow(values[planar_yi] - values[planar_yj], 2);
}

}  // namespace

// With the normal force of two steps back and what the normal dashpot felt, where they are kept.
TEST(PlanarBlocks, ALaneIsRestoredToWhatWasSaved) {
  const PlanarParts parts = {10, 4};
  PlanarBlockPool pool(10, slots, 0, {true, true});
  const auto state_with_all = [](double seed) {
    PlanarLaneState state = state_of(seed);
    state.history.earlier = seed + 4.0;
    state.history.relaxes = true;
    state.history.felt_velocity = seed + 5.0;
    return state;
  };
  std::vector<int> places;
  for (int k = 0; k < 6; ++k) places.push_back(add_block(pool, parts, k, k + 1));
  for (int k = 0; k < 6; ++k)
    for (int lane = 0; lane < planar_lanes; ++lane)
      pool.restore(places[k], lane, state_with_all(10.0 * k + lane));
  EXPECT_EQ(pool.contacts(), 12u);
  for (int k = 0; k < 6; ++k)
    for (int lane = 0; lane < planar_lanes; ++lane) {
      const PlanarLaneState state = saved(pool, places[k], lane);
      expect_same_history(state, state_with_all(10.0 * k + lane));
      EXPECT_EQ(state.i, k);
      EXPECT_EQ(state.j, k + 1);
      EXPECT_EQ(state.sphere_i, 2 * lane);
      EXPECT_EQ(state.sphere_j, 2 * lane + 1);
    }
  pool.clear(places[3], 1);
  EXPECT_EQ(pool.contacts(), 11u);
  EXPECT_EQ(saved(pool, places[3], 1).history.known, 0);
  expect_same_history(saved(pool, places[3], 0), state_with_all(30.0));
}

// The velocity of the step that is evaluated overwrites the oldest one, and is the newest after the
// turn.
TEST(PlanarBlocks, VelocitiesAreARingThatAgesOnceInAStep) {
  PlanarBlockPool pool(2, slots, 0);
  const int place = add_block(pool, {2, 4}, 0, 1);
  for (int step = 1; step <= 10; ++step) {
    pool.mutable_values(place)[pool.velocity(0, true)] = step;
    pool.age(1);
    for (int k = 0; k < std::min(step, slots); ++k)
      EXPECT_EQ(pool.values(place)[pool.velocity(k)], step - k);
  }
}

// A state that is given for the step after the turn is that one then.
TEST(PlanarBlocks, RestoresForTheStepThatIsEvaluated) {
  PlanarBlockPool pool(2, slots, 0);
  const int place = add_block(pool, {2, 4}, 0, 1);
  for (int step = 0; step < 5; ++step) {
    pool.restore(place, 0, state_of(step), true);
    pool.age(1);
    expect_same_history(saved(pool, place, 0), state_of(step));
  }
}

TEST(PlanarBlocks, LookingAheadIsAgeingForOnePartAlone) {
  PlanarBlockPool ahead(2, slots, 0), aged(2, slots, 0);
  for (int steps = 0; steps < 8; ++steps) {
    ahead.look_ahead(steps);
    for (int k = 0; k < slots; ++k)
      for (const bool next : {false, true})
        EXPECT_EQ(ahead.velocity(k, next), aged.velocity(k, next));
    aged.age(1);
  }
  ahead.age(8);
  EXPECT_EQ(ahead.velocity(0), aged.velocity(0));
}

TEST(PlanarBlocks, FindsTheLaneOfTwoSpheres) {
  const PlanarParts parts = {10, 4};
  PlanarBlockPool pool(10, slots, 0);
  add_block(pool, parts, 1, 2);
  const int place = add_block(pool, parts, 1, 3);
  const int half = add_block(pool, parts, 1, 4, 1);
  using Lane = std::pair<int, int>;
  EXPECT_EQ(pool.find(1, 0, 3, 1), Lane(place, 0));
  EXPECT_EQ(pool.find(1, 2, 3, 3), Lane(place, 1));
  EXPECT_EQ(pool.find(1, 0, 4, 1), Lane(half, 0));
  EXPECT_EQ(pool.find(1, 2, 4, 3).first, -1) << "an unused lane";
  EXPECT_EQ(pool.find(3, 0, 1, 1).first, -1) << "bodies in the other order";
  EXPECT_EQ(pool.find(1, 0, 3, 3).first, -1);
}

TEST(PlanarBlocks, WhatIsRemovedIsInNobodysIndex) {
  const PlanarParts parts = {10, 4};
  PlanarBlockPool pool(10, slots, 0);
  const int kept = add_block(pool, parts, 2, 3);
  for (const int other : {0, 1, 3, 5}) add_block(pool, parts, other, 4);
  pool.remove_all_of(4);
  EXPECT_EQ(pool.filled(), 1);
  for (int body = 0; body < 10; ++body)
    EXPECT_EQ(pool.of_body(body),
              body == 2 || body == 3 ? std::vector<int>{kept} : std::vector<int>());
}

namespace {

/// The SIMD loops take holes with the others: nothing may happen there, and no distance be 0.
void expect_hole(const PlanarBlockPool& pool, int place) {
  const PlanarBlockHead head = pool.head(place);
  EXPECT_EQ(head.used | head.alive | head.full_history | head.sliding, 0);
  EXPECT_TRUE(std::isinf(head.gap));
  EXPECT_EQ(head.i, 0);
  EXPECT_EQ(head.j, 0);
  for (int lane = 0; lane < planar_lanes; ++lane) EXPECT_GT(square_of_lane(pool, place, lane), 0.5);
}

}  // namespace

TEST(PlanarBlocks, HolesAreHarmless) {
  const PlanarParts parts = {10, 4};
  PlanarBlockPool pool(10, slots, 0);
  for (const int other : {0, 1, 3}) add_block(pool, parts, other, 4);
  pool.remove_all_of(3);
  EXPECT_EQ(pool.size(), 4) << "whole groups of four";
  int holes = 0;
  for (int place = 0; place < pool.size(); ++place) {
    if (pool.head(place).used != 0) continue;
    ++holes;
    expect_hole(pool, place);
  }
  EXPECT_EQ(holes, 2);
}

namespace {

/// Blocks in a chain of bodies and between far ones, of which every third touches.
void fill(PlanarBlockPool& pool, const PlanarParts& parts) {
  for (int k = 0; k < 60; ++k) {
    const int i = k * 7 % 40, j = (i + 1 + k % 5) % 40;
    const int place = add_block(pool, parts, i, j);
    if (k % 3 == 0) pool.restore(place, 0, state_of(k));
  }
}

}  // namespace

// With a last group the SIMD loops take one of which nothing comes.
TEST(PlanarBlocks, ThereIsAGroupThatIsNeverFilled) {
  const PlanarParts parts = {40, 10};
  PlanarBlockPool pool(40, slots, 0);
  const auto expect_empty = [&] {
    ASSERT_EQ(pool.spare() % planar_group, 0);
    for (int k = 0; k < planar_group; ++k) expect_hole(pool, pool.spare() + k);
    for (int body = 0; body < 40; ++body)
      for (const int place : pool.of_body(body)) EXPECT_LT(place, pool.spare());
  };
  expect_empty();
  for (int round = 0; round < 3; ++round) {
    fill(pool, parts);
    expect_empty();
    pool.sort(parts);
    expect_empty();
    for (int body = 0; body < 20; ++body) pool.remove_all_of(body);
    expect_empty();
  }
  EXPECT_GT(pool.filled(), 30);
}

// Four heads share a place in memory, eight lanes a byte for each kind of bits.
TEST(PlanarBlocks, HeadsOfAGroupAreTheirOwn) {
  const PlanarParts parts = {40, 10};
  for (const int wall : {0, 1}) {
    PlanarBlockPool pool(40, slots, wall ? -1 : 0);
    std::vector<int> places;
    for (int k = 0; k < planar_group; ++k) {
      places.push_back(add_block(pool, parts, 7 * k, wall ? -1 - k : 39 - k));
      pool.set_gap(places[k], k);
    }
    pool.restore(places[1], 1, state_of(1.0));
    pool.restore(places[3], 0, state_of(3.0));
    pool.remove(places[0]);
    for (int k = 1; k < planar_group; ++k) {
      const PlanarBlockHead head = pool.head(places[k]);
      EXPECT_EQ(head.i, 7 * k);
      EXPECT_EQ(head.j, wall ? -1 - k : 39 - k);
      EXPECT_EQ(head.used, all_of_block);
      EXPECT_EQ(head.alive, k == 1 ? 2 : k == 3 ? 1 : 0);
      EXPECT_NEAR(head.gap, k, 1e-6);
    }
    EXPECT_EQ(pool.head(places[0]).used, 0);
    EXPECT_EQ(pool.head(places[0]).alive, 0);
  }
}

TEST(PlanarBlocks, AreSortedByContactAndByPart) {
  const PlanarParts parts = {40, 10};
  PlanarBlockPool pool(40, slots, 0);
  fill(pool, parts);
  std::multiset<double> springs;
  for (int k = 0; k < 60; k += 3) springs.insert(k);
  pool.sort(parts);
  EXPECT_EQ(pool.filled(), 60);
  EXPECT_EQ(pool.contacts(), 20u);
  std::vector<int> times(pool.size(), 0);
  for (int part = 0; part < parts.count(); ++part)
    for (const bool touching : {true, false}) {
      const PlanarRange range = touching ? pool.touching(part) : pool.others(part);
      EXPECT_EQ(range.first % planar_group, 0);
      EXPECT_EQ(range.end % planar_group, 0);
      for (int place = range.first; place < range.end; ++place) {
        ++times[place];
        EXPECT_EQ(pool.part_of(place), part);
        const PlanarBlockHead& head = pool.head(place);
        EXPECT_LE(parts.of_pair(head.i, head.j), part) << "a body that has not moved yet";
        if (head.used == 0) continue;
        EXPECT_EQ(head.alive != 0, touching);
        if (touching) springs.erase(saved(pool, place, 0).history.spring);
      }
    }
  for (const int count : times) EXPECT_EQ(count, 1) << "each block is in one range";
  EXPECT_TRUE(springs.empty()) << "contacts keep their histories";
}

TEST(PlanarBlocks, NewOnesLieInNoPartBeforeTheirOwn) {
  const PlanarParts parts = {40, 10};
  PlanarBlockPool pool(40, slots, 0);
  fill(pool, parts);
  pool.sort(parts);
  const int size = pool.size();
  for (const int body : {3, 35, 12, 20, 3, 28}) {
    const std::vector<int> places = pool.of_body(body);
    std::vector<PlanarBlockHead> heads;
    for (const int place : places) heads.push_back(pool.head(place));
    pool.remove_all_of(body);
    for (const PlanarBlockHead& head : heads) {
      const int place = add_block(pool, parts, head.i, head.j);
      EXPECT_GE(pool.part_of(place), parts.of_pair(head.i, head.j));
    }
  }
  EXPECT_EQ(pool.filled(), 60);
  EXPECT_LE(pool.size(), size + planar_group) << "they take the places of those before";
}

TEST(PlanarBlocks, SortingTellsWhichPartsWaitForWhich) {
  const PlanarParts parts = {40, 10};
  PlanarBlocks blocks(40, slots);
  add_block(blocks.pairs(), parts, 5, 25);
  add_block(blocks.pairs(), parts, 11, 12);
  add_block(blocks.at_walls(), parts, 35, -1);
  add_block(blocks.at_walls(), parts, 5, -1);  // in a group with that of 35, and evaluated with it
  PlanarDependencies dependencies(parts);
  blocks.sort(parts, dependencies);
  // A group of four blocks is evaluated as one, so that those of 5 and 11 may come with part 2.
  EXPECT_EQ(dependencies.completed_by(0), 3);
  EXPECT_GE(dependencies.completed_by(1), 1);
  EXPECT_GE(dependencies.completed_by(2), 2);
  EXPECT_GE(dependencies.completed_by(3), 3);
  for (int place = 0; place < blocks.pairs().size(); ++place) {
    const PlanarBlockHead& head = blocks.pairs().head(place);
    if (head.used == 0) continue;
    for (const int body : {head.i, head.j})
      EXPECT_GE(dependencies.completed_by(parts.of(body)), blocks.pairs().part_of(place));
  }
}

}  // namespace rodpack

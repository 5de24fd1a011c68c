// SPDX-License-Identifier: GPL-2.0-or-later
// Ghosts of a rank, and the messages that bring them; ranks_test.cpp has whole scenes on several
// ranks.
#include "planar_ranks/halo.h"

#include <gtest/gtest.h>

#include <vector>

#include "heap.h"
#include "planar/blocks.h"
#include "planar/bodies.h"
#include "planar/events.h"
#include "planar_ranks/ghosts.h"
#include "planar_ranks/halo_messages.h"
#include "planar_lists/neighbours.h"

namespace rodpack {
namespace {

PlanarBody tagged(int tag, double x) {
  PlanarBody body = moving(rod(3, x, 0.0, 0.1 * tag), 0.1, 0.2, 3.0);
  body.tag = tag;
  return body;
}

PlanarJump some_jump() { return {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}, {7.0, 8.0, 9.0}, 0.6, 0.8}; }

void expect_same(const PlanarJump& a, const PlanarJump& b) {
  for (int d = 0; d < 3; ++d) {
    EXPECT_EQ(a.acceleration[d], b.acceleration[d]);
    EXPECT_EQ(a.velocity[d], b.velocity[d]);
    EXPECT_EQ(a.displacement[d], b.displacement[d]);
  }
  EXPECT_EQ(a.cosine, b.cosine);
  EXPECT_EQ(a.sine, b.sine);
}

/// One rank with two bodies, and what its ghosts are kept in.
struct Rank {
  PlanarSettings settings = settings_of();
  PlanarParts parts = {2, 4};
  PlanarBodyStates bodies = {settings, parts, {tagged(0, 0.0), tagged(1, 0.05)}};
  PlanarBlocks blocks = {2, 3};
  PlanarEvents events = PlanarEvents(parts);
  PlanarDependencies dependencies = PlanarDependencies(parts);
  PlanarNeighbours neighbours = {settings, bodies, parts, blocks, dependencies};
  PlanarGhosts ghosts = {bodies, neighbours, events};

  Rank() {
    events.resize(2);
    neighbours.set_longest_reach(bodies.longest_reach());
  }
  std::vector<int> choose(const std::vector<PlanarBody>& chosen) {
    std::vector<int> to_list;
    ghosts.choose(chosen, to_list);
    return to_list;
  }
};

/// The second of two ranks is played by the test.
class OtherRank : public PlanarRanks {
 public:
  int rank() const override { return 0; }
  int count() const override { return 2; }
  std::vector<double> gather(const std::vector<double>& own) override {
    std::vector<double> all = own;
    all.insert(all.end(), box.begin(), box.end());
    return all;
  }
  void largest(double*, int) override { ++questions; }
  void exchange(const std::vector<std::vector<double>>& to,
                std::vector<std::vector<double>>& from) override {
    sent = to[1];
    from = {{}, message};
  }
  void swap(std::vector<PlanarLink>& links) override {
    links_of_last_swap = static_cast<int>(links.size());
    if (!links.empty()) {
      const std::vector<double>& out = links[0].out;
      sent_in_step.assign(out.begin(), out.begin() + links[0].out_count);
    }
    for (PlanarLink& link : links) std::copy(step.begin(), step.end(), link.in.begin());
  }

  std::vector<double> box, message, step;  // corners and reach; new ghosts; a step of theirs
  std::vector<double> sent, sent_in_step;  // what the rank has said: of new ghosts; of a step
  int questions = 0, links_of_last_swap = 0;
};

}  // namespace

TEST(PlanarHaloMessages, BodiesArriveAsTheyWereSent) {
  PlanarBody still = tagged(7, 0.1), jumped = tagged(9, 0.2);
  jumped.jumped = true;
  jumped.jump = some_jump();
  for (std::size_t k = 0; k < still.spheres.size(); ++k)
    still.spheres[k].tag = 100 + static_cast<int>(k);
  std::vector<double> message;
  append_body(still, message);
  append_body(jumped, message);
  PlanarBody first, second;
  const double* const next = unpack_body(unpack_body(message.data(), first), second);
  EXPECT_EQ(next, message.data() + message.size());
  EXPECT_EQ(first.tag, 7);
  EXPECT_EQ(first.mass, still.mass);
  EXPECT_EQ(first.moment, still.moment);
  EXPECT_EQ(first.radius, still.radius);
  EXPECT_EQ(first.position[0], still.position[0]);
  EXPECT_EQ(first.sine, still.sine);
  for (int d = 0; d < 3; ++d) EXPECT_EQ(first.velocity[d], still.velocity[d]);
  ASSERT_EQ(first.spheres.size(), still.spheres.size());
  for (std::size_t k = 0; k < first.spheres.size(); ++k) {
    EXPECT_EQ(first.spheres[k].x, still.spheres[k].x);
    EXPECT_EQ(first.spheres[k].tag, still.spheres[k].tag);
  }
  EXPECT_FALSE(first.jumped);
  EXPECT_EQ(second.tag, 9);
  ASSERT_TRUE(second.jumped);
  expect_same(second.jump, jumped.jump);
}

TEST(PlanarHaloMessages, KinematicsLeaveTheRadiusAsItIs) {
  const PlanarKinematics kinematics = {1.0, 2.0, 0.6, 0.8, {3.0, 4.0, 5.0}, 6.0};
  double values[16];
  PlanarKinematics told = PlanarKinematics();
  told.radius = 9.0;
  double* const end = pack_kinematics(kinematics, values);
  EXPECT_EQ(unpack_kinematics(values, told), end);
  EXPECT_EQ(told.y, 2.0);
  EXPECT_EQ(told.sine, 0.8);
  EXPECT_EQ(told.velocity[2], 5.0);
  EXPECT_EQ(told.radius, 9.0);
}

TEST(PlanarGhosts, KnownOnesKeepTheirIndexAndOthersGetFreeOnes) {
  Rank rank;
  EXPECT_TRUE(rank.choose({tagged(10, 0.1), tagged(11, 0.11), tagged(12, 0.12)}).empty())
      << "the first lists are made of all bodies at once";
  EXPECT_EQ(rank.bodies.size(), 5);
  const int kept = rank.ghosts.of_tag(11), free = rank.ghosts.of_tag(10);
  rank.neighbours.list_all();
  const std::vector<int> to_list =
      rank.choose({tagged(12, 0.12), tagged(11, 0.11), tagged(13, 0.1)});
  EXPECT_EQ(rank.bodies.size(), 5);
  EXPECT_EQ(rank.ghosts.of_tag(11), kept);
  EXPECT_EQ(rank.ghosts.of_tag(13), free);
  EXPECT_EQ(to_list, std::vector<int>{free}) << "who has not moved has its lists";
  EXPECT_EQ(rank.bodies.tag(free), 13);
  rank.choose({});
  for (int ghost = 2; ghost < 5; ++ghost) EXPECT_EQ(rank.bodies.info(ghost).count, 0);
}

TEST(PlanarGhosts, MoveAndJumpAsTheirBodies) {
  Rank rank;
  PlanarBody body = tagged(10, 0.1);
  body.jumped = true;
  body.jump = some_jump();
  rank.choose({body});
  ASSERT_TRUE(rank.events.jumped(2));
  expect_same(rank.events.jump(2), body.jump);
  rank.neighbours.list_all();
  PlanarKinematics kinematics = rank.bodies.kinematics(2);
  std::vector<int> to_list;
  rank.ghosts.move(2, kinematics, to_list);
  EXPECT_TRUE(to_list.empty());
  kinematics.x += 2e-3;  // more than any skin
  rank.ghosts.move(2, kinematics, to_list);
  EXPECT_EQ(to_list, std::vector<int>{2});
  EXPECT_EQ(rank.bodies.kinematics(2).x, kinematics.x);
}

// The other rank has bodies from x = 0.06 on, with the same reach. Ghosts are those that are closer
// to its box than both reaches and twice the reserve of 1/4 reach + 2 skins:
// 2 * 4.5 mm + 2 * (1.125 + 2) mm = 15.25 mm; so body 1, at x = 0.05, and not body 0.
TEST(PlanarHalo, SendsTheBodiesThatTheOtherRankMayTouch) {
  Rank rank;
  OtherRank other;
  const double reach = rank.bodies.longest_reach();
  EXPECT_NEAR(reach, 4.5e-3, 1e-15);
  PlanarHalo halo(other, rank.settings, reach, rank.bodies, rank.events, rank.ghosts);
  std::vector<int> to_list;
  for (const double gap : {0.01524, 0.01526}) {
    other.box = {0.05 + gap, -1.0, 0.2, 1.0, reach};
    halo.renew(to_list);
    if (gap > 0.01525) {
      EXPECT_TRUE(other.sent.empty());
      continue;
    }
    ASSERT_FALSE(other.sent.empty());
    PlanarBody sent;
    EXPECT_EQ(unpack_body(other.sent.data(), sent), other.sent.data() + other.sent.size());
    EXPECT_EQ(sent.tag, 1);
    halo.hold_back_sent(rank.dependencies);
    EXPECT_EQ(rank.dependencies.completed_by(0), rank.parts.last());
  }
}

// In both directions: the other rank is sent body 1, which has jumped.
TEST(PlanarHalo, BringsGhostsToEachStep) {
  Rank rank;
  OtherRank other;
  const double reach = rank.bodies.longest_reach();
  other.box = {0.06, -1.0, 0.2, 1.0, reach};
  append_body(tagged(10, 0.06), other.message);
  append_body(tagged(11, 0.07), other.message);
  PlanarHalo halo(other, rank.settings, reach, rank.bodies, rank.events, rank.ghosts);
  std::vector<int> to_list;
  halo.renew(to_list);
  EXPECT_EQ(rank.bodies.size(), 4);
  // Both have moved, and the second one had an event.
  other.step.resize(most_step_values(2));
  PlanarKinematics kinematics = rank.bodies.kinematics(2);
  kinematics.x = 0.0601;
  double* next = pack_kinematics(kinematics, other.step.data());
  kinematics.x = 0.0701;
  next = pack_kinematics(kinematics, next);
  *next++ = 1.0;
  *next++ = 1.0;
  pack_jump(some_jump(), next);
  rank.events.set_jumped(1, some_jump());
  EXPECT_FALSE(halo.update(to_list));
  EXPECT_EQ(other.links_of_last_swap, 1);
  EXPECT_EQ(rank.bodies.kinematics(2).x, 0.0601);
  EXPECT_EQ(rank.bodies.kinematics(3).x, 0.0701);
  EXPECT_FALSE(rank.events.jumped(2));
  ASSERT_TRUE(rank.events.jumped(3));
  expect_same(rank.events.jump(3), some_jump());
  EXPECT_EQ(halo.ghosts_brought(), 2);

  const PlanarKinematics& own = rank.bodies.kinematics(1);
  std::vector<double> expected = {own.x,           own.y,           own.cosine,     own.sine,
                                  own.velocity[0], own.velocity[1], own.velocity[2]};
  expected.push_back(1.0);  // body that has jumped, and
  expected.push_back(0.0);  // its number among those that are sent
  for (double value = 1.0; value < 10.0; value += 1.0) expected.push_back(value);  // some_jump()
  expected.push_back(0.6);
  expected.push_back(0.8);
  EXPECT_EQ(other.sent_in_step, expected);
}

// Bodies at |v| + |w| reach = 0.2236 + 3 * 0.0045 = 0.2371 m/s go 2.61 um in a step; at twice that
// speed the reserve of 3.125 mm lasts for 599 steps. So the question comes again after 32 steps.
TEST(PlanarHalo, AsksAgainAfterThirtyTwoStepsAtMost) {
  Rank rank;
  OtherRank other;
  const double reach = rank.bodies.longest_reach();
  other.box = {0.5, -1.0, 0.6, 1.0, reach};
  PlanarHalo halo(other, rank.settings, reach, rank.bodies, rank.events, rank.ghosts);
  std::vector<int> to_list;
  halo.renew(to_list);
  halo.update(to_list);
  EXPECT_EQ(other.questions, 1);
  EXPECT_EQ(halo.quiet_updates(), 31);
  for (int k = 0; k < 31; ++k) halo.update(to_list);
  EXPECT_EQ(other.questions, 1);
  halo.update(to_list);
  EXPECT_EQ(other.questions, 2);
}

}  // namespace rodpack

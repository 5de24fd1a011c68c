// SPDX-License-Identifier: GPL-2.0-or-later
// The order in which a pipeline makes the parts of several steps.
#include "planar/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace rodpack {
namespace {

const int bodies_of_part = 10;

/// Parts of ten bodies each, and the part of the ghosts.
PlanarParts parts_of(int parts) { return {(parts - 1) * bodies_of_part, bodies_of_part}; }

/// Notes what is made, and checks that it may be.
class Recorder : public PlanarPartStep {
 public:
  Recorder(const PlanarParts& parts, const PlanarDependencies& dependencies)
      : evaluated(most_steps_in_pass, 0), parts_(parts), dependencies_(dependencies) {}

  bool move(int step, int part) override {
    EXPECT_EQ(part, evaluated[step]) << "parts of a step are made in their order";
    if (step > 0) {
      EXPECT_LT(dependencies_.completed_by(part), evaluated[step - 1])
          << "forces on part " << part << " are not complete";
    }
    return found.count({step, part}) > 0;
  }

  void evaluate(int step, int part) override {
    if (found.count({step, part}) > 0) {
      for (int before = 0; before < step; ++before) EXPECT_EQ(evaluated[before], parts_.count());
    }
    ++evaluated[step];
    for (int later = step + 1; later < most_steps_in_pass; ++later)
      most_behind = std::max(most_behind, evaluated[step] - evaluated[later]);
    order.push_back({step, part});
  }

  std::set<std::pair<int, int>> found;  // step and part in which new neighbours are found
  std::vector<std::pair<int, int>> order;
  std::vector<int> evaluated;  // parts that each step has made
  int most_behind = 0;         // parts that a step was behind one before it

 private:
  PlanarParts parts_;
  const PlanarDependencies& dependencies_;
};

/// Each part has contacts with the next one.
void connect_as_chain(const PlanarParts& parts, PlanarDependencies& dependencies) {
  for (int part = 0; part + 1 < parts.last(); ++part)
    dependencies.add_contact(part * bodies_of_part + 9, (part + 1) * bodies_of_part, part + 1);
}

using Order = std::vector<std::pair<int, int>>;

}  // namespace

TEST(PlanarDependencies, APartWaitsForTheLastOneThatHasAContactOfItsBodies) {
  const PlanarParts parts = parts_of(5);
  PlanarDependencies dependencies(parts);
  for (int part = 0; part < 5; ++part) EXPECT_EQ(dependencies.completed_by(part), part);
  dependencies.add_contact(3, 25, 2);   // bodies of parts 0 and 2
  dependencies.add_contact(12, -1, 3);  // a block with a wall, that lies with part 3
  dependencies.add_contact(5, 14, 1);
  const std::vector<int> expected = {2, 3, 2, 3, 4};
  for (int part = 0; part < 5; ++part) EXPECT_EQ(dependencies.completed_by(part), expected[part]);
  dependencies.hold_back(27);
  EXPECT_EQ(dependencies.completed_by(2), 4);
  dependencies.clear();
  for (int part = 0; part < 5; ++part) EXPECT_EQ(dependencies.completed_by(part), part);
}

TEST(PlanarPipeline, EveryStepMakesEveryPartOnceAndInOrder) {
  for (const int steps : {1, 2, 8})
    for (const int count : {1, 2, 9}) {
      const PlanarParts parts = parts_of(count);
      PlanarDependencies dependencies(parts);
      connect_as_chain(parts, dependencies);
      Recorder recorder(parts, dependencies);
      PlanarPipeline(parts, dependencies).run(steps, recorder);
      for (int step = 0; step < most_steps_in_pass; ++step)
        EXPECT_EQ(recorder.evaluated[step], step < steps ? count : 0);
    }
}

// Three parts in a chain, and the part of the ghosts, which has no contacts: part 0 makes the next
// step when part 1 has made the one before.
TEST(PlanarPipeline, APartGoesOnAsSoonAsTheForcesOnItAreComplete) {
  const PlanarParts parts = parts_of(4);
  PlanarDependencies dependencies(parts);
  connect_as_chain(parts, dependencies);
  Recorder recorder(parts, dependencies);
  PlanarPipeline(parts, dependencies).run(2, recorder);
  const Order expected = {{0, 0}, {0, 1}, {1, 0}, {0, 2}, {1, 1}, {1, 2}, {0, 3}, {1, 3}};
  EXPECT_EQ(recorder.order, expected);
}

// What is in the cache is used for all steps: a step is at most two parts behind the one before, 14
// behind the first of eight.
TEST(PlanarPipeline, StepsFollowEachOtherClosely) {
  const PlanarParts parts = parts_of(100);
  PlanarDependencies dependencies(parts);
  connect_as_chain(parts, dependencies);
  Recorder recorder(parts, dependencies);
  PlanarPipeline(parts, dependencies).run(8, recorder);
  EXPECT_LE(recorder.most_behind, 2 * 7);
}

TEST(PlanarPipeline, WhatIsHeldBackMakesOneStepAfterTheOther) {
  const PlanarParts parts = parts_of(3);
  PlanarDependencies dependencies(parts);
  dependencies.hold_back(0);
  Recorder recorder(parts, dependencies);
  PlanarPipeline(parts, dependencies).run(2, recorder);
  const Order expected = {{0, 0}, {0, 1}, {0, 2}, {1, 0}, {1, 1}, {1, 2}};
  EXPECT_EQ(recorder.order, expected);
}

// In the second of three steps part 0 finds neighbours of which it knew nothing: the first step has
// to be over before it evaluates them. In the third one, both.
TEST(PlanarPipeline, NewNeighboursAreNotMetByTheStepsBefore) {
  const PlanarParts parts = parts_of(6);
  PlanarDependencies dependencies(parts);
  connect_as_chain(parts, dependencies);
  for (const std::set<std::pair<int, int>>& found :
       {std::set<std::pair<int, int>>{{1, 0}}, {{2, 0}}, {{1, 1}, {2, 0}}}) {
    Recorder recorder(parts, dependencies);
    recorder.found = found;  // checked in Recorder::evaluate()
    PlanarPipeline(parts, dependencies).run(3, recorder);
    for (int step = 0; step < 3; ++step) EXPECT_EQ(recorder.evaluated[step], 6);
    EXPECT_GT(recorder.most_behind, 4);
  }
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
// Dumps of a group: its particles alone, to which all others are walls. Sorted dumps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

// Three balls in a row along x that overlap by 1e-5 m, the first and the third held by nothing, and
// a fourth by itself.
const std::string four_balls =
    "create_atoms 1 single 0.01 0.05 0 units box\n"
    "create_atoms 1 single 0.01299 0.05 0 units box\n"
    "create_atoms 1 single 0.01598 0.05 0 units box\n"
    "create_atoms 1 single 0.05 0.05 0 units box\n"
    "set group all diameter 0.003 density 2500\n"
    "group middle id 2\ngroup last id 3:4\n"
    "fix motion all nve/sphere\n"
    "run 0\n"
    "write_dump all    contact/gran all.dump modify format %.17g\n"
    "write_dump middle contact/gran middle.dump modify sort off format %.17g\n"
    "write_dump last   contact/gran last.dump modify format %.17g\n"
    "write_dump last   multisphere/body bodies.dump modify format %.17g\n";

}  // namespace

// k_n 1000 N/m in the pair: 0.01 N, at the middle of the overlap.
TEST(DumpOfAGroup, WhatIsNotInItIsAWallOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    const auto run = run_liggghts(Deck().processors("* 1 1").with(four_balls), {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(read_dump(run.folder / "all.dump").rows(), 2U);

    const Table middle = read_dump(run.folder / "middle.dump");
    ASSERT_EQ(middle.rows(), 2U);
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_EQ(middle.column("sphere_i")[c], 2);
      EXPECT_EQ(middle.column("body_j")[c], 0);
      EXPECT_EQ(middle.column("wall")[c], 1);
      // Away from the neighbour, which is where the contact is.
      const bool left = middle.column("x")[c] < 0.01299;
      EXPECT_NEAR(middle.column("fx")[c], left ? 0.01 : -0.01, 1e-9);
      EXPECT_NEAR(middle.column("nx")[c], left ? 1 : -1, 1e-12);
      EXPECT_NEAR(middle.column("x")[c], left ? 0.011495 : 0.014485, 1e-12);
      EXPECT_NEAR(middle.column("bix")[c], 0.01299, 1e-12);
      EXPECT_EQ(middle.column("bjx")[c], middle.column("x")[c]);
    }

    const Table last = read_dump(run.folder / "last.dump");
    ASSERT_EQ(last.rows(), 1U);
    EXPECT_EQ(last.column("sphere_i")[0], 3);
    EXPECT_EQ(last.column("wall")[0], 1);
    EXPECT_NEAR(last.column("fx")[0], 0.01, 1e-9);
    const Table bodies = read_dump(run.folder / "bodies.dump");
    ASSERT_EQ(bodies.rows(), 2U);
    EXPECT_NEAR(bodies.column("x")[0], 0.01598, 1e-12);
    EXPECT_NEAR(bodies.column("x")[1], 0.05, 1e-12);
  }
}

// Of what a contact's two sides are made: here a ball of type 2 between one of type 1 and a wall of
// type 3, with our contact models, which are evaluated once more, and with LIGGGHTS's own.
TEST(DumpOfContacts, TellsTheAtomTypesOfBothSidesOnOneAndTwoRanks) {
  for (const std::string models :
       {"model spring_dashpot tangential spring_dashpot", "model hertz tangential history"})
    for (const int ranks : {1, 2}) {
      auto deck = Deck().atom_types(3).processors("* 1 1");
      if (models.find("hertz") != std::string::npos) deck.hertz();
      const auto run = run_liggghts(deck.with("create_atoms 1 single 0.05299 0.0014 0 units box\n"
                                              "create_atoms 2 single 0.05 0.00149 0 units box\n"
                                              "set group all diameter 0.003 density 2500\n"
                                              "group right id 1\ngroup left id 2\n"
                                              "fix motion all nve/sphere\n"
                                              "fix floor left wall/gran " +
                                              models +
                                              " primitive type 3 yplane 0\nrun 0\n"
                                              "write_dump all contact/gran all.dump\n"
                                              "write_dump right contact/gran right.dump\n"
                                              "write_dump left contact/gran left.dump\n"),
                                    {}, ranks);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      using Types = std::set<std::array<double, 4>>;  // sphere_i, wall, type_i, type_j
      const auto types = [&](const std::string& name) {
        const Table contacts = read_dump(run.folder / name);
        Types found;
        for (std::size_t c = 0; c < contacts.rows(); ++c)
          found.insert({contacts.column("sphere_i")[c], contacts.column("wall")[c],
                        contacts.column("type_i")[c], contacts.column("type_j")[c]});
        return found;
      };
      const auto all = types("all.dump");
      EXPECT_TRUE(all == (Types{{1, 0, 1, 2}, {2, 1, 2, 3}}) ||
                  all == (Types{{2, 0, 2, 1}, {2, 1, 2, 3}}));
      EXPECT_EQ(types("right.dump"), (Types{{1, 1, 1, 2}}));
      EXPECT_EQ(types("left.dump"), (Types{{2, 1, 2, 1}, {2, 1, 2, 3}}));
    }
}

// Three balls that touch one another have three contacts, and two of these the same sphere_i: as
// many rows as atoms, whose ids are no places in the file.
TEST(SortedDumps, ContactsAsManyAsAtomsAreSortedBySphereOnOneAndTwoRanks) {
  const std::string three_balls =
      "create_atoms 1 single 0.049 0.05 0 units box\n"
      "create_atoms 1 single 0.05199 0.05 0 units box\n"
      "create_atoms 1 single 0.050495 0.0525894 0 units box\n"
      "set group all diameter 0.003 density 2500\n"
      "fix motion all nve/sphere\nrun 0\n"
      "write_dump all contact/gran c.dump modify sort id\n"
      "write_dump all contact/gran down.dump modify sort -3\n"
      "write_dump all multisphere/sphere s.dump modify sort id\n"
      "write_dump all multisphere/body b.dump modify sort id\n";
  for (const int ranks : {1, 2}) {
    const auto run = run_liggghts(Deck().processors("* 1 1").with(three_balls), {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    for (const std::string name : {"c.dump", "down.dump"}) {
      const Table contacts = read_dump(run.folder / name);
      ASSERT_EQ(contacts.rows(), 3U);
      auto ids = contacts.column("sphere_i");
      if (name == "down.dump") std::reverse(ids.begin(), ids.end());
      EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end())) << name;
      std::set<std::pair<double, double>> pairs;
      for (std::size_t c = 0; c < 3; ++c)
        pairs.insert(std::minmax(contacts.column("sphere_i")[c], contacts.column("sphere_j")[c]));
      EXPECT_EQ(pairs, (std::set<std::pair<double, double>>{{1, 2}, {1, 3}, {2, 3}})) << name;
    }
    for (const std::string name : {"s.dump", "b.dump"})
      EXPECT_EQ(read_dump(run.folder / name).column("id"), (std::vector<double>{1, 2, 3})) << name;
  }
}

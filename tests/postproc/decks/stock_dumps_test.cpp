// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS's own dumps: bodies from the spheres of a dump custom, and what is refused with the line
// that the deck needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "../synthetic_packing.h"
#include "analysis/pairs/pair_configuration.h"
#include "analysis/stock/local_contacts.h"
#include "analysis/stock/stock_dumps.h"
#include "liggghts_run.h"
#include "reading/checks/body_axes.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

const double pi = std::acos(-1.0);

// Spheres of a dump custom: one line each, in a box from 0 to 1, periodic in x.
struct Spheres {
  std::ostringstream rows;
  int count = 0;
  explicit Spheres() { rows.precision(17); }
  Spheres& add(int body, double x, double y, double z, double radius = 0.01) {
    rows << ++count << " 3 " << x << ' ' << y << ' ' << z << ' ' << radius << ' ' << body << '\n';
    return *this;
  }
  // A chain of `number` from (x, y, z) on, `step` apart along a unit vector.
  Spheres& chain(int body, int number, const Vector3& from, const Vector3& along, double step) {
    for (int k = 0; k < number; ++k) {
      double x = from[0] + k * step * along[0];
      x -= std::floor(x);
      add(body, x, from[1] + k * step * along[1], from[2] + k * step * along[2]);
    }
    return *this;
  }
  Frame frame(const std::string& column = "id_multisphere") const {
    return last_frame(
        {put(fresh_folder() / "bodies.7.dump",
             "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n" + std::to_string(count) +
                 "\nITEM: BOX BOUNDS pp ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id type x y z radius " +
                 column + "\n" + rows.str())});
  }
};

TEST(StockDumps, SpheresOfABodyAreItsChain) {
  // Smooth, coarse and a single one; the first crosses the periodic border.
  Spheres spheres;
  spheres.chain(5, 9, {0.97, 0.5, 0.5}, {0.8, 0.6, 0}, 0.01)
      .chain(2, 3, {0.3, 0.2, 0.2}, {0, 0, 1}, 0.02)
      .add(0, 0.7, 0.7, 0.7)
      .add(-1, 0.8, 0.7, 0.7);
  for (const std::string column : {"id_multisphere", "mol"}) {
    const auto bodies = as_bodies(spheres.frame(column));
    ASSERT_EQ(bodies.rows, 4U);
    const auto row = [&](const std::string& name, std::size_t k) { return bodies.column(name)[k]; };
    EXPECT_EQ(row("id", 1), 5);
    EXPECT_EQ(row("type", 1), 3);
    EXPECT_EQ(row("nspheres", 1), 9);
    EXPECT_NEAR(row("x", 1), 0.97 + 0.04 * 0.8 - 1, 1e-12);  // back inside the period
    EXPECT_NEAR(row("y", 1), 0.5 + 0.04 * 0.6, 1e-12);
    EXPECT_NEAR(std::remainder(row("angle", 1) - std::atan2(0.6, 0.8), pi), 0, 1e-9);
    EXPECT_NEAR(row("half_length", 1), 0.04 + 0.01, 1e-12);
    EXPECT_NEAR(row("radius", 1), 0.01, 1e-15);
    EXPECT_EQ(row("curvature", 1), 0);
    EXPECT_NEAR(row("area", 1), covered_area(shape_of_body(9, 5, 0.02, 0.02, 0)), 1e-12);
    const BodyAxes axes(bodies);
    EXPECT_NEAR(std::abs(axes.axis(1, 0)[0]), 0.8, 1e-9);
    EXPECT_NEAR(std::abs(axes.axis(0, 0)[2]), 1, 1e-9);
    // Beads that touch cover as many discs.
    EXPECT_NEAR(row("area", 0), 3 * pi * 1e-4, 1e-12);
    // Plain spheres: the atom's id plus the largest body's.
    EXPECT_EQ(row("id", 2), 13 + 5);
    EXPECT_EQ(row("nspheres", 3), 1);
    EXPECT_NEAR(row("area", 3), pi * 1e-4, 1e-15);
  }
}

TEST(StockDumps, WhatIsNoStraightChainIsRefusedByTheNameOfTheBody) {
  const auto refused = [](Spheres& spheres, const std::string& reason) {
    const auto frame = spheres.frame();
    EXPECT_THAT([&] { as_bodies(frame); },
                ThrowsMessage<DataError>(
                    AllOf(HasSubstr("bodies.7.dump:9: body 4: expected the equal spheres of a "
                                    "straight chain, found " +
                                    reason),
                          HasSubstr("'dump bodies all multisphere/body 10000 bodies.*.dump'"))));
  };
  Spheres bent, sizes, gap, apart, same;
  refused(bent.add(4, 0.1, 0.1, 0.1).add(4, 0.11, 0.105, 0.1).add(4, 0.12, 0.1, 0.1),
          "spheres beside a line");
  refused(sizes.add(4, 0.1, 0.1, 0.1).add(4, 0.11, 0.1, 0.1, 0.012), "spheres of different radii");
  refused(gap.add(4, 0.1, 0.1, 0.1).add(4, 0.11, 0.1, 0.1).add(4, 0.13, 0.1, 0.1),
          "uneven distances between them");
  refused(apart.add(4, 0.1, 0.1, 0.1).add(4, 0.13, 0.1, 0.1), "spheres that do not touch");
  refused(same.add(4, 0.1, 0.1, 0.1).add(4, 0.1, 0.1, 0.1), "spheres at one place");
}

TEST(StockDumps, AnotherDumpNamesTheLineThatTheDeckNeeds) {
  const auto folder = fresh_folder();
  const auto error = [&](const std::string& command) {
    const auto run = rodpack::test::run_rodpack(command, folder);
    EXPECT_EQ(run.exit_code, 1) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1) << run.output;
    return run.output;
  };
  const auto dump = [&](const std::string& name, const std::string& kind,
                        const std::string& columns, const std::string& row) {
    put(folder / name, "ITEM: TIMESTEP\n7\nITEM: NUMBER OF " + kind +
                           "\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: " + kind + " " +
                           columns + "\n" + row + "\n");
  };
  const std::string bodies = "'dump bodies all multisphere/body 10000 bodies.*.dump' in the deck";
  dump("s.dump", "ATOMS", "id type x y z radius", "1 1 0.5 0.5 0.5 0.01");
  EXPECT_THAT(error("orientation s.dump"),
              AllOf(HasSubstr("s.dump:9: expected a dump of bodies"),
                    HasSubstr("id type x y z radius id_multisphere"), HasSubstr(bodies)));
  dump("spheres.dump", "ATOMS", "id body type x y z radius", "1 1 1 0.5 0.5 0.5 0.01");
  EXPECT_THAT(error("rdf spheres.dump"),
              AllOf(HasSubstr("found one of spheres"), HasSubstr(bodies)));
  dump("local.dump", "ENTRIES", "c_cpl[1] c_cpl[2]", "1 2");
  EXPECT_THAT(error("forces local.dump"),
              AllOf(HasSubstr("local.dump:9: expected a dump of contacts"),
                    HasSubstr("'dump contacts all contact/gran 10000 contacts.*.dump' in the "
                              "deck writes them")));
  EXPECT_THAT(error("solid-fraction local.dump"), HasSubstr(bodies));
  dump("stock.dump", "ATOMS", "id type x y z radius id_multisphere", "1 1 0.5 0.5 0.5 0.01 0");
  EXPECT_THAT(error("stress stock.dump --contacts local.dump"),
              AllOf(HasSubstr("local.dump:9: expected a dump of contacts"),
                    HasSubstr("are read with --local")));
  const std::string motion =
      "stock.dump:9: expected particles with mass and velocity, which fields need, found some "
      "without; 'mass vx vy vz' among the columns of the dump custom tell them";
  EXPECT_THAT(error("solid-fraction stock.dump"), HasSubstr(motion));
  EXPECT_THAT(error("solid-fraction stock.dump --vertical z"), HasSubstr(motion));
  // Words that do not fit the columns, and bodies that do not tell their spheres.
  EXPECT_THAT(error("stress stock.dump --contacts local.dump --local id force"),
              HasSubstr("local.dump:9: expected 6 columns of the words of the compute, found 2"));
  dump("b.dump", "ENTRIES", "id type nspheres x y z angle half_length radius curvature area",
       "1 1 1 0.5 0.5 0.5 0 0.01 0.01 0 3e-4");
  dump("six.dump", "ENTRIES", "c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6]", "1 2 0 1 0 0");
  EXPECT_THAT(error("profile b.dump --contacts six.dump --local id force"),
              HasSubstr("b.dump:9: expected a dump of spheres that tells their bodies"));
  EXPECT_EQ(rodpack::test::run_rodpack("profile b.dump --local-walls local.dump", folder).exit_code,
            2);
}

// Each sphere of a body carries the body's mass; the velocity of the centre of a chain is the mean
// of its spheres', which are v + omega x r: here 3 m/s along y, turning with 5 rad/s about z.
TEST(StockDumps, MassAndVelocityOfABody) {
  const auto dump = [](double third_mass) {
    return last_frame({put(
        fresh_folder() / "bodies.7.dump",
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 "
        "1\nITEM: ATOMS id type x y z radius id_multisphere mass vx vy vz omegax omegay "
        "omegaz\n1 1 0.48 0.5 0.5 0.01 1 0.02 0 2.9 0 0 0 5\n2 1 0.5 0.5 0.5 0.01 1 0.02 0 3 0 "
        "0 0 5\n3 1 0.52 0.5 0.5 0.01 1 " +
            std::to_string(third_mass) +
            " 0 3.1 0 0 0 5\n4 1 0.7 0.7 0.7 0.01 0 0.008 1 -1 0.5 0 0 0\n")});
  };
  const auto bodies = as_bodies(dump(0.02));
  ASSERT_EQ(bodies.rows, 2U);
  const std::vector<std::pair<std::string, std::vector<double>>> expected{{"mass", {0.02, 0.008}},
                                                                          {"vx", {0, 1}},
                                                                          {"vy", {3, -1}},
                                                                          {"vz", {0, 0.5}},
                                                                          {"omegaz", {5, 0}}};
  for (const auto& [name, values] : expected)
    for (std::size_t row = 0; row < 2; ++row)
      EXPECT_NEAR(bodies.column(name)[row], values[row], 1e-12) << name;
  EXPECT_EQ(why_no_motion(bodies), "");
  const auto uneven = dump(0.03);
  EXPECT_THAT([&] { as_bodies(uneven); },
              ThrowsMessage<DataError>(HasSubstr("body 1: expected the equal spheres of a straight "
                                                 "chain, found spheres of different mass")));
}

// Two rods of two spheres, x periodic with 1 m, and a single sphere: rod 1 with sphere 2 (at 0.98)
// and rod 4 with sphere 3 (at 0.005) touch across the border, 0.001 deep in each other; rod 4 and
// the single sphere 5 are 0.002 deep. Bodies 1 and 4 come first, so the single one is 4 + 5 = 9.
TEST(LocalContacts, FollowTheWordsOfTheCompute) {
  const auto spheres = Spheres()
                           .add(1, 0.96, 0.5, 0.5, 0.013)
                           .add(1, 0.98, 0.5, 0.5, 0.013)
                           .add(4, 0.005, 0.5, 0.5, 0.013)
                           .add(4, 0.025, 0.5, 0.5, 0.013)
                           .add(0, 0.025, 0.524, 0.5, 0.013)
                           .frame();
  const auto folder = fresh_folder();
  const auto local = [&](int columns, const std::string& rows) {
    std::string names;
    for (int c = 1; c <= columns; ++c) names += " c_p[" + std::to_string(c) + "]";
    return last_frame({put(folder / "p.dump",
                           "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n2\nITEM: BOX "
                           "BOUNDS pp ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES" +
                               names + "\n" + rows)});
  };
  // The order of the words is none of LIGGGHTS's; of the history it is the rest that counts.
  const std::vector<std::string> words{"delta", "force", "history", "id"};
  const auto pairs = local(9, "2 3 1 5 6 7 0.1 0.2 0.001\n5 4 0 0 8 1 0.1 0.2 0.002\n");
  const auto contacts = contacts_of_local_dump(pairs, words, spheres);
  ASSERT_EQ(contacts.rows, 2U);
  const auto row = [&](std::size_t k) {
    std::vector<double> values;
    for (const char* name :
         {"body_i", "body_j", "sphere_i", "sphere_j", "wall", "x", "y", "fx", "bix", "biy", "bjx",
          "overlap_n", "nx", "ny", "nz", "type_i", "type_j"})
      values.push_back(contacts.column(name)[k]);
    return values;
  };
  // Contact point: x_j + r - overlap/2 towards i, at 1.005 - 0.0125; centre of rod 4 across the
  // border.
  const auto near = [](const std::vector<double>& values) {
    std::vector<testing::Matcher<double>> all;
    for (const double each : values) all.push_back(testing::DoubleNear(each, 1e-9));
    return testing::ElementsAreArray(all);
  };
  EXPECT_THAT(row(0),
              near({1, 4, 2, 3, 0, 0.9925, 0.5, 5, 0.97, 0.5, 1.015, 0.001, -1, 0, 0, 3, 3}));
  EXPECT_THAT(row(1),
              near({9, 4, 5, 4, 0, 0.025, 0.512, 0, 0.025, 0.524, 0.015, 0.002, 0, 1, 0, 3, 3}));
  const auto refusal = [&](const Frame& frame,
                           const std::vector<std::string>& given) -> std::string {
    try {
      contacts_of_local_dump(frame, given, spheres);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(pairs, {"id", "pos"}), HasSubstr("expected 'force' among them"));
  EXPECT_THAT(refusal(pairs, {"id", "force", "forces"}), HasSubstr("found 'forces'"));
  EXPECT_THAT(refusal(pairs, {"id", "force"}),
              HasSubstr("p.dump:9: expected 6 columns of the words of the compute, found 9"));
  EXPECT_THAT(refusal(pairs, {"pos", "vel", "id", "force", "history"}),
              HasSubstr("expected 18 columns and those of the history"));
  EXPECT_THAT(refusal(local(6, "2 8 1 5 6 7\n5 4 0 0 8 1\n"), {"id", "force"}),
              HasSubstr("no sphere 8, which has a contact in "));
  EXPECT_THAT(refusal(local(12, "0.98 0.5 0.5 0.5 0.5 0.5 2 3 1 5 6 7\n0 0 0 0 0 0 5 4 0 0 8 1\n"),
                      {"pos", "id", "force"}),
              HasSubstr("sphere 3: expected at 0.005 0.5 0.5 m"));
}

// A wall's contact lists wall, triangle and sphere; its normal points from the contact point to the
// sphere's centre, 0.0125 away, so that the overlap is 0.0005.
TEST(LocalContacts, OfWallsPointToTheSphere) {
  const auto spheres = Spheres().add(1, 0.3, 0.5, 0.5, 0.013).add(1, 0.32, 0.5, 0.5, 0.013).frame();
  const auto folder = fresh_folder();
  const auto frame = [&](const std::string& rows, int count) {
    return last_frame({put(folder / "w.dump",
                           "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n" + std::to_string(count) +
                               "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
                               "ITEM: ENTRIES c_w[1] c_w[2] c_w[3] c_w[4] c_w[5] c_w[6] c_w[7] "
                               "c_w[8] c_w[9] c_w[10] c_w[11] c_w[12]\n" +
                               rows)});
  };
  const std::vector<std::string> words{"pos", "id", "force"};
  const auto none = frame("", 0);
  auto contacts = contacts_of_local_dump(none, words, spheres);
  EXPECT_EQ(contacts.rows, 0U);
  add_contacts_of_wall_dump(frame("0.3 0.4875 0.5 0.3 0.5 0.5 0 3 1 7 8 9\n", 1), words, spheres,
                            contacts);
  ASSERT_EQ(contacts.rows, 1U);
  const std::pair<const char*, double> expected[] = {
      {"body_i", 1},  {"body_j", 0},    {"sphere_i", 1}, {"wall", 1},
      {"y", 0.48725}, {"fy", 8},        {"ny", 1},       {"overlap_n", 0.0005},
      {"bix", 0.31},  {"bjy", 0.48725}, {"type_i", 3},   {"type_j", 0}};
  for (const auto& [name, value] : expected)
    EXPECT_NEAR(contacts.column(name)[0], value, 1e-9) << name;
  EXPECT_THROW(add_contacts_of_wall_dump(none, {"id", "force"}, spheres, contacts), DataError);
}

TEST(LocalContacts, NeedTheDumpOfSpheres) {
  const auto folder = fresh_folder();
  put(folder / "p.dump",
      "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ENTRIES c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6]\n1 2 0 1 0 0\n");
  put(folder / "b.dump",
      "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ENTRIES id nspheres x y z\n1 2 0.5 0.5 0.5\n");
  const auto run =
      rodpack::test::run_rodpack("forces p.dump --local id force --bodies b.dump", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output,
              HasSubstr("b.dump:9: expected a dump of spheres that tells their bodies"));
  EXPECT_THAT(run.output,
              HasSubstr("custom 10000 bodies.*.dump id type x y z radius id_multisphere"));
  EXPECT_EQ(rodpack::test::run_rodpack("forces p.dump --local id force", folder).exit_code, 2);
  EXPECT_EQ(rodpack::test::run_rodpack("forces p.dump --bodies b.dump --local id fource", folder)
                .exit_code,
            2);
}

}  // namespace

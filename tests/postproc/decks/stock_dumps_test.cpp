// SPDX-License-Identifier: GPL-2.0-or-later
// LIGGGHTS's own dumps: bodies from the spheres of a dump custom, and what is refused with the line
// that the deck needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "../synthetic_packing.h"
#include "analysis/pairs/pair_configuration.h"
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
}

}  // namespace

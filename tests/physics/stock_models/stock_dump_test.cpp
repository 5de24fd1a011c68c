// SPDX-License-Identifier: GPL-2.0-or-later
// What rodpack reads of LIGGGHTS's own dump custom is what dump multisphere/body says of the same
// bodies.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/stock/stock_dumps.h"
#include "deck.h"
#include "liggghts_run.h"
#include "reading/checks/body_axes.h"

using namespace rodpack;
using namespace rodpack::test;

namespace {

TEST(StockDump, OfARunGivesTheBodiesOfItsOwnDump) {
  const auto run = run_liggghts(
      Deck().box("0 0.1 0 0.1 -0.012 0.012").boundary("p f f").processors("* 1 1").with(R"(
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 yplane 0.0
fix rods all particletemplate/multisphere/spherocylinder 1 type 1 aspect_ratio 4 diameter 0.003 surface smooth size_spread 0.05 density 2500 planar yes
fix move all multisphere/ab order 3 planar yes
fix plane all enforce2d/multisphere
fix lines all insert/line 3 template rods 1 per_line 6 x 0 0.1 y 0.06 total 12 fall 0.013 velocity -0.3 0.3
run 9000
write_dump all multisphere/body bodies.dump
write_dump all custom stock.dump id type x y z radius id_multisphere
)"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto ours = last_frame({(run.folder / "bodies.dump").string()});
  const auto stock = as_bodies(last_frame({(run.folder / "stock.dump").string()}));
  ASSERT_EQ(ours.rows, 12U);
  ASSERT_EQ(stock.rows, 12U);
  // LIGGGHTS prints six digits.
  for (std::size_t k = 0; k < 12; ++k) {
    for (const std::string name : {"id", "nspheres"})
      EXPECT_EQ(stock.column(name)[k], ours.column(name)[k]) << name << k;
    for (const std::string name : {"y", "half_length", "radius"})
      EXPECT_NEAR(stock.column(name)[k], ours.column(name)[k], 1e-6) << name << k;
    EXPECT_NEAR(std::remainder(stock.column("x")[k] - ours.column("x")[k], 0.1), 0, 1e-6) << k;
    EXPECT_NEAR(stock.column("area")[k], ours.column("area")[k], 2e-4 * ours.column("area")[k]);
    const double turned = stock.column("angle")[k] - ours.column("angle")[k];
    EXPECT_NEAR(std::remainder(turned, M_PI), 0, 1e-3) << k;
  }
}

}  // namespace

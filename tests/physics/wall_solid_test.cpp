// SPDX-License-Identifier: GPL-2.0-or-later
// fix wall/gran/solid: spheres that come in by more than their radius are pushed back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

// Three bodies of one sphere each (d = 3 mm, 2500 kg/m^3) fall from rest by 48.5 mm onto a soft
// elastic plane; without friction and damping.
const std::string deck = R"(
variable motion index "multisphere/ab order 3 planar yes"
variable style  index verlet
variable bound  index lo
variable plane  index 0
variable down   index -1
variable steps  index 26000
)" + Deck().processors("* 1 1")
                             .box("0 0.06 -0.01 0.11 -0.012 0.012")
                             .skin("3e-4")
                             .stiffness("3.2", "3")
                             .damping("0")
                             .friction("0")
                             .with(R"(
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran/solid model spring_dashpot tangential spring_dashpot primitive type 1 yplane ${plane} bound ${bound}
fix balls all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 aspect_ratio 1 diameter 3e-3 surface overlap 0.5 size_spread 0 density constant 2500 planar yes
fix motion all ${motion}
fix plane all enforce2d/multisphere
fix lines all insert/line 1 template balls 1 per_line 3 total 3 x 0 0.06 y 0.05 z 0 fall 0.004 velocity -0.02 0.02
run 1
unfix lines
unfix gravity
fix gravity all gravity 9.81 vector 0 ${down} 0
run_style ${style}
compute elastic all contact/energy
compute low all reduce min y
compute high all reduce max y
variable e equal c_elastic[1]
variable low equal c_low
variable high equal c_high
fix motions all print 10 "$e ${low} ${high}" file motions.txt screen no title "# elastic low high"
run ${steps}
write_dump all multisphere/body bodies.dump
)");

constexpr double gravity = 9.81, k = 3.2, radius = 1.5e-3, start = 0.05;
const double mass = 2500 * M_PI / 6 * std::pow(2 * radius, 3);

struct Flight {
  double deepest = 1, highest_after = 0, largest_elastic = 0;
  std::vector<double> last;
};

Flight fly(const std::map<std::string, std::string>& vars, int ranks = 1) {
  const auto run = run_liggghts(deck, vars, ranks);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const bool up = vars.count("down") != 0;  // the plane is at the top, y = 0.1
  const Table motions = read_table(run.folder / "motions.txt");
  Flight flight;
  for (std::size_t k = 0; k < motions.rows(); ++k) {
    const double low = motions.column("low")[k], high = motions.column("high")[k];
    if (flight.deepest < 0)
      flight.highest_after = std::max(flight.highest_after, up ? 0.1 - low : high);
    flight.deepest = std::min(flight.deepest, up ? 0.1 - high : low);
    flight.largest_elastic = std::max(flight.largest_elastic, motions.column("elastic")[k]);
  }
  const Table bodies = read_dump(run.folder / "bodies.dump");
  for (const double y : bodies.column("y")) flight.last.push_back(up ? 0.1 - y : y);
  std::sort(flight.last.begin(), flight.last.end());
  return flight;
}

}  // namespace

// Energy: m g (start - y) = k (radius - y)^2 / 2 at the lowest point y, 1.1 radii behind the plane;
// nothing is lost, so that the spheres rise to where they started.
TEST(SolidWall, PushesBackASphereWhoseCentreIsBehindIt) {
  const double sag = mass * gravity / k;
  const double deepest = radius - sag - std::sqrt(sag * sag + 2 * sag * (start - radius));
  ASSERT_LT(deepest, -1.05 * radius);
  for (const char* style : {"verlet", "verlet/planar"}) {
    const Flight flight = fly({{"style", style}});
    // Looked at every 10 steps: off the lowest point by half of them, k depth / m (5 dt)^2 / 2.
    EXPECT_NEAR(flight.deepest, deepest, 1e-3 * radius) << style;
    EXPECT_NEAR(flight.highest_after, start, 1e-4 * start) << style;
    EXPECT_NEAR(flight.largest_elastic, 3 * k / 2 * std::pow(radius - deepest, 2),
                1e-3 * flight.largest_elastic)
        << style;
  }
}

TEST(SolidWall, BoundsFromAboveToo) {
  const Flight lo = fly({}), hi = fly({{"bound", "hi"}, {"down", "1"}, {"plane", "0.1"}});
  EXPECT_NEAR(hi.deepest, lo.deepest, 1e-4 * radius);  // the first step was downwards in both
  EXPECT_NEAR(hi.highest_after, start, 1e-4 * start);
}

TEST(SolidWall, TheStockIntegratorAndTwoRanksGiveTheSame) {
  const Flight one = fly({}), two = fly({}, 2), stock = fly({{"motion", "multisphere"}});
  ASSERT_EQ(two.last.size(), 3u);
  for (int ball = 0; ball < 3; ++ball) EXPECT_NEAR(two.last[ball], one.last[ball], 1e-12);
  EXPECT_NEAR(stock.deepest, one.deepest, 1e-3 * radius);
  EXPECT_NEAR(stock.highest_after, start, 1e-3 * start);
}

TEST(SolidWall, DoesNotMove) {
  std::string text = deck;
  const std::string bound = "bound ${bound}";
  const auto run = run_liggghts(text.replace(text.find(bound), bound.size(), "bound lo shear x 1"));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("'shear'"));
}

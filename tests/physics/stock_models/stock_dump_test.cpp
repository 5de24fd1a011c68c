// SPDX-License-Identifier: GPL-2.0-or-later
// What rodpack reads of LIGGGHTS's own dump custom is what dump multisphere/body says of the same
// bodies.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>

#include "analysis/stock/local_contacts.h"
#include "analysis/stock/stock_dumps.h"
#include "deck.h"
#include "liggghts_run.h"
#include "reading/checks/body_axes.h"
#include "stock_heap.h"

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
write_dump all custom stock.dump id type x y z radius id_multisphere mass vx vy vz omegax omegay omegaz
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
    EXPECT_NEAR(stock.column("mass")[k], ours.column("mass")[k], 1e-5 * ours.column("mass")[k]);
    for (const std::string name : {"vx", "vy", "vz", "omegax", "omegay", "omegaz"})
      EXPECT_NEAR(stock.column(name)[k], ours.column(name)[k],
                  2e-5 * (1 + std::abs(ours.column(name)[k])))
          << name << k;
    const double turned = stock.column("angle")[k] - ours.column("angle")[k];
    EXPECT_NEAR(std::remainder(turned, M_PI), 0, 1e-3) << k;
  }
}

struct ForceParts {
  double normal = 0;
  Vector3 tangential{};
};

ForceParts parts(const Frame& contacts, std::size_t row, double sign) {
  const char* const f[] = {"fx", "fy", "fz"};
  const char* const n[] = {"nx", "ny", "nz"};
  ForceParts result;
  for (int c = 0; c < 3; ++c)
    result.normal += contacts.column(f[c])[row] * contacts.column(n[c])[row];
  for (std::size_t c = 0; c < 3; ++c)
    result.tangential[c] =
        sign * (contacts.column(f[c])[row] - result.normal * contacts.column(n[c])[row]);
  return result;
}

// Each contact of ours is one of the stock dumps and the other way round, whichever sphere they
// name first; LIGGGHTS prints six digits. Its compute evaluates the forces anew after the step,
// with later velocities. Where a contact slides, the spring is at the cap by then, not above, and
// the dashpot's force is added whole: such tangential forces are not those that acted, by up to
// twenty times here.
TEST(StockDump, LocalContactsOfARunAreThoseOfItsOwnDump) {
  const auto folder = stock_heap("history");
  const auto frame = [&](const char* name) { return last_frame({(folder / name).string()}); };
  const auto ours = frame("contacts.dump"), spheres = frame("spheres.dump");
  const std::vector<std::string> given{"pos", "id", "force", "delta"};
  auto stock = contacts_of_local_dump(frame("pairs.dump"), given, spheres);
  const auto between_particles = stock.rows;
  EXPECT_GE(between_particles, 3U);
  add_contacts_of_wall_dump(frame("walls.dump"), given, spheres, stock);
  EXPECT_GE(stock.rows, between_particles + 3);
  ASSERT_EQ(stock.rows, ours.rows);
  std::map<std::pair<double, double>, std::size_t> row_of;
  for (std::size_t row = 0; row < stock.rows; ++row)
    row_of[{stock.column("sphere_i")[row], stock.column("sphere_j")[row]}] = row;
  double mean_force = 0;
  for (std::size_t k = 0; k < ours.rows; ++k)
    mean_force += parts(ours, k, 1).normal / static_cast<double>(ours.rows);
  int sticking = 0;
  for (std::size_t k = 0; k < ours.rows; ++k) {
    const double i = ours.column("sphere_i")[k], j = ours.column("sphere_j")[k];
    const bool same_way = row_of.count({i, j}) > 0;
    ASSERT_TRUE(same_way || row_of.count({j, i})) << i << ' ' << j;
    const auto row = same_way ? row_of[{i, j}] : row_of[{j, i}];
    const double sign = same_way ? 1 : -1;
    const auto near = [&](const std::string& mine, const std::string& theirs, double factor,
                          double slack) {
      EXPECT_NEAR(factor * stock.column(theirs)[row], ours.column(mine)[k], slack) << mine << k;
    };
    near("body_i", same_way ? "body_i" : "body_j", 1, 0);
    near("body_j", same_way ? "body_j" : "body_i", 1, 0);
    near("wall", "wall", 1, 0);
    near("overlap_n", "overlap_n", 1, 1e-6);
    const auto own = parts(ours, k, 1), other = parts(stock, row, sign);
    EXPECT_NEAR(other.normal, own.normal, 5e-3 * mean_force) << k;
    const bool sticks = std::hypot(own.tangential[0], own.tangential[1], own.tangential[2]) <
                        0.9 * 0.3 * own.normal;
    sticking += sticks;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::string axis(1, "xyz"[c]);
      near("n" + axis, "n" + axis, sign, 2e-4);
      EXPECT_NEAR(std::remainder(stock.column(axis)[row] - ours.column(axis)[k], 0.04), 0, 3e-6);
      if (sticks) {
        EXPECT_NEAR(other.tangential[c], own.tangential[c], 5e-3 * mean_force) << k;
      }
      if (ours.column("wall")[k] != 0) continue;
      // The way between the centres of mass; LIGGGHTS takes those of bodies from random points.
      const auto branch = [&](const Frame& contacts, std::size_t at) {
        return contacts.column("bi" + axis)[at] - contacts.column("bj" + axis)[at];
      };
      EXPECT_NEAR(sign * branch(stock, row), branch(ours, k), 4e-5) << k;
    }
  }
  EXPECT_GE(sticking, 6);
}

// What rodpack makes of either dump: the same contacts, and the same means to what the forces
// differ.
TEST(StockDump, ForcesOfLocalContactsAreThoseOfOurDump) {
  const auto folder = stock_heap("history");
  const auto ours =
      run_rodpack("forces contacts.dump --bodies bodies.dump --walls-too -o ours", folder);
  ASSERT_EQ(ours.exit_code, 0) << ours.output;
  const auto stock = run_rodpack(
      "forces pairs.dump --bodies spheres.dump " + stock_contacts + " --walls-too -o stock",
      folder);
  ASSERT_EQ(stock.exit_code, 0) << stock.output;
  EXPECT_EQ(text_of(folder / "stock_coordination.csv"), text_of(folder / "ours_coordination.csv"));
  const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  EXPECT_EQ(first_line(stock.output), first_line(ours.output));  // how many of which
  EXPECT_NE(stock.output.find("evaluates forces anew"), std::string::npos) << stock.output;
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
// totalForceCap: what of it needs no closed form of an impact. Those are in
// tests/benchmark/thirdparty/closed_forms_test.py, events in
// tests/unit/contact/friction_cap_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

const std::string law = "model spring_dashpot tangential spring_dashpot ";

/// Spheres 1 and 2 collide obliquely across x = 0, 3 falls on the floor and slides; the whole in
/// `cap`, a setting of both contact laws unless there is one for the floor. From `restart` on, if
/// it is not empty.
std::string scene(const std::string& cap, const std::string& restart, const std::string& run,
                  const std::string& of_floor = "same") {
  const std::string spheres = R"(
create_atoms 1 single -0.00151 0.0104 0 units box
create_atoms 1 single  0.00151 0.0096 0 units box
create_atoms 1 single -0.008 0.00152 0 units box
set group all diameter 0.003 density 2500
set atom 1 vx 0.5 omegaz 40
set atom 2 vx -0.5
set atom 3 vx 2 vy -0.5
)";
  return Deck()
      .box("-0.02 0.02 0 0.03 -0.01 0.01")
      .processors("* 1 1")
      .damping("0.3")
      .models(law + cap)
      .restart(restart)
      .with("fix floor all wall/gran " + law + "primitive type 1 yplane 0 " +
            (of_floor == "same" ? cap : of_floor) + (restart.empty() ? spheres : "\n") +
            "fix motion all nve/sphere/ab order 3\nfix weight all gravity 9.81 vector 0 -1 0\n" +
            "thermo 1000000\n" + run +
            "\nwrite_dump all custom end.dump id x y vx vy omegaz modify "
            "format \"%d %.17g %.17g %.17g %.17g %.17g\" sort id\n");
}

Table end_of(const Run& run) {
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return read_dump(run.folder / "end.dump");
}

void expect_same_bits(const Table& a, const Table& b) {
  ASSERT_EQ(a.rows(), 3u);
  for (const char* name : {"id", "x", "y", "vx", "vy", "omegaz"})
    EXPECT_EQ(a.column(name), b.column(name)) << name;
}

const char* const on = "totalForceCap on";

/// Rods that land on the floor under the total cap, at 1.6 ms, in `steps` steps; `fall` says how.
Table landed(std::map<std::string, std::string> fall, const std::string& events, int steps) {
  std::ifstream stream(RODPACK_REPOSITORY "/inputs/accuracy/in.rods");
  std::string deck{std::istreambuf_iterator<char>(stream), {}};
  const std::string order = "multistepOrder 4", both = order + " " + on;
  for (auto at = deck.find(order); at != std::string::npos; at = deck.find(order, at + both.size()))
    deck.replace(at, order.size(), both);
  fall.insert({{"integrator", "multisphere/ab order 3 planar yes events " + events},
               {"dt", exact(1.6e-3 / steps)},
               {"steps", std::to_string(steps)},
               {"rods", "6"},
               {"shift", "3.1e-7"}});
  return end_of(run_liggghts(deck, fall));
}

/// Root mean square of the differences of velocities, and of spins times half a rod.
double difference(const Table& a, const Table& b) {
  double sum = 0;
  for (const auto& [name, scale] :
       {std::pair("vx", 1.0), std::pair("vy", 1.0), std::pair("omegaz", 5e-3)})
    for (std::size_t i = 0; i < a.rows(); ++i)
      sum += std::pow(scale * (a.column(name)[i] - b.column(name)[i]), 2);
  return std::sqrt(sum / static_cast<double>(a.rows()));
}

}  // namespace

TEST(TotalForceCap, IsOffUnlessAskedFor) {
  const Table without = end_of(run_liggghts(scene("", "", "run 120")));
  expect_same_bits(end_of(run_liggghts(scene("totalForceCap off", "", "run 120"))), without);
  const Table with = end_of(run_liggghts(scene(on, "", "run 120")));
  for (const std::size_t i : {0, 2}) {  // both contacts have slid
    EXPECT_GT(std::fabs(with.column("vx")[i] / without.column("vx")[i] - 1), 1e-3);
  }
}

// A sphere that sinks into the floor and comes out again while it slides: friction is mu times the
// whole normal force in every step, as the contacts are listed. The elastic force is another one.
TEST(TotalForceCap, ListedContactsSlideUnderTheWholeForce) {
  const auto run = run_liggghts(scene(on, "", "dump c all contact/gran 1 c.dump\nrun 40"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  int seen = 0;
  double largest = 0;
  for (int frame = 0; frame <= 40; ++frame) {
    const Table contacts = read_dump(run.folder / "c.dump", frame);
    for (std::size_t c = 0; c < contacts.rows(); ++c) {
      if (contacts.column("wall")[c] != 1) continue;
      const double fx = contacts.column("fx")[c], fy = contacts.column("fy")[c];
      EXPECT_NEAR(fx, -0.3 * fy, 1e-12 * 0.3 * fy) << frame;
      EXPECT_NEAR(contacts.column("overlap_t")[c], 0.3 * fy / 500, 1e-12 * fy) << frame;
      largest = std::max(largest, std::fabs(fy / (1000 * contacts.column("overlap_n")[c]) - 1));
      ++seen;
    }
  }
  EXPECT_GT(seen, 20);
  EXPECT_GT(largest, 0.5);
}

TEST(TotalForceCap, RestartRepeatsTheUninterruptedRunToTheLastBit) {
  for (const int before : {5, 15, 30}) {  // in the contacts: their begin, middle and end
    const std::string first = "run " + std::to_string(before);
    const auto whole = run_liggghts(scene(on, "", first + "\nwrite_restart half\nrun 60"));
    const Table expected = end_of(whole);
    expect_same_bits(end_of(run_liggghts_in(whole.folder, scene(on, "half", "run 60"))), expected);
  }
}

// Of pairs and of walls alike: the springs of one cap are too long under the other, and the total
// one keeps more of a contact.
TEST(TotalForceCap, ARestartUnderTheOtherCapIsRefused) {
  const std::string off = "totalForceCap off";
  for (const std::string& cap : {std::string(on), off}) {
    const std::string other = cap == on ? off : on;
    const auto first = run_liggghts(scene(cap, "", "run 15\nwrite_restart half"));
    ASSERT_EQ(first.exit_code, 0) << first.output;
    const auto pairs = run_liggghts_in(first.folder, scene(other, "half", "run 10", cap));
    EXPECT_NE(pairs.exit_code, 0);
    EXPECT_THAT(pairs.output, HasSubstr("saved simulation state used different contact history"));
    const auto floor = run_liggghts_in(first.folder, scene(cap, "half", "run 10", other));
    EXPECT_NE(floor.exit_code, 0);
    EXPECT_THAT(floor.output, HasSubstr("(id history_floor): restarted fix has incompatible data"));
  }
}

// Across a border each rank evaluates the pair from its own side, as under the other cap: the floor
// gives the same bits, the pair the same numbers.
TEST(TotalForceCap, RanksAgreeWithOneRankToRounding) {
  const Table one = end_of(run_liggghts(scene(on, "", "run 120")));
  const Table two = end_of(run_liggghts(scene(on, "", "run 120"), {}, 2));
  for (const char* name : {"x", "y", "vx", "vy", "omegaz"})
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = one.column(name)[i];
      EXPECT_NEAR(two.column(name)[i], expected, (i < 2 ? 1e-13 : 0) * std::fabs(expected)) << name;
    }
}

// A rod that falls on its end, and one whose spheres land one after the other: touch, slide, stick
// and end, and what they do to the other contacts of the rod. The reference is the same method at a
// step 16 times finer than the finest. Under the elastic cap the first has no limit of small steps.
TEST(TotalForceCap, RodsLandInThirdOrder) {
  const std::string tilt = exact(std::cos(M_PI / 72)) + " 0 0 " + exact(std::sin(M_PI / 72));
  for (const std::map<std::string, std::string>& fall :
       {std::map<std::string, std::string>{{"height", "0.00724"}},
        std::map<std::string, std::string>{{"height", "0.0024"}, {"orientation", tilt}}}) {
    const Table reference = landed(fall, "yes", 480 * 16);
    const double coarse = difference(landed(fall, "yes", 120), reference);
    const double fine = difference(landed(fall, "yes", 480), reference);
    EXPECT_NEAR(observed_order(coarse, fine, 4), 3, 0.2);
    EXPECT_GT(difference(landed(fall, "no", 480), reference), 1000 * fine);  // of first order
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
// run_style verlet/planar against the sphere-level path: the same deck, one line apart.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

using namespace rodpack::test;
using testing::HasSubstr;

namespace {

using Vars = std::map<std::string, std::string>;

// Rods that fall into a narrow box, line by line, or go on from a restart file. `extra`: a line
// before the run.
std::string deck_from(const std::string& restart) {
  return R"(
variable style     index verlet
variable events    index yes
variable order     index 3
variable rods      index 3
variable steps     index 1000
variable every     index 1000
variable curvature index 0
variable ar        index 5
variable width     index 0.06
variable height    index 0.03
variable extra     index "variable none equal 0"
variable end       index "variable none equal 0"
)" + Deck().processors("* 1 1")
             .box("0 ${width} 0 0.2 -0.012 0.012")
             .restart(restart)
             .skin("3e-4")
             .timestep("1.1e-5")
             .models("model spring_dashpot tangential spring_dashpot multistepOrder 4")
             .with(R"(
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 yplane 0.0 multistepOrder 4
fix left all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 xplane 0.0 multistepOrder 4
fix right all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 xplane ${width} multistepOrder 4
fix rods all particletemplate/multisphere/spherocylinder 1 atom_type 1 type 1 aspect_ratio ${ar} diameter 3e-3 surface overlap 0.5 curvature ${curvature} size_spread 0.05 density constant 2500 planar yes
fix motion all multisphere/ab order ${order} planar yes events ${events}
fix plane all enforce2d/multisphere
fix lines all insert/line 1 template rods 1 per_line 3 total ${rods} x 0 ${width} y ${height} z 0 fall 0.02 velocity -0.25 0.25
${extra}
run_style ${style}
thermo ${every}
dump bodies all multisphere/body ${every} bodies.*.dump
dump spheres all multisphere/sphere ${every} spheres.*.dump
dump contacts all contact/gran ${every} contacts.*.dump
run ${steps}
${end}
)");
}

const std::string deck = deck_from("");

/// The same with lines in every so many steps, from the first one on. A line one step after output
/// is inserted by LIGGGHTS, on one rank as on several.
std::string with_lines_every(int steps, std::string text = deck) {
  text.replace(text.find("fall 0.02"), 9, "interval " + std::to_string(1.1e-5 * steps));
  return text;
}

/// The same with dashpots that take some time to feel a velocity.
std::string with_relaxation(std::string text = deck) {
  text.insert(text.find("fix gravity"),
              "fix tau all property/global dashpotRelaxation scalar 2e-5\n");
  return text;
}

/// The same with friction up to mu times the whole normal force, or, with "off", up to what it is
/// without a word.
std::string with_cap(std::string text, const std::string& on_or_off = "on") {
  const std::string order = "multistepOrder 4", cap = " totalForceCap " + on_or_off;
  for (auto at = text.find(order); at != std::string::npos; at = text.find(order, at + 1))
    text.insert(at + order.size(), cap);
  return text;
}

/// Largest difference of a column, over the largest value of `scale` (its own if empty).
double difference(const Table& a, const Table& b, const std::string& name, double scale = 0) {
  if (a.rows() != b.rows()) throw std::runtime_error("tables of different length");
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < a.rows(); ++i) {
    worst = std::max(worst, std::fabs(a.column(name)[i] - b.column(name)[i]));
    largest = std::max(largest, std::fabs(a.column(name)[i]));
  }
  if (scale == 0) scale = largest;
  return scale > 0 ? worst / scale : worst;
}

/// Contacts in an order, and with an order of the two bodies, that does not depend on the ranks.
Table by_atoms(const Table& contacts) {
  const std::vector<std::string> names = {"body_i", "sphere_i", "body_j", "sphere_j",
                                          "wall",   "fx",       "fy",     "overlap_t"};
  std::vector<std::vector<double>> rows(contacts.rows());
  for (const std::string& name : names)
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(contacts.column(name)[i]);
  for (std::vector<double>& row : rows) {
    if (row[4] != 0 || row[0] < row[2]) continue;
    std::swap_ranges(row.begin(), row.begin() + 2, row.begin() + 2);
    for (int k : {5, 6}) row[k] = -row[k];
  }
  std::sort(rows.begin(), rows.end());
  return Table("sorted", names, rows);
}

Run finished(Vars vars, const std::string& style, const std::string& text = deck) {
  vars["style"] = style;
  auto run = run_liggghts(text, vars);
  if (run.exit_code != 0) throw std::runtime_error(run.output);
  return run;
}

Table last(const Run& run, const std::string& kind, const Vars& vars) {
  return read_dump(run.folder / (kind + "." + vars.at("steps") + ".dump"));
}

}  // namespace

// Three rods, 1e5 steps: fall, collisions, rest. What differs at first are rounding errors; what
// remains is below 1e-9 as long as the motion is not chaotic.
TEST(PlanarEngine, TrajectoriesAreThoseOfTheSphereLevelStyles) {
  const std::string total = with_cap(deck);
  // Rods so fast that they slide when they land, until they stick; a look in every twelfth step,
  // so that what contacts remember goes there and back within that.
  std::string fast = total;
  fast.replace(fast.find("velocity -0.25 0.25"), 19, "velocity -1.5 1.5");
  const std::string often = "fix look all print 12 looked screen no";
  // A rod that lies on the floor has four times its inertia then.
  const std::string scaled = "2 mass_scaling 2";
  const std::pair<std::string, Vars> cases[] = {{deck, {{"events", "yes"}, {"steps", "100000"}}},
                                                {deck, {{"events", "no"}}},
                                                {deck, {{"order", "2"}}},
                                                {deck, {{"order", "4"}}},
                                                {deck, {{"order", "1"}}},
                                                {deck, {{"order", scaled}, {"events", "no"}}},
                                                {deck, {{"order", scaled}}},
                                                {deck, {{"order", "0"}}},
                                                {with_relaxation(), {{"order", "0"}}},
                                                {with_relaxation(total), {{"order", "0"}}},
                                                {deck, {{"curvature", "120"}}},
                                                {deck, {{"ar", "1"}}},
                                                {deck, {{"ar", "2"}}},
                                                {total, {{"events", "yes"}, {"steps", "100000"}}},
                                                {total, {{"events", "no"}}},
                                                {total, {{"order", "2"}}},
                                                {total, {{"order", "4"}}},
                                                {total, {{"ar", "1"}}},
                                                {fast, {{"extra", often}}}};
  for (const auto& [text, changes] : cases) {
    Vars vars = changes;
    const std::string name =
        vars.begin()->first + " " + vars.begin()->second + (text == deck ? "" : " another deck");
    vars.insert({"steps", "10000"});
    vars["every"] = "1000";
    const auto spheres = finished(vars, "verlet", text),
               planar = finished(vars, "verlet/planar", text);
    const Table a = last(spheres, "bodies", vars), b = last(planar, "bodies", vars);
    for (const char* column : {"x", "y"}) EXPECT_LT(difference(a, b, column), 1e-9) << name;
    for (const char* column : {"vx", "vy"})
      EXPECT_LT(difference(a, b, column, 0.1), 1e-9) << name << ' ' << column;
    EXPECT_LT(difference(a, b, "omegaz", 0.1 / 7.5e-3), 1e-9) << name;
    // Only contacts turn the rods.
    double turned = 0;
    for (int step = 1000; step <= 10000; step += 1000) {
      const Table bodies = read_dump(planar.folder / ("bodies." + std::to_string(step) + ".dump"));
      for (const double omega : bodies.column("omegaz"))
        turned = std::max(turned, std::fabs(omega));
    }
    EXPECT_GT(turned, 0.1) << name;
  }
}

// The first line comes before there are bodies, the others at 64 and 128 ms. Of 14000 steps
// LIGGGHTS makes the first one, those with output, and those of lines that the engine cannot take
// in: under a roof that new rods may touch.
TEST(PlanarEngine, TakesLinesInWithoutAStepOfLiggghts) {
  const std::string roof =
      "fix roof all wall/gran model spring_dashpot tangential spring_dashpot primitive type 1 "
      "yplane 0.0874 multistepOrder 4";
  for (const auto& [extra, share] : {std::make_pair(std::string("variable none equal 0"), "99.98"),
                                     std::make_pair(roof, "99.96")})
    for (const char* order : {"3", "2 mass_scaling 2", "0"}) {
      const Vars vars = {{"rods", "9"},     {"height", "0.08"}, {"steps", "14000"},
                         {"every", "7000"}, {"extra", extra},   {"order", order}};
      const auto spheres = finished(vars, "verlet"), planar = finished(vars, "verlet/planar");
      EXPECT_THAT(planar.output,
                  HasSubstr("Planar engine: " + std::string(share) + " % of the steps"));
      const Table a = last(spheres, "bodies", vars), b = last(planar, "bodies", vars);
      ASSERT_EQ(b.rows(), 9u);
      for (const char* column : {"id", "x", "y", "radius"})
        EXPECT_LT(difference(a, b, column), 1e-9) << column;
      for (const char* column : {"vx", "vy"})
        EXPECT_LT(difference(a, b, column, 0.1), 1e-9) << extra << ' ' << column;
      EXPECT_LT(difference(a, b, "omegaz", 0.1 / 7.5e-3), 1e-9) << extra;
    }
}

// Some 60 rods at rest, from the same restart file. The forces of the contacts follow from springs
// that have been carried there and back.
TEST(PlanarEngine, ForcesOfABedAtRestAreThoseOfTheSphereLevelStyles) {
  for (const auto& [events, cap] :
       {std::make_pair("yes", "off"), std::make_pair("no", "off"), std::make_pair("yes", "on")}) {
    const auto bed = finished({{"rods", "60"},
                               {"height", "0.19"},
                               {"steps", "160000"},
                               {"every", "20000"},
                               {"events", events},
                               {"end", "write_restart bed.restart"}},
                              "verlet/planar", with_cap(deck, cap));
    std::vector<Table> contacts, spheres;
    for (const char* style : {"verlet", "verlet/planar"}) {
      const auto run = run_liggghts_in(bed.folder, with_cap(deck_from("bed.restart"), cap),
                                       {{"rods", "60"},
                                        {"height", "0.19"},
                                        {"steps", "10"},
                                        {"every", "10"},
                                        {"events", events},
                                        {"style", style}});
      ASSERT_EQ(run.exit_code, 0) << run.output;
      contacts.push_back(read_dump(bed.folder / "contacts.160010.dump"));
      spheres.push_back(read_dump(bed.folder / "spheres.160010.dump"));
    }
    EXPECT_GT(contacts[1].rows(), 100u);
    // Both components in units of the largest force: the last place of a position (7e-18 m) is
    // 7e-15 N along either axis.
    double largest = 0;
    for (std::size_t k = 0; k < contacts[0].rows(); ++k)
      largest =
          std::max(largest, std::hypot(contacts[0].column("fx")[k], contacts[0].column("fy")[k]));
    for (const char* column : {"fx", "fy"}) {
      EXPECT_LT(difference(contacts[0], contacts[1], column, largest), 1e-12);
      EXPECT_LT(difference(spheres[0], spheres[1], column, largest), 1e-12);
    }
  }
}

TEST(PlanarEngine, RunsWithTheInstructionsThatItIsTold) {
  const Vars vars = {{"steps", "100"}, {"every", "50"}};
  Vars told = vars;
  told["style"] = "verlet/planar skin 1e-4 1e-3 instructions baseline";
  const auto run = run_liggghts(deck, told);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("run_style verlet/planar: processor instructions baseline"));
}

// Nothing that the engine knows stays in it: what LIGGGHTS writes is all.
TEST(PlanarEngine, RestartGoesOnExactly) {
  const struct {
    const char *cap, *order, *style;
    bool relaxes;
  } cases[] = {{"off", "3", "verlet/planar", false},
               {"on", "3", "verlet/planar", false},
               {"off", "2 mass_scaling 2", "verlet/planar", false},
               {"off", "2 mass_scaling 2", "verlet", false},
               {"off", "0", "verlet/planar", true},
               {"on", "0", "verlet", true}};
  for (const auto& [cap, order, style, relaxes] : cases) {
    const auto text = [cap = cap, relaxes = relaxes](const std::string& restart) {
      const std::string plain = with_cap(deck_from(restart), cap);
      return relaxes ? with_relaxation(plain) : plain;
    };
    const Vars vars = {{"rods", "15"},    {"height", "0.08"}, {"steps", "20000"},
                       {"every", "1000"}, {"order", order},   {"extra", "restart 9000 r.*"},
                       {"style", style}};
    const auto run = run_liggghts(text(""), vars);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table whole = last(run, "bodies", vars);
    std::filesystem::remove(run.folder / "bodies.20000.dump");
    Vars rest = vars;
    rest["steps"] = "11000";
    const auto again = run_liggghts_in(run.folder, text("r.9000"), rest);
    ASSERT_EQ(again.exit_code, 0) << again.output;
    const Table parts = last(run, "bodies", vars);
    for (const char* column : {"x", "y", "qz", "vx", "vy", "omegaz"})
      EXPECT_EQ(whole.column(column), parts.column(column)) << cap << order << style << column;
  }
}

// Contacts of a file whose dashpots did not relax have not felt anything; those of one whose did
// may no longer.
TEST(PlanarEngine, DashpotsMayBeginAndCeaseToRelaxInARestart) {
  for (const bool begin : {true, false}) {
    const auto text = [&](const std::string& restart, bool relaxes) {
      return relaxes ? with_relaxation(deck_from(restart)) : deck_from(restart);
    };
    Vars vars = {

        {"steps", "30000"},
        {"every", "30000"},
        {"order", "0"},
        {"extra", "restart 30000 r.*"},
        {"style", "verlet/planar"}};
    const auto first = run_liggghts(text("", !begin), vars);
    ASSERT_EQ(first.exit_code, 0) << first.output;
    ASSERT_GT(last(first, "contacts", vars).rows(), 5u);
    vars.insert_or_assign("steps", "500");
    vars.insert_or_assign("every", "500");
    vars["extra"] = "variable none equal 0";
    std::vector<Table> ends;
    for (const char* style : {"verlet", "verlet/planar"}) {
      vars["style"] = style;
      const auto rest = run_liggghts_in(first.folder, text("r.30000", begin), vars);
      ASSERT_EQ(rest.exit_code, 0) << rest.output;
      ends.push_back(read_dump(first.folder / "bodies.30500.dump"));
    }
    for (const char* column : {"vx", "vy"})
      EXPECT_LT(difference(ends[0], ends[1], column, 0.1), 1e-9) << begin << column;
  }
}

TEST(PlanarEngine, RefusesWhatItCannotHonour) {
  const auto output = [](const Vars& changes, const std::string& from = "",
                         const std::string& to = "", int ranks = 1) {
    Vars vars = changes;
    vars["style"] = changes.count("style") ? changes.at("style") : "verlet/planar";
    std::string text = deck;
    if (!from.empty()) text.replace(text.find(from), from.size(), to);
    return run_liggghts(text, vars, ranks).output;
  };
  EXPECT_THAT(output({{"extra", "fix push all addforce 0 1 0"}}),
              HasSubstr("run_style verlet/planar: fix addforce (id push) acts in every step"));
  EXPECT_THAT(output({}, "xplane 0.0", "xcylinder 0.5 0 0"),
              HasSubstr("run_style verlet/planar: fix wall/gran (id left) is no plane, expected"));
  EXPECT_THAT(output({}, "xplane 0.0 multistepOrder 4", "xplane 0.0 shear y 1 multistepOrder 4"),
              HasSubstr("fix wall/gran (id left) moves ('shear'), expected a wall at rest"));
  const std::string pair = "pair_style gran model spring_dashpot tangential spring_dashpot ";
  for (const std::string& one : {std::string("xplane 0.0 "), pair})
    EXPECT_THAT(output({}, one + "multistepOrder 4", one + "multistepOrder 4 totalForceCap on"),
                HasSubstr("has another history than pair_style gran: give both the same "
                          "multistepOrder and totalForceCap"));
  EXPECT_THAT(
      output({}, pair + "multistepOrder 4\npair_coeff * *",
             "pair_style hybrid " + pair.substr(11) + "multistepOrder 4\npair_coeff * * gran"),
      HasSubstr("run_style verlet/planar: pair_style gran is needed, not in a hybrid"));
  EXPECT_THAT(output({}, "boundary f f f", "boundary p f f"),
              HasSubstr("run_style verlet/planar: periodic boundaries are not supported"));
  EXPECT_THAT(
      output({}, "fix motion all multisphere/ab order ${order} planar yes events ${events}",
             "fix motion all multisphere"),
      HasSubstr("run_style verlet/planar: the bodies have to be those of one fix multisphere/ab"));
  EXPECT_THAT(output({}, "planar yes events", "planar no events"),
              HasSubstr("run_style verlet/planar: fix multisphere/ab moves in space"));
  for (const char* leave_out : {"exclude type 1 1", "exclude group all all"})
    EXPECT_THAT(output({{"extra", std::string("neigh_modify ") + leave_out}}),
                HasSubstr("run_style verlet/planar: neigh_modify exclude or include leaves pairs"));
  EXPECT_THAT(output({}, "run ${steps}", "run 0\nrun_style verlet/planar\nrun 100 pre no"),
              HasSubstr("run_style verlet/planar: 'run ... pre no' before a run with 'pre yes'"));
  EXPECT_THAT(output({{"style", "verlet/planar skin 1e-6 1e-3"}, {"steps", "20"}}),
              HasSubstr("skin is at least 1e-06 m, expected"));
}

// Ranks differ from one another by the order of sums: nothing in the time of this test, in which
// the first rods fall, collide across the borders of the ranks and are looked at every 11 ms. With
// events it ends while two rods slap together on the border of two of four ranks; the collisions
// that follow make rounding grow, whatever the ranks, to 1e-11 m/s in 5000 further steps.
TEST(PlanarEngine, RanksAgreeWithOneRankToRounding) {
  const std::string lines = with_lines_every(5806), looks = "fix look all print 1000 . screen no";
  // The contacts that mass scaling counts are those of all ranks, with either style.
  const Vars shared = {{"rods", "15"},    {"height", "0.08"}, {"steps", "17418"},
                       {"every", "5806"}, {"events", "no"},   {"extra", looks}};
  const struct {
    const char *style, *order;
    std::string text;
  } cases[] = {{"verlet", "2 mass_scaling 2", lines},
               {"verlet/planar", "2 mass_scaling 2", lines},
               {"verlet", "0 mass_scaling 2", with_relaxation(lines)},
               {"verlet/planar", "0 mass_scaling 2", with_relaxation(lines)}};
  for (const auto& [style, order, text] : cases) {
    Vars vars = shared;
    vars["style"] = style;
    const auto plain = run_liggghts(lines, vars);
    vars["order"] = order;
    const auto one = run_liggghts(text, vars), two = run_liggghts(text, vars, 2);
    ASSERT_EQ(two.exit_code, 0) << two.output;
    const Table a = last(one, "bodies", vars), b = last(two, "bodies", vars);
    EXPECT_LT(difference(a, b, "x"), 1e-10) << style;
    EXPECT_LT(difference(a, b, "vy", 0.1), 1e-9) << style;
    EXPECT_LT(difference(a, b, "omegaz", 0.1 / 7.5e-3), 1e-9) << style;
    EXPECT_GT(difference(a, last(plain, "bodies", vars), "y"), 1e-5) << style;
  }
  const Vars vars = {{"rods", "15"},    {"height", "0.08"}, {"steps", "17070"},
                     {"every", "5690"}, {"extra", looks},   {"style", "verlet/planar"}};
  const auto one = run_liggghts(lines, vars);
  ASSERT_EQ(one.exit_code, 0) << one.output;
  const Table a = last(one, "bodies", vars), contacts = by_atoms(last(one, "contacts", vars));
  for (const auto& grid :
       {std::make_pair(2, "* 1 1"), std::make_pair(4, "* 1 1"), std::make_pair(4, "2 2 1")}) {
    std::string text = lines;
    text.replace(text.find("* 1 1"), 5, grid.second);
    const auto run = run_liggghts(text, vars, grid.first);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table b = last(run, "bodies", vars);
    for (const char* column : {"x", "y"}) EXPECT_LT(difference(a, b, column), 1e-10);
    for (const char* column : {"vx", "vy"}) EXPECT_LT(difference(a, b, column, 0.1), 1e-10);
    EXPECT_LT(difference(a, b, "omegaz", 0.1 / 7.5e-3), 1e-10);
    EXPECT_GT(contacts.rows(), 5u);
    EXPECT_LT(difference(contacts, by_atoms(last(run, "contacts", vars)), "overlap_t"), 1e-6);
  }
}

// Rods slide down an incline, in contact with it and with one another, over the borders of ranks
// 3 cm apart, of which they may pass one between two looks: what LIGGGHTS passes on has to be asked
// for more often than anybody looks.
// Friction here is that under the cap of the whole normal force, whose history is the longest.
// Rounding grows tenfold in every 1500 steps, and comes to the bounds some 3000 after the last one.
TEST(PlanarEngine, ContactsKeepTheirHistoryWhenRodsChangeTheirRanks) {
  std::string incline = with_cap(with_lines_every(6700));
  incline.replace(incline.find("vector 0 -1 0"), 13, "vector 1 -1 0");
  const Vars vars = {{"rods", "9"},      {"width", "0.12"},  {"every", "7475"},
                     {"steps", "14950"}, {"height", "0.02"}, {"style", "verlet/planar"}};
  const auto one = run_liggghts(incline, vars);
  ASSERT_EQ(one.exit_code, 0) << one.output;
  const Table before = read_dump(one.folder / "bodies.7475.dump"), a = last(one, "bodies", vars);
  int passed = 0;
  for (std::size_t i = 0; i < before.rows(); ++i)
    passed += std::floor(before.column("x")[i] / 0.03) < std::floor(a.column("x")[i] / 0.03);
  EXPECT_GT(passed, 2);
  EXPECT_GT(last(one, "contacts", vars).rows(), 5u);
  for (const int ranks : {2, 4}) {
    const auto run = run_liggghts(incline, vars, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table b = last(run, "bodies", vars);
    for (const char* column : {"x", "y"}) EXPECT_LT(difference(a, b, column), 1e-10) << ranks;
    for (const char* column : {"vx", "vy", "omegaz"})
      EXPECT_LT(difference(a, b, column), 1e-9) << ranks << column;
  }
}

TEST(PlanarEngine, RanksFindTheForcesOfABedAtRest) {
  const Vars bed_vars = {{"rods", "60"},
                         {"height", "0.19"},
                         {"steps", "160000"},
                         {"every", "20000"},
                         {"end", "write_restart bed.restart"}};
  const auto bed = finished(bed_vars, "verlet/planar");
  Vars vars = bed_vars;
  vars["steps"] = vars["every"] = "10";
  vars["end"] = "variable none equal 0";
  const auto contacts_of = [&](const char* style, int ranks) {
    vars["style"] = style;
    const auto run = run_liggghts_in(bed.folder, deck_from("bed.restart"), vars, ranks);
    if (run.exit_code != 0) throw std::runtime_error(run.output);
    return by_atoms(read_dump(bed.folder / "contacts.160010.dump"));
  };
  const Table expected = contacts_of("verlet", 1);
  EXPECT_GT(expected.rows(), 100u);
  for (const int ranks : {2, 4}) {
    const Table contacts = contacts_of("verlet/planar", ranks);
    for (const char* column : {"fx", "fy"})
      EXPECT_LT(difference(expected, contacts, column), 1e-12) << ranks;
  }
}

TEST(PlanarEngine, RanksGoOnExactlyFromARestart) {
  for (const auto& [ranks, cap] : {std::make_pair(2, "on"), std::make_pair(4, "off")}) {
    const Vars vars = {{"rods", "40"},
                       {"height", "0.1"},
                       {"steps", "50000"},
                       {"every", "1000"},
                       {"extra", "restart 38500 r.*"},
                       {"style", "verlet/planar"}};
    const auto run = run_liggghts(with_cap(deck, cap), vars, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table whole = last(run, "bodies", vars);
    std::filesystem::remove(run.folder / "bodies.50000.dump");
    Vars rest = vars;
    rest["steps"] = "11500";
    const auto again =
        run_liggghts_in(run.folder, with_cap(deck_from("r.38500"), cap), rest, ranks);
    ASSERT_EQ(again.exit_code, 0) << again.output;
    const Table parts = last(run, "bodies", vars);
    for (const char* column : {"x", "y", "qz", "vx", "vy", "omegaz"})
      EXPECT_EQ(whole.column(column), parts.column(column)) << ranks << column;
    EXPECT_GT(last(run, "contacts", vars).rows(), 40u);
  }
}

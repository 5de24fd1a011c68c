// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;

using Vars = std::map<std::string, std::string>;

const char* deck = "verification/lines/in.lines";

/// Steps at which the number inserted rises, with the number after it.
std::map<long, int> insertions(const std::string& output) {
  const Table thermo = read_thermo(output);
  std::map<long, int> steps;
  int before = 0;
  for (std::size_t i = 0; i < thermo.rows(); ++i) {
    const int now = static_cast<int>(thermo.column("lines")[i]);
    if (now > before) steps[static_cast<long>(thermo.column("Step")[i])] = now;
    before = now;
  }
  return steps;
}

void expect_same(const Table& a, const Table& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  for (const std::string& name : a.names())
    for (std::size_t i = 0; i < a.rows(); ++i)
      EXPECT_NEAR(a.column(name)[i], b.column(name)[i], tolerance) << name << " of row " << i;
}

TEST(InsertLine, LinesStartAtTheStepNearestToTheirTime) {
  // dt = 1e-4 s: sqrt(2 0.021 / 9.81) s = 654.324 steps between lines. First line at step 1, line k
  // at 1 + round(654.324 k): no error builds up over the lines.
  const auto run = run_liggghts(deck, {{"dt", "1e-4"},
                                       {"steps", "3300"},
                                       {"every", "1"},
                                       {"per_line", "2"},
                                       {"total", "11"},
                                       {"rod", "aspect_ratio 1 diameter 0.001 surface coarse"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::map<long, int> expected = {{1, 2},    {655, 4},   {1310, 6},
                                        {1964, 8}, {2618, 10}, {3273, 11}};
  EXPECT_EQ(insertions(run.output), expected);
}

TEST(InsertLine, IntervalIsATimeWhateverTheTimeStep) {
  for (const auto& [dt, step] : std::map<std::string, long>{{"1e-4", 201}, {"3e-5", 668}}) {
    // second line 0.02 s after the first at step 1: 200 steps, or 666.67, rounded to 667
    const auto run = run_liggghts(deck, {{"dt", dt},
                                         {"start", "interval 0.02"},
                                         {"steps", "700"},
                                         {"every", "1"},
                                         {"per_line", "3"},
                                         {"total", "6"},
                                         {"rod", "aspect_ratio 1 diameter 0.001 surface coarse"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(insertions(run.output), (std::map<long, int>{{1, 3}, {step, 6}}));
  }
}

TEST(InsertLine, RodsStandInTheirCellsAtRandomAnglesWithinTheBounds) {
  const auto run = run_liggghts(deck, {{"steps", "1"}, {"every", "1"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  // 6 rods of 2 * 5 - 1 = 9 spheres in cells of 0.12 / 6 = 0.02 m. After its first step a rod has
  // moved by at most dt (0.025 + g dt) = 2.6e-7 m.
  ASSERT_EQ(spheres.rows(), 54u);
  std::set<double> angles;
  for (int rod = 0; rod < 6; ++rod) {
    const std::size_t first = 9 * rod, middle = first + 4, last = first + 8;
    const auto& x = spheres.column("x");
    const auto& y = spheres.column("y");
    EXPECT_NEAR(x[middle], 0.02 * (rod + 0.5), 3e-7);
    EXPECT_NEAR(y[middle], 0.1, 3e-7);
    EXPECT_EQ(spheres.column("mol")[first], rod + 1);
    // end centres l_axial - d = 0.012 m apart
    EXPECT_NEAR(std::hypot(x[last] - x[first], y[last] - y[first]), 0.012, 1e-12);
    angles.insert(std::atan2(y[last] - y[first], x[last] - x[first]));
    EXPECT_LE(std::abs(spheres.column("vx")[middle]), 0.025);
    EXPECT_NEAR(spheres.column("vy")[middle], 0, 2e-4);
    for (std::size_t i = first; i <= last; ++i) {
      EXPECT_EQ(spheres.column("z")[i], 0);
      EXPECT_GT(x[i], 0.0015);
      EXPECT_LT(x[i], 0.12 - 0.0015);
    }
  }
  EXPECT_EQ(angles.size(), 6u);
}

TEST(InsertLine, SeedDecidesPrimeOrNot) {
  const auto positions = [](const std::string& seed) {
    const auto run = run_liggghts(deck, {{"seed", seed}, {"steps", "1"}, {"every", "1"}});
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return read_dump(run.folder / "spheres.dump").column("y");
  };
  const auto one = positions("1"), again = positions("1"), two = positions("2"),
             prime = positions("15485863");
  EXPECT_EQ(one, again);
  EXPECT_NE(one, two);
  EXPECT_NE(one, prime);
}

TEST(InsertLine, TotalNumberAndFractionsAreMetExactly) {
  // 0.5 : 0.3 : 0.2 of 17 particles = 8.5, 5.1, 3.4: by largest remainders 9, 5, 3. Lines of 5, the
  // last one of 2. Under 5000 m/s^2 a line falls 10 mm in 2 ms, its particles are up to 6 mm long.
  const auto run =
      run_liggghts(Deck().hertz().boundary("f f p").box("0 0.1 0 0.2 -0.005 0.005").with(R"(
fix a all particletemplate/multisphere/spherocylinder 7 type 1 aspect_ratio 3 diameter 0.002 surface smooth density 2500
fix b all particletemplate/multisphere/spherocylinder 8 type 2 aspect_ratio 2 diameter 0.002 surface coarse density 2500
group balls type 1
fix s balls particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius constant 0.002
fix lines all insert/line 12 template a 0.5 b 0.3 s 0.2 per_line 5 x 0 0.1 y 0.19 z 0 total 17 interval 2e-3
fix bodies all multisphere
fix fall all gravity 5000 vector 0 -1 0
fix move balls nve/sphere
dump d all custom 700 spheres.dump id mol type x y z radius
thermo 700
run 700
)"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  std::map<double, int> bodies;
  int plain = 0;
  for (double body : spheres.column("mol")) body < 0 ? ++plain : ++bodies[body];
  std::map<int, int> sizes;
  for (const auto& [body, number] : bodies) ++sizes[number];
  EXPECT_EQ(sizes, (std::map<int, int>{{5, 9}, {2, 5}}));
  EXPECT_EQ(plain, 3);
}

TEST(InsertLine, OneAndTwoRanksInsertTheSameBodies) {
  // Two ranks side by side, the middle one of five rods exactly on their border; and one above the
  // other, so that one rank inserts nothing.
  Vars vars = {
      {"per_line", "5"}, {"total", "15"},
      {"dt", "1e-4"},    {"steps", "1320"},
      {"every", "1320"}, {"rod", "aspect_ratio 5 diameter 0.003 surface smooth size_spread 0.05"}};
  const auto one = run_liggghts(deck, vars, 1);
  ASSERT_EQ(one.exit_code, 0) << one.output;
  const Table a = read_dump(one.folder / "spheres.dump");
  EXPECT_EQ(a.rows(), 135u);
  for (const char* grid : {"2 1 1", "1 2 1"}) {
    vars["grid"] = grid;
    const auto two = run_liggghts(deck, vars, 2);
    ASSERT_EQ(two.exit_code, 0) << two.output;
    // lines at steps 1, 655, 1310; all in free fall: only rounding differs
    expect_same(a, read_dump(two.folder / "spheres.dump"), 1e-10);
  }
}

void expect_restart_continues(const std::string& integrator) {
  const Vars vars = {{"steps", "22000"},
                     {"every", "11000"},
                     {"move", integrator},
                     {"rod", "aspect_ratio 5 diameter 0.003 surface smooth size_spread 0.05"}};
  const auto whole = run_liggghts(deck, vars);
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  Vars rest = vars;
  rest["begin"] = "read_restart " + (whole.folder / "lines.11000.restart").string();
  const auto second = run_liggghts(deck, rest);
  ASSERT_EQ(second.exit_code, 0) << second.output;
  const Table a = read_dump(whole.folder / "spheres.dump");
  EXPECT_EQ(a.rows(), 216u);  // all four lines, two of them inserted after the restart
  // The first line has hit the floor (fall of 0.1 m takes 0.143 s = step 14280).
  expect_same(a, read_dump(second.folder / "spheres.dump"), 1e-12);
  // The first frame after the restart too: what the bodies know of their chains is there at once.
  for (int frame : {-2, -1})
    expect_same(read_dump(whole.folder / "bodies.dump", frame),
                read_dump(second.folder / "bodies.dump", frame), 1e-12);
  const Table bodies = read_dump(second.folder / "bodies.dump", 0);
  for (double radius : bodies.column("radius")) EXPECT_NEAR(radius, 1.5e-3, 0.075e-3);
}

TEST(InsertLine, RestartBetweenTwoLinesGoesOnAsIfUninterrupted) {
  expect_restart_continues("multisphere");
}

TEST(InsertLine, RestartBetweenTwoLinesGoesOnAsIfUninterruptedWithAdamsBashforth) {
  expect_restart_continues("multisphere/ab");
}

TEST(InsertLine, RefusesARestartWithTheTemplateOfAnotherParticle) {
  const auto whole = run_liggghts(
      deck,
      {{"steps", "10"}, {"every", "5"}, {"rod", "aspect_ratio 5 diameter 0.003 surface smooth"}});
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  for (const char* other : {"aspect_ratio 4 diameter 0.003 surface smooth",
                            "aspect_ratio 5 diameter 0.003 surface smooth curvature 90"}) {
    const auto second = run_liggghts(
        deck, {{"steps", "20"},
               {"rod", other},
               {"begin", "read_restart " + (whole.folder / "lines.5.restart").string()}});
    EXPECT_NE(second.exit_code, 0) << other;
    EXPECT_NE(second.output.find("is a chain of 9 spheres and bounding radius 0.0075"),
              std::string::npos)
        << second.output;
  }
}

TEST(InsertLine, StopsWhereALineWouldOverlapTheLastOne) {
  // After 0.01 s the first line has fallen 0.5 mm only: rods 15 mm long are still in the way.
  const auto run = run_liggghts(deck, {{"start", "interval 0.01"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("line 2 at step 1001: its particle at x ="), std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("would overlap sphere"), std::string::npos);
}

TEST(InsertLine, StopsOnRanksAlikeWhereALineWouldOverlapTheLastOne) {
  const auto run = run_liggghts(deck, {{"start", "interval 0.01"}, {"dt", "1e-4"}}, 2);
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("would overlap sphere"), std::string::npos) << run.output;
}

TEST(InsertLine, RefusesParticlesThatDoNotFitTheirCell) {
  const auto run = run_liggghts(deck, {{"per_line", "9"}});  // cells of 13.3 mm, rods of 15 mm
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("particles of template rods are 0.015 m wide"), std::string::npos)
      << run.output;
}

// A box, a contact model and a template of rods: what a line needs but the integrator of its
// bodies.
const std::string rods_in_a_box = Deck().hertz().with(R"(
fix rods all particletemplate/multisphere/spherocylinder 7 type 1 aspect_ratio 5 diameter 0.003 surface smooth density 2500
)");

// Beside what the sweep of all keywords (trust/keyword_sweep_test.cpp) refuses.
TEST(InsertLine, RefusesWrongInput) {
  const std::string good = "per_line 2 x 0 0.1 y 0.05 total 4 ";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"1 template e 1 " + good + "interval 1",
       "template is 'e', expected the id of a fix particletemplate"},
      {"1 template rods 1 rods 1 " + good + "interval 1", "template rods is given twice"},
      {"1 template rods 1 per_line 2 x 0 0.2 y 0.05 total 4 interval 1",
       "x is '0.2', expected a position in the box, 0 to 0.1 m"},
      {"1 template rods 1 per_line 2 x 0 0.1 y 0.5 total 4 interval 1",
       "y is '0.5', expected a position in the box, 0 to 0.1 m"},
      {"1 template rods 1 " + good, "expected either fall H or interval T"},
      {"1 template rods 1 " + good + "fall 0.1 interval 1", "expected either fall H or interval T"},
      {"1 template rods 1 " + good + "interval 1 velocity 1", "value of velocity is missing"},
      {"1 template rods 1 " + good + "fall 0.1", "fall needs a fix gravity or keyword gravity"},
      {"1 template rods 1 " + good + "fall 0.1\nfix g all gravity 9.81 vector 1 0 0",
       "fall needs gravity along -y"},
      {"1 template rods 1 " + good + "interval 1e-6",
       "interval is '1e-06', expected at least a time step between lines"},
  };
  for (const auto& [arguments, message] : cases) {
    const auto run = run_liggghts(rods_in_a_box + R"(
fix bodies all multisphere
fix lines all insert/line )" + arguments +
                                  "\nrun 1\n");
    EXPECT_NE(run.exit_code, 0) << arguments;
    EXPECT_NE(run.output.find("insert/line (id lines): "), std::string::npos) << arguments;
    EXPECT_NE(run.output.find(message), std::string::npos) << message << "\n" << run.output;
  }
}

TEST(InsertLine, RefusesBodiesWithoutFixMultisphere) {
  const auto run = run_liggghts(rods_in_a_box + R"(
fix lines all insert/line 1 template rods 1 per_line 2 x 0 0.1 y 0.05 total 4 interval 1
run 1
)");
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("template rods needs exactly one fix multisphere, got '0'"),
            std::string::npos)
      << run.output;
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <regex>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"

namespace {

using namespace rodpack::test;

/// A box without walls or gravity: `templates` define fixes, `insertion` how they are put in.
std::string scene(const std::string& templates, const std::string& insertion,
                  const std::string& rest = "") {
  return Deck()
      .hertz()
      .box("0 0.4 0 0.4 -0.05 0.05")
      .atom_types(2)
      .with(templates + "\n" + insertion + "\nfix bodies all multisphere\n" + rest + R"(
dump spheres all custom 1 spheres.dump id mol type x y z vx vy vz omegax omegay omegaz radius mass
dump_modify spheres sort id format "%d %d %d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
run 1
)");
}

const std::string style = "particletemplate/multisphere/spherocylinder";

std::string rods(const std::string& arguments, const std::string& id = "rods",
                 const std::string& type = "1") {
  return "fix " + id + " all " + style + " 1" + type + " type " + type + " " + arguments + "\n";
}

std::string one_line(int number, const std::string& names = "rods 1") {
  return "fix lines all insert/line 5 template " + names + " per_line " + std::to_string(number) +
         " x 0 0.4 y 0.2 z 0 total " + std::to_string(number) + " interval 1\n";
}

/// Principal moments that the template writes to the log.
std::vector<double> moments(const std::string& output) {
  const std::regex line("Principal moments of inertia_: ([^,]+), ([^,]+), (\\S+)");
  std::smatch match;
  if (!std::regex_search(output, match, line)) return {};
  return {std::stod(match[1]), std::stod(match[2]), std::stod(match[3])};
}

TEST(SpherocylinderTemplate, MassAndInertiaOfTheReferenceParticle) {
  // Mass: 2500 kg/m^3 times the union of 9 spheres of r = 1.5 mm, r apart; a lens of two of them is
  // 5 pi r^3 / 12: V = pi r^3 (9 * 4/3 - 8 * 5/12). Inertia: 5 tangent spheres of M/5 at 0, +-d,
  // +-2d: I_x = 2/5 M r^2, I_y = I_z = I_x + 2 d^2 M. Coarse and smooth share both.
  const double r = 1.5e-3, d = 3e-3;
  const double mass = 2500 * M_PI * r * r * r * (9 * 4. / 3. - 8 * 5. / 12.);
  for (const std::string surface : {"smooth", "coarse", "overlap 0.2"}) {
    const auto run = run_liggghts(
        scene(rods("aspect_ratio 5 diameter 0.003 surface " + surface + " density constant 2500"),
              one_line(3)));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table spheres = read_dump(run.folder / "spheres.dump");
    for (double m : spheres.column("mass")) EXPECT_NEAR(m, mass, 1e-10 * mass);
    const auto inertia = moments(run.output);  // printed with 7 digits
    ASSERT_EQ(inertia.size(), 3u);
    EXPECT_NEAR(inertia[0], 0.4 * mass * r * r, 1e-6 * inertia[0]);
    EXPECT_NEAR(inertia[1], mass * (0.4 * r * r + 2 * d * d), 1e-6 * inertia[1]);
    EXPECT_NEAR(inertia[2], inertia[1], 1e-12);
  }
}

TEST(SpherocylinderTemplate, OwnAndGivenMass) {
  // Five tangent spheres of their own: M = 5 * 4/3 pi r^3 rho.
  const double r = 1.5e-3;
  const auto own = run_liggghts(scene(
      rods("aspect_ratio 5 diameter 0.003 surface coarse density 2500 mass own"), one_line(2)));
  ASSERT_EQ(own.exit_code, 0) << own.output;
  const double mass = 5 * 4. / 3. * M_PI * r * r * r * 2500;
  EXPECT_NEAR(read_dump(own.folder / "spheres.dump").column("mass")[0], mass, 1e-10 * mass);

  const auto given = run_liggghts(
      scene(rods("aspect_ratio 5 diameter 0.003 surface coarse mass given 3e-4 1e-10 5e-9 5.05e-9"),
            one_line(2)));
  ASSERT_EQ(given.exit_code, 0) << given.output;
  EXPECT_EQ(read_dump(given.folder / "spheres.dump").column("mass")[0], 3e-4);
  EXPECT_EQ(moments(given.output), (std::vector<double>{1e-10, 5e-9, 5.05e-9}));
}

TEST(SpherocylinderTemplate, DrawnDiametersSpreadEvenlyAndKeepTheAxialLength) {
  const auto run =
      run_liggghts(scene(rods("aspect_ratio 5 diameter 0.001 surface smooth density 2500 "
                              "size_spread 0.05 planar yes"),
                         "fix mix all particledistribution/discrete 32452843 1 rods 1\n"
                         "region low block 0.01 0.39 0.01 0.39 -0.004 0.004 units box\n"
                         "fix pack all insert/pack seed 32452867 distributiontemplate mix "
                         "insert_every once overlapcheck yes orientation random all_in yes "
                         "particles_in_region 1000 region low\n"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  ASSERT_EQ(spheres.rows(), 9000u);
  std::map<double, std::vector<std::size_t>> bodies;
  for (std::size_t i = 0; i < spheres.rows(); ++i) bodies[spheres.column("mol")[i]].push_back(i);
  ASSERT_EQ(bodies.size(), 1000u);
  double sum = 0, squares = 0, cosines = 0, sines = 0;
  for (const auto& [body, rows] : bodies) {
    ASSERT_EQ(rows.size(), 9u);
    const double d = 2 * spheres.column("radius")[rows[0]];
    EXPECT_GE(d, 0.95e-3);
    EXPECT_LE(d, 1.05e-3);
    const double dx = spheres.column("x")[rows[8]] - spheres.column("x")[rows[0]];
    const double dy = spheres.column("y")[rows[8]] - spheres.column("y")[rows[0]];
    EXPECT_NEAR(std::hypot(dx, dy), 5e-3 - d, 1e-12);  // end centres are l_axial - d apart
    for (std::size_t i : rows) {
      EXPECT_EQ(spheres.column("radius")[i], 0.5 * d);
      EXPECT_EQ(spheres.column("z")[i], 0.);  // planar, although insert/pack works in 3D
      // the drawn diameter leaves the mass alone
      EXPECT_EQ(spheres.column("mass")[i], spheres.column("mass")[0]);
    }
    sum += d;
    squares += d * d;
    const double angle = std::atan2(dy, dx);
    cosines += std::cos(angle);
    sines += std::sin(angle);
  }
  // uniform on +-5e-5 m: standard deviation 5e-5 / sqrt(3); of the mean of 1000: 9.1e-7 m (4 sigma
  // allowed), of the deviation 1.4e-2 relative (5 % allowed)
  const double mean = sum / 1000, deviation = std::sqrt(squares / 1000 - mean * mean);
  EXPECT_NEAR(mean, 1e-3, 3.7e-6);
  EXPECT_NEAR(deviation, 5e-5 / std::sqrt(3.), 0.05 * 5e-5 / std::sqrt(3.));
  // angles uniform over the circle: each sum has the deviation sqrt(1000 / 2) = 22.4 (4 sigma)
  EXPECT_NEAR(cosines, 0, 90);
  EXPECT_NEAR(sines, 0, 90);
}

TEST(SpherocylinderTemplate, MassFollowsTheDrawnSizeIfAsked) {
  // own coarse chain of two tangent-or-overlapping spheres: AR = 2, centres l - d apart. d <= l/2
  // for the draws below 1: two full spheres; above, they overlap.
  const auto run = run_liggghts(
      scene(rods("aspect_ratio 2 diameter 0.003 surface coarse density 2500 size_spread 0.05 "
                 "mass own follow_drawn_size yes"),
            one_line(20)));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  int separate = 0;
  for (std::size_t i = 0; i < spheres.rows(); ++i) {
    const double r = spheres.column("radius")[i], full = 2 * 4. / 3. * M_PI * r * r * r;
    const double h = 6e-3 - 2 * r;  // distance of the centres
    // lens of two spheres: pi (2r - h)^2 (h^2 + 4 h r) / (12 h)
    const double lens =
        h < 2 * r ? M_PI * (2 * r - h) * (2 * r - h) * (h * h + 4 * h * r) / (12 * h) : 0;
    EXPECT_NEAR(spheres.column("mass")[i], 2500 * (full - lens), 1e-9 * 2500 * full);
    separate += h > 2 * r;
  }
  EXPECT_GT(separate, 0);
  EXPECT_LT(separate, 40);
}

TEST(SpherocylinderTemplate, SingleSphereIsABodyOfOne) {
  const double d = 3e-3, mass = 2500 * M_PI / 6 * d * d * d;
  const auto run = run_liggghts(
      scene(rods("aspect_ratio 1 diameter 0.003 surface smooth density 2500 planar yes"),
            one_line(10), "fix plane all enforce2d/multisphere"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  ASSERT_EQ(spheres.rows(), 10u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(spheres.column("mol")[i], i + 1.);
    EXPECT_NEAR(spheres.column("mass")[i], mass, 1e-12 * mass);
    EXPECT_EQ(spheres.column("radius")[i], 0.5 * d);
  }
  const auto inertia = moments(run.output);
  for (double moment : inertia) EXPECT_NEAR(moment, 0.1 * mass * d * d, 1e-6 * moment);
}

TEST(SpherocylinderTemplate, MixesWithOtherTemplatesInStockInsertion) {
  const auto run = run_liggghts(scene(
      "fix stock all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 "
      "nspheres 2 ntry 100000 spheres 0 0 0 0.002 0.003 0 0 0.002 type 1\n"
      "group balls type 1\n"
      "fix ball balls particletemplate/sphere 15485867 atom_type 2 density constant 2500 radius "
      "constant 0.002\n" +
          rods("aspect_ratio 5 diameter 0.003 surface smooth density 2500", "a", "2") +
          rods("aspect_ratio 3 diameter 0.003 surface smooth curvature 60 density 2500 "
               "atom_type 2",
               "b", "3"),
      "fix mix all particledistribution/discrete/numberbased 32452843 4 stock 0.25 ball 0.25 a "
      "0.25 "
      "b 0.25\n"
      "fix pack all insert/pack seed 32452867 distributiontemplate mix insert_every once "
      "overlapcheck yes orientation random all_in yes particles_in_region 40 region box\n"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  std::map<double, int> bodies;
  int plain = 0;
  for (double body : spheres.column("mol")) body < 0 ? ++plain : ++bodies[body];
  std::map<int, int> sizes;
  for (const auto& [body, number] : bodies) ++sizes[number];
  EXPECT_EQ(sizes, (std::map<int, int>{{2, 10}, {5, 10}, {9, 10}}));
  EXPECT_EQ(plain, 10);
}

TEST(SpherocylinderTemplate, RateInsertionBringsNewRodsAgainAndAgain) {
  const auto run = run_liggghts(scene(
      rods("aspect_ratio 3 diameter 0.003 surface coarse density 2500 planar yes"),
      "fix mix all particledistribution/discrete 32452843 1 rods 1\n"
      "fix rate all insert/rate/region seed 32452867 distributiontemplate mix nparticles 40 "
      "particlerate 1e5 insert_every 10 overlapcheck yes orientation random vel constant 0 -1 0.5 "
      "region box ntry_mc 10000\n",
      "run 50"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table spheres = read_dump(run.folder / "spheres.dump");
  EXPECT_EQ(spheres.rows(), 120u);
  for (double z : spheres.column("z")) EXPECT_EQ(z, 0.);
  for (double v : spheres.column("vz")) EXPECT_EQ(v, 0.);
}

// Beside what the sweep of all keywords (trust/keyword_sweep_test.cpp) refuses.
TEST(SpherocylinderTemplate, RefusesWrongInput) {
  const std::string good = "aspect_ratio 5 diameter 0.003 surface smooth density 2500";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"11 type 1 aspect_ratio 10000 diameter 0.003 surface overlap 0.9 density 2500",
       "number of primary spheres = 99991: expected at most 10000"},
      {"11 type 1 aspect_ratio 5 diameter 0.003 surface smooth", "keyword density is missing"},
      {"11 type 1 " + good + " atom_type 3", "atom_type is '3', expected at most 2"},
      {"11 type 1 " + good + " mass given 1 1 1 3", "none exceeds the sum of the other two"},
      {"11 type 1 " + good + " mass given 1 1 1", "value of mass given IXX IYY IZZ is missing"},
      {"11 type 1 " + good + " mass given 1 1 1 1 follow_drawn_size yes", "contradicts mass given"},
      {"11 type 2 " + good, "type must be unique and run from 1 to 1 over all"},
      {"11 type 1 aspect_ratio 1.02 diameter 0.003 surface smooth density 2500 size_spread 0.05",
       "diameter"},
  };
  for (const auto& [arguments, message] : cases) {
    const auto run = run_liggghts(scene("fix rods all " + style + " " + arguments, one_line(2)));
    EXPECT_NE(run.exit_code, 0) << arguments;
    EXPECT_NE(run.output.find(style + " (id rods): "), std::string::npos) << arguments;
    EXPECT_NE(run.output.find(message), std::string::npos) << message << "\n" << run.output;
  }
}

}  // namespace

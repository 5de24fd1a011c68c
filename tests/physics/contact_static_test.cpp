// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

const double mass = 2500 * M_PI / 6 * std::pow(3e-3, 3);  // of a sphere, kg

/// A square floor at y = 0, within the box, as two triangles.
std::string write_floor(const std::filesystem::path& file) {
  std::ofstream stl(file);
  stl << "solid floor\n";
  for (const char* corners : {"-0.019 0 -0.009\nvertex 0.019 0 0.009\nvertex 0.019 0 -0.009",
                              "-0.019 0 -0.009\nvertex -0.019 0 0.009\nvertex 0.019 0 0.009"})
    stl << "facet normal 0 1 0\nouter loop\nvertex " << corners << "\nendloop\nendfacet\n";
  stl << "endsolid floor\n";
  return file.string();
}

}  // namespace

// Five pairs of spheres at rest, 10 um into each other, k = 1000 N/m: force k delta = 1e-2 N,
// energy k delta^2 / 2 = 5e-8 J each, contact point half-way, branch ends at the centres.
TEST(StaticContact, ForceEnergyAndGeometryOfAnOverlap) {
  const auto run = run_liggghts("verification/collision/in.collision",
                                {{"gap", "-1e-5"}, {"shift", "0"}, {"speed", "0"}, {"steps", "0"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table contacts = read_dump(run.folder / "contacts.dump");
  ASSERT_EQ(contacts.rows(), 5u);
  std::size_t row = 0;  // of the pair of spheres 5 and 6, on the x axis
  while (std::fabs(contacts.column("y")[row]) > 1e-3) ++row;
  const auto at = [&](const char* name) { return contacts.column(name)[row]; };
  const double side = at("sphere_i") == 5 ? -1 : 1;  // sphere 5 is on the left
  EXPECT_EQ(at("sphere_i") + at("sphere_j"), 11);
  EXPECT_EQ(at("body_i"), at("sphere_i"));
  EXPECT_EQ(at("wall"), 0);
  EXPECT_NEAR(at("overlap_n"), 1e-5, 1e-15);
  EXPECT_EQ(at("overlap_t"), 0);
  EXPECT_NEAR(at("fx"), side * 1e-2, 1e-12);
  EXPECT_NEAR(at("fy"), 0, 1e-18);
  EXPECT_NEAR(at("x"), 0, 1e-18);
  EXPECT_NEAR(at("bix"), side * 1.495e-3, 1e-15);
  EXPECT_NEAR(at("bjx"), -side * 1.495e-3, 1e-15);
  const Table energies = read_table(run.folder / "energies.txt");
  EXPECT_NEAR(energies.column("normal").back(), 5 * 5e-8, 1e-16);
  EXPECT_EQ(energies.column("tangential").back(), 0);
}

// Spheres that move at v and spin at omega: m v^2 / 2 for ten and (2/5 m r^2) omega^2 / 2 for five.
TEST(StaticContact, KineticEnergyOfPlainSpheres) {
  const auto run = run_liggghts("verification/collision/in.collision",
                                {{"speed", "0.5"}, {"spin", "100"}, {"steps", "0"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table energies = read_table(run.folder / "energies.txt");
  const double rotational = 5 * 0.5 * 0.4 * mass * 1.5e-3 * 1.5e-3 * 1e4;
  EXPECT_NEAR(energies.column("kinetic_translational")[0] / (10 * 0.5 * mass * 0.25), 1, 1e-12);
  EXPECT_NEAR(energies.column("kinetic_rotational")[0] / rotational, 1, 1e-12);
}

// m (v0 - v) c = I v / c with the lever arm c = r - delta/2, delta = m g / k_n: 5/7 v0 but for
// delta/r = 6e-5. On the way there v = v0 - mu g t. Both kinds of wall.
TEST(StaticContact, SlidingSphereEndsRolling) {
  const double radius = 1.5e-3, v0 = 0.05, mu = 0.3;
  const double arm = radius - 0.5 * mass * 9.81 / 2000;
  const double rolling = v0 / (1 + 0.4 * radius * radius / (arm * arm));
  const auto folder = fresh_folder();
  const std::string stl = write_floor(folder / "floor.stl");
  for (const char* mesh : {"0", "1"}) {
    for (const char* order : {"0", "3"}) {
      const auto run =
          run_liggghts("verification/sliding_sphere/in.sliding_sphere",
                       {{"mesh", mesh}, {"stl", stl}, {"order", order}, {"every", "200"}});
      ASSERT_EQ(run.exit_code, 0) << run.output;
      const Table sliding = read_dump(run.folder / "bodies.dump", 1);
      const Table end = read_dump(run.folder / "bodies.dump");
      const double time = 200 * 1.1e-5;
      // The first steps, in which the spring builds up to the cap, take off a little less.
      EXPECT_NEAR(sliding.column("vx")[0], v0 - mu * 9.81 * time, 1e-2 * mu * 9.81 * time)
          << mesh << order;
      EXPECT_NEAR(end.column("vx")[0], rolling, 1e-5 * v0) << mesh << order;
      EXPECT_NEAR(end.column("omegaz")[0], -rolling / arm, 1e-5 * v0 / arm) << mesh << order;
      const Table contacts = read_dump(run.folder / "contacts.dump");
      ASSERT_EQ(contacts.rows(), 1u) << mesh;
      EXPECT_EQ(contacts.column("wall")[0], 1);
      EXPECT_NEAR(contacts.column("fy")[0], mass * 9.81, 1e-6 * mass * 9.81);
    }
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "rodpack/geometry/chain_geometry.h"
#include "rodpack/contact/contact_law.h"
#include "rodpack/geometry/mass_properties.h"

using namespace rodpack::test;

namespace {

const char* const chains = "verification/chains/in.chains";
constexpr double diameter = 3e-3;  // m

const rodpack::ChainShape shape{3, diameter, 0.5, 0, diameter};

/// M = 2500 kg/m^3 times the volume of the union of the five spheres.
double chain_mass() {
  // Five spheres of radius r, neighbours r apart: each of the four overlaps is a lens of volume
  // pi (4 r + d)(2 r - d)^2 / 12 with d = r; spheres two places apart just touch.
  const double r = diameter / 2;
  return 2500 * (5 * 4.0 / 3 * M_PI - 4 * 5 * M_PI / 12) * r * r * r;
}

}  // namespace

// Effective mass M/2, so that the closed form of the restitution holds as for two spheres; an
// effective mass from the spheres would give eta sqrt(5) in its place and e = 0.34.
TEST(Chains, HeadOnRestitutionFollowsTheMassOfTheBodies) {
  const double expected = rodpack::restitution_coefficient(0.2);
  for (const char* order : {"0", "3"}) {
    const auto run = run_liggghts(chains, {{"order", order}, {"dt", "2.75e-6"}, {"steps", "1000"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table bodies = read_dump(run.folder / "bodies.dump");
    ASSERT_EQ(bodies.rows(), 2u);
    for (const std::size_t row : {0, 1}) {
      EXPECT_NEAR(std::fabs(bodies.column("vx")[row]) / 0.5, expected, 3e-3) << order;
      EXPECT_NEAR(bodies.column("vy")[row], 0, 1e-4);  // inserted to 1e-7 m
      EXPECT_NEAR(bodies.column("mass")[row] / chain_mass(), 1, 1e-10);
      EXPECT_EQ(bodies.column("nspheres")[row], 5);
      EXPECT_NEAR(bodies.column("half_length")[row], 4.5e-3, 1e-15);
      EXPECT_NEAR(bodies.column("area")[row] / rodpack::covered_area(shape), 1, 1e-12);
    }
    EXPECT_LT(bodies.column("x")[0] * bodies.column("x")[1], 0);
  }
}

// Side by side, about 20 um into each other: facing spheres overlap by delta = d - distance of the
// centres of mass, diagonal neighbours are about sqrt((d - delta)^2 + d^2/4) > d apart. Five
// contacts of k delta each, branch ends at the centres of mass.
TEST(Chains, SideBySideTouchInFiveSpherePairs) {
  const auto run = run_liggghts(chains, {{"x1", "0"},
                                         {"y1", "0"},
                                         {"x2", "0"},
                                         {"y2", "0.00298"},
                                         {"u", "0"},
                                         {"steps", "1"},
                                         {"every", "1"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table bodies = read_dump(run.folder / "bodies.dump");
  ASSERT_EQ(bodies.rows(), 2u);
  const auto& x = bodies.column("x");
  const auto& y = bodies.column("y");
  const double delta = diameter - std::hypot(x[1] - x[0], y[1] - y[0]);
  ASSERT_NEAR(delta, 2e-5, 1e-6);

  const Table contacts = read_dump(run.folder / "contacts.dump");
  ASSERT_EQ(contacts.rows(), 5u);
  double total = 0;
  for (std::size_t c = 0; c < 5; ++c) {
    const std::size_t i = contacts.column("body_i")[c] == bodies.column("id")[0] ? 0 : 1;
    EXPECT_EQ(contacts.column("body_j")[c], bodies.column("id")[1 - i]);
    EXPECT_NEAR(contacts.column("overlap_n")[c] / delta, 1, 1e-9);
    total += std::hypot(contacts.column("fx")[c], contacts.column("fy")[c]);
    EXPECT_GT(contacts.column("fy")[c] * (y[i] - y[1 - i]), 0) << "repulsive";
    EXPECT_NEAR(contacts.column("bix")[c], x[i], 1e-15);
    EXPECT_NEAR(contacts.column("biy")[c], y[i], 1e-15);
    EXPECT_NEAR(contacts.column("bjx")[c], x[1 - i], 1e-15);
    EXPECT_NEAR(contacts.column("bjy")[c], y[1 - i], 1e-15);
  }
  EXPECT_NEAR(total / (5 * 1000 * delta), 1, 1e-9);

  const Table spheres = read_dump(run.folder / "spheres.dump");
  ASSERT_EQ(spheres.rows(), 10u);
  double sum = 0;
  for (const double magnitude : spheres.column("fsum")) sum += magnitude;
  EXPECT_NEAR(sum / (2 * total), 1, 1e-12);
}

// At rest on the floor each chain's weight is on its five spheres, in equal parts by symmetry of
// the flat chain; k here is that of the type pair, 1000 N/m, so the overlap is M g / 5 k.
TEST(Chains, RestOnTheFloorCarriesTheWeight) {
  for (const char* order : {"0", "3"}) {
    const auto run = run_liggghts(chains, {{"order", order},
                                           {"g", "9.81"},
                                           {"x1", "-0.015"},
                                           {"x2", "0.015"},
                                           {"y1", "-0.0084"},
                                           {"y2", "-0.0084"},
                                           {"u", "0"},
                                           {"steps", "30000"},
                                           {"every", "30000"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const double weight = chain_mass() * 9.81;
    const Table contacts = read_dump(run.folder / "contacts.dump");
    ASSERT_EQ(contacts.rows(), 10u) << order;
    double carried = 0;
    for (std::size_t c = 0; c < contacts.rows(); ++c) {
      EXPECT_EQ(contacts.column("wall")[c], 1);
      EXPECT_NEAR(contacts.column("fy")[c] / (weight / 5), 1, 1e-4) << order;
      EXPECT_NEAR(contacts.column("overlap_n")[c] / (weight / 5000), 1, 1e-4) << order;
      carried += contacts.column("fy")[c];
    }
    EXPECT_NEAR(carried / (2 * weight), 1, 1e-6) << order;
  }
}

// Caps 1.2 mm off each other's axis: both chains leave with spin. Springs alone conserve
// E = sum M v^2 / 2 + I omega^2 / 2, but for the integrator, whose loss is of third order in the
// step.
TEST(Chains, KineticEnergyReturnsFromAnObliqueCollision) {
  for (const char* order : {"0", "3"}) {
    const auto run = run_liggghts(chains, {{"order", order},
                                           {"dt", "2.75e-6"},
                                           {"steps", "1000"},
                                           {"eta", "0"},
                                           {"mu", "0"},
                                           {"y1", "-0.0006"},
                                           {"y2", "0.0006"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table energies = read_table(run.folder / "energies.txt");
    const double at_start = 2 * 0.5 * chain_mass() * 0.25;
    const double spin = energies.column("kinetic_rotational")[0] / at_start;
    EXPECT_GT(spin, 0.05) << order;
    EXPECT_EQ(energies.column("normal")[0], 0) << "still in contact";
    EXPECT_NEAR(energies.column("kinetic_translational")[0] / at_start + spin, 1, 5e-4) << order;
  }
}

// A body of LIGGGHTS's own template, three tangent spheres, and a plain sphere beside it. The
// body's row is that of the straight chain around it; the sphere's id follows the largest body id.
TEST(Chains, BodiesOfStockTemplatesAndPlainSpheresAreListed) {
  const auto run = run_liggghts(Deck()
                                    .boundary("f f p")
                                    .box("-0.03 0.03 -0.02 0.02 -0.01 0.01")
                                    .with(R"(
create_atoms 1 single 0.01 0.01 0 units box
set group all diameter 0.002 density 2500
fix stock all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 3 &
  ntry 100000 spheres -0.003 0 0 0.0015 0 0 0 0.0015 0.003 0 0 0.0015 type 1
fix chains all particledistribution/discrete 15485867 1 stock 1.0
)" + one_particle("middle", {0, 0, 0}, "orientation constant 1 0 0 0", "chains") +
                                          R"(fix integrate all multisphere
dump bodies all multisphere/body 1 bodies.dump
run 1
)"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const Table bodies = read_dump(run.folder / "bodies.dump");
  ASSERT_EQ(bodies.rows(), 2u);
  EXPECT_EQ(bodies.column("id")[0], 1);
  EXPECT_EQ(bodies.column("nspheres")[0], 3);
  EXPECT_NEAR(bodies.column("half_length")[0], 4.5e-3,
              2e-5);  // LIGGGHTS samples the centre of mass
  EXPECT_NEAR(bodies.column("radius")[0], 1.5e-3, 1e-15);
  EXPECT_EQ(bodies.column("curvature")[0], 0);
  EXPECT_NEAR(bodies.column("area")[0], M_PI * 2.25e-6 + 4 * 1.5e-3 * 3e-3, 2e-7);
  EXPECT_EQ(bodies.column("id")[1], 2);
  EXPECT_EQ(bodies.column("nspheres")[1], 1);
  EXPECT_EQ(bodies.column("half_length")[1], 1e-3);
  EXPECT_NEAR(bodies.column("area")[1], M_PI * 1e-6, 1e-18);
}

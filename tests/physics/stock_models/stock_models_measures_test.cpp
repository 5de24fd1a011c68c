// SPDX-License-Identifier: GPL-2.0-or-later
// Stress, energy and overlaps with LIGGGHTS's own contact models.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "deck.h"
#include "liggghts_run.h"
#include "stock_models.h"

using namespace rodpack::test;

namespace {

constexpr double linear_stiffness = 1000;  // of hooke/stiffness, N/m

/// Overlap at which Hertz's force is `force`.
double hertz_overlap(double force, double reduced_radius) {
  return std::pow(3 * force / (4 * reduced_modulus * std::sqrt(reduced_radius)), 2.0 / 3);
}

/// Sum over a grid that `x` spans from edge to edge, times the area of a cell. A period counts
/// once.
double integral(const Table& fields, const std::string& name, bool periodic) {
  const auto& x = fields.column("x_m");
  std::size_t nx = 1;
  while (nx < x.size() && x[nx] > x[nx - 1]) ++nx;
  const double cell = (x[1] - x[0]) * (fields.column("y_m")[nx] - fields.column("y_m")[0]);
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!periodic || k % nx != nx - 1) sum += fields.column(name)[k] * cell;
  return sum;
}

/// -sum f_a r_b over the contacts of a dump, r from the centre of i to that of j.
double moment(const Table& contacts, char a, char b) {
  const auto& force = contacts.column(std::string("f") + a);
  const auto& from = contacts.column(std::string("bi") + b);
  const auto& to = contacts.column(std::string("bj") + b);
  double sum = 0;
  for (std::size_t c = 0; c < contacts.rows(); ++c) sum -= force[c] * (to[c] - from[c]);
  return sum;
}

}  // namespace

// A column of spheres in equilibrium: each contact carries the weight above it, F = m g (n - k),
// over a branch of length b. Integrated over all space, stress is sum F b and the push of the floor
// the whole weight.
TEST(StockModelsStress, AStaticColumnIntegratesToItsWeights) {
  const int n = 6;
  for (const bool hertz : {true, false}) {
    const std::string models = std::string("model ") + (hertz ? "hertz" : "hooke/stiffness") +
                               " tangential history rolling_friction epsd";
    std::string spheres;
    double y = 0, stress = 0;
    for (int k = 0; k < n; ++k) {
      const double load = (n - k) * sphere_mass * gravity;
      const double reduced = k == 0 ? sphere_radius : 0.5 * sphere_radius;
      const double overlap = hertz ? hertz_overlap(load, reduced) : load / linear_stiffness;
      y += (k == 0 ? 1 : 2) * sphere_radius - overlap;
      stress += load * (k == 0 ? sphere_radius - 0.5 * overlap : 2 * sphere_radius - overlap);
      spheres += "create_atoms 1 single 0.01 " + exact(y) + " 0 units box\n";
    }
    for (const int ranks : {1, 2}) {
      const auto run = run_liggghts(
          column_of(models, spheres) +
              "compute s all stress/goldhirsch scale 0.002 box -0.006 0.026 -0.016 0.034 "
              "tolerance 1e-12\nrun 0\n"
              "write_dump all stress/goldhirsch s.csv s\n"
              "write_dump all custom a.dump id fy modify format \"%d %.17g\"\n",
          {}, ranks);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      const Table atoms = read_dump(run.folder / "a.dump");
      for (const double fy : atoms.column("fy"))
        ASSERT_NEAR(fy, 0, 1e-10 * sphere_mass * gravity);  // nothing moves
      const Table fields = read_table(run.folder / "s.csv");
      EXPECT_NEAR(integral(fields, "contact_stress_yy_N_m", false), stress, 1e-8 * stress);
      EXPECT_NEAR(integral(fields, "contact_stress_xx_N_m", false), 0, 1e-12 * stress);
      const double weight = n * sphere_mass * gravity;
      EXPECT_NEAR(integral(fields, "boundary_force_density_y_N_m2", false), weight, 1e-8 * weight);
      EXPECT_NEAR(integral(fields, "mass_density_kg_m2", false) * gravity, weight, 1e-8 * weight);
    }
  }
}

// Bodies that collide: branches between centres of mass, contacts of two bodies added up, dashpots,
// friction and cohesion in the forces; periodic in x.
TEST(StockModelsStress, BodiesInMotionIntegrateToTheirContactsOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    const auto run = run_liggghts(
        falling_rods("model hertz tangential history cohesion sjkr",
                     listed_every(1000) +
                         "compute s all stress/goldhirsch scale 0.003 box 0 0.04 -0.02 0.06\n"
                         "dump f all stress/goldhirsch 1000 s.*.csv s\n"),
        {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    for (const int frame : {6, 8, 10}) {
      const Table contacts = read_dump(run.folder / "contacts.dump", frame);
      const Table fields =
          read_table(run.folder / ("s." + std::to_string(contacts.timestep()) + ".csv"));
      double scale = 0, floor = 0;
      for (std::size_t c = 0; c < contacts.rows(); ++c) {
        scale += 2 * sphere_radius * std::hypot(contacts.column("fx")[c], contacts.column("fy")[c]);
        if (contacts.column("wall")[c] == 1) floor += contacts.column("fy")[c];
      }
      ASSERT_GT(scale, 0);
      for (const char a : {'x', 'y'}) {
        for (const char b : {'x', 'y'}) {
          std::string stress = "contact_stress_";
          (stress += a) += b;
          EXPECT_NEAR(integral(fields, stress + "_N_m", true), moment(contacts, a, b), 1e-7 * scale)
              << stress << frame;
        }
      }
      EXPECT_NEAR(integral(fields, "boundary_force_density_y_N_m2", true), floor,
                  1e-7 * scale / sphere_radius);
    }
  }
}

// 8/15 E* sqrt(R*) delta^(5/2), which is 2/5 F delta, of two contacts at rest; k delta^2 / 2 of
// linear springs.
TEST(StockModelsEnergy, RestingContactsHaveTheEnergyOfTheirLaw) {
  const auto energy_of = [](const std::string& models) {
    const auto run = run_liggghts(pressed_spheres(models) +
                                  "compute e all contact/energy\n"
                                  "compute o all contact/overlap 15e-6\n"
                                  "thermo_style custom step c_e c_e[1] c_e[2] c_o c_o[2] c_o[3]\n"
                                  "thermo_modify format float %.15g\nrun 0\n");
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return read_thermo(run.output);
  };
  const Table hertz = energy_of("model hertz tangential history cohesion sjkr");
  double expected = 0;
  for (const double delta : {10e-6, 20e-6})
    expected +=
        0.4 * delta * hertz_force(delta, delta > 15e-6 ? sphere_radius : 0.5 * sphere_radius);
  EXPECT_NEAR(hertz.column("e").back(), expected, 1e-9 * expected);
  EXPECT_NEAR(hertz.column("e[1]").back(), expected, 1e-9 * expected);
  EXPECT_EQ(hertz.column("e[2]").back(), 0);
  EXPECT_EQ(hertz.column("o").back(), 0);  // pairs deeper than 15 um: a wall is none
  EXPECT_NEAR(hertz.column("o[2]").back(), 20e-6, 1e-15);
  EXPECT_EQ(hertz.column("o[3]").back(), 2);

  const Table linear = energy_of("model hooke/stiffness tangential history");
  expected = 0.5 * linear_stiffness * (10e-6 * 10e-6 + 20e-6 * 20e-6);
  EXPECT_NEAR(linear.column("e").back(), expected, 1e-9 * expected);
}

// Ours between the spheres and Hertz at the wall, and the other way round: each listed in its own
// way, 0.01 N and k delta^2 / 2 of the one, F of Hertz and 2/5 F delta of the other.
TEST(StockModelsEnergy, OursAndStockModelsMeetAtAWall) {
  const std::string ours = "model spring_dashpot tangential spring_dashpot";
  const std::string hertz = "model hertz tangential history";
  for (const bool hertz_at_wall : {true, false}) {
    std::string deck = pressed_spheres(hertz_at_wall ? ours : hertz);
    const std::string wall = "wall/gran " + (hertz_at_wall ? ours : hertz);
    deck.replace(deck.find(wall), wall.size(), "wall/gran " + (hertz_at_wall ? hertz : ours));
    const auto run = run_liggghts(deck +
                                  "compute e all contact/energy\nthermo_style custom step c_e\n"
                                  "thermo_modify format float %.15g\n"
                                  "dump c all contact/gran 1 c.dump\nrun 0\n");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table contacts = read_dump(run.folder / "c.dump");
    ASSERT_EQ(contacts.rows(), 2u);
    double energy = 0;
    for (std::size_t c = 0; c < 2; ++c) {
      const bool wall_contact = contacts.column("wall")[c] == 1;
      const double delta = wall_contact ? 20e-6 : 10e-6;
      const bool by_hertz = wall_contact == hertz_at_wall;
      const double force = by_hertz ? hertz_force(delta, (wall_contact ? 1 : 0.5) * sphere_radius)
                                    : linear_stiffness * delta;
      EXPECT_NEAR(std::fabs(contacts.column("fy")[c]), force, 1e-9 * force);
      energy += (by_hertz ? 0.4 : 0.5) * force * delta;
    }
    EXPECT_NEAR(read_thermo(run.output).column("e").back(), energy, 1e-9 * energy);
  }
}

// fix halt ends a run in a step that was none of output when it began.
TEST(StockModelsEnergy, ARunThatIsHaltedTellsOfItsLastStep) {
  const auto run = run_liggghts(pressed_spheres("model hertz tangential history") +
                                "variable now equal step\nfix h all halt 10 v_now >= 30\n"
                                "compute e all contact/energy\nthermo 1000\n"
                                "thermo_style custom step c_e\nrun 500\n");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(read_thermo(run.output).column("Step").back(), 30);
}

// Nothing is lost in an undamped collision but what velocity Verlet's step leaves; at the deepest
// all of it is in the contact. fix print announces every seventh step, where there is no output.
TEST(StockModelsEnergy, AnUndampedCollisionKeepsItsEnergy) {
  std::string deck = column_of("model hertz tangential history",
                               "create_atoms 1 single 0.01 0.02 0 units box\n"
                               "create_atoms 1 single 0.01 0.0231 0 units box\n");
  const std::string damped = "coefficientRestitution peratomtypepair 1 0.5";
  ASSERT_NE(deck.find(damped), std::string::npos);
  deck.replace(deck.find(damped), damped.size(), "coefficientRestitution peratomtypepair 1 1");
  const auto run =
      run_liggghts(deck +
                   "unfix g\ntimestep 1e-6\n"
                   "group low id 1\ngroup high id 2\n"
                   "velocity low set 0 0.1 0 units box\n"
                   "velocity high set 0 -0.1 0 units box\n"
                   "compute k all ke\ncompute e all contact/energy\n"
                   "variable k equal c_k\nvariable e equal c_e\n"
                   "fix t all print 7 \"${k} ${e}\" file e.txt title \"k e\" screen no\n"
                   "run 3000\n");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const double energy = 2 * 0.5 * sphere_mass * 0.1 * 0.1;
  const Table table = read_table(run.folder / "e.txt");
  ASSERT_EQ(table.rows(), 428u);
  double deepest = 0;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double stored = table.column("e")[k];
    EXPECT_NEAR(table.column("k")[k] + stored, energy, 1e-5 * energy);
    deepest = std::max(deepest, stored);
  }
  EXPECT_GT(deepest, 0.999 * energy);
  EXPECT_EQ(table.column("e").back(), 0);
}

// The upper sphere has slid along z by v dt = 1 um in one step: k_t s^2 / 2, and the force k_t s.
TEST(StockModelsEnergy, ATangentialSpringStoresHalfItsStiffnessTimesTheSquareOfItsLength) {
  const auto run =
      run_liggghts(pressed_spheres("model hooke/stiffness tangential history", nullptr,
                                   "tangential_damping off") +
                   "group high id 1\nvelocity high set 0 0 0.1 units box\n"
                   "compute e all contact/energy\nthermo_style custom step c_e[2]\n"
                   "thermo_modify format float %.15g\ndump c all contact/gran 1 c.dump\nrun 1\n");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const double length = 0.1 * 1e-5, stiffness = 500;
  EXPECT_NEAR(read_thermo(run.output).column("e[2]").back(), 0.5 * stiffness * length * length,
              1e-4 * 0.5 * stiffness * length * length);
  const Table contacts = read_dump(run.folder / "c.dump");
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    if (contacts.column("wall")[c] == 1) continue;
    EXPECT_NEAR(contacts.column("overlap_t")[c], length, 1e-4 * length);
    const auto at = [&](const std::string& name) { return contacts.column(name)[c]; };
    const double normal = at("fx") * at("nx") + at("fy") * at("ny") + at("fz") * at("nz");
    EXPECT_NEAR(std::fabs(at("fz") - normal * at("nz")), stiffness * length,
                1e-6 * stiffness * length);
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
// What is mended in the staged copy of LIGGGHTS (liggghts-src-ext/stock/), and how stock bodies are
// dumped.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;
using testing::Not;

namespace {

constexpr double radius = 2e-3, spacing = 3e-3;

/// A rod of three overlapping spheres along a direction of the template's frame, four of them born
/// as given, which drift for a few steps.
Run three_spheres(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  std::string centres;
  for (int k : {-1, 0, 1}) {
    for (double component : {x, y, z}) centres += exact(k * spacing * component / length) + " ";
    centres += exact(radius) + " ";
  }
  return run_liggghts(
      Deck()
          .box("0 0.1 0 0.1 -0.02 0.02")
          .skin("0.002")
          .with(
              "fix rod all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 "
              "nspheres 3 ntry 1000000 spheres " +
              centres + R"(type 1
fix mix all particledistribution/discrete 15485867 1 rod 1.0
fix lines all insert/line 3 template rod 1 per_line 4 x 0.01 0.09 y 0.05 z 0 total 4 interval 1 angle 0 0
fix motion all multisphere
run 5
write_dump all multisphere/body b.dump modify format %.17g
write_dump all multisphere/sphere s.dump modify format %.17g
)"));
}

std::vector<double> principal_moments(const std::string& output) {
  const std::string before = "Principal moments of inertia_: ";
  double moments[3] = {0, 0, 0};
  const auto at = output.find(before);
  if (at != std::string::npos)
    std::sscanf(output.c_str() + at + before.size(), "%lf, %lf, %lf", moments, moments + 1,
                moments + 2);
  std::sort(moments, moments + 3);
  return {moments, moments + 3};
}

/// Runs a deck through a pipe, as a user does who starts the program in a batch job, without the
/// line buffering of run_liggghts(); returns what came out of the pipe and the log file.
std::pair<std::string, std::string> through_a_pipe(const std::string& deck, int ranks) {
  const auto folder = fresh_folder();
  std::ofstream(folder / "in.deck") << deck;
  std::string start = "OMPI_MCA_orte_tmpdir_base=\"$PWD\" OMPI_MCA_ess_singleton_isolated=1 ";
  if (ranks > 1)
    start =
        "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpiexec --oversubscribe -np " +
        std::to_string(ranks) + " ";
  const auto run = run_command(start + "'" RODPACK_BIN "/liggghts' -in in.deck 2>&1 | cat", folder);
  return {run.output, text_of(folder / "log.liggghts")};
}

/// One sphere 4 mm off the plane, on the right of the box, where the last of one or two ranks has
/// it.
std::string off_the_plane() {
  return Deck().hertz().processors("* 1 1").with(R"(
create_atoms 1 single 0.09 0.05 0.004 units box
set group all diameter 0.003 density 2500
fix move all nve/sphere
fix plane all enforce2d/multisphere
print "said before"
run 0
)");
}

}  // namespace

// The union of the three spheres is a body of revolution, so two principal moments are equal, and
// none depends on the direction. They are sampled: 1e6 points, of which a quarter hit, give 0.3 %.
TEST(StockMends, PrincipalMomentsDoNotDependOnTheDirectionOfTheSpheres) {
  const auto reference = principal_moments(three_spheres(1, 0, 0).output);
  ASSERT_GT(reference[0], 0.0);
  EXPECT_NEAR(reference[1], reference[2], 0.01 * reference[2]);
  const double directions[][3] = {{0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 2, 3}};
  for (const auto& direction : directions) {
    const auto moments =
        principal_moments(three_spheres(direction[0], direction[1], direction[2]).output);
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(moments[k], reference[k], 0.02 * reference[k])
          << direction[0] << direction[1] << direction[2];
  }
}

// The axis of a body's shape, as the dump of its spheres has it, whichever principal axis is first.
TEST(StockMends, AStockBodysAngleAndXAxisAreThoseOfItsSpheres) {
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, 120.0}) {
    const double angle = degrees * M_PI / 180;
    const auto run = three_spheres(std::cos(angle), std::sin(angle), 0);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const Table bodies = read_dump(run.folder / "b.dump");
    ASSERT_EQ(bodies.rows(), 4u);
    for (std::size_t k = 0; k < bodies.rows(); ++k) {
      // Of lines, not of directions: modulo 180 degrees.
      EXPECT_NEAR(std::sin(bodies.column("angle")[k] - angle), 0.0, 1e-6) << degrees;
      const double w = bodies.column("qw")[k], x = bodies.column("qx")[k],
                   y = bodies.column("qy")[k], z = bodies.column("qz")[k];
      const double axis[3] = {w * w + x * x - y * y - z * z, 2 * (x * y + w * z),
                              2 * (x * z - w * y)};
      EXPECT_NEAR(std::fabs(axis[0] * std::cos(angle) + axis[1] * std::sin(angle)), 1.0, 1e-6);
      EXPECT_NEAR(axis[2], 0.0, 1e-6);
    }
    // Of all bodies alike, since they were born alike.
    for (std::size_t k = 1; k < bodies.rows(); ++k)
      EXPECT_NEAR(bodies.column("angle")[k], bodies.column("angle")[0], 1e-6);
  }
}

// A pipe is written to by blocks, and MPI_Abort throws away what waits for its block to fill: the
// line, and what came before, have to be flushed first. Of a rank that does not have the log, too.
TEST(StockMends, TheErrorOfAnyOfTwoRanksArrivesThroughAPipeAndInTheLog) {
  for (int ranks : {1, 2}) {
    const auto [output, log] = through_a_pipe(off_the_plane(), ranks);
    const std::string line =
        "ERROR on proc " + std::to_string(ranks - 1) +
        ": Fix enforce2d/multisphere (id plane): sphere 1 lies 0.004 m off the plane";
    EXPECT_THAT(output, HasSubstr("said before")) << ranks;
    EXPECT_THAT(output, HasSubstr(line)) << ranks;
    EXPECT_THAT(log, HasSubstr(line)) << ranks;
  }
}

// Stock's own: of one rank (a restart file that is not there), and of all (an unknown command).
TEST(StockMends, StockErrorsArriveThroughAPipeAndInTheLogFromAnyOfTwoRanks) {
  const std::pair<const char*, const char*> decks[] = {
      {"read_restart nowhere.restart\n", "ERROR on proc 0: Restart file nowhere.restart cannot be"},
      {"no_such_command\n", "ERROR: Unknown command: no_such_command"}};
  for (const auto& [deck, line] : decks)
    for (int ranks : {1, 2}) {
      const auto [output, log] = through_a_pipe(deck, ranks);
      EXPECT_THAT(output, HasSubstr(line)) << ranks;
      EXPECT_THAT(log, HasSubstr(line)) << ranks;
    }
}

// What says nothing to a user hides what does.
TEST(StockMends, ADepositionBeginsWithoutAWarning) {
  const auto run = run_liggghts("deposition/in.deposition", {{"particles", "6"},
                                                             {"particles_per_line", "6"},
                                                             {"width_in_lengths", "8"},
                                                             {"container_height", "0.1"},
                                                             {"aspect_ratio", "3"},
                                                             {"relaxation_limit", "1e-3"},
                                                             {"out", "run"}});
  EXPECT_THAT(run.output, HasSubstr("Step"));
  EXPECT_THAT(run.output, Not(HasSubstr("WARNING")));
}

// Thermo's own kinetic energy counts the spheres: that is said where it is printed.
TEST(StockMends, ThermosOwnKineticEnergyOfBodiesIsWarnedOf) {
  // The default columns of thermo have it.
  EXPECT_THAT(three_spheres(1, 0, 0).output,
              HasSubstr("kinetic energy ke is not that of multispheres"));
}

TEST(StockMends, BodiesOfASubgroupAreRefused) {
  const auto run = run_liggghts(Deck().atom_types(2).with(R"(
group some type 2
fix rod some particletemplate/multisphere/spherocylinder 1 atom_type 2 type 1 &
    aspect_ratio 3 diameter 0.003 surface smooth density constant 2500
fix motion some multisphere/ab
)"));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, HasSubstr("Fix multisphere/ab (id motion): moves every body: the group "
                                    "has to be 'all'"));
}

// A deck in cgs: dumps say so, what is labelled in SI is refused, and messages have its units.
TEST(StockMends, UnitsOfTheDeckAreSaidOrRefused) {
  const auto deck = [](const std::string& lines) {
    std::string text = Deck()
                           .box("0 10 0 10 -1 1")
                           .skin("0.1")
                           .stiffness("1e6", "5e5")
                           .with(
                               "create_atoms 1 single 5 5 0 units box\nset group all diameter 0.3 "
                               "density 2.5\nfix move all nve/sphere\n" +
                               lines + "\nrun 0\n");
    return text.replace(text.find("units si"), 8, "units cgs");
  };
  const auto dumped = run_liggghts(deck("dump s all multisphere/sphere 1 s.dump"));
  ASSERT_EQ(dumped.exit_code, 0) << dumped.output;
  EXPECT_EQ(text_of(dumped.folder / "s.dump").rfind("ITEM: UNITS\ncgs\nITEM: TIMESTEP\n", 0), 0u);
  for (const std::string name : {"f.csv", "f.vti"})
    EXPECT_THAT(run_liggghts(deck("compute st all stress/goldhirsch scale 0.6 spacing 0.4\n"
                                  "dump f all stress/goldhirsch 1 " +
                                  name + " st"))
                    .output,
                HasSubstr("named with units of SI: the deck's units are cgs, expected si"));
  EXPECT_THAT(run_liggghts(deck("compute o all contact/overlap")).output,
              HasSubstr("expected a length (cm) in (0, 1e15]"));
}

// Stock LIGGGHTS takes 'run 1e6' for one step, 1e10 steps modulo 2^32, 12-5 for 12.
TEST(StockMends, NumbersOfCommandsAreWholeWordsInTheirRange) {
  const auto sphere = [](const std::string& lines) {
    return Deck().hertz().with(
        "create_atoms 1 single 0.05 0.05 0 units box\n"
        "set group all diameter 0.003 density 2500\n"
        "fix move all nve/sphere\n" +
        lines + "\n");
  };
  const std::pair<const char*, const char*> wrong[] = {
      {"run 1e6", "expected a whole number of steps, got '1e6'"},
      {"run 5.5", "expected a whole number of steps, got '5.5'"},
      {"run 10 upto start 0x", "expected a whole number of steps, got '0x'"},
      {"reset_timestep 1e3", "expected a whole number of steps, got '1e3'"},
      {"restart 10000000000 r.*", "expected an integer of at most 2147483647, got '10000000000'"},
      {"thermo 12-5", "expected an integer of at most 2147483647, got '12-5'"},
      {"thermo 1e3", "expected an integer, got '1e3'"},
      {"timestep 1e400", "expected a finite number, got '1e400'"},
      {"timestep 1e-5e", "expected a finite number, got '1e-5e'"},
      {"timestep abc", "expected a number, got 'abc'"}};
  for (const auto& [command, message] : wrong) {
    const auto run = run_liggghts(sphere(command));
    EXPECT_NE(run.exit_code, 0) << command;
    EXPECT_THAT(run.output, HasSubstr(message)) << command;
  }
  const auto run = run_liggghts(sphere("timestep +1.0E-5\nrun 10\nrun +20 upto\nrun 0"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

// On the axis every direction leads to the wall: none in a cylinder that is wider than the sphere,
// and across the axis, by the overlap of the radii, in one that is narrower. k_n 1000 N/m.
TEST(StockMends, ASphereOnTheAxisOfACylinderTouchesItOnlyWhereItIsNarrower) {
  for (const std::string axis : {"x", "y", "z"})
    for (const std::string radius : {"0.02", "0.00149"}) {
      SCOPED_TRACE(axis + " " + radius);
      const auto run = run_liggghts(Deck()
                                        .box("0 0.1 0 0.1 0 0.1")
                                        .with("create_atoms 1 single 0.05 0.05 0.05 units box\n"
                                              "set group all diameter 0.003 density 2500\n"
                                              "fix move all nve/sphere\n"
                                              "fix wall all wall/gran model spring_dashpot "
                                              "tangential spring_dashpot primitive type 1 " +
                                              axis + "cylinder " + radius +
                                              " 0.05 0.05\n"
                                              "run 0\n"
                                              "write_dump all contact/gran c.dump\n"));
      ASSERT_EQ(run.exit_code, 0) << run.output;
      const Table contacts = read_dump(run.folder / "c.dump");
      ASSERT_EQ(contacts.rows(), radius == "0.02" ? 0u : 1u);
      if (contacts.rows() == 0) continue;
      EXPECT_NEAR(contacts.column("overlap_n")[0], 1e-5, 1e-12);
      const double f[3] = {contacts.column("fx")[0], contacts.column("fy")[0],
                           contacts.column("fz")[0]};
      EXPECT_EQ(f[axis[0] - 'x'], 0.0);
      EXPECT_NEAR(std::sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]), 0.01, 1e-9);
    }
}

// Stock reads meshes and inserts particles with words for a screen, whether there is one or not.
TEST(StockMends, RunsWithoutAScreenOnOneAndTwoRanks) {
  const std::string silo = " -in '" RODPACK_REPOSITORY "/inputs/discharge3d/in.discharge3d'" +
                           std::string(
                               " -var particles 20 -var settle_time 0.01 -var lid_speed 5 "
                               "-var flow_limit 0.01 -var container_width 0.024 "
                               "-var orifice_width 0.015 -var column_fraction 0.05");
  const std::string mpi =
      "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpiexec --oversubscribe -np 2 ";
  const auto folder = fresh_folder();
  const std::pair<std::string, std::string> starts[] = {
      {"none", ""}, {"none", mpi}, {"said.txt", mpi}};
  int k = 0;
  for (const auto& [screen, start] : starts) {
    const std::string out = "run" + std::to_string(k++);
    const auto run = run_command(start + "'" RODPACK_BIN "/liggghts' -log none -screen " + screen +
                                     silo + " -var out " + out,
                                 folder);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    EXPECT_EQ(run.output, "");
    EXPECT_THAT(text_of(folder / out / "log.liggghts"), HasSubstr("Loop time"));
    EXPECT_TRUE(std::filesystem::exists(folder / out / "result.json"));
  }
  EXPECT_THAT(text_of(folder / "said.txt"), HasSubstr("Loop time"));
}

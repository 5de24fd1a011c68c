// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "deck.h"
#include "liggghts_run.h"

namespace rodpack::test {
namespace {

std::filesystem::path written(const std::string& text) {
  const std::filesystem::path file = fresh_folder() / "file";
  std::ofstream(file) << text;
  return file;
}

using Numbers = std::vector<double>;

TEST(TestSupport, ReadsCommaAndBlankSeparatedTablesByColumnName) {
  const Table csv = read_table(written("step,time_s\n1,0.5\n2,1e-3\n"));
  EXPECT_EQ(csv.column("time_s"), (Numbers{0.5, 1e-3}));
  // LIGGGHTS's fix ave/time writes a title first; the names are in the last comment line.
  const Table blanks = read_table(written("# Time-averaged data\n# TimeStep c_ke\n7 8\n"));
  EXPECT_EQ(blanks.column("c_ke"), (Numbers{8}));
  EXPECT_EQ(blanks.rows(), 1u);
}

TEST(TestSupport, NamesTheMissingColumnAndTheBadLine) {
  EXPECT_THROW(read_table(written("a b\n1 2\n")).column("c"), std::out_of_range);
  EXPECT_THROW(read_table(written("a b\n1\n")), std::runtime_error);
  EXPECT_THROW(read_table(written("a b\n1 x\n")), std::runtime_error);
  EXPECT_THROW(read_table("no/such/file"), std::runtime_error);
}

// Lines between the rows that are none are left out, and so is a table that has no end.
TEST(TestSupport, ReadsTheThermoTableOfTheWantedRun) {
  const std::string output =
      "run 2\n  Step  Atoms lines \n 0 0 0 \nWARNING: 1 2 x\n 2 54 6e0 \n"
      "Loop time of 1 on 1 procs\nStep ke\n3 7\nLoop time of 1 on 1 procs\nStep ke\n4 8\n";
  const Table thermo = read_thermo(output);
  EXPECT_EQ(thermo.names(), (std::vector<std::string>{"Step", "Atoms", "lines"}));
  EXPECT_EQ(thermo.column("Step"), (Numbers{0, 2}));
  EXPECT_EQ(thermo.column("lines"), (Numbers{0, 6}));
  for (const int second : {1, -1}) {
    EXPECT_EQ(read_thermo(output, second).names(), (std::vector<std::string>{"Step", "ke"}));
    EXPECT_EQ(read_thermo(output, second).column("ke"), Numbers{7});
  }
  EXPECT_THROW(read_thermo(output, 2), std::runtime_error);
  EXPECT_THROW(read_thermo("Step Atoms\n1 2\n", -1), std::runtime_error);
}

TEST(TestSupport, ReadsTheWantedFrameOfADump) {
  const auto frame = [](const std::string& step, const std::string& x) {
    return "ITEM: TIMESTEP\n" + step + "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n" +
           "0 4\n0 4\n0 1\nITEM: ATOMS id x\n1 " + x + "\n2 0.25\n";
  };
  const auto file = written(frame("10", "1.5") + frame("20", "2.5"));
  EXPECT_EQ(read_dump(file).timestep(), 20);
  EXPECT_EQ(read_dump(file).column("x"), (Numbers{2.5, 0.25}));
  EXPECT_EQ(read_dump(file, 0).column("x"), (Numbers{1.5, 0.25}));
  EXPECT_THROW(read_dump(file, 2), std::runtime_error);
}

TEST(TestSupport, ReportsExitCodeAndOutputOfACommand) {
  const auto run = run_command("echo heard; exit 3");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.output, "heard\n");
}

// LIGGGHTS reads commands in their order: the box has to know boundaries and ranks, properties the
// number of atom types.
TEST(TestSupport, DecksBeginWithWhatTheyAreTold) {
  EXPECT_EQ(Deck()
                .boundary("f p f")
                .processors("2 1 1")
                .box("0 1 0 2 0 3")
                .atom_types(2)
                .stiffness("7", "8")
                .damping("0")
                .friction("0.5")
                .skin("0.1")
                .timestep("1e-6")
                .with("run 1\n"),
            "atom_style granular\natom_modify map array sort 0 0\nboundary f p f\nunits si\n"
            "newton off\ncommunicate single vel yes\nsoft_particles yes\nprocessors 2 1 1\n"
            "region box block 0 1 0 2 0 3 units box\ncreate_box 2 box\n"
            "neighbor 0.1 bin\nneigh_modify delay 0\n"
            "fix kn all property/global kn peratomtypepair 2 7 7 7 7\n"
            "fix kt all property/global kt peratomtypepair 2 8 8 8 8\n"
            "fix dn all property/global dampingRatioNormal peratomtypepair 2 0 0 0 0\n"
            "fix dt all property/global dampingRatioTangential peratomtypepair 2 0 0 0 0\n"
            "fix mu all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n"
            "pair_style gran model spring_dashpot tangential spring_dashpot\npair_coeff * *\n"
            "timestep 1e-6\nrun 1\n");
  EXPECT_NE(Deck().restart("a.100").with("").find("\nread_restart a.100\nneighbor"),
            std::string::npos);
}

TEST(TestSupport, ObservedOrderOfAQuadraticErrorIsTwo) {
  EXPECT_NEAR(observed_order(4e-3, 1e-3), 2, 1e-12);
}

}  // namespace
}  // namespace rodpack::test

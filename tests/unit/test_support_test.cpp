// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

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

TEST(TestSupport, ReadsTheWantedFrameOfADump) {
  const auto frame = [](const std::string& step, const std::string& x) {
    return "ITEM: TIMESTEP\n" + step + "\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n" +
           "0 1\n0 1\n0 1\nITEM: ATOMS id x\n1 " + x + "\n2 0.25\n";
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

TEST(TestSupport, ObservedOrderOfAQuadraticErrorIsTwo) {
  EXPECT_NEAR(observed_order(4e-3, 1e-3), 2, 1e-12);
}

}  // namespace
}  // namespace rodpack::test

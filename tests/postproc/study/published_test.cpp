// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/published.h"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "reading/data_error.h"
#include "reading/text_file.h"
#include "liggghts_run.h"

namespace {
using namespace rodpack;
using testing::HasSubstr;

std::string file_with(const std::string& rows) {
  const auto file = (test::fresh_folder() / "published.csv").string();
  write_text(file, "case,quantity,value,error,source\n" + rows);
  return file;
}

Ensemble ensemble_of(const std::string& name, double phi, std::optional<double> sem) {
  Ensemble ensemble;
  EnsembleCase each;
  each.name = name;
  each.numbers["solid_fraction"] = {phi, sem, sem ? 4 : 1};
  each.numbers["solid_fraction_to_3_omega_below_surface"] = {phi + 0.02, sem, sem ? 4 : 1};
  ensemble.cases.push_back(each);
  return ensemble;
}

void expect_refused(const std::string& rows, const std::string& words) {
  try {
    read_published(file_with(rows), {});
    FAIL() << "not refused: " << rows;
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("published.csv:2: "));
    EXPECT_THAT(error.what(), HasSubstr(words));
  }
}

TEST(Published, ValuesOfThePaperAreRead) {
  const auto values =
      read_published(std::string(RODPACK_REPOSITORY) + "/inputs/study/published.csv", {});
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[0].case_name, "coarse-AR2");
  EXPECT_EQ(values[0].value, 0.87);
  EXPECT_EQ(values[0].error, 0.0021);
}

TEST(Published, RoundingIsThatOfTheLastPrintedDigit) {
  // Uniform over a unit of the last digit: its width over sqrt 12.
  const auto values = read_published(file_with("smooth-AR2,solid_fraction,0.88,0,a\n"
                                               "smooth-AR3,solid_fraction,0.880,0,a\n"
                                               "spheres,janssen_pressure_N_m,1.2e1,0,a\n"
                                               "spheres,janssen_depth_over_dp,31,0,a\n"),
                                     {});
  EXPECT_NEAR(values[0].rounding, 0.01 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(values[1].rounding, 0.001 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(values[2].rounding, 1 / std::sqrt(12.0), 1e-12);
  EXPECT_NEAR(values[3].rounding, 1 / std::sqrt(12.0), 1e-12);
}

TEST(Published, WrongRowsAreRefusedByFileAndLine) {
  expect_refused("rough-AR2,solid_fraction,0.8,0,a\n", "found 'rough-AR2'");
  expect_refused("smooth-ARx,solid_fraction,0.8,0,a\n", "found 'smooth-ARx'");
  expect_refused("smooth-AR2,phi,0.8,0,a\n", "found 'phi'");
  expect_refused("smooth-AR2,solid_fraction,high,0,a\n", "found 'high'");
  expect_refused("smooth-AR2,solid_fraction,nan,0,a\n", "a finite number");
  expect_refused("smooth-AR2,solid_fraction,0.8,-0.1,a\n", "at least 0");
}

TEST(Published, SameValueTwiceIsRefused) {
  const std::string row = "smooth-AR2,solid_fraction,0.8,0.1,a\n";
  try {
    read_published(file_with(row + row), {});
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("published.csv:3: expected one line per case"));
  }
  EXPECT_EQ(read_published(file_with(row + "smooth-AR2,solid_fraction,0.8,0.1,b\n"), {}).size(),
            2U);
}

TEST(Published, CasesAndQuantitiesOfOnesOwnStudyAreTaken) {
  auto own = ensemble_of("long-ones", 0.7, 0.01);
  own.cases[0].numbers["my_number"] = {1, 0.1, 3};
  EXPECT_EQ(read_published(file_with("long-ones,my_number,1.1,0.1,a\n"), own).size(), 1U);
}

TEST(Published, DifferencesAreInUnitsOfTheCombinedError) {
  // sem 0.003, error 0.0021, rounding 0.01 / sqrt 12: root of 9 + 4.41 + 8.3333, times 1e-3.
  const double combined = 1e-3 * std::sqrt(9 + 4.41 + 100 / 12.0);
  const auto values = read_published(file_with("coarse-AR2,solid_fraction,0.87,0.0021,a\n"), {});
  const auto rows =
      compare_with_published(ensemble_of("coarse-AR2", 0.86, 0.003), values, "solid_fraction");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_NEAR(rows[0].difference, -0.01, 1e-12);
  EXPECT_NEAR(*rows[0].combined_error, combined, 1e-12);
  EXPECT_NEAR(*rows[0].deviation(), -0.01 / combined, 1e-9);
}

TEST(Published, SingleRunHasNoCombinedError) {
  const auto values = read_published(file_with("coarse-AR2,solid_fraction,0.87,0.0021,a\n"), {});
  const auto rows = compare_with_published(ensemble_of("coarse-AR2", 0.86, std::nullopt), values,
                                           "solid_fraction");
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_FALSE(rows[0].combined_error);
  EXPECT_FALSE(rows[0].deviation());
}

TEST(Published, TableHasBothAveragesBesideTheValue) {
  const auto values = read_published(file_with("coarse-AR2,solid_fraction,0.87,0.0021,a\n"), {});
  const auto stem = (test::fresh_folder() / "table2").string();
  ASSERT_TRUE(write_solid_fraction_table(ensemble_of("coarse-AR2", 0.86, 0.003), values, stem));
  const auto csv = read_text(stem + ".csv");
  EXPECT_THAT(csv, HasSubstr("\ncoarse-AR2,solid_fraction,3 omega above the floor to the surface,"
                             "0.86,0.003,4,0.87,0.0021,0.00289,-0.01,"));
  EXPECT_THAT(csv,
              HasSubstr("to 3 omega below the surface,0.88,0.003,4,0.87,0.0021,0.00289,0.01,"));
  // 0.01 / 0.004663 = 2.1
  EXPECT_THAT(read_text(stem + ".md"),
              HasSubstr("| coarse-AR2 | 4 | 0.8600 ± 0.0030 | 0.8800 ± 0.0030 | 0.87 ± 0.0021 | "
                        "−0.0100 (2.1 σ) | +0.0100 (2.1 σ) |"));
}

}  // namespace

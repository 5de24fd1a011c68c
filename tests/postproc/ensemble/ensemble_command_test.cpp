// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "ensemble/ensemble.h"
#include "liggghts_run.h"
#include "run_folders.h"

namespace {
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::text_of;
using rodpack::test::write_finished_run;
using testing::HasSubstr;
namespace fs = std::filesystem;

auto ensemble_command(const std::string& arguments, const fs::path& folder) {
  return rodpack::test::run_rodpack("ensemble " + arguments, folder);
}

TEST(EnsembleCommand, AnalysesWhatIsNotCurrentAndGivesTheSameWhateverTheOrder) {
  const auto folder = fresh_folder();
  for (const unsigned seed : {1U, 2U})
    write_finished_run(folder / ("r" + std::to_string(seed)), seed);
  auto run = ensemble_command("r1 r2 --jobs 2", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("2 of 2 runs analysed"));
  EXPECT_THAT(run.output, HasSubstr("smooth-AR5: 2 runs"));
  const auto first = text_of(folder / "ensemble/ensemble.json");
  const auto read = rodpack::read_ensemble((folder / "ensemble/ensemble.json").string());
  ASSERT_EQ(read.cases.size(), 1U);
  const auto& one = read.cases[0];
  EXPECT_EQ(one.runs, (std::vector<std::string>{"r1", "r2"}));
  EXPECT_EQ(one.numbers.at("nematic_order_S2").n, 2);
  // Densities of bins 5 degrees wide (10 for fewer than 1000 particles) integrate to 1.
  const auto& density = one.curves.at("orientation.probability_density_per_deg");
  double integral = 0;
  for (const auto& bin : density.y) integral += bin.mean * (density.x[1] - density.x[0]);
  EXPECT_NEAR(integral, 1, 1e-8);
  EXPECT_EQ(density.x[0], 0);
  for (const char* table : {"orientation", "rdf", "profile", "forces", "fields"})
    EXPECT_TRUE(fs::exists(folder / "ensemble" / ("smooth-AR5_" + std::string(table) + ".csv")));

  run = ensemble_command(". --jobs 1 --again", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(text_of(folder / "ensemble/ensemble.json"), first);
  run = ensemble_command("r2 r1 r1", folder);
  EXPECT_THAT(run.output, testing::Not(HasSubstr("analysed")))
      << "current analyses were made again";
  EXPECT_EQ(text_of(folder / "ensemble/ensemble.json"), first);
}

TEST(EnsembleCommand, AFailingAnalysisIsNamedAndTheOthersAreMade) {
  const auto folder = fresh_folder();
  for (const unsigned seed : {1U, 2U})
    write_finished_run(folder / ("r" + std::to_string(seed)), seed);
  put(folder / "r1/dumps/bodies.2000.dump", "nonsense\n");
  const auto run = ensemble_command("r1 r2 -j 1", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("rodpack: r1: its analysis ended with exit code 1: rodpack: "
                                    "r1/dumps/bodies.2000.dump:1: expected 'ITEM: TIMESTEP'"));
  EXPECT_TRUE(fs::exists(folder / "r2/analysis/summary.json"));
  EXPECT_FALSE(fs::exists(folder / "ensemble"));
}

TEST(EnsembleCommand, RefusalsExitWithOneAndWrongUsageWithTwo) {
  const auto folder = fresh_folder();
  const auto run = ensemble_command("none", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "rodpack: none: no such folder\n");
  EXPECT_EQ(ensemble_command("", folder).exit_code, 2);
  EXPECT_EQ(ensemble_command("a --jobs 0", folder).exit_code, 2);
}

}  // namespace

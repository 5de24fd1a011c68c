// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/stability/stability.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "liggghts_run.h"
#include "reading/data_error.h"

namespace rodpack {
namespace {

namespace fs = std::filesystem;

TEST(Stability, BisectionFindsWhereGrowthBegins) {
  int calls = 0;
  const auto grows = [&](double y) { return ++calls, y > 0.7236; };
  EXPECT_NEAR(bisect_growth(grows, 0.05, 2.5, 1e-3), 0.7236, 0.7236 * 1e-3);
  EXPECT_LT(calls, 20);
  EXPECT_EQ(bisect_growth(grows, 0.8, 2.5, 1e-3), 0.0);
  EXPECT_TRUE(std::isinf(bisect_growth(grows, 0.05, 0.7, 1e-3)));
}

// A program that is not there: rows in the table need no run.
TEST(Stability, RowsOfTheTableAreNotMeasuredAgain) {
  const fs::path folder = test::fresh_folder();
  const std::string header = "method,order,damping_ratio,limit_measured,limit_theory\n";
  const std::string rows =
      "adams_bashforth,3,0.2,0.6668,0.6666666667\nvelocity_verlet,0,0.2,1.64,1.639607805\n";
  std::ofstream(folder / "stability.csv") << header << rows;
  StabilityOptions options;
  options.liggghts.program = "/no/such/program";
  options.decks = RODPACK_REPOSITORY "/inputs";
  options.folder = folder.string();
  options.orders = {0, 3};
  options.damping_ratios = {0.2};
  const auto limits = measure_stability(options);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].order, 0);
  EXPECT_EQ(limits[0].limit_measured, 1.64);
  EXPECT_EQ(limits[1].limit_measured, 0.6668);
  options.damping_ratios = {0.2, 0.3};
  EXPECT_THROW(measure_stability(options), DataError);

  write_stability(limits, folder.string());
  EXPECT_EQ(test::text_of(folder / "stability.csv"),
            header +
                "velocity_verlet,0,0.2,1.64,1.639607805\n"
                "adams_bashforth,3,0.2,0.6668,0.6666666667\n");
  for (const char* figure : {"stability.png", "stability.svg"})
    EXPECT_GT(fs::file_size(folder / figure), 1000u) << figure;
}

TEST(Stability, AMalformedTableIsNamed) {
  const fs::path folder = test::fresh_folder();
  StabilityOptions options;
  options.folder = folder.string();
  const auto message = [&](const std::string& content) -> std::string {
    std::ofstream(folder / "stability.csv") << content;
    try {
      measure_stability(options);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  const std::string file = (folder / "stability.csv").string();
  EXPECT_EQ(
      message("a,b\n"),
      file + ":1: expected method,order,damping_ratio,limit_measured,limit_theory, found 'a,b'");
  const std::string header = "method,order,damping_ratio,limit_measured,limit_theory\n";
  EXPECT_EQ(message(header + "adams_bashforth,3,0.2\n"),
            file +
                ":2: expected method,order,damping_ratio,limit_measured,limit_theory, found "
                "'adams_bashforth,3,0.2'");
  EXPECT_EQ(message(header + "adams_bashforth,3,0.2,x,1\n"),
            file + ":2: expected a number, found 'x' (column 'limit_measured')");
}

TEST(Stability, ScenesAreWrittenWithTheirFactor) {
  const fs::path folder = test::fresh_folder();
  write_stability_scenes({{"rod_flat", 3, 0.2, 1e-4, 0.99e-4, 3e-4}}, folder.string());
  EXPECT_EQ(test::text_of(folder / "stability_scenes.csv"),
            "scene,order,damping_ratio,limit_measured_s,limit_check_s,limit_single_contact_s,"
            "factor\nrod_flat,3,0.2,0.0001,9.9e-05,0.0003,3\n");
}

}  // namespace
}  // namespace rodpack

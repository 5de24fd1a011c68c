// SPDX-License-Identifier: GPL-2.0-or-later
// What `rodpack stress`, `profile` and `analyse` make of LIGGGHTS's own dumps is what they make of
// ours of the same step.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "liggghts_run.h"
#include "reading/table.h"
#include "stock_heap.h"

using namespace rodpack;
using namespace rodpack::test;
using testing::HasSubstr;

namespace {

// Each column of the one table is that of the other but for `slack` of its largest value.
void expect_close(const std::string& stock, const std::string& ours, double slack,
                  const std::vector<std::string>& names) {
  const auto mine = read_table(ours), theirs = read_table(stock);
  for (const auto& name : names) {
    const auto &expected = mine.column(name), &found = theirs.column(name);
    ASSERT_EQ(found.size(), expected.size());
    double largest = 0, off = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      largest = std::max(largest, std::abs(expected[k]));
      off = std::max(off, std::abs(found[k] - expected[k]));
    }
    EXPECT_GT(largest, 0) << name;
    EXPECT_LT(off, slack * largest) << name;
  }
}

// Forces without a spring in them are those that acted to what velocities change in half a step;
// LIGGGHTS takes centres and masses of its bodies from random points.
TEST(StockFields, StressAndProfileAreThoseOfOurDumps) {
  const auto folder = stock_heap("no_history");
  const std::string scale = " --ar 2.34 --scale 0.0035 --vertical y";
  const std::string stock_files = " spheres.dump --contacts pairs.dump " + stock_contacts;
  for (const std::string command : {"stress", "profile"}) {
    const auto made = [&](const std::string& files, const std::string& name) {
      auto words = command + files;
      words += scale;
      words += " -o ";
      words += name;
      words += "_";
      words += command;
      return run_rodpack(words, folder);
    };
    const auto ours = made(" bodies.dump", "ours");
    ASSERT_EQ(ours.exit_code, 0) << ours.output;
    const auto stock = made(stock_files, "stock");
    ASSERT_EQ(stock.exit_code, 0) << stock.output;
    EXPECT_THAT(stock.output, HasSubstr("evaluates forces anew after the step"));
  }
  const auto tables = [&](const std::string& name, double slack,
                          const std::vector<std::string>& columns) {
    expect_close((folder / ("stock_" + name)).string(), (folder / ("ours_" + name)).string(), slack,
                 columns);
  };
  tables("stress.csv", 0.02,
         {"number_density_1_m3", "mass_density_kg_m3", "momentum_density_y_kg_m2_s",
          "contact_stress_xx_N_m2", "contact_stress_xy_N_m2", "contact_stress_yx_N_m2",
          "contact_stress_yy_N_m2", "contact_stress_zz_N_m2", "kinetic_stress_yy_N_m2",
          "boundary_force_density_y_N_m3"});
  tables("profile.csv", 0.01,
         {"density_kg_m3", "stress_vertical_N_m2", "stress_horizontal_1_N_m2", "pressure_N_m2",
          "wall_force_N_m3"});
}

// A folder of LIGGGHTS's own dumps alone gives what one of ours gives.
TEST(StockFields, AnalysisIsThatOfOurDumps) {
  const auto folder = stock_heap("no_history");
  const auto put = [&](const std::string& from, const std::string& to) {
    std::filesystem::create_directories((folder / to).parent_path());
    std::filesystem::copy_file(folder / from, folder / to);
  };
  put("bodies.dump", "ours/bodies.dump");
  put("contacts.dump", "ours/contacts.dump");
  put("spheres.dump", "stock/bodies.dump");
  put("pairs.dump", "stock/contacts.dump");
  const auto analysed = [&](const std::string& arguments) {
    const auto run = run_rodpack("analyse " + arguments + " --vertical y --friction 0.3", folder);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    const auto name = arguments.substr(0, arguments.find(' '));
    return nlohmann::json::parse(text_of(folder / name / "analysis/summary.json"));
  };
  const auto ours = analysed("ours"), stock = analysed("stock " + stock_contacts);
  for (const char* key : {"particles", "coordination_number", "contacts_per_particle", "rattlers"})
    EXPECT_EQ(stock.at(key), ours.at(key)) << key;
  for (const char* key : {"mean_normal_force_N", "mean_tangential_force_N",
                          "mobilised_friction_mean", "contact_normals_S2", "bed_height_m"})
    EXPECT_NEAR(stock.at(key).get<double>(), ours.at(key).get<double>(),
                0.01 * std::abs(ours.at(key).get<double>()))
        << key;
  for (const char* name : {"fields.csv", "profile.csv", "forces_coordination.csv",
                           "vtk/contacts.10000.vtp", "vtk/capsules.10000.vtp"})
    EXPECT_TRUE(std::filesystem::exists(folder / "stock/analysis" / name)) << name;
  EXPECT_THAT(stock.at("notes").dump(), HasSubstr("evaluates forces anew after the step"));

  // Without the words the contacts are left out, by name.
  const auto without = analysed("stock");
  EXPECT_FALSE(without.contains("coordination_number"));
  EXPECT_THAT(without.at("notes").dump(), HasSubstr("are read with --local"));
  EXPECT_FALSE(std::filesystem::exists(folder / "stock/analysis/vtk/contacts.10000.vtp"));
}

}  // namespace

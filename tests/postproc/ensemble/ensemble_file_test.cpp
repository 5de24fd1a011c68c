// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "../synthetic_packing.h"
#include "ensemble/ensemble.h"
#include "ensemble/ensemble_field.h"
#include "liggghts_run.h"
#include "reading/data_error.h"
#include "reading/table.h"
#include "reading/text_file.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
namespace fs = std::filesystem;

const double none = std::nan("");

Ensemble some_ensemble() {
  EnsembleCase one;
  one.name = "smooth-AR5";
  one.parameters = {{"aspect_ratio", 5}, {"surface", "smooth"}};
  one.runs = {"runs/smooth-AR5/seed-1", "runs/smooth-AR5/seed-2"};
  one.seeds = {1, 2};
  one.numbers["solid_fraction"] = {1.0 / 3, 0.1 / 3, 2};
  one.numbers["single"] = {0.1 + 0.2, std::nullopt, 1};
  one.numbers["wall_time_s"] = {1.0 / 7, 0.01, 2};
  one.curves["rdf.g"] = {"r_over_dp",
                         {0.05, 0.15, 1.0 / 7},
                         {{1e-300, 0.0, 2}, {M_PI, {}, 1}, {none, {}, 0}},
                         {{0.1 / 3, none, 1}, {M_PI, 2, 3e-5}}};
  one.curves["profile.pressure_N_m"] = {"h_over_dp", {0}, {{1, 2.0, 3}}, {}};
  EnsembleCase other;
  other.name = "another";
  other.runs = {"x"};
  other.seeds = {7};
  other.parameters = nlohmann::ordered_json::object();
  return {{one, other}, {"a note", "and \"another\" µ"}};
}

void expect_same(const EnsembleMean& a, const EnsembleMean& b) {
  EXPECT_TRUE(a.mean == b.mean || (std::isnan(a.mean) && std::isnan(b.mean)));
  EXPECT_EQ(a.sem, b.sem);
  EXPECT_EQ(a.n, b.n);
}

TEST(EnsembleFile, RoundTripIsExact) {
  const auto folder = fresh_folder() / "new" / "folder";
  const Ensemble written = some_ensemble();
  write_ensemble(written, folder.string());
  const Ensemble read = read_ensemble((folder / "ensemble.json").string());
  EXPECT_EQ(read.notes, written.notes);
  ASSERT_EQ(read.cases.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto &a = written.cases[k], &b = read.cases[k];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.parameters, b.parameters);
    EXPECT_EQ(a.runs, b.runs);
    EXPECT_EQ(a.seeds, b.seeds);
    ASSERT_EQ(a.numbers.size(), b.numbers.size());
    for (const auto& [name, mean] : a.numbers) expect_same(mean, b.numbers.at(name));
    ASSERT_EQ(a.curves.size(), b.curves.size());
    for (const auto& [name, curve] : a.curves) {
      const auto& other = b.curves.at(name);
      EXPECT_EQ(curve.abscissa, other.abscissa);
      EXPECT_EQ(curve.x, other.x);
      ASSERT_EQ(curve.of_runs.size(), other.of_runs.size());
      for (std::size_t run = 0; run < curve.of_runs.size(); ++run)
        EXPECT_THAT(other.of_runs[run],
                    testing::Pointwise(testing::NanSensitiveDoubleEq(), curve.of_runs[run]));
      ASSERT_EQ(curve.y.size(), other.y.size());
      for (std::size_t i = 0; i < curve.y.size(); ++i) expect_same(curve.y[i], other.y[i]);
    }
  }
}

TEST(EnsembleFile, NumbersStandWhereUsersLookForThem) {
  const auto folder = fresh_folder();
  write_ensemble(some_ensemble(), folder.string());
  std::ifstream in(folder / "ensemble.json");
  const auto json = nlohmann::json::parse(in);
  const auto& one = json.at("cases").at("smooth-AR5");
  EXPECT_EQ(one.at("solid_fraction").at("mean"), 1.0 / 3);
  EXPECT_EQ(one.at("solid_fraction").at("n"), 2);
  EXPECT_TRUE(one.at("single").at("sem").is_null());
  EXPECT_FALSE(one.contains("wall_time_s")) << "another number each time that a study is run";
  EXPECT_THAT(read_text((folder / "cost.json").string()), testing::HasSubstr("wall_time_s"));
  EXPECT_EQ(one.at("curves").at("rdf").at("g").at("mean")[1], M_PI);
  EXPECT_EQ(one.at("curves").at("profile").at("pressure_N_m").at("abscissa"), "h_over_dp");
  const auto numbers = read_table((folder / "numbers.csv").string(), "case,number,mean,sem,n");
  EXPECT_EQ(numbers.words("number"), (std::vector<std::string>{"single", "solid_fraction"}));
  EXPECT_EQ(numbers.words("case")[1], "smooth-AR5");
  EXPECT_NEAR(numbers.column("mean")[1], 1.0 / 3, 1e-10);
  EXPECT_EQ(numbers.words("sem")[0], "nan");
  const auto table = read_table((folder / "smooth-AR5_rdf.csv").string(), "r_over_dp,g,g_sem,g_n");
  EXPECT_EQ(table.column("g_n"), (std::vector<double>{2, 1, 0}));
}

TEST(EnsembleFile, TablesOfCasesThatAreNoMoreAreRemoved) {
  const auto folder = fresh_folder();
  write_ensemble(some_ensemble(), folder.string());
  test::put(folder / "mine.csv", "x\n");
  Ensemble other = some_ensemble();
  other.cases[0].name = "renamed";
  write_ensemble(other, folder.string());
  EXPECT_FALSE(fs::exists(folder / "smooth-AR5_rdf.csv"));
  EXPECT_TRUE(fs::exists(folder / "renamed_rdf.csv"));
  EXPECT_TRUE(fs::exists(folder / "mine.csv"));
}

TEST(EnsembleFile, WhatIsNoneIsRefused) {
  const auto folder = fresh_folder();
  const auto error_of = [&](const std::string& text) -> std::string {
    const auto file = test::put(folder / "e.json", text);
    try {
      read_ensemble(file);
    } catch (const DataError& error) {
      return std::string(error.what()).substr(folder.string().size());
    }
    return "no error";
  };
  EXPECT_EQ(error_of("{}"),
            "/e.json: expected a JSON object with \"format\": \"rodpack-ensemble 1\"");
  EXPECT_EQ(error_of("half a fi"), "/e.json:1: expected a JSON object, found an error in it here");
  EXPECT_THAT(error_of(R"({"format": "rodpack-ensemble 1", "cases": {"a": 1}, "notes": []})"),
              testing::StartsWith("/e.json: is not as `rodpack ensemble` writes it"));
  EXPECT_THROW(read_ensemble((folder / "none.json").string()), DataError);
}

TEST(EnsembleFieldFile, IsReadBackAsItWasWritten) {
  const auto file = (fresh_folder() / "f.csv").string();
  EnsembleField field{{0, 0.5}, {0, 1, 2}, {}, {}};
  for (int k = 0; k < 6; ++k) {
    field.solid_fraction.push_back({0.125 * k, 0.25, 3});
    field.pressure.push_back({2.0 * k, {}, 1});
  }
  write_ensemble_field(field, file);
  const auto read = read_ensemble_field(file);
  EXPECT_EQ(read.x, field.x);
  EXPECT_EQ(read.y, field.y);
  ASSERT_EQ(read.solid_fraction.size(), 6U);
  for (std::size_t k = 0; k < 6; ++k) {
    expect_same(read.solid_fraction[k], field.solid_fraction[k]);
    expect_same(read.pressure[k], field.pressure[k]);
  }
}

}  // namespace

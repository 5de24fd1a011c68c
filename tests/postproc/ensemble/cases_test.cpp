// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

#include "ensemble/case_name.h"
#include "liggghts_run.h"
#include "reading/data_error.h"
#include "run_folders.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::MadeUpRun;
using rodpack::test::put;
using testing::ElementsAre;
using Json = nlohmann::json;
namespace fs = std::filesystem;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of_cases(const fs::path& folder) {
  return error_of([&] { find_cases({folder.string()}, folder.string(), false); });
}

MadeUpRun run_of(long seed, const Json& changes = Json::object()) {
  MadeUpRun run;
  run.seed = seed;
  run.parameters.update(changes);
  return run;
}

TEST(CaseName, SaysShapeAndWhatDiffersFromThePaper) {
  EXPECT_EQ(case_name({{"aspect_ratio", 1}, {"surface", "smooth"}}), "spheres");
  EXPECT_EQ(case_name({{"aspect_ratio", 2}, {"surface", "coarse"}}), "coarse-AR2");
  EXPECT_EQ(case_name({{"aspect_ratio", 7}, {"surface", "smooth"}, {"curvature_deg", 0}}),
            "smooth-AR7");
  EXPECT_EQ(case_name({{"aspect_ratio", 5}, {"surface", "smooth"}, {"curvature_deg", 60}}),
            "curved-AR5-theta60");
  EXPECT_EQ(case_name({{"aspect_ratio", 2.5}, {"surface", "overlap"}, {"overlap", 0.3}}),
            "overlap0.3-AR2.5");
  const Json paper = {{"aspect_ratio", 5},
                      {"normal_stiffness_N_m", 2000},
                      {"tangential_stiffness_N_m", 1000},
                      {"damping_ratio_normal", 0.2},
                      {"damping_ratio_tangential", 0.2},
                      {"friction", 0.3}};
  const auto with = [&](const Json& changes) {
    auto changed = paper;
    changed.update(changes);
    return case_name(changed);
  };
  EXPECT_EQ(with(Json::object()), "smooth-AR5");
  EXPECT_EQ(with({{"normal_stiffness_N_m", 4000}, {"tangential_stiffness_N_m", 2000}}),
            "smooth-AR5-kn4000");
  EXPECT_EQ(with({{"normal_stiffness_N_m", 4000}}), "smooth-AR5-kn4000-kt1000");
  EXPECT_EQ(with({{"damping_ratio_normal", 0.4}, {"damping_ratio_tangential", 0.4}}),
            "smooth-AR5-eta0.4");
  EXPECT_EQ(with({{"damping_ratio_normal", 0.4}}), "smooth-AR5-etan0.4");
  EXPECT_EQ(with({{"friction", 0.1}}), "smooth-AR5-mu0.1");
}

TEST(Cases, RunsWithoutMassScalingGoWithThoseOfBeforeThereWasAny) {
  const auto folder = fresh_folder();
  run_of(1).write(folder / "a");
  run_of(2, {{"mass_scaling", 0}}).write(folder / "b");
  run_of(3, {{"mass_scaling", 5}}).write(folder / "c");
  const auto found = find_cases({folder.string()}, folder.string(), false);
  ASSERT_EQ(found.cases.size(), 2U);
  EXPECT_EQ(found.cases[0].runs.size() + found.cases[1].runs.size(), 3U);
  for (const auto& one : found.cases)
    EXPECT_EQ(one.parameters.contains("mass_scaling"), one.runs.front().seed == 3);
}

TEST(Cases, RunsAreSortedByTheirParametersWhateverTheOrderOfFolders) {
  const auto folder = fresh_folder();
  run_of(2, {{"engine", "spheres"}}).write(folder / "a");
  run_of(1).write(folder / "deep" / "er" / "b");
  run_of(10).write(folder / "c");
  run_of(1, {{"aspect_ratio", 1}}).write(folder / "d");
  run_of(1, {{"curvature_deg", 30}, {"aspect_ratio", 3}}).write(folder / "e");
  run_of(1, {{"aspect_ratio", 7}, {"surface", "coarse"}}).write(folder / "f");
  const auto names = [&](const std::vector<std::string>& folders) {
    const auto found = find_cases(folders, folder.string(), false);
    std::vector<std::string> text;
    for (const auto& one : found.cases) {
      text.push_back(one.name);
      for (const auto& run : one.runs) text.back() += " " + run.name;
    }
    return text;
  };
  const std::vector<std::string> expected = {"spheres d", "coarse-AR7 f",
                                             "smooth-AR5 deep/er/b a c", "curved-AR3-theta30 e"};
  EXPECT_EQ(names({folder.string()}), expected);
  std::vector<std::string> single;
  for (const char* run : {"f", "e", "c", "a", "d", "deep", "a"}) single.push_back(folder / run);
  EXPECT_EQ(names(single), expected);
}

TEST(Cases, SameNameWithOtherParametersIsToldApart) {
  const auto folder = fresh_folder();
  run_of(1, {{"particles", 3000}}).write(folder / "a");
  run_of(1, {{"particles", 9000}}).write(folder / "b");
  const auto found = find_cases({folder.string()}, folder.string(), false);
  ASSERT_EQ(found.cases.size(), 2U);
  EXPECT_EQ(found.cases[0].name, "smooth-AR5-particles3000");
  EXPECT_EQ(found.cases[1].name, "smooth-AR5-particles9000");
}

TEST(Cases, SeveralVersionsOfRodpackAreNoted) {
  const auto folder = fresh_folder();
  run_of(1).write(folder / "a");
  auto parameters = run_of(2).all_parameters(folder / "b");
  parameters["rodpack"]["version"] = "0.1";
  run_of(2).write(folder / "b");
  put(folder / "b" / "parameters.json", parameters.dump());
  EXPECT_THAT(find_cases({folder.string()}, folder.string(), false).notes,
              ElementsAre("the runs were made by several versions of rodpack: 0.1 (1 runs), " +
                          std::string(version()) + " (1 runs)"));
}

TEST(Cases, EqualSeedsAreRefused) {
  const auto folder = fresh_folder();
  run_of(3).write(folder / "a");
  run_of(3).write(folder / "b");
  EXPECT_EQ(error_of_cases(folder),
            (folder / "b").string() + ": seed 3 of case smooth-AR5, expected another one than in " +
                (folder / "a").string());
}

TEST(Cases, AnUnfinishedRunIsRefusedOrLeftOutWithANote) {
  const auto folder = fresh_folder();
  run_of(1).write(folder / "a");
  run_of(2).write(folder / "b");
  fs::remove(folder / "b" / "result.json");
  EXPECT_EQ(error_of_cases(folder),
            (folder / "b").string() +
                ": the run has not finished (no result.json); expected finished runs, or "
                "--allow-missing to leave others out");
  const auto found = find_cases({folder.string()}, folder.string(), true);
  ASSERT_EQ(found.cases.size(), 1U);
  EXPECT_EQ(found.cases[0].runs.size(), 1U);
  EXPECT_THAT(found.notes, ElementsAre("left out: b, the run has not finished (no result.json)"));
}

TEST(Cases, FoldersWithoutRunsAreRefused) {
  const auto folder = fresh_folder();
  EXPECT_EQ(error_of_cases(folder / "none"), (folder / "none").string() + ": no such folder");
  EXPECT_EQ(error_of_cases(folder),
            folder.string() + ": no run folder in it, expected one with parameters.json");
}

/// Two cases of two runs each.
struct Study {
  fs::path folder = fresh_folder();
  Json cases = {{"format", "rodpack-study 1"},
                {"columns", {"aspect_ratio"}},
                {"cases",
                 {{"rods", {{"seeds", {1, 2}}, {"parameters", {{"aspect_ratio", 5}}}}},
                  {"long", {{"seeds", {1, 2}}, {"parameters", {{"aspect_ratio", 7}}}}}}}};

  Study() {
    for (const long seed : {1L, 2L}) {
      write("rods", seed, Json::object());
      write("long", seed, {{"aspect_ratio", 7}});
    }
  }
  fs::path run(const std::string& name, long seed) const {
    return folder / "runs" / name / ("seed-" + std::to_string(seed));
  }
  void write(const std::string& name, long seed, const Json& changes) const {
    run_of(seed, changes).write(run(name, seed));
  }
  FoundCases find(bool allow_missing = false) const {
    put(folder / "cases.json", cases.dump());
    return find_cases({folder.string()}, folder.string(), allow_missing);
  }
  std::string error() const {
    return error_of([&] { find(); });
  }
};

TEST(StudyCases, AreThoseOfTheTable) {
  const Study study;
  const auto found = study.find();
  ASSERT_EQ(found.cases.size(), 2U);
  EXPECT_EQ(found.cases[0].name, "rods");
  EXPECT_EQ(found.cases[1].name, "long");
  EXPECT_EQ(found.cases[1].runs[1].name, "runs/long/seed-2");
  EXPECT_EQ(found.cases[1].runs[1].seed, 2);
}

TEST(StudyCases, MissingRunsAreRefusedTogetherOrNoted) {
  const Study study;
  fs::remove_all(study.run("rods", 2));
  fs::remove(study.run("long", 1) / "result.json");
  EXPECT_EQ(study.error(),
            study.run("long", 1).string() +
                ": the run has not finished (no result.json), nor have 1 other runs; expected "
                "finished runs, or --allow-missing to leave others out");
  EXPECT_THAT(study.find(true).notes,
              ElementsAre("left out: runs/long/seed-1, the run has not finished (no result.json)",
                          "left out: runs/rods/seed-2, there is no such run"));
}

TEST(StudyCases, WhatTheWorkflowLeftOutIsNoted) {
  Study study;
  study.cases["left_out"] = {"rods seed 3"};
  EXPECT_THAT(study.find().notes, ElementsAre("left out: rods seed 3, as cases.json says"));
}

TEST(StudyCases, ARunThatDiffersFromItsCaseIsRefused) {
  Study study;
  study.write("rods", 2, {{"friction", 0.4}});
  EXPECT_EQ(study.error(), study.run("rods", 2).string() +
                               ": friction is 0.4, expected no such parameter as in " +
                               study.run("rods", 1).string() + ", the same case rods");
  study.write("rods", 1, {{"friction", 0.3}});
  EXPECT_EQ(study.error(), study.run("rods", 2).string() +
                               ": friction is 0.4, expected 0.3 as in " +
                               study.run("rods", 1).string() + ", the same case rods");
}

TEST(StudyCases, ARunThatDiffersFromTheTableIsRefused) {
  Study study;
  study.write("long", 2, {{"aspect_ratio", 6}});
  EXPECT_EQ(study.error(), study.run("long", 2).string() +
                               ": aspect_ratio is 6, expected 7 as the study's cases.json has for "
                               "case long");
  study.write("long", 2, {{"aspect_ratio", 7}});
  run_of(9, {{"aspect_ratio", 7}}).write(study.run("long", 2));
  EXPECT_EQ(study.error(),
            study.run("long", 2).string() + ": seed is 9, expected 2 by the name of the folder");
}

TEST(StudyCases, CasesThatDifferInWhatTheTableDoesNotNameAreRefused) {
  Study study;
  for (const long seed : {1L, 2L}) {
    study.write("rods", seed, {{"timestep_s", 1e-5}});
    study.write("long", seed, {{"timestep_s", 2e-5}, {"aspect_ratio", 7}});
  }
  EXPECT_EQ(study.error(), study.run("rods", 1).string() +
                               ": timestep_s is 1e-05, expected 2e-05 as in " +
                               study.run("long", 1).string() +
                               ", since the table of the study names no such column");
  study.cases["columns"].push_back("timestep");
  EXPECT_EQ(study.error(), "no error") << "a column of the table may differ";
}

TEST(StudyCases, ATableThatIsNoneIsRefused) {
  Study study;
  study.cases["format"] = "something";
  EXPECT_EQ(study.error(), (study.folder / "cases.json").string() +
                               ": expected a JSON object with \"format\": \"rodpack-study 1\"");
  study.cases["format"] = "rodpack-study 1";
  study.cases["cases"]["../x"] = study.cases["cases"]["rods"];
  EXPECT_EQ(study.error(), (study.folder / "cases.json").string() +
                               ": case '../x', expected a name that can be that of a folder");
  study.cases["cases"] = {{"rods", 3}};
  EXPECT_THAT(study.error(), testing::StartsWith((study.folder / "cases.json").string() +
                                                 ": is not as the workflow of a study writes it"));
  study.cases["cases"] = 3;
  EXPECT_EQ(study.error(), (study.folder / "cases.json").string() + ": expected an object 'cases'");
}

}  // namespace

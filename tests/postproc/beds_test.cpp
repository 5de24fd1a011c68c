// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/beds/beds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "liggghts_run.h"
#include "reading/data_error.h"

namespace {

using namespace rodpack;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr int rods = 60;

BedRow bed(const BedModel& model, int seed, double solid_fraction = 0.8) {
  BedRow row;
  row.model = model;
  row.seed = seed;
  row.rods = rods;
  row.kinetic = 1e-12;
  row.elastic = 2e-6;
  row.carried_weight = 1.001;
  row.height = 6;
  row.solid_fraction = solid_fraction;
  row.order = 0.9;
  row.neighbours = 2.5;
  row.contacts = 13;
  row.overlap = 1e-3;
  row.mean_force = 0.01;
  row.largest_force = 0.04;
  row.step_over_limit = 0.5;
  row.steps = std::lround(1.1 / model.step);
  row.seconds_per_step = 5e-5;
  return row;
}

BedModel step_model(double step, const std::string& method = "ab3e") {
  BedModel model;
  model.method = method;
  model.step = step;
  model.planar = method != "builtin";
  return model;
}

// Two seeds, 0.01 below and above the mean, or the other way round: a difference between the two
// ways is 0.02 below and above its mean, with a standard error of 0.02
void add_pair(std::vector<BedRow>& rows, const BedModel& model, double solid_fraction,
              bool turned = false) {
  const double half = turned ? -0.01 : 0.01;
  rows.push_back(bed(model, 1, solid_fraction - half));
  rows.push_back(bed(model, 2, solid_fraction + half));
}

BedComparison steps_of(const std::string& method) {
  for (const auto& comparison : bed_comparisons({method}))
    if (comparison.name == "step_" + method) return comparison;
  throw std::logic_error(method);
}

std::string message_of(const fs::path& file, const std::string& content) {
  std::ofstream(file) << content;
  try {
    read_bed_rows(file.string());
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

// 1, 2, 6: mean 3, variance (4 + 1 + 9)/2 = 7, standard error sqrt(7/3)
TEST(Beds, MeansCarryTheStandardErrorOfTheSeeds) {
  const auto mean = seed_mean({1, 2, 6});
  EXPECT_EQ(mean.seeds, 3);
  EXPECT_NEAR(mean.value, 3, 1e-15);
  EXPECT_NEAR(mean.error, std::sqrt(7.0 / 3), 1e-15);
  EXPECT_EQ(seed_mean({4}).error, 0);
  EXPECT_EQ(seed_mean({}).seeds, 0);
  EXPECT_NEAR(in_standard_errors({3, -10, 4}), 2.5, 1e-15);
  EXPECT_EQ(in_standard_errors({1, 0, 0}), 0);
  EXPECT_TRUE(std::isinf(in_standard_errors({1, 10, 0})));
}

TEST(Beds, RestNeedsAllRodsLittleMotionAndTheWeightCarried) {
  const auto changed = [](auto change) {
    BedRow row = bed({}, 1);
    change(row);
    return row.at_rest(rods);
  };
  EXPECT_TRUE(changed([](BedRow&) {}));
  EXPECT_FALSE(changed([](BedRow& row) { row.rods = rods - 1; }));
  EXPECT_FALSE(changed([](BedRow& row) { row.kinetic = 1.01e-5 * row.elastic; }));
  EXPECT_TRUE(changed([](BedRow& row) { row.kinetic = 0.99e-5 * row.elastic; }));
  EXPECT_FALSE(changed([](BedRow& row) { row.carried_weight = 0.989; }));
  EXPECT_FALSE(changed([](BedRow& row) { row.carried_weight = 1.011; }));
}

// What the seeds have in common cancels: differences 0.01, 0.01, 0.04; the fourth has no partner
TEST(Beds, DifferencesAreTakenSeedBySeed) {
  std::vector<BedRow> rows;
  const double finest[] = {0.6, 0.7, 0.8}, other[] = {0.61, 0.71, 0.84, 0.1};
  for (int k = 0; k < 3; ++k) rows.push_back(bed(step_model(0.55e-5), k + 1, finest[k]));
  for (int k = 3; k >= 0; --k) rows.push_back(bed(step_model(1.1e-5), k + 1, other[k]));
  const auto steps = summarise_beds(rows, steps_of("ab3e"), rods);
  ASSERT_EQ(steps.size(), 2u);
  const auto& difference = steps.front().differences.front();
  EXPECT_EQ(difference.seeds, 3);
  EXPECT_NEAR(difference.value, 0.02, 1e-12);
  EXPECT_NEAR(difference.error, 0.01, 1e-12);
  EXPECT_NEAR(steps.front().worst, 2, 1e-9);
  rows[2].kinetic = 1;  // the third of the finest does not rest
  EXPECT_EQ(summarise_beds(rows, steps_of("ab3e"), rods).front().differences.front().seeds, 2);
}

// Steps 0.55, 1.1, 1.65, 2.2, 2.75 e-5 s; standard error of a difference 0.02
TEST(Beds, StepGrowsUntilAMeanLeavesTheErrors) {
  std::vector<BedRow> rows;
  add_pair(rows, step_model(0.55e-5), 0.80);
  add_pair(rows, step_model(1.1e-5), 0.81, true);
  add_pair(rows, step_model(1.65e-5), 0.85, true);
  add_pair(rows, step_model(2.2e-5), 0.80, true);
  add_pair(rows, step_model(2.75e-5), 0.90, true);
  const auto steps = summarise_beds(rows, steps_of("ab3e"), rods);
  ASSERT_EQ(steps.size(), 5u);
  EXPECT_NEAR(steps[2].worst, 2.5, 1e-9);
  EXPECT_EQ(steps[2].worst_of, "φ");
  EXPECT_EQ(largest_step_within(steps, 2), 1.1e-5);  // a later step that agrees does not count
  EXPECT_EQ(largest_step_within(steps, 3), 2.2e-5);
  EXPECT_EQ(largest_step_within(steps, 0.4), 0.55e-5);
}

// One run that is awake ends the growth, however well the means of the others agree
TEST(Beds, StepGrowsOnlyWhileAllRunsComeToRest) {
  std::vector<BedRow> rows;
  for (const double step : {0.55e-5, 1.1e-5, 1.65e-5})
    add_pair(rows, step_model(step), 0.8, step > 1e-5);
  auto awake = rows;
  awake[3].kinetic = 1e-3;
  EXPECT_EQ(largest_step_within(summarise_beds(rows, steps_of("ab3e"), rods), 2), 1.65e-5);
  EXPECT_EQ(largest_step_within(summarise_beds(awake, steps_of("ab3e"), rods), 2), 0.55e-5);
  awake[0].rods = 59;
  EXPECT_FALSE(largest_step_within(summarise_beds(awake, steps_of("ab3e"), rods), 2));
  EXPECT_FALSE(largest_step_within({}, 2));
}

TEST(Beds, EveryComparedQuantityCounts) {
  const std::pair<const char*, void (*)(BedRow&)> changes[] = {
      {"S₂", [](BedRow& row) { row.order -= 0.5; }},
      {"E_p", [](BedRow& row) { row.elastic *= 2; }},
      {"neighbours", [](BedRow& row) { row.neighbours += 1; }}};
  for (const auto& [name, change] : changes) {
    std::vector<BedRow> rows;
    add_pair(rows, step_model(0.55e-5), 0.8);
    add_pair(rows, step_model(1.1e-5), 0.8);
    change(rows[2]);
    change(rows[3]);
    const auto steps = summarise_beds(rows, steps_of("ab3e"), rods);
    EXPECT_EQ(steps.front().worst_of, name);
    EXPECT_EQ(largest_step_within(steps, 1e6), 0.55e-5);
  }
}

// 5e-5 s a step: per simulated second 1/2 of the paper's at twice its step
TEST(Beds, CostIsThatOfASimulatedSecond) {
  std::vector<BedRow> rows;
  for (int seed = 1; seed <= 3; ++seed) rows.push_back(bed(step_model(2.2e-5), seed));
  rows[0].seconds_per_step = 1;  // one disturbed run
  EXPECT_NEAR(bed_cost(rows, step_model(2.2e-5)), 5e-5 / 2.2e-5, 1e-12);
  EXPECT_EQ(bed_cost(rows, {}), 0);
}

TEST(Beds, ComparisonsCanBeChosen) {
  const auto chosen = bed_comparisons({"ab3"}, {"engine", "step_ab3"});
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_TRUE(chosen[0].models.front().engine);
  EXPECT_FALSE(chosen[0].models.front() == chosen[0].models.back());
  EXPECT_EQ(chosen[1].name, "step_ab3");
  try {
    bed_comparisons({"ab3"}, {"engines"});
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--comparisons: expected one of surface planar engine"));
  }
}

TEST(Beds, ComparisonsVaryOneThing) {
  const auto all = bed_comparisons({"builtin", "ab3"});
  ASSERT_EQ(all.size(), 9u);
  for (const auto& comparison : all) {
    bool has_paper = false;
    for (const auto& model : comparison.models) {
      has_paper = has_paper || model == paper_model(comparison.by_engine());
      EXPECT_NO_THROW(accuracy_method(model.method));
      EXPECT_FALSE(model.method == "builtin" && model.planar);
      const bool scaled = comparison.name == "stiffness" && model.step != paper_step;
      if (scaled) {
        EXPECT_NEAR(model.step / paper_step, std::sqrt(2000 / model.stiffness), 1e-12);
      }
      EXPECT_TRUE(model.stiffness == 2000 || comparison.name == "stiffness");
      EXPECT_TRUE(model.overlap == 0.5 || comparison.name == "surface");
      EXPECT_TRUE(!(model.mass_scaling > 0) || comparison.name == "economy" ||
                  comparison.name == "presets");
    }
    EXPECT_EQ(has_paper, comparison.name.rfind("step_", 0) != 0) << comparison.name;
  }
  for (const auto& model : all[4].models) EXPECT_EQ(model.method, "builtin");
}

TEST(Beds, FrontierIsByTheEngineAndHeldAgainstHalfThePapersStep) {
  const auto frontier = bed_comparisons({}, {"frontier"}).front();
  EXPECT_TRUE(frontier.by_engine());
  EXPECT_FALSE(bed_comparisons({}, {"engine"}).front().by_engine());
  BedModel finest = paper_model(true);
  finest.step = 0.5 * paper_step;
  EXPECT_TRUE(frontier.models.back() == finest);
  const auto economy = bed_comparisons({}, {"economy"}).front();
  EXPECT_TRUE(economy.by_engine());
  EXPECT_TRUE(economy.models.back() == paper_model(true));
}

// The step of `economy` is 0.9 y(S eta) / (S omega_0), with omega_0^2 = 2 k / m of a pair: it goes
// with the square root of the mass. That is of the smooth chain, coarse or not: spheres at the
// distance R, each of which adds to the one before 4/3 pi R^3 less their lens, 5/12 pi R^3; so
// 16 + 2 x 11 for AR = 2 and 16 + 4 x 11 for AR = 3. For the paper's rods it is what the deck
// takes.
TEST(Beds, PresetsKnowTheRodsOfTheScene) {
  BedScene two, three;
  two.aspect_ratio = 2;
  three.aspect_ratio = 3;
  two.surface = three.surface = "coarse";
  const auto of = [](const BedScene& scene) {
    return bed_comparisons({}, {"presets"}, scene).front();
  };
  for (const BedModel& model : of(two).models) EXPECT_EQ(model.overlap, 0);
  EXPECT_TRUE(of(two).models[1] == paper_model(true, two));
  EXPECT_NEAR(of(three).models[0].step / of(two).models[0].step, std::sqrt(60.0 / 38), 1e-12);
  const BedModel economy = of({}).models[0];
  EXPECT_EQ(economy.method, "leapfrog");
  EXPECT_EQ(economy.mass_scaling, 7);
  EXPECT_EQ(economy.relaxation_steps, 1);
  EXPECT_NEAR(economy.step, 4.74e-5, 0.01e-5);
  const auto frontier = bed_comparisons({}, {"frontier"}, two);
  for (const BedModel& model : frontier.front().models) EXPECT_EQ(model.overlap, 0);
}

// A step of the paper's model takes 5e-5 s by the engine and ten times that without: twice its step
// by the engine costs half of the former.
TEST(Beds, FrontierCostsAreRelativeToThePapersModelByTheEngine) {
  AccuracySettings settings;
  settings.bed_comparisons = {"frontier"};
  BedModel twice = paper_model(true);
  twice.step = 2 * paper_step;
  std::vector<BedRow> rows;
  for (const BedModel& model : {paper_model(false), paper_model(true), twice})
    for (int seed = 1; seed <= 2; ++seed) rows.push_back(bed(model, seed));
  rows[0].seconds_per_step = rows[1].seconds_per_step = 5e-4;
  const std::string section = beds_section(rows, settings);
  EXPECT_THAT(section, HasSubstr("### What is the cheapest way to a bed at rest?"));
  EXPECT_THAT(section, testing::ContainsRegex("ab3e engine \\| 22 [^\n]* \\| 0\\.5 \\|"));
  EXPECT_THAT(section, testing::ContainsRegex("ab3e engine \\| 11 [^\n]* \\| 1 \\|"));
}

TEST(Beds, RowsComeBackFromTheirText) {
  const fs::path file = rodpack::test::fresh_folder() / "beds.csv";
  EXPECT_TRUE(read_bed_rows(file.string()).empty());  // makes it
  BedModel model = step_model(paper_step / 3, "builtin");
  model.overlap = 0.875;
  model.stiffness = 1000;
  model.mass_scaling = 4;
  model.relaxation_steps = 1.5;
  BedRow row = bed(model, 7);
  row.mean_force = 1.0 / 3;
  row.contacts = 11.25;
  std::ofstream(file, std::ios::app) << bed_row_text(row) << '\n';
  const auto rows = read_bed_rows(file.string());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_TRUE(rows[0].model == model);
  EXPECT_EQ(rows[0].seed, 7);
  EXPECT_EQ(rows[0].contacts, 11.25);
  EXPECT_EQ(rows[0].steps, row.steps);
  EXPECT_EQ(bed_row_text(rows[0]), bed_row_text(row));
}

TEST(Beds, MalformedRowsAreNamed) {
  const fs::path file = rodpack::test::fresh_folder() / "beds.csv";
  read_bed_rows(file.string());
  std::ifstream in(file);
  std::string header;
  std::getline(in, header);
  const std::string row = bed_row_text(bed({}, 1));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = row;
    text.replace(text.find(from), from.size(), to);
    return message_of(file, header + "\n" + row + "\n" + text + "\n");
  };
  EXPECT_EQ(with("ab3e", "ab3e"), "no error");
  EXPECT_EQ(with(",yes,", ",engine,"), "no error");
  EXPECT_THAT(with(",2000,", ",2000N,"),
              HasSubstr("beds.csv:3: expected a number, found '2000N' (column "
                        "'normal_stiffness_N_m')"));
  EXPECT_THAT(with(",yes,", ",maybe,"),
              HasSubstr("beds.csv:3: expected yes, no or engine, found 'maybe' (column 'planar')"));
  EXPECT_THAT(with(",60,", ","), HasSubstr("beds.csv:3: expected method,timestep_s"));
  EXPECT_THAT(message_of(file, "seed\n"), HasSubstr("beds.csv:1: expected method,timestep_s"));
}

// 2 rods of 1 g, 0.1 m above the floor of a container 0.08 m wide, 4e-5 m^2 each: phi = 8e-5 / (2 x
// 0.1 x 0.08). One lies flat, one stands: S2 = 0. They touch in two spheres with (1, 2) + (2, 2) N,
// listed in either order: 5 N. The floor carries 0.015 N of 0.01962 N, the left wall 0.00462 N.
TEST(Beds, ARowHoldsWhatTheRunLeft) {
  const fs::path folder = rodpack::test::fresh_folder();
  const std::string frame = "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ";
  const std::string box = "ITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n";
  std::ofstream(folder / "fake")
      << "#!/bin/sh\necho \"$@\" > ../arguments\ncat > end.dump << EOD\n"
      << frame << "ATOMS\n2\n"
      << box
      << "ITEM: ATOMS id y angle area mass\n1 0.09 0 4e-5 1e-3\n2 0.11 1.5707963267948966 4e-5 "
         "1e-3\nEOD\ncat > contacts.dump << EOD\n"
      << frame << "ENTRIES\n4\n"
      << box
      << "ITEM: ENTRIES body_i body_j wall fx fy overlap_n\n1 2 0 1 2 3e-6\n2 1 0 -2 -2 9e-6\n"
         "1 0 1 0 0.015 6e-6\n2 0 1 0.5 0.00462 6e-6\nEOD\n"
         "echo '# kinetic_J elastic_J step_over_limit' > energies.txt\necho '1e-12 2e-6 0.4' >> "
         "energies.txt\n";
  fs::permissions(folder / "fake", fs::perms::owner_all);
  AccuracySettings settings;
  settings.liggghts.program = (folder / "fake").string();
  settings.inputs = RODPACK_REPOSITORY "/inputs";
  BedModel model;
  model.overlap = 0.75;
  model.mass_scaling = 4.5;
  model.relaxation_steps = 2;
  settings.bed_scene = {24, 5};
  const auto row = run_bed(settings, folder.string(), model, 3);
  EXPECT_EQ(row.rods, 2);
  EXPECT_EQ(row.seed, 3);
  EXPECT_EQ(row.steps, 150000);
  EXPECT_EQ(row.kinetic, 1e-12);
  EXPECT_EQ(row.elastic, 2e-6);
  EXPECT_EQ(row.step_over_limit, 0.4);
  EXPECT_NEAR(row.carried_weight, 1, 1e-12);
  EXPECT_NEAR(row.height, 0.1 / 3e-3, 1e-12);
  EXPECT_NEAR(row.solid_fraction, 8e-5 / 0.016, 1e-15);
  EXPECT_NEAR(row.order, 0, 1e-12);
  EXPECT_EQ(row.neighbours, 1);
  EXPECT_EQ(row.contacts, 2);
  EXPECT_NEAR(row.overlap, 2e-3, 1e-15);
  EXPECT_NEAR(row.mean_force, 5, 1e-12);
  EXPECT_NEAR(row.largest_force, 5, 1e-12);
  std::ostringstream arguments;
  arguments << std::ifstream(folder / "arguments").rdbuf();
  EXPECT_THAT(arguments.str(),
              HasSubstr("-var integrator multisphere/ab order 3 events yes mass_scaling 4.5 planar "
                        "yes "));
  EXPECT_THAT(arguments.str(), HasSubstr("-var style verlet "));
  EXPECT_THAT(arguments.str(),
              HasSubstr("-var lines 24 -var overlap 0.75 -var per_line 5 -var relaxation "
                        "2.1999999999999999e-05 -var seed 3"));
}

// A run that left no numbers is a row without rods; one that left nothing is an error
TEST(Beds, ARunBeyondAllBoundsIsARowWithoutRods) {
  const fs::path folder = rodpack::test::fresh_folder();
  const auto fake = [&](const std::string& script) {
    std::ofstream(folder / "fake") << "#!/bin/sh\n" << script;
    fs::permissions(folder / "fake", fs::perms::owner_all);
    AccuracySettings settings;
    settings.liggghts.program = (folder / "fake").string();
    settings.inputs = RODPACK_REPOSITORY "/inputs";
    return run_bed(settings, folder.string(), {}, 1);
  };
  const auto row = fake(
      "echo '# kinetic_J elastic_J step_over_limit' > energies.txt\necho 'nan nan inf' >> "
      "energies.txt\ncat > end.dump << EOD\n"
      "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
      "ITEM: ATOMS id y angle area mass\n1 nan nan 4e-5 1e-3\nEOD\n");
  EXPECT_EQ(row.rods, 0);
  EXPECT_EQ(row.elastic, 0);
  EXPECT_FALSE(row.at_rest(20));
  const std::string one_body =
      "cat > end.dump << EOD\nITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff "
      "ff\n0 1\n0 1\n0 1\nITEM: ATOMS id y angle area mass\n1 1 1 4e-5 1e-3\nEOD\n"
      "cat > contacts.dump << EOD\nITEM: TIMESTEP\n1\nITEM: NUMBER OF ENTRIES\n0\nITEM: BOX BOUNDS "
      "ff ff ff\n0 1\n0 1\n0 1\nITEM: ENTRIES body_i body_j wall fx fy overlap_n\nEOD\n"
      "echo '# kinetic_J elastic_J step_over_limit' > energies.txt\n";
  EXPECT_EQ(fake(one_body + "echo '1 1 1' >> energies.txt\n").rods, 1);
  EXPECT_EQ(fake(one_body + "echo 'nan 1 1' >> energies.txt\n").rods, 0);
  EXPECT_THROW(fake("true\n"), DataError);
  EXPECT_THROW(fake("echo 'ERROR: no' ; exit 1\n"), DataError);
}

// Paper 0.80 at cost 5e-5/1.1e-5; builtin the same at 2.2e-5, half the cost; 33 spheres 0.85.
// Standard error of a difference 0.02.
TEST(Beds, GuideIsComputedFromTheRows) {
  std::vector<BedRow> rows;
  const auto all = bed_comparisons({"builtin"});
  for (const auto& model : all.front().models)
    add_pair(rows, model, model.overlap > 0.8 ? 0.85 : 0.80, model.overlap < 0.8);
  for (const double step : {0.55e-5, 1.1e-5, 1.65e-5, 2.2e-5})
    add_pair(rows, step_model(step, "builtin"), 0.82, step == 0.55e-5);
  const auto guide = bed_guide(rows, {"builtin"}, rods);
  EXPECT_THAT(guide, HasSubstr("| how rough the rods are | 9 spheres, 2000 N/m | ab3e planar | 11 "
                               "| -0.050 ± 0.020 | 0 | φ, 2.5 | 1 |"));
  EXPECT_THAT(guide, HasSubstr("| 33 spheres, 2000 N/m | ab3e planar | 4.12 | reference | "
                               "reference | reference |"));
  EXPECT_THAT(guide, HasSubstr("| means of a bed, the longest step | 9 spheres, 2000 N/m | builtin "
                               "| 22 | 0.000 ± 0.020 | 0 | "));
  EXPECT_THAT(guide, HasSubstr(" | 0.5 |"));
  EXPECT_THAT(guide, HasSubstr("| planar or not | 9 spheres, 2000 N/m | builtin | 11 | 0.020 ±"));

  AccuracySettings settings;
  settings.bed_methods = {"builtin"};
  rows.back().kinetic = 1;  // the longest step, one run of two
  const auto section = beds_section(rows, settings);
  EXPECT_THAT(section, HasSubstr("means over 2 seeds"));
  EXPECT_THAT(section, HasSubstr("| builtin | 22 | 9 spheres, 2000 N/m | 1 of 2 |"));
  EXPECT_THAT(section, HasSubstr("| builtin | 16.5 | 22: 1 of 2 at rest | 16.5 |"));
  EXPECT_EQ(beds_section({}, settings), "");
}

TEST(Beds, FiguresAreDrawn) {
  const fs::path folder = rodpack::test::fresh_folder();
  std::vector<BedRow> rows;
  for (const auto& comparison : bed_comparisons({"ab3", "ab3e"}))
    for (const auto& model : comparison.models) add_pair(rows, model, 0.8);
  AccuracySettings settings;
  settings.bed_methods = {"ab3", "ab3e"};
  draw_beds(rows, settings, folder.string());
  for (const char* name :
       {"beds_step", "beds_surface", "beds_stiffness", "beds_frontier", "beds_economy"})
    for (const char* suffix : {".png", ".svg"})
      EXPECT_GT(fs::file_size(folder / (std::string(name) + suffix)), 5000u) << name << suffix;
}

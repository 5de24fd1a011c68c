// SPDX-License-Identifier: GPL-2.0-or-later
// The deck inputs/discharge/in.discharge on a small scale.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;
namespace fs = std::filesystem;

namespace {

using Vars = std::map<std::string, std::string>;

const std::string deck = "discharge/in.discharge";
constexpr double diameter = 3e-3;

/// 40 discs in a silo of 12 d_p, an orifice of 5 d_p: a second.
Vars small(const Vars& changes = {}) {
  Vars vars = {
      {"particles", "40"},         {"container_width", "0.036"}, {"orifice_width", "0.015"},
      {"particles_per_line", "5"}, {"settle_time", "0.1"},       {"flow_limit", "0.2"},
      {"shutter_speed", "0.5"},    {"restart_interval", "0.04"}, {"out", "run"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

nlohmann::json result_of(const fs::path& run) {
  return nlohmann::json::parse(text_of(run / "result.json"));
}

fs::path last_bodies(const fs::path& run) {
  return run / "dumps" /
         ("bodies." + std::to_string(result_of(run).at("step").get<long>()) + ".dump");
}

/// What is counted is all there is, nothing comes through the shutter, and at the end the count is
/// that of the bodies whose centres lie below the floor.
void expect_all_counted(const fs::path& run, double particles) {
  const auto result = result_of(run);
  const double opened = result.at("opened_at_s");
  const Table counts = read_table(run / "discharge.csv");
  for (std::size_t i = 0; i < counts.rows(); ++i) {
    EXPECT_NEAR(counts.column("inside")[i] + counts.column("discharged")[i],
                counts.column("particles")[i], 1e-9);
    if (counts.column("time_s")[i] < opened) {
      EXPECT_EQ(counts.column("discharged")[i], 0);
    }
  }
  EXPECT_EQ(counts.column("particles").back(), particles);
  EXPECT_NEAR(result.at("inside").get<double>() + result.at("discharged").get<double>(), particles,
              1e-9);
  const Table bodies = read_dump(last_bodies(run));
  ASSERT_EQ(bodies.rows(), particles);
  double below = 0, straddling = 0;
  for (std::size_t b = 0; b < bodies.rows(); ++b) {
    const double y = bodies.column("y")[b], reach = bodies.column("half_length")[b];
    below += y < -diameter;
    straddling += std::fabs(y + diameter) < reach;
  }
  EXPECT_NEAR(result.at("discharged").get<double>(), below, straddling);
  EXPECT_GT(below, particles / 2);
}

}  // namespace

TEST(Discharge, CountsEveryParticleOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    const auto run = run_liggghts(deck, small(), ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_all_counted(run.folder / "run", 40);
  }
}

TEST(Discharge, CountsRodsThatTheSphereStylesMove) {
  const auto run = run_liggghts(deck, small({{"aspect_ratio", "2"},
                                             {"particles", "16"},
                                             {"surface", "coarse"},
                                             {"particles_per_line", "4"},
                                             {"orifice_width", "0.021"},
                                             {"engine", "spheres"}}));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  expect_all_counted(run.folder / "run", 16);
}

// From a restart file of before the opening, while the shutter goes down, and of the flow, the run
// ends with the same bits: bodies, counts and result.
TEST(Discharge, ResumesExactly) {
  const auto whole = run_liggghts(deck, small());
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const fs::path run = whole.folder / "run";
  const std::string bodies = text_of(last_bodies(run)), counts = text_of(run / "discharge.csv");
  const std::string result = text_of(run / "result.json"), energies = text_of(run / "energies.csv");
  const double opened = result_of(run).at("opened_at_s");
  const long every = std::lround(std::ceil(0.04 / 1.1e-5));
  const auto before = static_cast<long>(opened / 1.1e-5) / every;
  // The later ones first: a run that goes on sets later restart files aside.
  for (const long file : {before + 4, before + 1, before}) {
    const auto restart = "run/restart/discharge." + std::to_string(file * every) + ".restart";
    ASSERT_TRUE(fs::exists(whole.folder / restart)) << restart;
    const auto resumed = run_liggghts_in(whole.folder, deck, small({{"resume", restart}}));
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(text_of(run / "result.json"), result);
    EXPECT_EQ(text_of(run / "discharge.csv"), counts);
    EXPECT_EQ(text_of(run / "energies.csv"), energies);
    EXPECT_EQ(text_of(last_bodies(run)), bodies);
  }
}

/// 200 discs, 24 d_p wide, an orifice of 6 d_p that a gate closes 0.12 s after its opening.
Vars closing() {
  return small({{"particles", "200"},
                {"container_width", "0.072"},
                {"particles_per_line", "11"},
                {"orifice_width", "0.018"},
                {"collector_depth", "0.1"},
                {"shutter_speed", "1"},
                {"close_after", "0.12"},
                {"rest_time", "0.1"},
                {"flow_limit", "3"}});
}

// Two particles more and the way that the gate leaves is blocked; what is above rests on floor and
// gate, the heap below on the collector's floor: each bed's walls carry its weight. What is left is
// mass times acceleration, of the order sqrt(E_k / E_p) = 3e-3 of the weight.
TEST(Discharge, GateStopsTheFlowAndBothBedsComeToRest) {
  const auto run = run_liggghts(deck, closing());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const fs::path folder = run.folder / "run";
  const auto result = result_of(folder);
  EXPECT_EQ(result.at("at_rest"), 1);
  const double out = result.at("discharged");
  EXPECT_GT(out, 20);
  EXPECT_LT(out, 160);
  // The last 0.5 s of the count: nothing came through.
  const Table counts = read_table(folder / "discharge.csv");
  for (std::size_t i = 0; i < counts.rows(); ++i)
    if (counts.column("since_opening_s")[i] > 0.4) {
      EXPECT_EQ(counts.column("discharged")[i], out);
    }

  const std::string step = std::to_string(result.at("step").get<long>());
  const Table heap = read_dump(folder / ("collector/bodies." + step + ".dump"));
  EXPECT_EQ(heap.rows(), out);
  EXPECT_EQ(read_dump(folder / ("silo/bodies." + step + ".dump")).rows(), 200 - out);
  for (const std::string bed : {"dumps", "silo", "collector"}) {
    const Table bodies = read_dump(folder / (bed + "/bodies." + step + ".dump"));
    const Table contacts = read_dump(folder / (bed + "/contacts." + step + ".dump"));
    double weight = 0, up = 0, along = 0;
    for (const double mass : bodies.column("mass")) weight += 9.81 * mass;
    for (std::size_t c = 0; c < contacts.rows(); ++c) {
      if (contacts.column("wall")[c] == 0) continue;
      along += contacts.column("fx")[c];
      up += contacts.column("fy")[c];
    }
    EXPECT_NEAR(up / weight, 1, 0.01) << bed;
    EXPECT_NEAR(along / weight, 0, 0.01) << bed;
  }
  // Before the opening the same bed is there whole.
  const auto opened = std::to_string(result.at("opened_at_step").get<long>());
  EXPECT_EQ(read_dump(folder / ("dumps/bodies." + opened + ".dump")).rows(), 200U);
  const auto said = run_rodpack("discharge run", run.folder);
  EXPECT_EQ(said.exit_code, 0) << said.output;
  EXPECT_THAT(said.output, testing::HasSubstr("closed at the end"));
  const auto profile = run_rodpack("profile run/silo/bodies." + step + ".dump", run.folder);
  EXPECT_EQ(profile.exit_code, 0) << profile.output;
}

// While the gate waits, slides (for 9 ms), and when it has closed.
TEST(Discharge, ResumesExactlyWhileTheGateIsAtWork) {
  const Vars vars = [] {
    Vars often = closing();
    often["restart_interval"] = "0.008";
    often["rest_time"] = "0.02";
    return often;
  }();
  const auto whole = run_liggghts(deck, vars);
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const fs::path run = whole.folder / "run";
  const std::string bodies = text_of(last_bodies(run)), result = text_of(run / "result.json");
  const std::string counts = text_of(run / "discharge.csv");
  const long every = std::lround(std::ceil(0.008 / 1.1e-5));
  const long closes =
      result_of(run).at("opened_at_step").get<long>() + std::lround(std::ceil(0.12 / 1.1e-5));
  for (const long file : {closes / every + 3, closes / every + 1, closes / every}) {
    Vars again = vars;
    again["resume"] = "run/restart/discharge." + std::to_string(file * every) + ".restart";
    ASSERT_TRUE(fs::exists(whole.folder / again["resume"])) << again["resume"];
    const auto resumed = run_liggghts_in(whole.folder, deck, again);
    ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
    EXPECT_EQ(text_of(run / "result.json"), result);
    EXPECT_EQ(text_of(run / "discharge.csv"), counts);
    EXPECT_EQ(text_of(last_bodies(run)), bodies);
  }
}

TEST(Discharge, RefusesWrongParameters) {
  const std::pair<Vars, std::string> wrong[] = {
      {{{"orifice_width", "-0.01"}}, "parameter 'orifice_width': expected above 0, got -0.01"},
      {{{"orifice_width", "0.004"}},
       "orifice_width: expected from 1.5 particle_diameter, 0.0045 m"},
      {{{"orifice_width", "0.031"}}, "container_width less 2 particle_diameter, 0.03 m, got 0.031"},
      {{{"close_after", "-1"}}, "parameter 'close_after': expected minimum 0, got -1"},
      {{{"close_after", "0.5"}},
       "container_width: expected with close_after at least 3 orifice_width and a "
       "particle_diameter, 0.048 m, for the gate, got 0.036"},
      {{{"close_after", "0.01"}, {"orifice_width", "0.0105"}, {"collector_depth", "0.1"}},
       "parameter close_after: expected 0, or as long as the shutter takes"},
      {{{"collector_depth", "0"}}, "parameter 'collector_depth': expected above 0, got 0"},
      {{{"collector_depth", "0.01"}}, "4 particle lengths and particle_diameter at least, 0.015 m"},
      {{{"shutter_speed", "-1"}}, "parameter 'shutter_speed': expected above 0, got -1"},
      {{{"surface", "coarse"}, {"overlap", "0.3"}}, "got 0.3 with surface coarse"},
      {{{"orifice_widht", "0.02"}}, "unknown deck parameter 'orifice_widht'"}};
  for (const auto& [vars, message] : wrong) {
    const auto run = run_liggghts(deck, small(vars));
    EXPECT_NE(run.exit_code, 0) << message;
    EXPECT_THAT(run.output, testing::HasSubstr(message));
    EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
  }
}

// 120 discs, 9 of whose layers the collector takes at best, stop the flow through an orifice that
// lets all pass.
TEST(Discharge, SaysThatTheCollectorIsFull) {
  const auto run = run_liggghts(deck, small({{"particles", "120"},
                                             {"collector_depth", "0.018"},
                                             {"flow_limit", "5"},
                                             {"rest_ratio", "1e-2"},
                                             {"rest_time", "0.05"}}));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_THAT(run.output, testing::HasSubstr("ERROR: the heap in the collector has grown up to"));
  EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
}

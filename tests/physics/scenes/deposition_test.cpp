// SPDX-License-Identifier: GPL-2.0-or-later
// The deck inputs/deposition/in.deposition on a small scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "liggghts_run.h"
#include "rodpack/version.h"

using namespace rodpack::test;
namespace fs = std::filesystem;

namespace {

using Vars = std::map<std::string, std::string>;

const std::string deck = "deposition/in.deposition";
constexpr double gravity = 9.81;

/// 24 particles in a narrow container: a few seconds.
Vars small(const Vars& changes = {}) {
  Vars vars = {{"particles", "24"},
               {"width_in_lengths", "5"},
               {"particles_per_line", "4"},
               {"container_height", "0.12"},
               {"out", "run"},
               {"relaxation_ratio", "1e-4"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

/// File run/dumps/KIND.N.dump with the largest N.
fs::path last_dump(const fs::path& run, const std::string& kind) {
  fs::path last;
  long largest = -1;
  for (const auto& entry : fs::directory_iterator(run / "dumps")) {
    const std::string name = entry.path().filename().string();
    if (name.rfind(kind + ".", 0) != 0) continue;
    const long step = std::stol(name.substr(kind.size() + 1));
    if (step <= largest) continue;
    largest = step;
    last = entry.path();
  }
  return last;
}

nlohmann::json json_of(const fs::path& file) { return nlohmann::json::parse(text_of(file)); }

/// A settled bed: all particles inside the container, planar, and carried by floor and walls.
void expect_settled(const fs::path& run, std::size_t particles, double width) {
  const Table bodies = read_dump(last_dump(run, "bodies"));
  ASSERT_EQ(bodies.rows(), particles);
  double weight = 0;
  for (std::size_t b = 0; b < particles; ++b) {
    weight += bodies.column("mass")[b] * gravity;
    EXPECT_GT(bodies.column("x")[b], 0);
    EXPECT_LT(bodies.column("x")[b], width);
    EXPECT_GT(bodies.column("y")[b], 0);
    for (const char* zero : {"z", "vz", "omegax", "omegay", "qx", "qy"})
      EXPECT_EQ(bodies.column(zero)[b], 0) << zero;
  }
  // At rest the walls' vertical forces add up to the weight and their horizontal ones to nothing;
  // what is left is the residual acceleration, of order sqrt(E_k/E_p) = 1e-2.
  const Table contacts = read_dump(last_dump(run, "contacts"));
  double vertical = 0, horizontal = 0;
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    if (contacts.column("wall")[c] == 0) continue;
    vertical += contacts.column("fy")[c];
    horizontal += contacts.column("fx")[c];
  }
  EXPECT_NEAR(vertical / weight, 1, 0.02);
  EXPECT_NEAR(horizontal / weight, 0, 0.02);

  // The contact forces on the spheres of all bodies carry the same weight.
  const Table spheres = read_dump(last_dump(run, "spheres"));
  double on_spheres = 0;
  for (const double fy : spheres.column("fy")) on_spheres += fy;
  EXPECT_NEAR(on_spheres / vertical, 1, 1e-9);
}

}  // namespace

TEST(Deposition, SettlesToABedThatTheWallsCarry) {
  const auto run = run_liggghts(deck, small());
  ASSERT_EQ(run.exit_code, 0) << run.output;
  expect_settled(run.folder / "run", 24, 5 * 5 * 3e-3);

  const Table energies = read_table(run.folder / "run/energies.csv");
  EXPECT_LE(energies.column("kinetic_over_elastic").back(), 1e-4);
  EXPECT_EQ(energies.column("particles").back(), 24);
  const nlohmann::json by = {{"version", rodpack::version()}, {"commit", rodpack::commit()}};
  const nlohmann::json result = json_of(run.folder / "run/result.json");
  EXPECT_EQ(result.at("crossed_pairs"), 0);
  EXPECT_EQ(result.at("rodpack"), by);
  const nlohmann::json parameters = json_of(run.folder / "run/parameters.json");
  EXPECT_EQ(parameters.at("aspect_ratio"), 5);
  EXPECT_EQ(parameters.at("timestep_s"), 1.1e-5);
  EXPECT_EQ(parameters.at("rodpack"), by);
}

TEST(Deposition, SettlesSpheresCoarseAndCurvedParticlesAndWithTheBuiltInIntegrator) {
  for (const Vars& kind :
       {Vars{{"aspect_ratio", "1"}, {"width_in_lengths", "12"}},
        Vars{{"aspect_ratio", "3"}, {"surface", "coarse"}},
        Vars{{"aspect_ratio", "12"}, {"surface", "coarse"}, {"line_fall", "0.05"}},
        Vars{{"aspect_ratio", "5"}, {"curvature", "120"}}, Vars{{"integrator", "builtin"}}}) {
    const auto run = run_liggghts(deck, small(kind));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const double lengths = kind.count("width_in_lengths") ? 12 : 5;
    const double ratio = kind.count("aspect_ratio") ? std::stod(kind.at("aspect_ratio")) : 5;
    expect_settled(run.folder / "run", 24, lengths * ratio * 3e-3);
  }
}

TEST(Deposition, RunsOnTwoRanks) {
  for (const char* engine : {"spheres", "planar"}) {
    const auto run = run_liggghts(deck, small({{"engine", engine}}), 2);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_settled(run.folder / "run", 24, 5 * 5 * 3e-3);
  }
}

// The paper's drop of 1.985 m: a rod of 0.25 g that lands on its end goes in by up to 3 mm, twice
// its radius. The planes of wall/gran throw five rods of the first ten lines out.
TEST(Deposition, WhatFallsFromTheTopStaysInTheContainer) {
  const auto run = run_liggghts(
      deck,
      {{"particles", "180"}, {"out", "run"}, {"relaxation_ratio", "1e-2"}, {"engine", "planar"}});
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(read_dump(last_dump(run.folder / "run", "bodies")).rows(), 180u);
}

// tests/benchmark holds the engine and the built-in against each other from one bed: the stock fix
// takes its restart file, once it has the built-in's name and no seal that would be wrong.
TEST(Deposition, BenchmarksGiveItsBedsToTheBuiltIn) {
  const auto bed = run_liggghts(deck, small({{"particles", "8"}}));
  ASSERT_EQ(bed.exit_code, 0) << bed.output;
  const std::string benchmark = RODPACK_REPOSITORY "/tests/benchmark/";
  const auto renamed = run_command(benchmark + "for_builtin.sh " + bed.folder.string() +
                                   "/run/restart/deposition.end.restart > builtin.restart");
  ASSERT_EQ(renamed.exit_code, 0) << renamed.output;
  const auto steps = run_liggghts_in(renamed.folder, text_of(benchmark + "in.steps"),
                                     {{"start", "builtin.restart"},
                                      {"method", "builtin"},
                                      {"width", "0.075"},
                                      {"warm_up", "5"},
                                      {"steps", "5"}});
  EXPECT_EQ(steps.exit_code, 0) << steps.output;
  EXPECT_NE(steps.output.find("for 5 steps with 72 atoms"), std::string::npos) << steps.output;
}

TEST(Deposition, SeedsGiveOtherPackingsAndTheSameSeedTheSameOne) {
  const auto y = [](const Vars& vars) {
    const auto run = run_liggghts(deck, small(vars));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return read_dump(last_dump(run.folder / "run", "bodies")).column("y");
  };
  const auto first = y({});
  EXPECT_EQ(first, y({}));
  EXPECT_NE(first, y({{"seed", "2"}}));
}

// The resumed run starts from a restart file in the middle of the landing and ends bit for bit
// where the uninterrupted one does.
TEST(Deposition, ResumesExactly) {
  const auto whole = run_liggghts(deck, small({{"restart_interval", "0.1"}}));
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const fs::path run = whole.folder / "run";
  const std::string last_bodies = text_of(last_dump(run, "bodies"));
  const std::string result = text_of(run / "result.json");
  const long every = std::lround(std::ceil(0.1 / 1.1e-5));
  const fs::path restart = run / ("restart/deposition." + std::to_string(3 * every) + ".restart");
  ASSERT_TRUE(fs::exists(restart));
  ASSERT_GT(json_of(run / "result.json").at("time_s").get<double>(), 0.35);

  fs::remove(run / "result.json");
  const auto resumed = run_liggghts_in(
      whole.folder, deck, small({{"restart_interval", "0.1"}, {"resume", restart.string()}}));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(text_of(run / "result.json"), result);
  EXPECT_EQ(text_of(last_dump(run, "bodies")), last_bodies);
}

TEST(Deposition, NeverOverwritesARun) {
  const auto first = run_liggghts(deck, small({{"particles", "4"}}));
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const std::string energies = text_of(first.folder / "run/energies.csv");
  const auto second = run_liggghts_in(first.folder, deck, small({{"particles", "8"}}));
  EXPECT_NE(second.exit_code, 0);
  EXPECT_NE(second.output.find("run/parameters.json' exists already"), std::string::npos)
      << second.output;
  EXPECT_EQ(text_of(first.folder / "run/energies.csv"), energies);
}

TEST(Deposition, SaysWhenTheBedDidNotComeToRest) {
  const auto run = run_liggghts(deck, small({{"relaxation_limit", "0.001"}}));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("ERROR: kinetic over elastic energy is"), std::string::npos)
      << run.output;
  EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
}

// A hundred times the paper's time step is beyond the stability limit even of a single contact.
TEST(Deposition, RefusesATimeStepBeyondTheStabilityLimit) {
  const auto run = run_liggghts(deck, small({{"timestep", "1.1e-3"}}));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("of the stability limit"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
}

// Particles that move by more than their diameter in a step fly through the walls, and LIGGGHTS
// deletes them.
TEST(Deposition, SaysWhenParticlesHaveLeftTheContainer) {
  const auto run = run_liggghts(deck, small({{"horizontal_speed", "1000"}}));
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("particles have left the container, expected all 24"),
            std::string::npos)
      << run.output;
  EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
}

TEST(Deposition, ResumesWithTheParametersOfTheRunOnly) {
  const auto first = run_liggghts(deck, small({{"particles", "4"}}));
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const auto resume = [&](Vars vars) {
    vars["resume"] = "run/restart/deposition.end.restart";
    return run_liggghts_in(first.folder, deck, small(vars));
  };
  const auto other = resume({{"particles", "4"}, {"friction", "0.5"}});
  EXPECT_NE(other.exit_code, 0);
  EXPECT_NE(other.output.find("parameter 'friction': expected as in 'run/parameters.json', 0.3, "
                              "got 0.5"),
            std::string::npos)
      << other.output;
  const auto longer = resume({{"particles", "4"}, {"relaxation_limit", "30"}});
  EXPECT_EQ(longer.exit_code, 0) << longer.output;
}

TEST(Deposition, RefusesWrongParameters) {
  const std::pair<Vars, std::string> wrong[] = {
      {{{"aspect_ratio", "0.5"}}, "parameter 'aspect_ratio': expected minimum 1, got 0.5"},
      {{{"surface", "rough"}}, "parameter 'surface': value 'rough' is none of:"},
      {{{"surface", "coarse"}, {"overlap", "0.3"}}, "got 0.3 with surface coarse"},
      {{{"drop_height", "0.115"}}, "expected room for particles of template particles"},
      {{{"curvature", "200"}}, "parameter 'curvature': expected maximum 180, got 200"},
      {{{"size_spread", "1"}}, "parameter 'size_spread': expected below 1, got 1"},
      {{{"timestep", "0"}}, "parameter 'timestep': expected above 0, got 0"},
      {{{"output_interval", "1e5"}}, "parameter 'output_interval': expected maximum 1e4, got 1e5"},
      {{{"gravity", "1e-12"}}, "steps, expected at most 2e9: are gravity 1e-12 m/s2, drop_height"},
      {{{"integrator", "ab5"}}, "parameter 'integrator': value 'ab5' is none of:"},
      {{{"aspectratio", "3"}}, "unknown deck parameter 'aspectratio'"},
      {{{"particles_per_line", "40"}}, "per_line 40"}};
  for (const auto& [vars, message] : wrong) {
    const auto run = run_liggghts(deck, small(vars));
    EXPECT_NE(run.exit_code, 0) << message;
    EXPECT_NE(run.output.find(message), std::string::npos) << run.output;
  }
}

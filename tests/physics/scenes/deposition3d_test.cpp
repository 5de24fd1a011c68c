// SPDX-License-Identifier: GPL-2.0-or-later
// The deck inputs/deposition3d/in.deposition3d on a small scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "liggghts_run.h"

using namespace rodpack::test;
namespace fs = std::filesystem;

namespace {

using Vars = std::map<std::string, std::string>;

const std::string deck_in_space = "deposition3d/in.deposition3d";
constexpr double width = 0.018;
constexpr double diameter = 3e-3;

/// 30 rods of three spheres, two lengths wide and two or three layers deep: less than a second.
/// (Alone on the floor they would roll on for ever: nothing damps it.)
Vars heap(const Vars& changes = {}) {
  Vars vars = {{"particles", "30"},
               {"aspect_ratio", "3"},
               {"surface", "coarse"},
               {"container_width", "0.018"},
               {"out", "run"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

nlohmann::json result_of(const fs::path& run) {
  return nlohmann::json::parse(text_of(run / "result.json"));
}

/// File run/dumps/KIND.N.dump of the step N that the run ended with.
fs::path end_dump(const fs::path& run, const std::string& kind) {
  const auto step = result_of(run).at("step").get<long>();
  return run / "dumps" / (kind + "." + std::to_string(step) + ".dump");
}

/// Every sphere lies in the container, but for what a soft contact gives way, and spheres leave
/// the plane.
void expect_inside(const fs::path& run, bool cylinder) {
  const Table spheres = read_dump(end_dump(run, "spheres"));
  ASSERT_EQ(spheres.rows(), 90U);
  // The numbers of dump and result are rounded to a few digits.
  const double slack = 1.01 * result_of(run).at("largest_overlap_m").get<double>();
  ASSERT_LT(slack, 0.01 * diameter);
  double lowest = 1, highest = -1;
  for (std::size_t s = 0; s < spheres.rows(); ++s) {
    const double x = spheres.column("x")[s] - width / 2, y = spheres.column("y")[s] - width / 2;
    const double reach = cylinder ? std::hypot(x, y) : std::max(std::abs(x), std::abs(y));
    const double r = spheres.column("radius")[s];
    EXPECT_LT(reach + r, width / 2 + slack);
    EXPECT_GT(spheres.column("z")[s], r - slack);
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
  }
  EXPECT_GT(highest - lowest, width / 2);
}

/// At rest floor and walls carry the weight, and push sideways in balance. What is left is mass
/// times acceleration: of the order sqrt(E_k / E_p) = 3e-3 of the weight.
void expect_carried(const fs::path& run) {
  double weight = 0, up = 0, along_x = 0, along_y = 0;
  const Table bodies = read_dump(end_dump(run, "bodies"));
  ASSERT_EQ(bodies.rows(), 30U);
  for (const double mass : bodies.column("mass")) weight += 9.81 * mass;
  const Table contacts = read_dump(end_dump(run, "contacts"));
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    if (contacts.column("wall")[c] == 0) continue;
    along_x += contacts.column("fx")[c];
    along_y += contacts.column("fy")[c];
    up += contacts.column("fz")[c];
  }
  EXPECT_NEAR(up / weight, 1, 0.01);
  EXPECT_NEAR(along_x / weight, 0, 0.01);
  EXPECT_NEAR(along_y / weight, 0, 0.01);
}

}  // namespace

TEST(DepositionInSpace, FloorAndWallsCarryTheWeightOnOneAndTwoRanks) {
  for (const char* container : {"box", "cylinder"})
    for (const int ranks : {1, 2}) {
      SCOPED_TRACE(std::string(container) + ", ranks: " + std::to_string(ranks));
      const auto run = run_liggghts(deck_in_space, heap({{"container", container}}), ranks);
      ASSERT_EQ(run.exit_code, 0) << run.output;
      ASSERT_TRUE(fs::exists(run.folder / "run/result.json")) << run.output;
      expect_inside(run.folder / "run", container == std::string("cylinder"));
      expect_carried(run.folder / "run");
      EXPECT_LE(result_of(run.folder / "run").at("kinetic_over_elastic"), 1e-5);
    }
}

// Restarts from the last file, when the bed has come to rest and the run only waits whether it
// stays there, and from the middle of the fall, on as many ranks as before: the same bits at the
// end. There is a file every 910 steps, the bed is observed every 1000.
TEST(DepositionInSpace, ResumesExactlyOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    const Vars often = {{"restart_interval", "0.01"}, {"container", "cylinder"}};
    const auto whole = run_liggghts(deck_in_space, heap(often), ranks);
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    const fs::path run = whole.folder / "run";
    const std::string result = text_of(run / "result.json");
    const fs::path bodies = end_dump(run, "bodies");
    const std::string last = text_of(bodies), energies = text_of(run / "energies.csv");
    const auto every = std::lround(std::ceil(0.01 / 1.1e-5));
    const long files = result_of(run).at("step").get<long>() / every;
    for (const long file : {files, 10L}) {
      const auto restart =
          run / ("restart/deposition3d." + std::to_string(file * every) + ".restart");
      ASSERT_TRUE(fs::exists(restart));
      fs::remove(run / "result.json");
      fs::remove(bodies);
      Vars again = heap(often);
      again["resume"] = restart.string();
      const auto resumed = run_liggghts_in(whole.folder, deck_in_space, again, ranks);
      ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
      EXPECT_EQ(text_of(run / "result.json"), result) << ranks << " ranks, file " << file;
      EXPECT_EQ(text_of(bodies), last) << ranks << " ranks, file " << file;
      EXPECT_EQ(text_of(run / "energies.csv"), energies) << ranks << " ranks, file " << file;
    }
  }
}

TEST(DepositionInSpace, SeedsGiveOtherPackingsAndTheSameSeedTheSameOne) {
  const auto bodies = [](const std::string& seed) {
    const auto run = run_liggghts(deck_in_space, heap({{"seed", seed}}));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return read_dump(end_dump(run.folder / "run", "bodies")).column("x");
  };
  const auto first = bodies("1");
  EXPECT_EQ(first, bodies("1"));
  EXPECT_NE(first, bodies("2"));
}

// What the post-processor takes for walls are those of the deck, not the box of the simulation.
TEST(DepositionInSpace, IsMeasuredBetweenItsWalls) {
  const auto run = run_liggghts(deck_in_space, heap({{"container", "cylinder"}}));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto measured = run_rodpack("profile '" + end_dump(run.folder / "run", "bodies").string() +
                                        "' --normalise walls-and-surface --scale-in-dp 0.5",
                                    run.folder);
  EXPECT_EQ(measured.exit_code, 0) << measured.output;
  // pi (0.018 / 2)^2 m^2
  EXPECT_NE(measured.output.find("cross-section 0.0002545 m^2"), std::string::npos)
      << measured.output;
}

TEST(DepositionInSpace, RefusesWrongParameters) {
  const std::pair<Vars, std::string> wrong[] = {
      {{{"particle_diameter", "-0.003"}},
       "parameter 'particle_diameter': expected above 0, got -0.003"},
      {{{"container", "sphere"}}, "parameter 'container': value 'sphere' is none of: box cylinder"},
      {{{"vertical_axis", "y"}}, "parameter 'vertical_axis': value 'y' is none of: z"},
      {{{"container_width", "0.008"}},
       "parameter container_width: expected more than a particle is long, 0.009 m, got 0.008"},
      {{{"container_height", "0.009"}},
       "parameter container_height: expected more than a particle is long, 0.009 m, got 0.009"},
      {{{"column_fraction", "0.5"}}, "parameter 'column_fraction': expected maximum 0.3, got 0.5"},
      {{{"container_height", "0.03"}, {"particles", "300"}},
       "with room for all 300 particles, got container_height 0.03 m, where"},
      {{{"seed", "41"}}, "parameter 'seed': expected maximum 40, got 41"},
      {{{"engine", "planar"}}, "unknown deck parameter 'engine'"},
      {{{"surface", "coarse"}, {"overlap", "0.3"}}, "got 0.3 with surface coarse"}};
  for (const auto& [vars, message] : wrong) {
    const auto run = run_liggghts(deck_in_space, heap(vars));
    EXPECT_NE(run.exit_code, 0) << message;
    EXPECT_NE(run.output.find(message), std::string::npos) << run.output;
    EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
  }
}

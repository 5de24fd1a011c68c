// SPDX-License-Identifier: GPL-2.0-or-later
// The deck inputs/discharge3d/in.discharge3d on a small scale.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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

const std::string silo = "discharge3d/in.discharge3d";
constexpr double diameter = 3e-3, silo_width = 0.024;

/// 100 spheres in a cylinder of 8 d_p, an orifice of 5 d_p: some seconds.
Vars small_silo(const Vars& changes = {}) {
  Vars vars = {
      {"particles", "100"},        {"container_width", "0.024"}, {"orifice_width", "0.015"},
      {"settle_time", "0.05"},     {"column_fraction", "0.05"},  {"flow_limit", "0.15"},
      {"output_interval", "0.05"}, {"restart_interval", "0.03"}, {"out", "run"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

nlohmann::json result_of_silo(const fs::path& run) {
  return nlohmann::json::parse(text_of(run / "result.json"));
}

fs::path silo_dump(const fs::path& run, const std::string& kind) {
  const auto step = result_of_silo(run).at("step").get<long>();
  return run / "dumps" / (kind + "." + std::to_string(step) + ".dump");
}

/// The lid holds all until it is taken away; what is counted is all there is, and at the end the
/// count is that of the spheres below the bottom by d_p. Nothing is outside of the cylinder.
void expect_counted(const fs::path& run, double particles, double spheres_each) {
  const auto result = result_of_silo(run);
  const Table counts = read_table(run / "discharge.csv");
  double before = -1;
  for (std::size_t i = 0; i < counts.rows(); ++i) {
    EXPECT_NEAR(counts.column("inside")[i] + counts.column("discharged")[i], particles, 1e-9);
    EXPECT_LE(before, counts.column("discharged")[i]);
    before = counts.column("discharged")[i];
    if (counts.column("since_opening_s")[i] <= 0) {
      EXPECT_EQ(before, 0);
    }
  }
  const Table spheres = read_dump(silo_dump(run, "spheres"));
  ASSERT_EQ(spheres.rows(), particles * spheres_each);
  double below = 0;
  for (std::size_t s = 0; s < spheres.rows(); ++s) {
    below += spheres.column("z")[s] < -diameter;
    const double r = std::hypot(spheres.column("x")[s] - silo_width / 2,
                                spheres.column("y")[s] - silo_width / 2);
    EXPECT_LT(r + spheres.column("radius")[s], silo_width / 2 + 0.1 * diameter);
  }
  EXPECT_NEAR(result.at("discharged").get<double>(), below / spheres_each, 1e-9);
  EXPECT_GT(below, spheres.rows() / 3.0);
}

/// The largest depth by which a sphere above the orifice is in a face of the hopper: a face whose
/// normal points to the azimuth a holds the points with (x cos a + y sin a - reach) cos(half angle)
/// = z sin(half angle), where reach is the distance of the sides of the orifice from the axis.
double depth_in_hopper(const fs::path& spheres_dump, double orifice, double half_angle) {
  const Table spheres = read_dump(spheres_dump);
  const double reach = 0.5 * orifice * 1.013002 * std::cos(M_PI / 16);
  double deepest = -1;
  for (std::size_t s = 0; s < spheres.rows(); ++s) {
    const double z = spheres.column("z")[s];
    if (z < 0) continue;
    for (int face = 0; face < 16; ++face) {
      const double azimuth = (face + 0.5) * M_PI / 8;
      const double outward = (spheres.column("x")[s] - silo_width / 2) * std::cos(azimuth) +
                             (spheres.column("y")[s] - silo_width / 2) * std::sin(azimuth);
      const double out = outward - reach;
      const double along = out * std::sin(half_angle) + z * std::cos(half_angle);
      // The edge of the orifice is what a sphere touches that is not above the face.
      const double gap =
          along > 0 ? z * std::sin(half_angle) - out * std::cos(half_angle) : std::hypot(out, z);
      deepest = std::max(deepest, spheres.column("radius")[s] - gap);
    }
  }
  return deepest;
}

}  // namespace

// Before the opening, while it flows and at the end no sphere is in a face by more than a tenth of
// its diameter; on a flat bottom of this width they stand up to 1.5 diameters beyond.
TEST(DischargeInSpace, HopperHoldsTheSpheresOnOneTwoAndFourRanks) {
  const std::pair<int, double> cases[] = {{1, 20}, {1, 60}, {2, 40}, {4, 60}};
  for (const auto& [ranks, half_angle] : cases) {
    SCOPED_TRACE(std::to_string(ranks) + " ranks, " + std::to_string(half_angle));
    const auto run =
        run_liggghts(silo, small_silo({{"half_angle", std::to_string(half_angle)}}), ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_counted(run.folder / "run", 100, 1);
    int dumps = 0;
    for (const auto& file : fs::directory_iterator(run.folder / "run/dumps"))
      if (file.path().filename().string().rfind("spheres.", 0) == 0 &&
          file.path().filename() != "spheres.0.dump") {
        ++dumps;
        EXPECT_LT(depth_in_hopper(file.path(), 0.015, half_angle * M_PI / 180), 0.1 * diameter)
            << file.path();
      }
    EXPECT_GE(dumps, 4);
  }
}

TEST(DischargeInSpace, HopperLetsRodsAndPlainSpheresPass) {
  const auto rods = run_liggghts(silo, small_silo({{"half_angle", "30"},
                                                   {"aspect_ratio", "2"},
                                                   {"surface", "coarse"},
                                                   {"particles", "50"}}));
  ASSERT_EQ(rods.exit_code, 0) << rods.output;
  expect_counted(rods.folder / "run", 50, 2);
  // Narrower than a flat bottom of floor.stl can be, a fifth of the width.
  const auto narrow = run_liggghts(silo, small_silo({{"half_angle", "15"},
                                                     {"spheres", "plain"},
                                                     {"particles", "30"},
                                                     {"orifice_width", "0.0045"}}));
  ASSERT_EQ(narrow.exit_code, 0) << narrow.output;
  const auto result = result_of_silo(narrow.folder / "run");
  EXPECT_EQ(result.at("inside").get<double>() + result.at("discharged").get<double>(), 30);
  EXPECT_LT(depth_in_hopper(silo_dump(narrow.folder / "run", "spheres"), 0.0045, M_PI / 12),
            0.1 * diameter);
}

TEST(DischargeInSpace, CountsEverySphereOnOneTwoAndFourRanks) {
  for (const int ranks : {1, 2, 4}) {
    SCOPED_TRACE(ranks);
    const auto run = run_liggghts(silo, small_silo(), ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_counted(run.folder / "run", 100, 1);
  }
}

TEST(DischargeInSpace, CountsPlainSpheresOnOneAndTwoRanks) {
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(ranks);
    const auto run = run_liggghts(silo, small_silo({{"spheres", "plain"}}), ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_counted(run.folder / "run", 100, 1);
  }
}

TEST(DischargeInSpace, CountsRods) {
  const auto run = run_liggghts(
      silo, small_silo({{"aspect_ratio", "2"}, {"surface", "coarse"}, {"particles", "50"}}));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  expect_counted(run.folder / "run", 50, 2);
}

// From a restart file of before and of after the opening the run ends with the same bits: meshes,
// their contacts and the lid that is no longer there go on.
TEST(DischargeInSpace, ResumesExactlyOnOneAndTwoRanks) {
  const std::pair<Vars, int> cases[] = {{{{"spheres", "plain"}}, 1},
                                        {{{"spheres", "bodies"}}, 2},
                                        {{{"half_angle", "40"}}, 1},
                                        {{{"half_angle", "40"}}, 2}};
  for (const auto& [changes, ranks] : cases) {
    SCOPED_TRACE(changes.begin()->first + " " + changes.begin()->second);
    const auto whole = run_liggghts(silo, small_silo(changes), ranks);
    ASSERT_EQ(whole.exit_code, 0) << whole.output;
    const fs::path run = whole.folder / "run";
    const std::string bodies = text_of(silo_dump(run, "bodies"));
    const std::string counts = text_of(run / "discharge.csv"),
                      result = text_of(run / "result.json");
    const double opened = result_of_silo(run).at("opened_at_s");
    const long every = std::lround(std::ceil(0.03 / 1.1e-5));
    const auto before = static_cast<long>(opened / 1.1e-5) / every;
    for (const long file : {before + 2, before}) {
      const auto restart = "run/restart/discharge3d." + std::to_string(file * every) + ".restart";
      ASSERT_TRUE(fs::exists(whole.folder / restart)) << restart;
      auto vars = small_silo(changes);
      vars["resume"] = restart;
      const auto resumed = run_liggghts_in(whole.folder, silo, vars, ranks);
      ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
      EXPECT_EQ(text_of(run / "result.json"), result);
      EXPECT_EQ(text_of(run / "discharge.csv"), counts);
      EXPECT_EQ(text_of(silo_dump(run, "bodies")), bodies);
    }
  }
}

TEST(DischargeInSpace, RefusesWrongParameters) {
  const std::pair<Vars, std::string> wrong[] = {
      {{{"orifice_width", "-0.01"}}, "parameter 'orifice_width': expected above 0, got -0.01"},
      {{{"orifice_width", "0.004"}}, "parameter orifice_width: expected from 0.0048 m"},
      {{{"orifice_width", "0.019"}},
       "container_width less 2 particle_diameter, 0.018 m, got 0.019"},
      {{{"aspect_ratio", "4"}, {"orifice_width", "0.011"}}, "expected from 0.012 m"},
      {{{"aspect_ratio", "2"}, {"spheres", "plain"}},
       "parameter spheres: expected bodies with aspect_ratio 2"},
      {{{"seed", "41"}}, "parameter 'seed': expected maximum 40, got 41"},
      {{{"engine", "planar"}}, "unknown deck parameter 'engine'"},
      {{{"half_angle", "0"}}, "parameter 'half_angle': expected minimum 5, got 0"},
      {{{"half_angle", "95"}}, "parameter 'half_angle': expected maximum 90, got 95"},
      {{{"half_angle", "30"}, {"orifice_width", "0.019"}},
       "expected from 0.003 m, a particle length, to container_width less 2 particle_diameter, "
       "0.018 m, got 0.019"},
      {{{"half_angle", "10"}, {"container_height", "0.03"}},
       "parameter container_height: expected room for a column above the hopper of half_angle 10"},
      {{{"container_height", "0.01"}}, "with room for all 100 particles"}};
  for (const auto& [vars, message] : wrong) {
    const auto run = run_liggghts(silo, small_silo(vars));
    EXPECT_NE(run.exit_code, 0) << message;
    EXPECT_THAT(run.output, testing::HasSubstr(message));
    EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
  }
}

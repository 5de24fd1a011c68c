// SPDX-License-Identifier: GPL-2.0-or-later
// The deck inputs/incline/in.incline on a small scale.
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

const std::string inclined = "incline/in.incline";
constexpr double gravity = 9.81;

/// 40 discs on a slope of 12 degrees, 10 d_p long: a second or two.
Vars slope(const Vars& changes = {}) {
  Vars vars = {{"particles", "40"}, {"container_width", "0.03"},  {"inclination", "12"},
               {"flow_time", "3"},  {"restart_interval", "0.05"}, {"output_interval", "0.1"},
               {"out", "run"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

nlohmann::json result_of_slope(const fs::path& run) {
  return nlohmann::json::parse(text_of(run / "result.json"));
}

fs::path dump_at_end(const fs::path& run, const std::string& kind) {
  const auto step = result_of_slope(run).at("step").get<long>();
  return run / "dumps" / (kind + "." + std::to_string(step) + ".dump");
}

/// At rest walls and base carry the weight, down the slope and onto it: force -W sin, W cos. What
/// is left is mass times acceleration, of the order sqrt(E_k / E_p) = 3e-3 of the weight.
void expect_at_rest(const fs::path& run, double degrees) {
  ASSERT_EQ(result_of_slope(run).at("at_rest"), 1);
  const Table bodies = read_dump(dump_at_end(run, "bodies"));
  ASSERT_EQ(bodies.rows(), 40U);
  double weight = 0, x = 0, y = 0;
  for (const double mass : bodies.column("mass")) weight += gravity * mass;
  for (const double type : bodies.column("type")) EXPECT_EQ(type, 1);
  const Table contacts = read_dump(dump_at_end(run, "contacts"));
  for (std::size_t c = 0; c < contacts.rows(); ++c) {
    if (contacts.column("wall")[c] == 0) continue;
    x += contacts.column("fx")[c];
    y += contacts.column("fy")[c];
  }
  const double angle = degrees * M_PI / 180;
  EXPECT_NEAR(x / weight, -std::sin(angle), 0.01);
  EXPECT_NEAR(y / weight, std::cos(angle), 0.01);
}

}  // namespace

TEST(Incline, RoughBaseCarriesTheWeightOnOneTwoAndFourRanks) {
  for (const int ranks : {1, 2, 4}) {
    SCOPED_TRACE(ranks);
    const auto run = run_liggghts(inclined, slope(), ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_at_rest(run.folder / "run", 12);
  }
}

TEST(Incline, BoxOnTheEngineOrTheSphereStylesIsMeasured) {
  for (const char* engine : {"planar", "spheres"}) {
    const auto run = run_liggghts(
        inclined,
        slope({{"sides", "walls"}, {"base", "smooth"}, {"engine", engine}, {"inclination", "20"}}));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    expect_at_rest(run.folder / "run", 20);
    const auto said = run_rodpack("incline run --last 0.01 --scale-in-dp 0.5", run.folder);
    EXPECT_EQ(said.exit_code, 0) << said.output;
    EXPECT_THAT(said.output, testing::HasSubstr("20 degrees (tan 0.364), at rest, 1 frames"));
  }
}

// Above tan 20 degrees = 0.36 > friction 0.3 nothing holds discs on a smooth base: they speed up,
// at g (sin - mu cos) once they slide, and less while they roll up to it.
TEST(Incline, DiscsSlideDownASmoothBase) {
  const auto run = run_liggghts(
      inclined, slope({{"base", "smooth"}, {"inclination", "30"}, {"flow_time", "0.3"}}));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(result_of_slope(run.folder / "run").at("at_rest"), 0);
  EXPECT_GT(result_of_slope(run.folder / "run").at("velocity_m_s").get<double>(), 0.3);
  const auto said = run_rodpack("incline run --scale-in-dp 0.5 --last 0.9", run.folder);
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, testing::HasSubstr("give --last so that all frames are of the filled"));
  const auto late = run_rodpack("incline run --scale-in-dp 0.5", run.folder);
  EXPECT_EQ(late.exit_code, 0) << late.output;
  EXPECT_THAT(late.output, testing::HasSubstr("accelerating"));
}

// From a restart file of the filling and of the flow, the run ends with the same bits, periodic on
// the sphere styles and between walls on the engine.
TEST(Incline, ResumesExactlyOnOneAndTwoRanks) {
  for (const char* sides : {"periodic", "walls"})
    for (const int ranks : {1, 2}) {
      SCOPED_TRACE(std::string(sides) + " " + std::to_string(ranks));
      const Vars vars = slope({{"sides", sides}, {"flow_time", "0.1"}});
      const auto whole = run_liggghts(inclined, vars, ranks);
      ASSERT_EQ(whole.exit_code, 0) << whole.output;
      const fs::path run = whole.folder / "run";
      const std::string bodies = text_of(dump_at_end(run, "bodies"));
      const std::string flow = text_of(run / "flow.csv"), result = text_of(run / "result.json");
      const long every = std::lround(std::ceil(0.05 / 1.1e-5));
      for (const long file : {4L, 1L}) {
        Vars again = vars;
        again["resume"] = "run/restart/incline." + std::to_string(file * every) + ".restart";
        ASSERT_TRUE(fs::exists(whole.folder / again["resume"]));
        const auto resumed = run_liggghts_in(whole.folder, inclined, again, ranks);
        ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
        EXPECT_EQ(text_of(run / "result.json"), result);
        EXPECT_EQ(text_of(run / "flow.csv"), flow);
        EXPECT_EQ(text_of(dump_at_end(run, "bodies")), bodies);
      }
    }
}

TEST(Incline, RefusesWrongParameters) {
  const std::pair<Vars, std::string> wrong[] = {
      {{{"inclination", "61"}}, "parameter 'inclination': expected maximum 60, got 61"},
      {{{"inclination", "-1"}}, "parameter 'inclination': expected minimum 0, got -1"},
      {{{"base", "sticky"}}, "parameter 'base': value 'sticky' is none of: rough smooth"},
      {{{"engine", "planar"}}, "parameter engine: expected spheres with periodic sides"},
      {{{"surface", "coarse"}, {"overlap", "0.3"}}, "got 0.3 with surface coarse"},
      {{{"slope", "20"}}, "unknown deck parameter 'slope'"}};
  for (const auto& [vars, message] : wrong) {
    const auto run = run_liggghts(inclined, slope(vars));
    EXPECT_NE(run.exit_code, 0) << message;
    EXPECT_THAT(run.output, testing::HasSubstr(message));
    EXPECT_FALSE(fs::exists(run.folder / "run/result.json"));
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
// The post-processor on what runs left: the same fields as in the run, and Janssen's law.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <stdexcept>
#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

auto postprocess(const std::string& arguments, const std::filesystem::path& folder) {
  return run_rodpack(arguments, folder);
}

std::string last_bodies(const std::filesystem::path& dumps) {
  long last = -1;
  for (const auto& entry : std::filesystem::directory_iterator(dumps)) {
    const std::string name = entry.path().filename().string();
    if (name.rfind("bodies.", 0) == 0) last = std::max(last, std::stol(name.substr(7)));
  }
  return (dumps / ("bodies." + std::to_string(last) + ".dump")).string();
}

}  // namespace

// Dumps hold 16 digits, the tables 15.
TEST(StressInTheRunAndAfterIt, AgreeToTheDumpsPrecision) {
  for (const std::string periodic : {"0", "1"}) {
    const auto run = run_liggghts("verification/stress/in.stress",
                                  {{"steps", "40000"}, {"every", "40000"}, {"periodic", periodic}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto post = postprocess(
        "stress bodies.40000.dump --couple --scale 0.006 --spacing 0.0015 "
        "--tolerance 1e-12 --window -0.045 0.105 -0.045 0.105 --walls 0 0.06 0",
        run.folder);
    ASSERT_EQ(post.exit_code, 0) << post.output;
    const Table during = read_table(run.folder / "fields.40000.csv");
    const Table after = read_table(run.folder / "stress.csv");
    ASSERT_EQ(during.names(), after.names());
    ASSERT_EQ(during.rows(), after.rows());
    for (const auto& name : during.names()) {
      // Where there is next to no mass, velocity and coordination are ratios of rounding errors.
      const bool ratio = name.rfind("velocity", 0) == 0 || name.rfind("co", 0) == 0;
      const auto& density = during.column("mass_density_kg_m2");
      const auto& a = during.column(name);
      const auto& b = after.column(name);
      double scale = 0, worst = 0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (ratio && name.find("stress") == std::string::npos && density[i] < 1e-3) continue;
        scale = std::max(scale, std::fabs(a[i]));
        worst = std::max(worst, std::fabs(a[i] - b[i]));
      }
      EXPECT_LE(worst, 1e-11 * scale) << name;
    }
  }
}

namespace {

// The deck in space, with the compute at the places of a file beside its dumps, for another folder.
std::string deposition_with_fields() {
  const std::regex beside("parameter include \\.\\./");
  std::string deck =
      std::regex_replace(text_of(RODPACK_REPOSITORY "/inputs/deposition3d/in.deposition3d"), beside,
                         "include " RODPACK_REPOSITORY "/inputs/");
  const std::string before = "dump bodies   all";
  const auto at = deck.find(before);
  if (at == std::string::npos) throw std::runtime_error("the deck has no '" + before + "'");
  return deck.insert(at,
                     "compute fields all stress/goldhirsch scale 0.003 dimension 3 tolerance 1e-12 "
                     "couple yes points places.txt\n"
                     "dump fields all stress/goldhirsch ${n_output} fields.*.csv fields\n");
}

}  // namespace

// Rods that fall and collide in a box, one seed, one rank: the second run is the first one, with
// the compute at places of the grid that rodpack made of the first.
TEST(StressInTheRunAndAfterIt, AgreeInSpaceToTheDumpsPrecision) {
  std::map<std::string, std::string> vars = {
      {"particles", "30"},          {"aspect_ratio", "3"},       {"surface", "coarse"},
      {"container_width", "0.018"}, {"output_interval", "0.15"}, {"out", "run"}};
  const auto first = run_liggghts("deposition3d/in.deposition3d", vars);
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const std::string step = std::to_string(static_cast<long>(std::ceil(0.15 / 1.1e-5)));
  const auto post =
      postprocess("stress run/dumps/bodies." + step +
                      ".dump --couple --scale 0.003 --spacing 0.003 --tolerance 1e-12",
                  first.folder);
  ASSERT_EQ(post.exit_code, 0) << post.output;
  const Table after = read_table(first.folder / "stress.csv");
  std::string places;
  for (std::size_t i = 0; i < after.rows(); ++i) {
    for (const char* name : {"x_m", "y_m", "z_m"}) {
      char number[32];
      std::snprintf(number, sizeof number, "%.17g ", after.column(name)[i]);
      places += number;
    }
    places += '\n';
  }
  const auto folder = fresh_folder();
  std::ofstream(folder / "places.txt") << places;
  const auto second = run_liggghts_in(folder, deposition_with_fields(), vars);
  ASSERT_EQ(second.exit_code, 0) << second.output;
  const Table during = read_table(folder / ("fields." + step + ".csv"));
  ASSERT_EQ(during.names(), after.names());
  ASSERT_EQ(during.rows(), after.rows());
  const auto& density = during.column("mass_density_kg_m3");
  for (const auto& name : during.names()) {
    const bool ratio = name.rfind("velocity", 0) == 0 || name.rfind("coord", 0) == 0 ||
                       name.rfind("contacts", 0) == 0;
    double scale = 0, worst = 0;
    for (std::size_t i = 0; i < during.rows(); ++i) {
      if (ratio && density[i] < 1) continue;
      scale = std::max(scale, std::fabs(during.column(name)[i]));
      worst = std::max(worst, std::fabs(during.column(name)[i] - after.column(name)[i]));
    }
    EXPECT_LE(worst, 1e-11 * scale) << name;
  }
  double largest = 0;
  for (const double each : during.column("contact_stress_zz_N_m2"))
    largest = std::max(largest, std::fabs(each));
  EXPECT_GT(largest, 1);  // there are contacts
}

// A narrow column of spheres, 100 d_p high and 4 d_p wide: friction at the walls carries what is
// added above, the pressure saturates. h_c = W / (2 mu_w K) with the mobilised mu_w <= mu = 0.5 and
// K < 1 is above 4 d_p; that it is below half the height makes it a Janssen column.
// One column is one draw: seven gave 20 to 51 d_p, 33 +- 10; hence the mean of three.
TEST(StressInTheRunAndAfterIt, SpheresInANarrowColumnFollowJanssen) {
  const int seeds = 3;
  const double heights[] = {5, 30, 45, 85};  // d_p, depths below the top
  double depth = 0, pressure[4] = {};
  for (int seed = 1; seed <= seeds; ++seed) {
    const auto run = run_liggghts("deposition/in.deposition", {{"aspect_ratio", "1"},
                                                               {"particles", "400"},
                                                               {"width_in_lengths", "4"},
                                                               {"particles_per_line", "3"},
                                                               {"container_height", "0.45"},
                                                               {"line_fall", "0.008"},
                                                               {"timestep", "2e-5"},
                                                               {"friction", "0.5"},
                                                               {"engine", "planar"},
                                                               {"seed", std::to_string(seed)},
                                                               {"out", "run"}});
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto post =
        postprocess("profile '" + last_bodies(run.folder / "run/dumps") + "'", run.folder);
    ASSERT_EQ(post.exit_code, 0) << post.output;
    EXPECT_THAT(post.output, testing::HasSubstr("Janssen: P_j = ")) << post.output;
    EXPECT_THAT(post.output, testing::HasSubstr("rms residual"));
    const auto at = post.output.find("h_c = ");
    ASSERT_NE(at, std::string::npos);
    depth += std::stod(post.output.substr(at + 6)) / seeds;

    const Table profile = read_table(run.folder / "profile.csv");
    const auto& h = profile.column("h_over_dp");
    for (int k = 0; k < 4; ++k) {
      std::size_t best = 0;
      for (std::size_t row = 0; row < h.size(); ++row)
        if (std::fabs(h[row] - heights[k]) < std::fabs(h[best] - heights[k])) best = row;
      pressure[k] += profile.column("pressure_N_m")[best] / seeds;
    }
  }
  EXPECT_GT(depth, 4);
  EXPECT_LT(depth, 50);

  // Without walls the pressure would grow by phi rho_2d g per depth, with at least phi = 0.75 and
  // rho_2d the mass of a sphere over the area of its disc; half of it, since P_0 is the mean of the
  // vertical stress and a horizontal one of at least 0. Below the top 40 d_p friction carries at
  // least two thirds of what is added, whatever the fluctuations of a column four spheres wide.
  const double free_slope = 0.5 * 0.75 * 2500 * 2.0 / 3.0 * 3e-3 * 9.81 * 3e-3;  // N/m per d_p
  EXPECT_GT(pressure[1], 2 * pressure[0]);
  EXPECT_LT((pressure[3] - pressure[2]) / 40, free_slope / 3);
}

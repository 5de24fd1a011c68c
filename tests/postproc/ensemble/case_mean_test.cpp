// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/case_mean.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>

#include "ensemble/ensemble_field.h"
#include "ensemble/run_analysis.h"
#include "ensemble/run_cost.h"
#include "liggghts_run.h"
#include "reading/data_error.h"
#include "run_folders.h"

namespace {
using namespace rodpack;
using rodpack::test::case_of;
using rodpack::test::fresh_folder;
using rodpack::test::MadeUpRun;
using rodpack::test::put;
using Json = nlohmann::json;
namespace fs = std::filesystem;

MadeUpRun with_numbers(const Json& numbers) {
  MadeUpRun run;
  run.numbers = numbers;
  return run;
}

MadeUpRun with_table(const std::string& name, const std::string& text) {
  MadeUpRun run;
  run.tables[name] = text;
  return run;
}

std::string error_of(const CaseRuns& one) {
  try {
    mean_over_case(one);
  } catch (const DataError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CaseMean, NumbersAreThoseOfTheSummaries) {
  const std::string phi = "solid_fraction_from_3_omega_above_floor_to_surface";
  const auto mean = mean_over_case(case_of(
      fresh_folder(), {with_numbers({{phi, 0.80}, {"director_deg", 178}, {"a_standard_error", 1}}),
                       with_numbers({{phi, 0.84}, {"director_deg", 2}, {"rattlers", nullptr}}),
                       with_numbers({{phi, nullptr}, {"director_deg", 0}})}));
  EXPECT_EQ(mean.name, "smooth-AR5");
  EXPECT_EQ(mean.seeds, (std::vector<long>{1, 2, 3}));
  EXPECT_EQ(mean.runs, (std::vector<std::string>{"seed-1", "seed-2", "seed-3"}));
  EXPECT_FALSE(mean.parameters.contains("seed"));
  const auto& fraction = mean.numbers.at("solid_fraction");
  EXPECT_NEAR(fraction.mean, 0.82, 1e-15);
  EXPECT_NEAR(fraction.sem.value(), 0.02, 1e-15);  // deviations 0.02: sqrt(2 0.02^2 / 1 / 2)
  EXPECT_EQ(fraction.n, 2);
  const auto& director = mean.numbers.at("director_deg");
  EXPECT_NEAR(std::remainder(director.mean, 180), 0, 1e-12);
  EXPECT_NEAR(director.sem.value(), std::sqrt(8.0 / 2 / 3), 1e-12);
  EXPECT_FALSE(mean.numbers.count("rattlers"));
  EXPECT_FALSE(mean.numbers.count("a_standard_error"));
}

// 100 particles along 0 degrees and 300 along 90, S2 = 0.5 both: (100 - 300) 0.5 / 400 = -0.25.
// Of the four resamples the two pure ones have S2 = 0.5, the mixed ones 0.25: deviations 1/8.
TEST(CaseMean, PooledOrderIsThatOfAllParticles) {
  const auto mean = mean_over_case(case_of(
      fresh_folder(),
      {with_numbers(
           {{"orientation_particles", 100}, {"nematic_order_S2", 0.5}, {"director_deg", 0}}),
       with_numbers(
           {{"orientation_particles", 300}, {"nematic_order_S2", 0.5}, {"director_deg", 90}})}));
  EXPECT_NEAR(mean.numbers.at("nematic_order_S2").mean, 0.5, 1e-15);
  EXPECT_NEAR(mean.numbers.at("nematic_order_S2_pooled").mean, 0.25, 1e-15);
  EXPECT_NEAR(mean.numbers.at("nematic_order_S2_pooled").sem.value(), std::sqrt(2.0) / 8, 1e-12);
  EXPECT_NEAR(mean.numbers.at("director_pooled_deg").mean, 90, 1e-12);
}

TEST(CaseMean, BinsAreAveragedOneByOne) {
  const auto mean = mean_over_case(
      case_of(fresh_folder(),
              {with_table("rdf", "r_over_dp,g,standard_error,pairs\n0.05,0,0,0\n0.15,2,1,4\n"),
               with_table("rdf", "r_over_dp,g,standard_error,pairs\n0.05,0,0,0\n0.15,4,1,8\n"),
               MadeUpRun()}));
  const auto& g = mean.curves.at("rdf.g");
  EXPECT_EQ(g.abscissa, "r_over_dp");
  EXPECT_EQ(g.x, (std::vector<double>{0.05, 0.15}));
  EXPECT_EQ(g.y[1].mean, 3);
  EXPECT_NEAR(g.y[1].sem.value(), 1, 1e-15);
  EXPECT_EQ(g.y[1].n, 2) << "the third run has no table";
  EXPECT_EQ(g.y[0].sem.value(), 0);
  EXPECT_EQ(mean.curves.count("rdf.standard_error"), 0U);
}

TEST(CaseMean, ForcesBeyondARunsLargestOneAreZero) {
  const std::string head = "f_over_mean,normal_count,normal_density\n";
  const auto mean = mean_over_case(
      case_of(fresh_folder(), {with_table("forces", head + "0.125,3,4\n"),
                               with_table("forces", head + "0.125,1,2\n0.375,1,2\n")}));
  const auto& density = mean.curves.at("forces.normal_density");
  EXPECT_EQ(density.y[0].mean, 3);
  EXPECT_EQ(density.y[1].mean, 1);
  EXPECT_EQ(density.y[1].n, 2);
}

TEST(CaseMean, OtherBinsAreRefused) {
  const auto folder = fresh_folder();
  const auto one =
      case_of(folder, {with_table("orientation", "gamma_deg,count\n0,1\n45,1\n90,1\n135,1\n"),
                       with_table("orientation", "gamma_deg,count\n0,2\n90,2\n")});
  EXPECT_EQ(error_of(one), (folder / "seed-2/analysis/orientation.csv").string() +
                               ": 2 bins of gamma_deg up to 90, expected the 4 bins up to 135 of " +
                               (folder / "seed-1/analysis/orientation.csv").string() +
                               ", another run of the same case");
}

// A bed of 40 d_p and one of 30 d_p, the pressure of either twice the depth below its own surface.
// At a depth h below the higher surface the lower bed has 2 (h - 10), and nothing above 10.
TEST(CaseMean, ProfileCountsDepthFromTheHighestSurface) {
  const auto profile = [](double height, int steps) {
    std::ostringstream text;
    text.precision(12);
    text
        << "h_over_dp,pressure_N_m,stress_xx_N_m,stress_xy_N_m,stress_yx_N_m,stress_yy_N_m,sigma_1_"
           "N_m,sigma_2_N_m,sigma_1_direction_deg,anisotropy,solid_fraction\n";
    for (int k = 0; k <= steps; ++k) {
      const double h = height * k / steps;
      // xx : yy = 1 : 3, so that sigma_1 = yy points up.
      text << h << ',' << 2 * h << ',' << h << ",0,0," << 3 * h << ",0,0,0,0," << 0.8 << '\n';
    }
    return text.str();
  };
  const auto mean =
      mean_over_case(case_of(fresh_folder(), {with_table("profile", profile(30, 7)),
                                              with_table("profile", profile(40, 8))}));
  const auto& pressure = mean.curves.at("profile.pressure_N_m");
  EXPECT_EQ(pressure.x, (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40}));
  ASSERT_EQ(pressure.of_runs.size(), 2U);
  EXPECT_TRUE(std::isnan(pressure.of_runs[0][1]));
  EXPECT_NEAR(pressure.of_runs[0][8], 60, 1e-9);
  EXPECT_NEAR(pressure.of_runs[1][8], 80, 1e-9);
  EXPECT_EQ(pressure.y[1].n, 1);
  EXPECT_NEAR(pressure.y[1].mean, 10, 1e-9);
  EXPECT_EQ(pressure.y[2].n, 2);
  for (std::size_t k = 2; k < pressure.x.size(); ++k) {
    const double h = pressure.x[k];
    EXPECT_NEAR(pressure.y[k].mean, (2 * h + 2 * (h - 10)) / 2, 1e-9);
    EXPECT_NEAR(pressure.y[k].sem.value(), 10, 1e-9);  // 2 h and 2 (h - 10): half the difference
    EXPECT_NEAR(mean.curves.at("profile.sigma_1_N_m").y[k].mean, 1.5 * pressure.y[k].mean, 1e-9);
  }
  EXPECT_NEAR(mean.curves.at("profile.sigma_1_direction_deg").y[8].mean, 90, 1e-9);
  EXPECT_NEAR(mean.curves.at("profile.anisotropy").y[8].mean, 0.5, 1e-9);
  EXPECT_NEAR(mean.curves.at("profile.solid_fraction").y[0].mean, 0.8, 1e-12);
}

TEST(CaseMean, HeightsAreThoseOfTheHighestBed) {
  const std::string head = "height_over_dp,solid_fraction\n";
  const auto mean = mean_over_case(
      case_of(fresh_folder(), {with_table("solid_fraction", head + "0,1\n1,2\n2,3\n3,4\n4,5\n"),
                               with_table("solid_fraction", head + "0,3\n1.5,4.5\n3,6\n")}));
  const auto& fraction = mean.curves.at("solid_fraction.solid_fraction");
  EXPECT_EQ(fraction.x, (std::vector<double>{0, 1, 2, 3, 4}));
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fraction.y[k].mean, 2 + fraction.x[k], 1e-12);
  EXPECT_EQ(fraction.y[4].n, 1) << "above the surface of the second bed";
}

// Parabolas 3 - 4 (r - c)^2 about c = 1.23 +- 0.02: their mean is one about 1.23, lower by
// 4 0.02^2; of the four resamples the pure ones peak at their c, so that the deviations are 0.02,
// -0.02, 0, 0: variance 0.02^2 / 2, times 2.
TEST(CaseMean, RdfPeakIsTheTopOfTheMeanCurve) {
  const auto rdf = [](double centre) {
    std::ostringstream text;
    text.precision(17);
    text << "r_over_dp,g,standard_error,pairs\n";
    for (int k = 0; k < 20; ++k) {
      const double r = 0.05 + 0.1 * k;
      text << r << ',' << 3 - 4 * (r - centre) * (r - centre) << ",0,1\n";
    }
    return text.str();
  };
  const auto mean = mean_over_case(
      case_of(fresh_folder(), {with_table("rdf", rdf(1.21)), with_table("rdf", rdf(1.25))}));
  EXPECT_NEAR(mean.numbers.at("rdf_peak_r_over_dp").mean, 1.23, 1e-10);
  EXPECT_NEAR(mean.numbers.at("rdf_peak_r_over_dp").sem.value(), 0.02, 1e-10);
  EXPECT_NEAR(mean.numbers.at("rdf_peak_g").mean, 3 - 4 * 0.02 * 0.02, 1e-10);
}

// Janssen's law with P_j = 8 N/m and 12 N/m, h_c = 20 d_p: the mean has 10 N/m. Resamples have 8,
// 10, 10, 12: variance 2, times 2.
TEST(CaseMean, JanssensLawIsFittedToTheMeanProfile) {
  const auto run = [](double limit) {
    std::ostringstream text;
    text.precision(17);
    text << "h_over_dp,pressure_N_m,stress_xx_N_m,stress_xy_N_m,stress_yx_N_m,stress_yy_N_m\n";
    for (int k = 0; k <= 100; ++k) {
      const double p = limit * (1 - std::exp(-k / 20.0));
      text << k << ',' << p << ',' << p << ",0,0," << p << '\n';
    }
    auto made = with_table("profile", text.str());
    made.numbers["omega_m"] = 4e-3;  // 4 d_p
    return made;
  };
  const auto mean = mean_over_case(case_of(fresh_folder(), {run(8), run(12)}));
  const auto& limit = mean.numbers.at("janssen_pressure_of_mean_profile_N_m");
  EXPECT_NEAR(limit.mean, 10, 1e-6);
  EXPECT_NEAR(limit.sem.value(), 2, 1e-6);
  EXPECT_NEAR(mean.numbers.at("janssen_depth_of_mean_profile_over_dp").mean, 20, 1e-5);
  // Fitted down to 3 w = 12 d_p above the floor.
  EXPECT_NEAR(mean.numbers.at("janssen_depth_over_fitted_depth").mean, 20.0 / 88, 1e-6);
}

TEST(CaseMean, MapsAreInterpolatedAtTheRowsOfTheHighestBed) {
  const auto fields = [](int rows, double spacing, double slope) {
    std::ostringstream text;
    text << "x_m,y_m,solid_fraction,contact_stress_xx_N_m,contact_stress_yy_N_m\n";
    for (int row = 0; row < rows; ++row)
      for (const double x : {0.0, 1.0})
        text << x << ',' << row * spacing << ',' << x + slope * row * spacing << ",1,3\n";
    return text.str();
  };
  const auto folder = fresh_folder();
  const auto one = case_of(
      folder, {with_table("fields", fields(5, 0.5, 2)), with_table("fields", fields(5, 0.75, 4))});
  const auto field = mean_field(one).value();
  EXPECT_EQ(field.x, (std::vector<double>{0, 1}));
  EXPECT_EQ(field.y, (std::vector<double>{0, 0.75, 1.5, 2.25, 3}));
  EXPECT_NEAR(field.solid_fraction[1].mean, 1, 1e-12);
  EXPECT_NEAR(field.solid_fraction[2].mean, 3 * 0.75, 1e-12);
  EXPECT_NEAR(field.solid_fraction[2].sem.value(), 0.75, 1e-12);
  EXPECT_EQ(field.solid_fraction[6].n, 1) << "beyond the grid of the lower bed";
  EXPECT_NEAR(field.pressure[2].mean, 2, 1e-12);
  const auto second = folder / "seed-2/analysis/fields.csv";
  put(second, "x_m,y_m,solid_fraction\n0,0,1\n0,1,1\n");
  EXPECT_THROW(mean_field(one), DataError);
  put(second, "x_m,y_m,solid_fraction\n0,0,1\n1.002,0,1\n0,1,1\n1.002,1,1\n");
  EXPECT_THROW(mean_field(one), DataError) << "columns a five-hundredth of their distance away";
  put(second, "x_m,y_m,solid_fraction\n0,0,1\n1.0005,0,1\n0,1,1\n1.0005,1,1\n");
  EXPECT_NO_THROW(mean_field(one)) << "columns with fewer digits";
}

TEST(RunAnalysis, SaysWhyItIsNotCurrent) {
  const auto folder = fresh_folder();
  const auto one = case_of(folder, {MadeUpRun()});
  const auto& run = one.runs[0];
  EXPECT_EQ(why_not_current(run), "");
  const fs::path summary = folder / "seed-1/analysis/summary.json";
  const Json good = read_summary(run);
  const auto reason_with = [&](const std::string& key, const Json& value) {
    Json changed = good;
    changed[key] = value;
    put(summary, changed.dump());
    return why_not_current(run);
  };
  EXPECT_EQ(reason_with("format", "rodpack-analysis 1"),
            std::string("the analysis is not of the format '") + analysis_format + "'");
  EXPECT_EQ(reason_with("rodpack", {{"version", "0.0"}}),
            std::string("the analysis is not by rodpack ") + version());
  EXPECT_EQ(reason_with("timestep", 1000),
            "the analysis is not of the step at which result.json says the run ended");
  EXPECT_EQ(reason_with("parameters", {{"aspect_ratio", 3}}),
            "the analysis is of other parameters than parameters.json has");
  put(summary, good.dump().substr(0, 20));
  EXPECT_EQ(why_not_current(run), "there is no analysis/summary.json");
  put(summary, good.dump());
  EXPECT_EQ(why_not_current(run), "");
  fs::last_write_time(folder / "seed-1/result.json",
                      fs::last_write_time(summary) + std::chrono::seconds(1));
  EXPECT_EQ(why_not_current(run), "the analysis is older than result.json");
  EXPECT_EQ(error_of(one), run.folder +
                               ": the analysis is older than result.json, expected it to "
                               "be current");
}

// Loops of 10 s and 2 s on 2 ranks; before them an attempt that was cut short after 7.5 s on one.
TEST(RunCost, SumsTheLoopsOfAllAttempts) {
  const auto log = put(fresh_folder() / "log.liggghts",
                       "  1 by 1 by 1 MPI processor grid\n"
                       "    Step            CPU       min_left \n"
                       "       0              0              0 \n"
                       "WARNING: something\n"
                       "    5000            7.5            1.5 \n"
                       "  2 by 1 by 1 MPI processor grid\n"
                       "    Step            CPU       min_left \n"
                       "    5000              1            1.5 \n"
                       "Loop time of 10 on 2 procs for 100 steps with 60 atoms, finish time Sat\n"
                       "    Step            CPU       min_left \n"
                       "    5100              1            1.5 \n"
                       "Loop time of 2 on 2 procs for 10 steps with 60 atoms, finish time Sat\n");
  const auto cost = cost_of_run(log).value();
  EXPECT_NEAR(cost.wall_time_s, 19.5, 1e-12);
  EXPECT_NEAR(cost.core_seconds, 7.5 + 20 + 4, 1e-12);
  EXPECT_FALSE(cost_of_run(log + ".none"));
  EXPECT_FALSE(cost_of_run(put(fresh_folder() / "log", "LIGGGHTS\n")));
}

}  // namespace

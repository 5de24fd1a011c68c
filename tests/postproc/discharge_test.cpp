// SPDX-License-Identifier: GPL-2.0-or-later
// The steady rate of an outflow whose counts are written down, and Beverloo's law of exact rates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/discharge/beverloo_fit.h"
#include "analysis/discharge/hopper_factor.h"
#include "analysis/discharge/outflow.h"
#include "liggghts_run.h"
#include "reading/dump.h"
#include "synthetic_packing.h"

namespace {

using namespace rodpack;
using test::fresh_folder;
using test::put;
using testing::HasSubstr;

constexpr double interval = 0.004;  // s, of the rows

// 500 particles per second until `all` are out of 1000, from ten rows before the opening to `end`.
OutflowHistory even_flow(double all, double end, double throat_at_end) {
  OutflowHistory history;
  for (int i = -10; i * interval <= end + 1e-9; ++i) {
    const double t = i * interval, out = std::clamp(500 * t, 0.0, all);
    history.time.push_back(t);
    history.discharged.push_back(out);
    history.inside.push_back(1000 - out);
    history.throat.push_back(out < all ? 80 : throat_at_end);
  }
  return history;
}

TEST(Outflow, EvenFlowHasItsRateAndNoError) {
  const auto outflow = measure_outflow(even_flow(800, 2, 0), {});
  ASSERT_TRUE(outflow.rate);
  EXPECT_NEAR(*outflow.rate, 500, 1e-9);
  EXPECT_NEAR(*outflow.rate_error, 0, 1e-9);
  // 20 and 70 % of 800 at 500 per second.
  EXPECT_NEAR(outflow.from, 0.32, 1e-12);
  EXPECT_NEAR(outflow.to, 1.12, 1e-12);
  EXPECT_NEAR(outflow.last, 1.6, 1e-12);
  EXPECT_EQ(outflow.discharged, 800);
  EXPECT_EQ(outflow.inside, 200);
}

// Ten intervals of 550 and 450 per second in turn deviate by 50 from their mean: the standard error
// of the mean is 50 sqrt(10/9) / sqrt(10) = 50/3.
TEST(Outflow, StandardErrorIsThatOfTenIntervals) {
  OutflowHistory history;
  double out = 0;
  for (int i = -1; i <= 100; ++i) {
    history.time.push_back(i * interval);
    history.discharged.push_back(out);
    history.inside.push_back(500 - out);
    history.throat.push_back(10);
    if (i >= 0 && i < 100) out += (i / 10 % 2 == 0 ? 550 : 450) * interval;
  }
  const auto outflow = measure_outflow(history, {0, 1, 0.2});
  ASSERT_TRUE(outflow.rate);
  EXPECT_NEAR(*outflow.rate, 500, 1e-8);
  EXPECT_NEAR(*outflow.rate_error, 50. / 3, 1e-6);
}

// A quarter of the 80 particles in the throat at the opening are 20.
TEST(Outflow, FullThroatFlowsOrIsCloggedAnEmptyOneHasDrained) {
  EXPECT_EQ(measure_outflow(even_flow(800, 2, 0), {}).end, OutflowEnd::drained);
  EXPECT_EQ(measure_outflow(even_flow(800, 2, 19), {}).end, OutflowEnd::drained);
  EXPECT_EQ(measure_outflow(even_flow(800, 2, 20), {}).end, OutflowEnd::clogged);
  EXPECT_EQ(measure_outflow(even_flow(800, 1.75, 20), {}).end, OutflowEnd::flowing);
  EXPECT_EQ(measure_outflow(even_flow(800, 1.75, 19), {}).end, OutflowEnd::drained);
  EXPECT_EQ(measure_outflow(even_flow(0, 2, 80), {}).end, OutflowEnd::clogged);
}

// Closed 1 s after the opening at 500 per second: 20 and 70 % of 500. An orifice that had clogged
// by then was not closed.
TEST(Outflow, NothingCountsAfterTheOrificeWasClosed) {
  OutflowOptions options;
  options.closed_at = 1.0;
  const auto outflow = measure_outflow(even_flow(800, 2, 80), options);
  EXPECT_EQ(outflow.end, OutflowEnd::closed);
  EXPECT_NEAR(outflow.discharged, 500, 1e-9);
  EXPECT_NEAR(outflow.from, 0.2, 1e-12);
  EXPECT_NEAR(outflow.to, 0.7, 1e-12);
  ASSERT_TRUE(outflow.rate);
  EXPECT_NEAR(*outflow.rate, 500, 1e-9);
  EXPECT_EQ(measure_outflow(even_flow(300, 2, 80), options).end, OutflowEnd::clogged);
  options.closed_at = 1e-6;
  EXPECT_THROW(measure_outflow(even_flow(800, 2, 80), options), DataError);
}

TEST(Outflow, FewParticlesHaveNoRate) {
  EXPECT_TRUE(measure_outflow(even_flow(101, 2, 80), {}).rate);
  EXPECT_FALSE(measure_outflow(even_flow(99, 2, 80), {}).rate);
}

TEST(Outflow, ReadsItsTableWithoutRowsThatWereComputedAnew) {
  const auto file = fresh_folder() / "discharge.csv";
  const std::string head = "step,time_s,since_opening_s,particles,inside,discharged,throat\n";
  put(file, head + "1,1,-0.5,9,9,0,3\n2,2,0.5,9,8,1,3\n3,3,1.5,9,7,2,3\n2,2,0.5,9,8,1,2\n");
  const auto history = read_outflow(file.string());
  EXPECT_EQ(history.time, (std::vector<double>{-0.5, 0.5}));
  EXPECT_EQ(history.throat, (std::vector<double>{3, 2}));
  const auto refusal = [&](const std::string& rows) -> std::string {
    put(file, head + rows);
    try {
      measure_outflow(read_outflow(file.string()), {});
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal("1,1,-0.5,9,9,0,3\n"), HasSubstr("no rows after the opening"));
  EXPECT_THAT(refusal("1,1,0.5,9,9,0,3\n"), HasSubstr("discharge.csv: no row before the opening"));
  for (const std::string count : {"-1", "1e16", "1e308"})
    EXPECT_THAT(refusal("1,1,0.5,9,9," + count + ",3\n"),
                HasSubstr("discharge.csv:2: expected a number of particles of 0 to 1e15, found '" +
                          count + "'"));
  for (const std::string time : {"1e10", "-1e300"})
    EXPECT_THAT(refusal("1,1," + time + ",9,9,0,3\n"),
                HasSubstr("discharge.csv:2: expected a time of -1e9 to 1e9 s, found '" + time));
  // Its last count could be a part of one.
  EXPECT_THAT(refusal("1,1,-0.5,9,9,0,3\n1,1,0.5,9,9,0,3"),
              HasSubstr("discharge.csv: the file is cut short: its last line has no line end"));
}

// Times that no particle falls in, from a hand or a time step that is none: a rate beyond all.
TEST(Outflow, NoTimeHasNoRate) {
  auto history = even_flow(800, 2, 0);
  for (double& time : history.time) time *= 1e-300;
  const auto outflow = measure_outflow(history, {});
  EXPECT_FALSE(outflow.rate);
  EXPECT_FALSE(outflow.rate_error);
}

std::vector<double> rates(const std::vector<double>& widths, double c, double k, double exponent) {
  std::vector<double> result;
  for (const double x : widths) result.push_back(c * std::pow(x - k, exponent));
  return result;
}

TEST(Beverloo, ExactRatesGiveTheirConstantsAndExponent) {
  const std::vector<double> widths{4, 6, 8, 11, 11};
  const auto fit = fit_beverloo(widths, rates(widths, 0.8, 1.3, 1.5), 2);
  EXPECT_NEAR(fit.c, 0.8, 1e-12);
  EXPECT_NEAR(fit.k, 1.3, 1e-12);
  EXPECT_NEAR(fit.c_error, 0, 1e-6);
  EXPECT_NEAR(fit.k_error, 0, 1e-6);
  ASSERT_TRUE(fit.exponent);
  EXPECT_NEAR(*fit.exponent, 1.5, 1e-5);
}

TEST(Beverloo, ExponentInSpaceIsThreeHalvesAndOne) {
  const std::vector<double> widths{4, 5, 6, 8};
  const auto fit = fit_beverloo(widths, rates(widths, 0.1, 0.7, 2.5), 3);
  EXPECT_EQ(fit.law, 2.5);
  EXPECT_NEAR(fit.c, 0.1, 1e-12);
  EXPECT_NEAR(fit.k, 0.7, 1e-12);
  ASSERT_TRUE(fit.exponent);
  EXPECT_NEAR(*fit.exponent, 2.5, 1e-5);
  // The law of the plane does not go through these rates.
  EXPECT_GT(fit_beverloo(widths, rates(widths, 0.1, 0.7, 2.5), 2).c_error, 1e-3);
}

// Q^(2/3) = x + e (1, -2, 1) at x = 4, 5, 6: the residuals are orthogonal to every straight line,
// which is Q^(2/3) = x then. Their variance is 6 e^2 with one degree of freedom; that of the slope
// 6 e^2 / 2, that of the zero 6 e^2 (1/3 + 5^2/2); C is the slope to the power 3/2.
TEST(Beverloo, StandardErrorsAreThoseOfTheStraightLine) {
  const double e = 1e-3;
  const auto fit = fit_beverloo(
      {4, 5, 6}, {std::pow(4 + e, 1.5), std::pow(5 - 2 * e, 1.5), std::pow(6 + e, 1.5)}, 2);
  EXPECT_NEAR(fit.c, 1, 1e-10);
  EXPECT_NEAR(fit.k, 0, 1e-10);
  EXPECT_NEAR(fit.c_error, 1.5 * e * std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(fit.k_error, e * std::sqrt(6 * (1 / 3. + 12.5)), 1e-9);
  EXPECT_FALSE(fit.exponent);
}

// The exponents of 400 sets of rates with 1 % of noise scatter by what each set says of itself,
// whose own scatter is 1/sqrt(2 * 400) = 4 % of it, and 5 degrees of freedom make it 5 % less.
TEST(Beverloo, ErrorOfTheExponentIsItsScatter) {
  const std::vector<double> widths{4, 5, 6, 7, 8, 10, 12, 14};
  const auto exact = rates(widths, 0.8, 1.3, 1.5);
  std::mt19937 generator(1);
  std::normal_distribution<double> noise(0, 0.01);
  double sum = 0, squares = 0, variances = 0;
  constexpr int sets = 400;
  for (int i = 0; i < sets; ++i) {
    auto noisy = exact;
    for (double& each : noisy) each *= std::exp(noise(generator));
    const auto fit = fit_beverloo(widths, noisy, 2);
    sum += *fit.exponent;
    squares += *fit.exponent * *fit.exponent;
    variances += *fit.exponent_error * *fit.exponent_error;
  }
  const double scatter = std::sqrt(squares / sets - sum * sum / sets / sets);
  EXPECT_NEAR(std::sqrt(variances / sets) / scatter, 1, 0.15);
}

TEST(Beverloo, RefusesFewWidthsAndFallingRates) {
  EXPECT_THROW(fit_beverloo({4, 5, 5}, {1, 2, 2}, 2), TooFewParticles);
  EXPECT_THROW(fit_beverloo({4, 5, 6}, {3, 2, 1}, 2), TooFewParticles);
}

// Runs of exact rates in `folder`, by the law C (D/d_p - 1.2)^exponent; `more`: of their
// parameters.
std::string write_runs(const std::filesystem::path& folder, double c, double exponent,
                       const std::string& more) {
  std::string runs;
  for (const int width : {5, 7, 9, 12}) {
    const auto run = folder / std::to_string(width);
    std::filesystem::create_directory(run);
    put(run / "parameters.json", "{\"orifice_width_m\": " + std::to_string(width * 1e-3) + more +
                                     ", \"particle_diameter_m\": 1e-3, \"gravity_m_s2\": 10}");
    const double rate = c * std::pow(width - 1.2, exponent) / std::sqrt(1e-4);
    std::string rows = "since_opening_s,inside,discharged,throat\n";
    for (int i = -1; i <= 200; ++i) {
      const double out = std::max(0.0, rate * i * 0.01);
      rows += std::to_string(i * 0.01) + ',' + std::to_string(1e4 - out) + ',' +
              std::to_string(out) + ",9\n";
    }
    put(run / "discharge.csv", rows);
    runs += ' ' + std::to_string(width);
  }
  return runs;
}

// tan 30 degrees = 1/sqrt 3, tan 60 = sqrt 3, tan 45 = 1; from a + b = 90 degrees on there is no
// gain, and up to there none that jumps.
TEST(Hopper, FactorOfRoseAndTanaka) {
  EXPECT_NEAR(rose_tanaka_factor(30), std::pow(3, 0.175), 1e-12);
  EXPECT_NEAR(rose_tanaka_factor(30, 30), std::pow(3, 0.35), 1e-12);
  EXPECT_NEAR(rose_tanaka_factor(20, 50), rose_tanaka_factor(50, 20), 1e-12);
  EXPECT_NEAR(rose_tanaka_factor(45 - 1e-9), 1, 1e-9);
  for (const double steep : {45., 60., 90.}) EXPECT_EQ(rose_tanaka_factor(steep), 1);
}

// Flat bottoms of 10 and 12 scatter by sqrt 2, their mean by 1, which is more than their own errors
// give. Two hoppers of 22 +- 1.6 and 22 +- 1.2 do not scatter: the mean has hypot(1.6, 1.2)/2 = 1.
TEST(Hopper, RateIsOverThatOfFlatBottomsOfItsWidth) {
  const auto factors = hopper_factors({{5, 90, 10, 0.1},
                                       {6, 30, 9, 0.1},
                                       {5, 30, 22, 1.6},
                                       {5, 90, 12, 0.1},
                                       {5, 60, 11, 0.5},
                                       {5, 30, 22, 1.2}});
  ASSERT_EQ(factors.size(), 2U);
  EXPECT_EQ(factors[0].width, 5);
  EXPECT_EQ(factors[0].half_angle, 30);
  EXPECT_EQ(factors[0].runs, 2U);
  EXPECT_NEAR(factors[0].factor, 2, 1e-12);
  EXPECT_NEAR(factors[0].factor_error, 2 * std::hypot(1. / 22, 1. / 11), 1e-12);
  EXPECT_EQ(factors[1].half_angle, 60);
  EXPECT_EQ(factors[1].runs, 1U);
  EXPECT_NEAR(factors[1].factor, 1, 1e-12);
  EXPECT_NEAR(factors[1].factor_error, std::hypot(0.5 / 11, 1. / 11), 1e-12);
}

// Four runs of exact rates through the command: the numbers, the table and the figures.
TEST(DischargeCommand, FitsRunsOfSeveralWidths) {
  const auto folder = fresh_folder();
  const auto runs = write_runs(folder, 0.9, 1.5, "");
  const auto said = test::run_rodpack("discharge" + runs, folder);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("(D/d_p - k)^(3/2): C = 0.9 +- "));
  EXPECT_THAT(said.output, HasSubstr("k = 1.2 +- "));
  EXPECT_THAT(said.output, HasSubstr("exponent 1.5 +- "));
  for (const char* file : {"outflow.csv", "outflow.png", "outflow.svg"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  const auto one = test::run_rodpack("discharge 5 -o one", folder);
  EXPECT_EQ(one.exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "one.png"));
  EXPECT_EQ(test::run_rodpack("discharge 5 --from 0.7 --to 0.2", folder).exit_code, 2);
  // A run counts once, and with others of the same particles.
  const auto refusal = [&](const std::string& runs) {
    const auto refused = test::run_rodpack("discharge -o refused " + runs, folder);
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    return refused.output;
  };
  EXPECT_THAT(refusal("5 7 9 ./7"),
              HasSubstr("./7: expected each run once, found that of 7 again\n"));
  std::filesystem::copy(folder / "7", folder / "copy");
  EXPECT_THAT(refusal("5 7 9 copy"),
              HasSubstr("copy: expected each run once, found that of 7 again\n"));
  put(folder / "copy/parameters.json",
      "{\"orifice_width_m\": 8e-3, \"particle_diameter_m\": 1e-3, \"gravity_m_s2\": 10, "
      "\"friction\": 0.5}");
  EXPECT_THAT(refusal("5 7 9 copy"), HasSubstr("key 'friction': expected null as in 5, found 0.5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "refused.csv"));
}

TEST(DischargeCommand, ParametersOutOfRangeAreRefused) {
  const auto folder = fresh_folder();
  write_runs(folder, 0.9, 1.5, "");
  const auto refusal = [&](const std::string& parameters) {
    put(folder / "5/parameters.json", "{\"particle_diameter_m\": 1e-3, " + parameters + "}");
    const auto refused = test::run_rodpack("discharge 5", folder);
    EXPECT_EQ(refused.exit_code, 1) << refused.output;
    return refused.output;
  };
  const std::string width = "\"orifice_width_m\": ", gravity = "\"gravity_m_s2\": ";
  for (const char* wrong : {"0", "-1", "1e300", "1e-300"})
    EXPECT_THAT(refusal(std::string(width).append(wrong).append(", ").append(gravity).append("10")),
                HasSubstr("5/parameters.json: key 'orifice_width_m': expected a number of 1e-12"));
  EXPECT_THAT(refusal(width + "5e-3, " + gravity + "0"),
              HasSubstr("key 'gravity_m_s2': expected a number above 0, found 0"));
  const std::string sound = width + "5e-3, " + gravity + "10, ";
  EXPECT_THAT(refusal(sound + "\"close_after_s\": -1"), HasSubstr("key 'close_after_s'"));
  EXPECT_THAT(
      refusal(sound + "\"close_after_s\": 1e-3"),
      HasSubstr("discharge.csv: no row between the opening of the orifice and its closing"));
  for (const std::string axis : {"\"q\"", "\"\"", "\"xy\"", "5", "null"})
    EXPECT_THAT(refusal(std::string(sound).append("\"vertical_axis\": ").append(axis)),
                HasSubstr("key 'vertical_axis': expected \"x\", \"y\" or \"z\", found " + axis));
}

// gnuplot says five lines where it stops: one of them is the reason.
TEST(DischargeCommand, AFigureThatCannotBeWrittenIsOneLine) {
  const auto folder = fresh_folder();
  write_runs(folder, 0.9, 1.5, "");
  const auto said = test::run_rodpack("discharge 5 -o /proc/outflow", folder);
  EXPECT_EQ(said.exit_code, 1);
  const auto begin = said.output.find("rodpack: ");
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(std::count(said.output.begin(), said.output.end(), '\n'), 2) << said.output;
  EXPECT_THAT(said.output.substr(begin),
              HasSubstr("/proc/outflow.png: gnuplot failed to draw it: line "));
}

// A scene in space says so by its vertical axis; the two laws do not mix.
TEST(DischargeCommand, TakesTheLawOfSpaceForASceneInSpace) {
  const auto folder = fresh_folder();
  const auto runs = write_runs(folder, 0.1, 2.5, ", \"vertical_axis\": \"z\"");
  const auto said = test::run_rodpack("discharge" + runs, folder);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("(D/d_p - k)^(5/2): C = 0.1 +- "));
  EXPECT_THAT(said.output, HasSubstr("k = 1.2 +- "));
  EXPECT_THAT(said.output, HasSubstr("exponent 2.5 +- "));
  put(folder / "5" / "parameters.json",
      "{\"orifice_width_m\": 5e-3, \"particle_diameter_m\": 1e-3, \"gravity_m_s2\": 10}");
  const auto mixed = test::run_rodpack("discharge" + runs, folder);
  EXPECT_EQ(mixed.exit_code, 1);
  EXPECT_THAT(mixed.output, HasSubstr("7: expected a scene in a plane as that of 5"));
}

// Hoppers of 30 degrees flow twice as fast as the flat bottoms in these files: each has a law of
// its own, and their rates are compared width by width.
TEST(DischargeCommand, ComparesHoppersWithFlatBottoms) {
  const auto folder = fresh_folder();
  for (const char* name : {"flat", "hopper"}) std::filesystem::create_directory(folder / name);
  write_runs(folder / "flat", 0.06, 2.5, ", \"vertical_axis\": \"z\"");
  write_runs(folder / "hopper", 0.12, 2.5, ", \"vertical_axis\": \"z\", \"half_angle_deg\": 30");
  const auto said =
      test::run_rodpack("discharge flat/5 flat/7 flat/9 hopper/7 hopper/9 hopper/12", folder);
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_THAT(said.output, HasSubstr("hopper/7: D = 7 d_p, half angle 30 deg, flowing"));
  EXPECT_THAT(said.output,
              HasSubstr("flat bottom: Q sqrt(d_p/g) = C (D/d_p - k)^(5/2): C = 0.06 "));
  EXPECT_THAT(said.output,
              HasSubstr("half angle 30 deg: Q sqrt(d_p/g) = C (D/d_p - k)^(5/2): C = 0.12 "));
  EXPECT_THAT(said.output, HasSubstr("D = 7 d_p, half angle 30 deg: 2 +- "));
  EXPECT_THAT(said.output, HasSubstr("of the rate above a flat bottom; Rose and Tanaka 1.212\n"));
  EXPECT_THAT(said.output, HasSubstr("outflow.csv .png .svg, outflow_hopper.csv .png .svg\n"));
  const auto table = test::read_table(folder / "outflow_hopper.csv");
  ASSERT_EQ(table.rows(), 2U);  // widths with a flat bottom
  EXPECT_EQ(table.column("orifice_width_over_dp")[1], 9);
  EXPECT_NEAR(table.column("rate_over_flat_bottom")[1], 2, 1e-6);
  EXPECT_THAT(test::text_of(folder / "outflow.csv"), HasSubstr("\nhopper/9,9,30,"));
  for (const char* file : {"outflow_hopper.png", "outflow_hopper.svg", "outflow.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  put(folder / "flat/5/parameters.json",
      "{\"orifice_width_m\": 5e-3, \"particle_diameter_m\": 1e-3, \"gravity_m_s2\": 10, "
      "\"half_angle_deg\": 95}");
  const auto refused = test::run_rodpack("discharge flat/5", folder);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("key 'half_angle_deg': expected a number above 0, at most "
                                        "90, found 95"));
}

}  // namespace

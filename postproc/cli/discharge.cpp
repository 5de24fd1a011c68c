// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>

#include "analysis/discharge/beverloo_fit.h"
#include "analysis/discharge/hopper_factor.h"
#include "analysis/discharge/outflow.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "figures/discharge/hopper_figure.h"
#include "figures/discharge/outflow_figure.h"
#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/dump.h"
#include "reading/number_text.h"
#include "reading/parameters.h"
#include "reading/space/vertical_axis.h"
#include "reading/text_file.h"

namespace rodpack::cli {
namespace {
namespace fs = std::filesystem;

struct DischargeCommand {
  std::vector<std::string> runs;
  OutflowOptions outflow;
  std::string stem = "outflow";
};

struct MeasuredRun {
  std::string folder;
  RunParameters parameters;
  OutflowHistory history;
  Outflow outflow;
  int dimension;      // 2 in a plane, 3 in space
  double width;       // D / d_p
  double half_angle;  // of the hopper's wall and the vertical, degrees
  double rate_scale;  // sqrt(d_p / g), s
};

MeasuredRun measure_run(const std::string& folder, OutflowOptions options) {
  auto parameters = read_parameters((fs::path(folder) / "parameters.json").string());
  const double width = parameters.number("orifice_width_m");
  const double g = parameters.positive_number("gravity_m_s2");
  const double diameter = parameters.number("particle_diameter_m");
  if (parameters.values.contains("close_after_s") && parameters.number("close_after_s") > 0)
    options.closed_at = parameters.number("close_after_s");
  // A scene in space states which axis is the vertical one.
  const int dimension = vertical_axis(parameters) ? 3 : 2;
  const double half_angle = parameters.values.contains("half_angle_deg")
                                ? parameters.number("half_angle_deg")
                                : flat_bottom;
  auto history = read_outflow((fs::path(folder) / "discharge.csv").string());
  auto outflow = measure_outflow(history, options);
  return {folder,    std::move(parameters), std::move(history), outflow,
          dimension, width / diameter,      half_angle,         std::sqrt(diameter / g)};
}

// One law holds for particles of one shape and friction, and a run that counts twice would make the
// errors too small.
void require_other_run_of_the_same_particles(const MeasuredRun& run, const MeasuredRun& first) {
  require_other_folder(run.folder, first.folder);
  if (run.outflow.discharged > 0 && run.width == first.width &&
      run.history.time == first.history.time && run.history.discharged == first.history.discharged)
    refuse_run_again(run.folder, first.folder);
  for (const char* key : {"aspect_ratio", "overlap", "size_spread", "friction",
                          "damping_ratio_normal", "damping_ratio_tangential"}) {
    const auto expected = first.parameters.values.value(key, nlohmann::json());
    const auto found = run.parameters.values.value(key, nlohmann::json());
    if (found != expected)
      throw DataError(run.parameters.file + ": key '" + key + "': expected " + expected.dump() +
                      " as in " + first.folder + ", found " + found.dump() +
                      ": other particles do not share a law");
  }
}

void write_table(const std::vector<MeasuredRun>& runs, const std::string& file) {
  std::string text =
      csv_line({"run", "orifice_width_over_dp", "half_angle_deg", "rate_per_s", "rate_sem_per_s",
                "rate_times_sqrt_dp_over_g", "rate_sem_times_sqrt_dp_over_g", "from_s", "to_s",
                "discharged", "inside", "last_outflow_s", "end"}) +
      '\n';
  for (const auto& run : runs) {
    const auto& out = run.outflow;
    const auto scaled = [&](std::optional<double> rate) {
      if (rate) *rate *= run.rate_scale;
      return rate;
    };
    text += csv_line({run.folder, number_text(run.width), number_text(run.half_angle),
                      csv_number(out.rate), csv_number(out.rate_error),
                      csv_number(scaled(out.rate)), csv_number(scaled(out.rate_error)),
                      number_text(out.from), number_text(out.to), number_text(out.discharged),
                      number_text(out.inside), number_text(out.last), describe(out.end)});
    text += '\n';
  }
  write_text(file, text);
}

void print_run(const MeasuredRun& run) {
  const auto& out = run.outflow;
  std::cout << run.folder << ": D = " << number_text(run.width, 4) << " d_p, "
            << (run.half_angle < flat_bottom
                    ? "half angle " + number_text(run.half_angle, 4) + " deg, "
                    : "")
            << describe(out.end) << " at the end, " << number_text(out.discharged, 5)
            << " particles out, " << number_text(out.inside, 5) << " inside";
  if (out.rate)
    std::cout << "; Q = " << number_text(*out.rate, 4) << " +- " << number_text(*out.rate_error, 2)
              << " /s from " << number_text(out.from, 3) << " to " << number_text(out.to, 3)
              << " s, Q sqrt(d_p/g) = " << number_text(*out.rate * run.rate_scale, 4);
  else
    std::cout << "; too few for a steady rate";
  std::cout << '\n';
}

// The law of the runs of one half angle with a steady flow; none, and a line that says why, where
// there are too few. `before`: of the lines on the terminal.
void fit_law(WidthSeries& series, int dimension, const std::string& before) {
  try {
    series.fit = fit_beverloo(series.width, series.rate, dimension);
    const auto& fit = *series.fit;
    std::cout << before << "Q sqrt(d_p/g) = C (D/d_p - k)^(" << 2 * dimension - 1
              << "/2): C = " << number_text(fit.c, 3) << " +- " << number_text(fit.c_error, 2)
              << ", k = " << number_text(fit.k, 3) << " +- " << number_text(fit.k_error, 2) << '\n';
    if (fit.exponent)
      std::cout << before << "with C, k and the exponent free: exponent "
                << number_text(*fit.exponent, 3) << " +- " << number_text(*fit.exponent_error, 2)
                << '\n';
  } catch (const TooFewParticles& why) {
    std::cout << before << why.what() << '\n';
  }
}

// Rate over width, a series per half angle, the flattest one first.
void fit_and_draw(const std::vector<MeasuredRun>& runs, const std::string& stem) {
  std::map<double, WidthSeries, std::greater<>> by_angle;
  bool any = false;
  for (const auto& run : runs) {
    auto& series = by_angle[run.half_angle];
    if (run.outflow.end == OutflowEnd::clogged) {
      series.clogged.push_back(run.width);
    } else if (run.outflow.rate) {
      series.width.push_back(run.width);
      series.rate.push_back(*run.outflow.rate * run.rate_scale);
      series.error.push_back(*run.outflow.rate_error * run.rate_scale);
    }
    any = any || !series.clogged.empty() || !series.width.empty();
  }
  if (!any) throw TooFewParticles("discharge: none of the runs has a steady rate or is clogged");
  std::vector<WidthSeries> all;
  for (auto& [half_angle, series] : by_angle) {
    series.name = half_angle == flat_bottom ? "flat bottom"
                                            : "half angle " + number_text(half_angle, 4) + "°";
    const bool alone = by_angle.size() == 1;
    fit_law(series, runs.front().dimension,
            alone                       ? ""
            : half_angle == flat_bottom ? "flat bottom: "
                                        : "half angle " + number_text(half_angle, 4) + " deg: ");
    all.push_back(std::move(series));
  }
  plot_beverloo(all, stem);
}

// The hoppers beside flat bottoms of their widths, where there are such.
std::string compare_hoppers(const std::vector<MeasuredRun>& runs, const std::string& stem) {
  std::vector<HopperRate> rates;
  for (const auto& run : runs)
    if (run.outflow.end != OutflowEnd::clogged && run.outflow.rate)
      rates.push_back({run.width, run.half_angle, *run.outflow.rate * run.rate_scale,
                       *run.outflow.rate_error * run.rate_scale});
  const auto factors = hopper_factors(rates);
  if (factors.empty()) return "";
  std::vector<std::vector<double>> columns(6);
  for (const auto& each : factors) {
    const double law = rose_tanaka_factor(each.half_angle);
    const double row[] = {each.width,  each.half_angle,   static_cast<double>(each.runs),
                          each.factor, each.factor_error, law};
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(row[c]);
    std::cout << "D = " << number_text(each.width, 4) << " d_p, half angle "
              << number_text(each.half_angle, 4) << " deg: " << number_text(each.factor, 4)
              << " +- " << number_text(each.factor_error, 2)
              << " of the rate above a flat bottom; Rose and Tanaka " << number_text(law, 4)
              << '\n';
  }
  write_csv(stem + "_hopper.csv", {{"orifice_width_over_dp", columns[0]},
                                   {"half_angle_deg", columns[1]},
                                   {"runs", columns[2]},
                                   {"rate_over_flat_bottom", columns[3]},
                                   {"standard_error", columns[4]},
                                   {"rose_tanaka", columns[5]}});
  plot_hopper_factors(factors, stem + "_hopper");
  return ", " + stem + "_hopper.csv .png .svg";
}

void run_discharge(const DischargeCommand& command) {
  if (command.outflow.from >= command.outflow.to)
    throw CLI::ValidationError("--from", "expected less than --to, found " +
                                             number_text(command.outflow.from) + " and " +
                                             number_text(command.outflow.to));
  std::vector<MeasuredRun> runs;
  for (const auto& folder : command.runs) {
    auto run = measure_run(folder, command.outflow);
    for (const auto& earlier : runs) require_other_run_of_the_same_particles(run, earlier);
    runs.push_back(std::move(run));
  }
  for (const auto& run : runs)
    if (run.dimension != runs.front().dimension)
      throw DataError(run.folder + ": expected a scene " +
                      (runs.front().dimension == 3 ? "in space" : "in a plane") + " as that of " +
                      runs.front().folder);
  for (const auto& run : runs) print_run(run);
  if (runs.size() == 1)
    plot_outflow(runs.front().history, runs.front().outflow, command.stem);
  else
    fit_and_draw(runs, command.stem);
  const auto hoppers = compare_hoppers(runs, command.stem);
  write_table(runs, command.stem + ".csv");
  std::cout << "written: " << command.stem << ".csv .png .svg" << hoppers << '\n';
}

}  // namespace

void add_discharge(CLI::App& app) {
  auto options = std::make_shared<DischargeCommand>();
  auto* command = app.add_subcommand(
      "discharge",
      "Flow through an orifice, of runs of inputs/discharge/ and inputs/discharge3d/: steady rate "
      "with its standard error, "
      "clogged or not; of several widths Beverloo's law, with exponent 3/2 in a plane "
      "and 5/2 in space, and the exponent; of hoppers the rate over that of flat bottoms.");
  command->footer(
      "Examples:\n"
      "  rodpack discharge results/orifice_24mm\n"
      "writes outflow.csv and outflow.png/.svg, the discharged particles over time.\n"
      "  rodpack discharge results/orifice_*\n"
      "writes a row per run and the figure of the rate over the width.\n"
      "  rodpack discharge results/flat results/hopper_*\n"
      "writes outflow_hopper.csv and outflow_hopper.png/.svg too: what the half angle does.");
  command->add_option("runs", options->runs, "run folders FOLDER...")
      ->required()
      ->check(existing_folder());
  command
      ->add_option("--from", options->outflow.from,
                   "share of all that comes through at which the steady flow begins")
      ->check(number(0, 1))
      ->capture_default_str();
  command->add_option("--to", options->outflow.to, "share at which it ends")
      ->check(number(0, 1))
      ->capture_default_str();
  command
      ->add_option("--stopped-after", options->outflow.stopped_after,
                   "time without outflow at the end, s, after which it has stopped")
      ->check(positive_number(1e6))
      ->capture_default_str();
  add_output(*command, options->stem);
  command->callback([options] { run_discharge(*options); });
}

}  // namespace rodpack::cli

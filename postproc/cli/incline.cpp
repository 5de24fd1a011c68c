// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "analysis/incline/chute_motion.h"
#include "analysis/incline/chute_profile.h"
#include "cli/checks.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "figures/incline/chute_figure.h"
#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"
#include "reading/text_file.h"

namespace rodpack::cli {
namespace {
namespace fs = std::filesystem;

struct InclineCommand {
  std::vector<std::string> runs;
  double last = 0.5;
  std::optional<double> scale;  // in d_p
  std::string stem = "chute";
};

struct MeasuredSlope {
  std::string folder;
  ChuteProfile profile;
  ChuteMotion motion;
  std::vector<double> time;  // of the frames, s
  std::optional<ShearLaw> shear;
  std::optional<ChuteBulk> bulk;
  double speed;  // sqrt(g d_p), m/s
};

// The last files, one frame each, from which a share of all is left.
std::vector<std::string> last_of(std::vector<std::string> files, double share) {
  const auto count = static_cast<double>(files.size());
  const auto kept = static_cast<std::ptrdiff_t>(std::max(1.0, std::floor(share * count)));
  files.erase(files.begin(), files.end() - kept);
  return files;
}

double mean_velocity(const Frame& bodies) {
  const auto &mass = bodies.column("mass"), &v = bodies.column("vx");
  double momentum = 0, all = 0;
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    momentum += mass[i] * v[i];
    all += mass[i];
  }
  return momentum / all;
}

MeasuredSlope measure_slope(const std::string& folder, const InclineCommand& command) {
  const auto parameters = read_parameters((fs::path(folder) / "parameters.json").string());
  const Slope slope{parameters.number("inclination_deg") * degree,
                    parameters.positive_number("gravity_m_s2")};
  const double d = parameters.number("particle_diameter_m"), dt = parameters.number("timestep_s");
  const auto contact_files = dumps_of_run(folder, "contacts");
  std::optional<double> scale;
  if (command.scale) scale = *command.scale * d;
  ChuteSample sample(slope, scale);
  MeasuredSlope run;
  std::vector<double> velocity;
  std::size_t particles = 0;
  PackingOptions options;
  options.parameters = parameters.file;
  for_each_frame(last_of(dumps_of_run(folder, "bodies"), command.last), [&](const Frame& bodies) {
    if (particles == 0) particles = bodies.rows;
    if (bodies.rows != particles)
      throw DataError(bodies.file + ": expected " + std::to_string(particles) +
                      " particles as in the frame before, found " + std::to_string(bodies.rows) +
                      ": give --last so that all frames are of the filled plane");
    sample.add(read_packing(bodies, options), bodies, frame_beside(bodies, contact_files));
    run.time.push_back(static_cast<double>(bodies.timestep) * dt);
    velocity.push_back(mean_velocity(bodies));
  });
  run.folder = folder;
  run.profile = sample.result();
  run.speed = std::sqrt(slope.gravity * d);
  run.motion = measure_motion(run.time, velocity, run.speed);
  run.bulk = bulk_of(run.profile);
  if (run.motion.state != ChuteState::at_rest) run.shear = fit_shear(run.profile);
  return run;
}

void print_slope(const MeasuredSlope& run) {
  const auto& profile = run.profile;
  const auto imbalance = imbalance_of(profile);
  std::cout << run.folder << ": " << number_text(profile.slope.angle * degrees_in_radian, 4)
            << " degrees (tan " << number_text(std::tan(profile.slope.angle), 4) << "), "
            << describe(run.motion.state) << ", " << run.time.size() << " frames from "
            << number_text(run.time.front(), 4) << " to " << number_text(run.time.back(), 4)
            << " s\n  mean velocity " << number_text(run.motion.velocity / run.speed, 3)
            << " sqrt(g d_p), acceleration "
            << number_text(run.motion.acceleration / profile.slope.gravity, 2) << " g, bed "
            << number_text(profile.surface / profile.particle_diameter, 3) << " d_p high\n";
  std::cout << "  stress against the weight above: normal within "
            << number_text(100 * imbalance.onto, 2) << " %, shear within "
            << number_text(100 * imbalance.down, 2) << " % of the largest load\n";
  if (!run.bulk) {
    std::cout << "  too low for a place 3 w from base and surface\n";
    return;
  }
  std::cout << "  3 w from base and surface: -sigma_xy / sigma_yy = "
            << number_text(run.bulk->friction, 3)
            << ", solid fraction = " << number_text(run.bulk->solid_fraction, 4);
  if (run.shear)
    std::cout << ", inertial number = " << number_text(run.bulk->inertial_number, 3)
              << ", shear rate ~ depth^n with n = " << number_text(run.shear->exponent, 2) << " +- "
              << number_text(run.shear->exponent_error, 2);
  std::cout << '\n';
}

std::string or_empty(bool there, double value) { return there ? number_text(value) : ""; }

void write_slopes(const std::vector<MeasuredSlope>& runs, const std::string& file) {
  std::string text =
      csv_line({"run", "inclination_deg", "state", "velocity_over_sqrt_g_dp", "acceleration_over_g",
                "bed_height_over_dp", "friction", "inertial_number", "solid_fraction",
                "shear_exponent", "shear_exponent_sem", "imbalance_onto", "imbalance_down"}) +
      '\n';
  for (const auto& run : runs) {
    const auto bulk = run.bulk.value_or(ChuteBulk{});
    const auto shear = run.shear.value_or(ShearLaw{});
    const auto imbalance = imbalance_of(run.profile);
    const bool moves = run.bulk && run.motion.state != ChuteState::at_rest;
    text += csv_line({run.folder, number_text(run.profile.slope.angle * degrees_in_radian),
                      describe(run.motion.state), number_text(run.motion.velocity / run.speed),
                      number_text(run.motion.acceleration / run.profile.slope.gravity),
                      number_text(run.profile.surface / run.profile.particle_diameter),
                      or_empty(run.bulk.has_value(), bulk.friction),
                      or_empty(moves, bulk.inertial_number),
                      or_empty(run.bulk.has_value(), bulk.solid_fraction),
                      or_empty(run.shear.has_value(), shear.exponent),
                      or_empty(run.shear.has_value(), shear.exponent_error),
                      number_text(imbalance.onto), number_text(imbalance.down)}) +
            '\n';
  }
  write_text(file, text);
}

void run_incline(const InclineCommand& command) {
  std::vector<MeasuredSlope> runs;
  for (const auto& folder : command.runs) {
    for (const auto& earlier : runs) require_other_folder(folder, earlier.folder);
    runs.push_back(measure_slope(folder, command));
  }
  for (const auto& run : runs) print_slope(run);
  const auto& stem = command.stem;
  if (runs.size() == 1) {
    write_chute_table(runs.front().profile, stem + ".csv");
    plot_chute(runs.front().profile, stem);
    std::cout << "written: " << stem << ".csv .png .svg\n";
    return;
  }
  write_slopes(runs, stem + ".csv");
  std::vector<double> number, friction, fraction;
  for (const auto& run : runs) {
    if (run.motion.state != ChuteState::steady || !run.bulk) continue;
    number.push_back(run.bulk->inertial_number);
    friction.push_back(run.bulk->friction);
    fraction.push_back(run.bulk->solid_fraction);
  }
  if (number.empty()) {
    std::cout << "none of the flows is steady: no figure\nwritten: " << stem << ".csv\n";
    return;
  }
  plot_rheology(number, friction, fraction, stem);
  std::cout << "written: " << stem << ".csv .png .svg\n";
}

}  // namespace

void add_incline(CLI::App& app) {
  auto options = std::make_shared<InclineCommand>();
  auto* command = app.add_subcommand(
      "incline",
      "A bed on an inclined plane, of runs of inputs/incline/: at rest, steady or accelerating; "
      "velocity, solid fraction and stresses over the height above the base, beside the weight "
      "that they carry; of several runs friction and solid fraction over the inertial number.");
  command->footer(
      "Examples:\n"
      "  rodpack incline results/chute_18\n"
      "writes chute.csv and chute.png/.svg, the profiles.\n"
      "  rodpack incline results/chute_*\n"
      "writes a row per run and the figure of the steady ones.");
  command->add_option("runs", options->runs, "run folders FOLDER...")
      ->required()
      ->check(existing_folder());
  command
      ->add_option("--last", options->last, "share of the frames that is averaged over, at the end")
      ->check(positive_number(1))
      ->capture_default_str();
  command
      ->add_option("--scale-in-dp", options->scale,
                   "scale w of the averaging, d_p [default: AR/2, at least 1]")
      ->check(number(1e-3, 1e4))
      ->type_name("N");
  add_output(*command, options->stem);
  command->callback([options] { run_incline(*options); });
}

}  // namespace rodpack::cli

// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "campaigns/comparison/comparison.h"
#include "campaigns/launch/deck_folder.h"
#include "campaigns/launch/deck_run.h"
#include "campaigns/launch/step_timing.h"
#include "reading/text.h"

namespace rodpack::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string out;
  Liggghts liggghts;
  std::string inputs;
  long particles = 120;
  long seed = 1;
  double time = 0.6;
  long every = 100;
  double limit = 0.01;
  int rounds = 5;
  long timed_steps = 5000;
};

/// Runs the stages of the deck, each in a folder of its own below OUT/runs.
class Stages {
 public:
  explicit Stages(const Options& options)
      : options_(options),
        liggghts_(options.liggghts),
        deck_(find_deck("comparison/in.comparison", options.inputs)),
        runs_(fs::path(options.out) / "runs") {
    if (liggghts_.program.empty()) liggghts_.program = liggghts_beside_this_program();
  }

  std::string folder(const std::string& name) const { return (runs_ / name).string(); }

  /// The start states, of exact and of sampled bodies.
  void start() {
    progress("start state of " + std::to_string(options_.particles) + " rods");
    run("start", {{"stage", "start"}});
    run("start_sampled", {{"stage", "start"}, {"template", "sampled"}});
    const double timestep = read_parameters(folder("start/parameters.json")).number("timestep_s");
    const auto every = static_cast<double>(options_.every);
    steps_ = static_cast<long>(std::ceil(options_.time / timestep / every) * every);
  }

  MethodRun fall(const std::string& name, const std::string& method, const std::string& body) {
    progress(name + ": " + std::to_string(steps_) + " steps");
    run(name,
        {{"stage", "run"},
         {"method", method},
         {"template", body},
         {"start", body == "sampled" ? "../start_sampled/start.restart" : "../start/start.restart"},
         {"steps", std::to_string(steps_)},
         {"every", std::to_string(options_.every)}});
    return read_method_run(name, folder(name));
  }

  StepTimes times(const std::string& state, const std::string& restart) {
    progress("time per step, " + state + ": " + std::to_string(options_.rounds) + " rounds of " +
             std::to_string(options_.timed_steps) + " steps");
    const std::vector<std::string> methods = {"builtin", "rodpack"};
    const auto seconds = measure_in_turns(2, options_.rounds, [&](int who, int round) {
      const auto& method = methods[static_cast<std::size_t>(who)];
      const auto name = "time_" + state + "_" + method + "_" + std::to_string(round + 1);
      return time_per_step(run(name, {{"stage", "time"},
                                      {"method", method},
                                      {"start", restart},
                                      {"steps", std::to_string(options_.timed_steps)}}));
    });
    return {state, seconds[0], seconds[1]};
  }

 private:
  static void progress(const std::string& text) { std::cout << text << " ..." << std::endl; }

  std::string run(const std::string& name, DeckVariables variables) const {
    variables["particles"] = std::to_string(options_.particles);
    variables["seed"] = std::to_string(options_.seed);
    return run_deck(liggghts_, deck_, variables, folder(name));
  }

  const Options& options_;
  Liggghts liggghts_;
  std::string deck_;
  fs::path runs_;
  long steps_ = 0;
};

void refuse_what_is_there(const std::string& out) {
  if (fs::exists(out) && (!fs::is_directory(out) || !fs::is_empty(out)))
    throw DataError(out + ": expected a new or empty folder, found " +
                    (!fs::is_directory(out)                      ? "a file"
                     : fs::exists(fs::path(out) / "compare.csv") ? "a comparison"
                                                                 : "other files") +
                    "; nothing is overwritten");
}

void compare(const Options& options) {
  refuse_what_is_there(options.out);
  Stages stages(options);
  std::string processors;
  {
    // Too few processors for the timing are an error before the long runs.
    const ProcessorPin pin(options.liggghts.ranks);
    processors = pin.processors();
  }
  stages.start();
  Comparison comparison;
  comparison.builtin = stages.fall("builtin", "builtin", "exact");
  comparison.rodpack = stages.fall("rodpack", "rodpack", "exact");
  comparison.sampled = stages.fall("builtin_sampled", "builtin", "sampled");
  const auto parameters = read_parameters(stages.folder("rodpack/parameters.json"));
  comparison.exact = exact_mass_properties(parameters);
  comparison.particle_diameter = parameters.number("particle_diameter_m");
  comparison.limit = options.limit * comparison.particle_diameter;
  const auto from_rodpack = [&](const MethodRun& run) {
    return separate(run.bodies, comparison.rodpack.bodies, comparison.limit);
  };
  comparison.builtin_rodpack = from_rodpack(comparison.builtin);
  comparison.sampled_rodpack = from_rodpack(comparison.sampled);
  {
    const ProcessorPin pin(options.liggghts.ranks);
    comparison.step_times = {stages.times("falling", "../start/start.restart"),
                             stages.times("at_the_end", "../builtin/end.restart")};
  }
  const auto file = [&](const std::string& name) {
    return (fs::path(options.out) / name).string();
  };
  const auto rows = comparison_rows(comparison);
  write_trajectories(comparison, file("trajectories.csv"));
  write_separation(comparison, file("separation.csv"));
  write_energies(comparison, file("energies.csv"));
  write_step_times(comparison, file("times.csv"));
  plot_separation(comparison, file("separation"));
  plot_energy_comparison(comparison, file("energies"));
  write_comparison(rows, file("compare.csv"));
  std::cout
      << '\n'
      << comparison_text(rows)
      << "\nbuiltin: fix multisphere (velocity Verlet) with the exact bodies; rodpack: "
         "multisphere/ab order 3 with\n"
         "enforce2d/multisphere; builtin_sampled: fix multisphere with the stock template "
         "(fflag, tflag).\n"
      << "Parted: a centre is more than " << number_text(options.limit)
      << " d_p from that of rodpack; seen every " << options.every
      << " steps. From then on the beds are different draws:\ntheir contacts, solid fractions and "
         "orientations differ by chance as well.\nTimes: medians of "
      << options.rounds << " rounds in turns on processors " << processors
      << ", measured on this machine "
      << "with whatever else ran on it.\nwritten: " << options.out
      << "/compare.csv, trajectories.csv, separation.csv .png .svg, energies.csv .png .svg, "
         "times.csv, runs/\n";
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand(
      "compare",
      "LIGGGHTS's built-in fix multisphere beside fix multisphere/ab: one small bed of rods, "
      "started from one state, falls and comes to rest with either. Shows when the trajectories "
      "part, masses, motion out of the plane, energies, contacts, solid fraction, orientation and "
      "time per step.");
  command->footer(
      "Example:\n"
      "  rodpack compare results/compare --particles 120\n"
      "runs inputs/comparison/in.comparison (half a minute) and writes compare.csv, "
      "trajectories.csv,\n"
      "separation.csv, energies.csv, times.csv and figures into results/compare.");
  command->add_option("out", options->out, "new folder for the results")
      ->required()
      ->type_name("OUT");
  command->add_option("--liggghts", options->liggghts.program, "LIGGGHTS; default: beside rodpack")
      ->check(CLI::ExistingFile)
      ->type_name("PROGRAM");
  command
      ->add_option("--inputs", options->inputs,
                   "the folder inputs/; default: that of the repository")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER");
  const auto number = [command](const std::string& name, auto& value, const std::string& text,
                                const CLI::Validator& range) {
    command->add_option(name, value, text)->check(range)->capture_default_str();
  };
  number("--particles", options->particles, "number of rods", CLI::Range(2L, 100000L));
  number("--seed", options->seed, "of angles and velocities", CLI::Range(1L, 1000000L));
  number("--time", options->time, "simulated time, s", CLI::Range(1e-3, 1000.0));
  number("--every", options->every, "steps between frames", CLI::Range(1L, 1000000L));
  number("--limit", options->limit, "distance at which trajectories have parted, d_p",
         CLI::Range(1e-15, 1e3));
  number("--ranks", options->liggghts.ranks, "MPI ranks of each run", CLI::Range(1, 1024));
  number("--rounds", options->rounds, "rounds of timing", CLI::Range(5, 1000));
  number("--timed-steps", options->timed_steps, "steps of a timed run", CLI::Range(1L, 100000000L));
  command->callback([options] { compare(*options); });
}

}  // namespace rodpack::cli

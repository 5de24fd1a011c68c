// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/comparison/compare_methods.h"

#include <cmath>
#include <filesystem>
#include <ostream>

#include "campaigns/launch/deck_folder.h"
#include "campaigns/launch/step_timing.h"
#include "reading/data_error.h"
#include "reading/parameters.h"

namespace rodpack {
namespace {

namespace fs = std::filesystem;

/// Runs the stages of the deck, each in a folder of its own below OUT/runs.
class Stages {
 public:
  Stages(const ComparisonOptions& options, std::ostream& progress)
      : options_(options),
        progress_(progress),
        liggghts_(options.liggghts),
        deck_(find_deck("comparison/in.comparison", options.inputs)),
        runs_(fs::path(options.out) / "runs") {
    if (liggghts_.program.empty()) liggghts_.program = liggghts_beside_this_program();
  }

  std::string folder(const std::string& name) const { return (runs_ / name).string(); }

  /// Makes the start states, of exact and of sampled bodies.
  void start() {
    say("start state of " + std::to_string(options_.particles) + " rods");
    run("start", {{"stage", "start"}});
    run("start_sampled", {{"stage", "start"}, {"template", "sampled"}});
    const double timestep = read_parameters(folder("start/parameters.json")).number("timestep_s");
    const auto every = static_cast<double>(options_.every);
    steps_ = static_cast<long>(std::ceil(options_.time / timestep / every) * every);
  }

  MethodRun fall(const std::string& name, const std::string& method, const std::string& body) {
    say(name + ": " + std::to_string(steps_) + " steps");
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
    say("time per step, " + state + ": " + std::to_string(options_.rounds) + " rounds of " +
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
  void say(const std::string& text) const { progress_ << text << " ..." << std::endl; }

  std::string run(const std::string& name, DeckVariables variables) const {
    variables["particles"] = std::to_string(options_.particles);
    variables["seed"] = std::to_string(options_.seed);
    return run_deck(liggghts_, deck_, variables, folder(name));
  }

  const ComparisonOptions& options_;
  std::ostream& progress_;
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

}  // namespace

ComparisonOutcome compare_methods(const ComparisonOptions& options, std::ostream& progress) {
  refuse_what_is_there(options.out);
  Stages stages(options, progress);
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
  return {rows, processors};
}

}  // namespace rodpack

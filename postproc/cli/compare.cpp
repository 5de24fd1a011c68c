// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/comparison/compare_methods.h"

#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "reading/number_text.h"

namespace rodpack::cli {
namespace {

void compare(const ComparisonOptions& options) {
  const auto outcome = compare_methods(options, std::cout);
  std::cout
      << '\n'
      << comparison_text(outcome.rows)
      << "\nbuiltin: fix multisphere (velocity Verlet) with the exact bodies; rodpack: "
         "multisphere/ab order 3 with\n"
         "enforce2d/multisphere; builtin_sampled: fix multisphere with the stock template "
         "(fflag, tflag).\n"
      << "Parted: a centre is more than " << number_text(options.limit)
      << " d_p from that of rodpack; seen every " << options.every
      << " steps. From then on the beds are different draws:\ntheir contacts, solid fractions and "
         "orientations differ by chance as well.\nTimes: medians of "
      << options.rounds << " rounds in turns on processors " << outcome.processors
      << ", measured on this machine "
      << "with whatever else ran on it.\nwritten: " << options.out
      << "/compare.csv, trajectories.csv, separation.csv .png .svg, energies.csv .png .svg, "
         "times.csv, runs/\n";
}

}  // namespace

void add_compare(CLI::App& app) {
  auto options = std::make_shared<ComparisonOptions>();
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

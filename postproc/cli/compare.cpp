// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/comparison/compare_methods.h"

#include <iostream>
#include <memory>

#include "cli/checks.h"
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
      ->check(some_name())
      ->type_name("OUT");
  command->add_option("--liggghts", options->liggghts.program, "LIGGGHTS; default: beside rodpack")
      ->check(existing_program())
      ->type_name("PROGRAM");
  command
      ->add_option("--inputs", options->inputs,
                   "the folder inputs/; default: that of the repository")
      ->check(existing_folder())
      ->type_name("FOLDER");
  const auto number = [command](const std::string& name, auto& value, const std::string& text,
                                const CLI::Validator& range) {
    command->add_option(name, value, text)->check(range)->capture_default_str();
  };
  number("--particles", options->particles, "number of rods", whole_number(2, 100000));
  number("--seed", options->seed, "of angles and velocities", whole_number(1, 1000000));
  number("--time", options->time, "simulated time, s", cli::number(1e-3, 1000));
  number("--every", options->every, "steps between frames", whole_number(1, 1000000));
  number("--limit", options->limit, "distance at which trajectories have parted, d_p",
         cli::number(1e-15, 1e3));
  number("--ranks", options->liggghts.ranks, "MPI ranks of each run", whole_number(1, 1024));
  number("--rounds", options->rounds, "rounds of timing", whole_number(5, 1000));
  number("--timed-steps", options->timed_steps, "steps of a timed run", whole_number(1, 100000000));
  command->callback([options] { compare(*options); });
}

}  // namespace rodpack::cli

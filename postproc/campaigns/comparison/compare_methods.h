// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_COMPARISON_COMPARE_METHODS_H
#define RODPACK_CAMPAIGNS_COMPARISON_COMPARE_METHODS_H

#include <iosfwd>
#include <string>
#include <vector>

#include "campaigns/comparison/comparison.h"
#include "campaigns/launch/deck_run.h"

namespace rodpack {

struct ComparisonOptions {
  std::string out;       // new or empty folder of the results
  Liggghts liggghts;     // program empty: the one beside this program
  std::string inputs;    // folder inputs/; empty: find_deck looks for it
  long particles = 120;  // rods
  long seed = 1;         // of their angles and velocities
  double time = 0.6;     // simulated, s
  long every = 100;      // steps between frames
  double limit = 0.01;   // distance from which trajectories have parted, d_p
  int rounds = 5;        // of timing
  long timed_steps = 5000;
};

struct ComparisonOutcome {
  std::vector<ComparisonRow> rows;  // of compare.csv
  std::string processors;           // on which the steps were timed, "0,1"
};

/// Runs inputs/comparison/in.comparison with the built-in fix multisphere and with ours, each stage
/// in a folder below `options.out`/runs, times both, and writes compare.csv, trajectories.csv,
/// separation.csv, energies.csv, times.csv and two figures. Lines of progress go to `progress`.
/// @throws DataError when `options.out` holds anything, there are fewer processors than ranks, or a
/// run fails.
ComparisonOutcome compare_methods(const ComparisonOptions& options, std::ostream& progress);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_RUN_COST_H
#define RODPACK_ENSEMBLE_RUN_COST_H

#include <optional>
#include <string>

namespace rodpack {

/// What a run took, without LIGGGHTS's set-up and this package's analysis.
struct RunCost {
  double wall_time_s = 0;   // of all time-stepping loops, those that were cut short included
  double core_seconds = 0;  // each times its MPI ranks
};

/// Reads it from log.liggghts, to which resumed runs append: the loop times; for a loop that was
/// cut short the last `cpu` that its thermo output told. None when the log is missing or tells of
/// no loop.
std::optional<RunCost> cost_of_run(const std::string& log);

}  // namespace rodpack

#endif

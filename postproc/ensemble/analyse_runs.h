// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_ANALYSE_RUNS_H
#define RODPACK_ENSEMBLE_ANALYSE_RUNS_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rodpack {

/// Called after each run: how many are done, of how many, and the folder.
using AnalysisProgress =
    std::function<void(std::size_t done, std::size_t of, const std::string& folder)>;

/// Runs `program` analyse FOLDER for every folder, up to `jobs` processes at a time. They end with
/// this one; what they had finished stays and is not repeated.
/// @throws DataError with the first failing run's own error line, after the others have ended.
void analyse_runs(const std::vector<std::string>& folders, int jobs, const std::string& program,
                  const AnalysisProgress& progress);

}  // namespace rodpack

#endif

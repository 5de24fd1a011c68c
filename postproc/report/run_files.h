// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_RUN_FILES_H
#define RODPACK_REPORT_RUN_FILES_H

#include <optional>
#include <string>
#include <vector>

#include "reading/dump.h"
#include "reading/parameters.h"

namespace rodpack {

/// What a run folder holds for analyse_run(), the only one that includes this.
struct RunFiles {
  std::optional<RunParameters> parameters;
  bool own_parameters = false;                        // they are `run`/parameters.json
  std::vector<std::string> body_files, sphere_files;  // in order of time
  Frame bodies;                                       // the last frame
  std::optional<Frame> spheres;                       // the last frame
  std::vector<std::string> notes;  // what is missing, why, and what would give it
};

/// Finds them: dumps in `run`/dumps, else in `run`; parameters.json at `given`, else in `run`, else
/// as find_parameters() does. A folder without its own one is anybody's, so that its dumps are
/// checked to be of one run.
/// @throws DataError when there is no such folder, no dump of bodies, or dumps are of several runs.
RunFiles find_run_files(const std::string& run, const std::string& given);

}  // namespace rodpack

#endif

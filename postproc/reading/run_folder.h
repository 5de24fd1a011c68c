// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_RUN_FOLDER_H
#define RODPACK_READING_RUN_FOLDER_H

#include <string>
#include <vector>

namespace rodpack {

/// "format" of analysis/summary.json. The number rises when a number in it or a table beside it is
/// added or changes its meaning, so that analyses of before are not mixed with later ones.
constexpr const char* analysis_format = "rodpack-analysis 3";

/// Files `kind`.*.dump and `kind`.dump, plain or .gz, that lie in `folder` itself, in no order;
/// none where there is no such folder.
std::vector<std::string> dumps_in(const std::string& folder, const std::string& kind);

/// Dumps of this kind in `run`/dumps, or, where it has none, in `run`, in order of time. A run that
/// was resumed may end earlier than the one that was interrupted had come: dumps after the step
/// that `run`/result.json names as its end are of a course that the run did not take, and are left
/// out.
/// @throws DataError when there are none, or result.json names no step.
std::vector<std::string> dumps_of_run(const std::string& run, const std::string& kind);

}  // namespace rodpack

#endif

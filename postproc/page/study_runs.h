// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PAGE_STUDY_RUNS_H
#define RODPACK_PAGE_STUDY_RUNS_H

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ensemble/ensemble.h"
#include "ensemble/run_cost.h"
#include "page/frame.h"

namespace rodpack {

/// One run of a study and what its folder tells; what is missing is empty.
struct StudyRun {
  std::string case_name;
  long seed = 0;
  std::string folder;
  nlohmann::ordered_json parameters, result, summary;
  std::optional<RunCost> cost;
};

/// A study as its page needs it.
struct Study {
  std::string folder;            // as the user named it
  std::string results;           // folder of ensemble.json and the figures
  nlohmann::ordered_json table;  // cases.json; empty where there is none
  Ensemble ensemble;
  std::vector<StudyRun> runs;
};

/// Whether `folder` is that of a study, or one that "rodpack ensemble -o" wrote.
bool is_study(const std::string& folder);

/// Reads `folder`/ensemble/ensemble.json, or `folder`/ensemble.json where that is its place,
/// cases.json and what the runs' folders tell.
/// @throws DataError when ensemble.json is missing or one of the files is malformed.
Study read_study(const std::string& folder);

/// What was run: cases, parameters, seeds, versions.
std::string runs_html(const Study& study);

/// What it took: per case, and folded per run.
std::string cost_html(const Study& study);

/// The notes of the ensemble and of the runs' analyses.
std::vector<Note> notes_of(const Study& study);

}  // namespace rodpack

#endif

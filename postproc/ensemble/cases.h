// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_CASES_H
#define RODPACK_ENSEMBLE_CASES_H

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rodpack {

/// A finished run: its folder holds result.json.
struct FinishedRun {
  std::string folder;         // as it can be opened
  std::string name;           // the folder, relative to where that of the ensemble's results lies
  long seed = 0;              // from parameters.json
  nlohmann::json parameters;  // parameters.json
};

/// The repetitions of one case, by seed.
struct CaseRuns {
  std::string name;
  nlohmann::json parameters;  // common to the runs, see common_parameters()
  std::vector<FinishedRun> runs;
};

/// What an ensemble is to be made of.
struct FoundCases {
  std::vector<CaseRuns> cases;     // in the order of case_before()
  std::vector<std::string> notes;  // what is missing, versions that differ
};

/// parameters.json less what tells repetitions apart (seed), where and how a run was computed (out,
/// resume, preset, engine, skins, intervals of output, limit of the relaxation) and by which
/// version; a mass_scaling of 0 is none.
nlohmann::json common_parameters(const nlohmann::json& parameters);

/// Finds the runs in `folders` and sorts them by cases. A folder with a cases.json is a study,
/// which stands alone: its cases and seeds are those of that file, runs/<case>/seed-<n>; any other
/// is a run folder, or is searched for run folders, which are sorted by common_parameters() and
/// named by case_name(). `relative_to`: folder that the names of the runs start from.
/// `allow_missing`: leave out runs that are missing or did not finish, with a note.
/// @throws DataError naming the folder when there is no run, one is missing or did not finish, two
/// have the same seed, or one differs from its case, or from the rest of the study, in a parameter
/// that the table does not name.
FoundCases find_cases(const std::vector<std::string>& folders, const std::string& relative_to,
                      bool allow_missing);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_STUDY_TABLE_H
#define RODPACK_ENSEMBLE_STUDY_TABLE_H

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rodpack {

struct FinishedRun;

/// A case as the study's table asks for it.
struct PlannedCase {
  std::string name;
  std::vector<long> seeds;
  nlohmann::json parameters;  // by the deck's names, without units: aspect_ratio, curvature ...
};

/// cases.json, which the workflow of a study writes.
struct StudyTable {
  std::string file;
  std::vector<std::string> columns;  // parameters of the deck that the table names
  std::vector<PlannedCase> cases;
  std::vector<std::string> left_out;  // runs that the workflow was told to do without
};

/// Reads cases.json. @throws DataError naming the file and what is wrong with it.
StudyTable read_study_table(const std::string& file);

/// Whether `key` of parameters.json holds the deck's parameter `name`: curvature_deg is curvature.
bool is_deck_parameter(const std::string& key, const std::string& name);

/// @throws DataError naming the run when its seed or a parameter is another one than was planned.
void refuse_other_than_planned(const PlannedCase& planned, long seed, const FinishedRun& run);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/study_table.h"

#include <cmath>
#include <set>

#include "ensemble/cases.h"
#include "reading/data_error.h"
#include "reading/json_file.h"

namespace rodpack {
namespace {
using Json = nlohmann::json;

constexpr const char* study_format = "rodpack-study 1";

// Numbers are equal to the six digits that a deck may write.
bool same_value(const Json& found, const Json& expected) {
  if (!found.is_number() || !expected.is_number()) return found == expected;
  const double a = found.get<double>(), b = expected.get<double>();
  return std::fabs(a - b) <= 1e-6 * std::fabs(b);
}

}  // namespace

StudyTable read_study_table(const std::string& file) {
  const Json json = read_json_object(file);
  if (json.value("format", Json()) != study_format)
    throw DataError(file + ": expected a JSON object with \"format\": \"" + study_format + "\"");
  StudyTable table;
  table.file = file;
  try {
    table.columns = json.value("columns", std::vector<std::string>());
    table.left_out = json.value("left_out", std::vector<std::string>());
    if (!json.at("cases").is_object()) throw DataError(file + ": expected an object 'cases'");
    for (const auto& [name, one] : json.at("cases").items()) {
      if (name.empty() || name.find('/') != std::string::npos || name[0] == '.')
        throw DataError(file + ": case '" + name +
                        "', expected a name that can be that of a folder");
      table.cases.push_back({name, one.at("seeds").get<std::vector<long>>(),
                             one.value("parameters", Json::object())});
    }
  } catch (const Json::exception& reason) {
    throw DataError(file + ": is not as the workflow of a study writes it: " + reason.what());
  }
  return table;
}

bool is_deck_parameter(const std::string& key, const std::string& name) {
  static const std::set<std::string> units = {"_deg", "_m",    "_kg_m3", "_N_m",
                                              "_m_s", "_m_s2", "_s"};
  return key == name ||
         (key.compare(0, name.size(), name) == 0 && units.count(key.substr(name.size())) > 0);
}

void refuse_other_than_planned(const PlannedCase& planned, long seed, const FinishedRun& run) {
  if (run.seed != seed)
    throw DataError(run.folder + ": seed is " + std::to_string(run.seed) + ", expected " +
                    std::to_string(seed) + " by the name of the folder");
  const Json common = common_parameters(run.parameters);
  for (const auto& [name, value] : planned.parameters.items())
    for (const auto& [key, found] : common.items())
      if (is_deck_parameter(key, name) && !same_value(found, value))
        throw DataError(run.folder + ": " + key + " is " + found.dump() + ", expected " +
                        value.dump() + " as the study's cases.json has for case " + planned.name);
}

}  // namespace rodpack

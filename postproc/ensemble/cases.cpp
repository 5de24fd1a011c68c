// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/cases.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "ensemble/case_name.h"
#include "ensemble/study_table.h"
#include "reading/data_error.h"
#include "reading/number_text.h"
#include "reading/parameters.h"
#include "reading/run_folder.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::set<std::string> not_of_the_case = {"format",
                                               "rodpack",
                                               "preset",
                                               "seed",
                                               "out",
                                               "resume",
                                               "engine",
                                               "relaxation_limit_s",
                                               "output_interval_s",
                                               "restart_interval_s",
                                               "falling_skin_m",
                                               "settled_skin_m"};

/// Takes in what finished runs there are; those that are missing are refused together, or noted.
class Finished {
 public:
  explicit Finished(bool allow_missing) : allow_missing_(allow_missing) {}

  /// Whether the run in `folder` has finished; `name` is for the note.
  bool accepts(const fs::path& folder, const std::string& name) {
    std::string reason;
    if (!fs::is_directory(folder))
      reason = "there is no such run";
    else if (!fs::exists(folder / "result.json"))
      reason = "the run has not finished (no result.json)";
    if (reason.empty()) return true;
    if (missing_++ == 0) first_ = folder.string() + ": " + reason;
    notes_.push_back("left out: " + name + ", " + reason);
    return false;
  }

  /// Returns the notes on what is missing. @throws DataError when nothing may be missing.
  std::vector<std::string> notes() const {
    if (missing_ > 0 && !allow_missing_)
      throw DataError(first_ +
                      (missing_ > 1 ? ", nor have " + std::to_string(missing_ - 1) + " other runs"
                                    : std::string()) +
                      "; expected finished runs, or --allow-missing to leave others out");
    return notes_;
  }

 private:
  bool allow_missing_;
  int missing_ = 0;
  std::string first_;
  std::vector<std::string> notes_;
};

std::string relative_name(const fs::path& folder, const fs::path& relative_to) {
  return fs::absolute(folder)
      .lexically_normal()
      .lexically_relative(fs::absolute(relative_to).lexically_normal())
      .generic_string();
}

FinishedRun read_run(const fs::path& folder, const fs::path& relative_to) {
  FinishedRun run;
  run.folder = folder.string();
  run.name = relative_name(folder, relative_to);
  const auto parameters = read_parameters((folder / "parameters.json").string());
  run.seed = static_cast<long>(parameters.number("seed"));
  run.parameters = parameters.values;
  return run;
}

// A key in which two sets of parameters differ, "friction is 0.4, expected 0.3"; empty when none.
std::string difference(const Json& found, const Json& expected,
                       const std::set<std::string>& except) {
  for (const auto& [key, value] : expected.items()) {
    if (except.count(key)) continue;
    if (!found.contains(key)) return "has no " + key + ", expected " + value.dump();
    if (found[key] != value) return key + " is " + found[key].dump() + ", expected " + value.dump();
  }
  for (const auto& [key, value] : found.items())
    if (!except.count(key) && !expected.contains(key))
      return key + " is " + value.dump() + ", expected no such parameter";
  return {};
}

void refuse_equal_seeds(const CaseRuns& one) {
  for (std::size_t k = 1; k < one.runs.size(); ++k)
    if (one.runs[k].seed == one.runs[k - 1].seed)
      throw DataError(one.runs[k].folder + ": seed " + std::to_string(one.runs[k].seed) +
                      " of case " + one.name + ", expected another one than in " +
                      one.runs[k - 1].folder);
}

// The runs of a case agree in everything that is not of the single run.
void refuse_other_parameters(const CaseRuns& one) {
  for (const auto& run : one.runs) {
    const auto other = difference(common_parameters(run.parameters), one.parameters, {});
    if (!other.empty())
      throw DataError(run.folder + ": " + other + " as in " + one.runs.front().folder +
                      ", the same case " + one.name);
  }
}

void finish_case(CaseRuns& one) {
  std::sort(one.runs.begin(), one.runs.end(), [](const FinishedRun& a, const FinishedRun& b) {
    return std::tie(a.seed, a.name) < std::tie(b.seed, b.name);
  });
  one.parameters = common_parameters(one.runs.front().parameters);
  refuse_equal_seeds(one);
  refuse_other_parameters(one);
}

// Cases may differ in what the table names, and in what the deck derives from it.
void refuse_unnamed_differences(const StudyTable& table, const std::vector<CaseRuns>& cases) {
  if (table.columns.empty()) return;
  for (const auto& one : cases) {
    std::set<std::string> named = {"container_width_m", "drop_height_m", "overlap"};
    for (const auto& part : {one.parameters, cases.front().parameters})
      for (const auto& [key, value] : part.items())
        for (const auto& column : table.columns)
          if (is_deck_parameter(key, column)) named.insert(key);
    const auto other = difference(one.parameters, cases.front().parameters, named);
    if (!other.empty())
      throw DataError(one.runs.front().folder + ": " + other + " as in " +
                      cases.front().runs.front().folder +
                      ", since the table of the study names no such column");
  }
}

FoundCases cases_of_study(const fs::path& study, const fs::path& relative_to, bool allow_missing) {
  const StudyTable table = read_study_table((study / "cases.json").string());
  FoundCases found;
  Finished finished(allow_missing);
  for (const auto& planned : table.cases) {
    CaseRuns one;
    one.name = planned.name;
    for (const long seed : planned.seeds) {
      const fs::path folder = study / "runs" / planned.name / ("seed-" + std::to_string(seed));
      if (!finished.accepts(folder, relative_name(folder, relative_to))) continue;
      one.runs.push_back(read_run(folder, relative_to));
      refuse_other_than_planned(planned, seed, one.runs.back());
    }
    if (one.runs.empty()) continue;
    finish_case(one);
    found.cases.push_back(std::move(one));
  }
  found.notes = finished.notes();
  for (const auto& run : table.left_out)
    found.notes.push_back("left out: " + run + ", as cases.json says");
  if (found.cases.empty())
    throw DataError(study.string() + ": none of its runs has finished, expected at least one");
  refuse_unnamed_differences(table, found.cases);
  return found;
}

// The run folders at and below `folder`, in order of their names.
std::vector<fs::path> run_folders(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw DataError(folder.string() + ": no such folder");
  if (fs::exists(folder / "parameters.json")) return {folder};
  std::vector<fs::path> runs;
  for (auto entry = fs::recursive_directory_iterator(folder);
       entry != fs::recursive_directory_iterator(); ++entry)
    if (entry->is_directory() && fs::exists(entry->path() / "parameters.json")) {
      runs.push_back(entry->path());
      entry.disable_recursion_pending();
    }
  if (runs.empty() && !(dumps_in(folder.string(), "bodies").empty() &&
                        dumps_in((folder / "dumps").string(), "bodies").empty()))
    throw DataError(folder.string() +
                    ": dumps without parameters.json, which tells a run's case and seed, expected "
                    "with them");
  if (runs.empty())
    throw DataError(folder.string() + ": no run folder in it, expected one with parameters.json");
  return runs;
}

// Two sets of parameters of one name: each is named after that in which it differs from the others.
void tell_apart(std::vector<CaseRuns>& cases) {
  std::map<std::string, std::vector<CaseRuns*>> of_name;
  for (auto& one : cases) of_name[one.name].push_back(&one);
  for (const auto& [name, same] : of_name) {
    std::set<std::string> keys;
    for (const auto* one : same)
      for (const auto& [key, value] : one->parameters.items())
        for (const auto* other : same)
          if (!other->parameters.contains(key) || other->parameters[key] != value) keys.insert(key);
    for (auto* one : same)
      for (const auto& key : keys)
        if (one->parameters.contains(key)) {
          const Json& value = one->parameters[key];
          one->name += "-" + key +
                       (value.is_string()   ? "-" + value.get<std::string>()
                        : value.is_number() ? number_text(value.get<double>(), 6)
                                            : value.dump());
        }
  }
}

FoundCases cases_of_runs(const std::vector<std::string>& folders, const fs::path& relative_to,
                         bool allow_missing) {
  FoundCases found;
  Finished finished(allow_missing);
  std::set<fs::path> seen;
  for (const auto& folder : folders)
    for (const auto& run : run_folders(folder)) {
      if (!seen.insert(fs::canonical(run)).second) continue;
      if (!finished.accepts(run, relative_name(run, relative_to))) continue;
      auto one = read_run(run, relative_to);
      const Json parameters = common_parameters(one.parameters);
      const auto same = std::find_if(found.cases.begin(), found.cases.end(),
                                     [&](const CaseRuns& c) { return c.parameters == parameters; });
      if (same != found.cases.end())
        same->runs.push_back(std::move(one));
      else
        found.cases.push_back({case_name(parameters), parameters, {std::move(one)}});
    }
  found.notes = finished.notes();
  if (found.cases.empty())
    throw DataError(folders.front() + ": none of its runs has finished, expected at least one");
  tell_apart(found.cases);
  for (auto& one : found.cases) finish_case(one);
  std::sort(found.notes.begin(), found.notes.end());
  return found;
}

void note_versions(FoundCases& found) {
  std::map<std::string, int> runs_of;
  for (const auto& one : found.cases)
    for (const auto& run : one.runs) {
      const auto rodpack = run.parameters.value("rodpack", Json::object());
      ++runs_of[rodpack.is_object() ? rodpack.value("version", std::string("unknown")) : "unknown"];
    }
  if (runs_of.size() < 2) return;
  std::string text;
  for (const auto& [version, runs] : runs_of)
    text += (text.empty() ? "" : ", ") + version + " (" + std::to_string(runs) + " runs)";
  found.notes.push_back("the runs were made by several versions of rodpack: " + text);
}

}  // namespace

Json common_parameters(const Json& parameters) {
  Json common = Json::object();
  for (const auto& [key, value] : parameters.items())
    if (!not_of_the_case.count(key)) common[key] = value;
  // None, as in runs of decks that did not have the parameter yet.
  if (common.contains("mass_scaling") && common["mass_scaling"] == 0) common.erase("mass_scaling");
  return common;
}

FoundCases find_cases(const std::vector<std::string>& folders, const std::string& relative_to,
                      bool allow_missing) {
  const auto study = std::find_if(folders.begin(), folders.end(), [](const std::string& folder) {
    return fs::exists(fs::path(folder) / "cases.json");
  });
  if (study != folders.end() && folders.size() > 1)
    throw DataError(*study + ": is a study, expected no other folder beside it");
  FoundCases found = study != folders.end() ? cases_of_study(*study, relative_to, allow_missing)
                                            : cases_of_runs(folders, relative_to, allow_missing);
  std::sort(found.cases.begin(), found.cases.end(), [](const CaseRuns& a, const CaseRuns& b) {
    return case_before(a.parameters, a.name, b.parameters, b.name);
  });
  note_versions(found);
  return found;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/study_runs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "page/html.h"
#include "page/tables.h"
#include "page/words.h"
#include "reading/data_error.h"
#include "reading/json_file.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json json_if_there(const fs::path& file) {
  return fs::exists(file) ? read_json_object(file.string()) : Json::object();
}

StudyRun read_run(const std::string& case_name, long seed, const fs::path& folder) {
  return {case_name,
          seed,
          folder.string(),
          json_if_there(folder / "parameters.json"),
          json_if_there(folder / "result.json"),
          json_if_there(folder / "analysis" / "summary.json"),
          cost_of_run((folder / "log.liggghts").string())};
}

std::string cell(const Json& value) {
  if (value.is_number()) return number_html(value.get<double>(), 6);
  if (value.is_null()) return "–";
  return escaped(value.is_string() ? value.get<std::string>() : value.dump());
}

// The parameter of the deck that a column names: in parameters.json it may carry a unit.
Json value_of(const EnsembleCase& one, const std::string& column) {
  for (const auto& [key, value] : one.parameters.items())
    if (key == column || (key.rfind(column + "_", 0) == 0 && !wording(key).unit.empty()))
      return value;
  return {};
}

// Parameters in which the cases differ, or what the table names.
std::vector<std::string> columns_of(const Study& study) {
  if (study.table.contains("columns")) return study.table["columns"];
  std::vector<std::string> columns;
  const auto& cases = study.ensemble.cases;
  if (cases.empty()) return columns;
  for (const auto& [key, value] : cases.front().parameters.items())
    for (const auto& one : cases)
      if (one.parameters.value(key, Json()) != value) {
        columns.push_back(key);
        break;
      }
  return columns;
}

// The parameters that all cases have the same.
Json common_values(const Study& study) {
  Json common;
  const auto& cases = study.ensemble.cases;
  if (cases.empty()) return Json::object();
  for (const auto& [key, value] : cases.front().parameters.items())
    if (std::all_of(cases.begin(), cases.end(), [&, &k = key, &v = value](const EnsembleCase& one) {
          return one.parameters.value(k, Json()) == v;
        }))
      common[key] = value;
  common.erase("format");
  return common;
}

// "1, 2, 3", or "1 to 30".
std::string seeds_text(const std::vector<long>& seeds) {
  const bool in_row =
      seeds.size() > 3 && seeds.back() - seeds.front() + 1 == static_cast<long>(seeds.size());
  if (in_row) return std::to_string(seeds.front()) + " to " + std::to_string(seeds.back());
  std::string text;
  for (const long seed : seeds) text += (text.empty() ? "" : ", ") + std::to_string(seed);
  return text;
}

// Seeds that cases.json asks for and the ensemble lacks.
std::vector<long> missing_seeds(const Study& study, const std::string& name,
                                const std::vector<long>& seeds) {
  std::vector<long> missing;
  for (const auto& seed : study.table["cases"][name].value("seeds", Json::array()))
    if (seed.is_number_integer() &&
        std::find(seeds.begin(), seeds.end(), seed.get<long>()) == seeds.end())
      missing.push_back(seed.get<long>());
  return missing;
}

// MPI ranks per run; none where cases.json does not tell.
std::string ranks_cell(const Study& study, const std::string& name) {
  if (!study.table.contains("cases") || !study.table["cases"].contains(name)) return "–";
  return cell(study.table["cases"][name].value("ranks", Json()));
}

HtmlTable cases_table(const Study& study) {
  HtmlTable table;
  const auto columns = columns_of(study);
  table.header = {"Case"};
  table.numeric = {false};
  for (const auto& column : columns) {
    table.header.push_back(heading(column));
    const auto& cases = study.ensemble.cases;
    table.numeric.push_back(std::all_of(cases.begin(), cases.end(), [&](const EnsembleCase& one) {
      return !value_of(one, column).is_string();
    }));
  }
  table.header.insert(table.header.end(), {"MPI ranks", "Repetitions", "Seeds"});
  table.numeric.insert(table.numeric.end(), {true, true, false});
  std::set<std::string> named;
  for (const auto& one : study.ensemble.cases) {
    named.insert(one.name);
    std::vector<std::string> row{name_html(one.name)};
    for (const auto& column : columns) row.push_back(cell(value_of(one, column)));
    row.push_back(ranks_cell(study, one.name));
    row.push_back(std::to_string(one.runs.size()));
    std::string seeds = seeds_text(one.seeds);
    if (study.table.contains("cases") && study.table["cases"].contains(one.name)) {
      const auto missing = missing_seeds(study, one.name, one.seeds);
      if (!missing.empty())
        seeds += "; <span class=\"missing\">missing: " + seeds_text(missing) + "</span>";
    }
    row.push_back(seeds);
    table.rows.push_back(row);
  }
  if (study.table.contains("cases"))
    for (const auto& [name, planned] : study.table["cases"].items())
      if (!named.count(name)) {
        std::vector<std::string> row{name_html(name)};
        for (const auto& column : columns)
          row.push_back(cell(planned.value("parameters", Json::object()).value(column, Json())));
        row.insert(row.end(),
                   {ranks_cell(study, name), "0", "<span class=\"missing\">all missing</span>"});
        table.rows.push_back(row);
      }
  return table;
}

std::string version_of(const Json& json) {
  const auto found = json.find("rodpack");
  if (found == json.end() || !found->is_object()) return "";
  return found->value("version", "?") + " (commit " + found->value("commit", "?") + ")";
}

std::string joined(const std::map<std::string, int>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : ", ") + escaped(name) +
            (counts.size() > 1 ? " for " + std::to_string(count) + " runs" : "");
  return text;
}

std::string versions_html(const Study& study) {
  std::map<std::string, int> simulated, analysed;
  for (const auto& run : study.runs) {
    const auto by = version_of(run.parameters), with = version_of(run.summary);
    ++simulated[by.empty() ? "of an unknown version" : by];
    ++analysed[with.empty() ? "of an unknown version" : with];
  }
  return "<p>Simulated by rodpack " + joined(simulated) + "; analysed by rodpack " +
         joined(analysed) + ".</p>\n";
}

double sum_of(const std::vector<const StudyRun*>& runs, double RunCost::*what) {
  double sum = 0;
  for (const auto* run : runs)
    if (run->cost) sum += (*run->cost).*what;
  return sum;
}

std::string result_cell(const StudyRun& run, const char* key, int digits) {
  const auto found = run.result.find(key);
  return found != run.result.end() && found->is_number() ? number_html(found->get<double>(), digits)
                                                         : "–";
}

std::string cost_of_runs(const Study& study) {
  HtmlTable table{"",
                  {"Run", "Particles", "Steps", "Simulated time (s)", "Time it took (min)",
                   "Processor time (core\u2011h)"},
                  {false, true, true, true, true, true},
                  {}};
  for (const auto& run : study.runs)
    table.rows.push_back({escaped(run.case_name) + ", seed " + std::to_string(run.seed),
                          result_cell(run, "particles", 12), result_cell(run, "step", 12),
                          result_cell(run, "time_s", 4),
                          run.cost ? number_html(run.cost->wall_time_s, 3, 1.0 / 60) : "–",
                          run.cost ? number_html(run.cost->core_seconds, 3, 1.0 / 3600) : "–"});
  return "<details><summary>Every run</summary>\n" + table_html(table) + "</details>\n";
}

}  // namespace

bool is_study(const std::string& folder) {
  const fs::path root(folder);
  return fs::exists(root / "cases.json") || fs::exists(root / "ensemble.json") ||
         fs::exists(root / "ensemble" / "ensemble.json");
}

Study read_study(const std::string& folder) {
  const bool is_results = fs::exists(fs::path(folder) / "ensemble.json");
  const fs::path results = is_results ? fs::path(folder) : fs::path(folder) / "ensemble";
  // The runs' folders are told from the one that holds the results' folder.
  const fs::path root =
      is_results ? (fs::absolute(results) / "").lexically_normal().parent_path().parent_path()
                 : fs::path(folder);
  const auto file = results / "ensemble.json";
  if (!fs::exists(file))
    throw DataError(file.string() + ": no such file; \"rodpack ensemble " + folder + "\" makes it");
  Study study{folder,
              results.string(),
              json_if_there(root / "cases.json"),
              read_ensemble(file.string()),
              {}};
  for (const auto& one : study.ensemble.cases)
    for (std::size_t k = 0; k < one.runs.size(); ++k)
      study.runs.push_back(read_run(one.name, k < one.seeds.size() ? one.seeds[k] : 0,
                                    (root / one.runs[k]).lexically_normal()));
  return study;
}

std::string runs_html(const Study& study) {
  std::string html = versions_html(study) + table_html(cases_table(study));
  if (!study.table.contains("cases"))
    html +=
        "<p class=\"missing\">No cases.json in the folder: the cases are those that the runs' "
        "parameters make.</p>\n";
  return html + "<details><summary>Parameters that all cases share</summary>\n" +
         values_table(common_values(study), "") + "</details>\n";
}

std::string cost_html(const Study& study) {
  HtmlTable table{"Time-stepping alone, from the runs' logs. It depends on the machine.",
                  {"Case", "Runs", "Time per run (min)", "Processor time per run (core\u2011h)",
                   "Of all runs (core\u2011h)"},
                  {false, true, true, true, true},
                  {}};
  double total = 0;
  std::size_t told = 0;
  for (const auto& one : study.ensemble.cases) {
    std::vector<const StudyRun*> runs;
    for (const auto& run : study.runs)
      if (run.case_name == one.name && run.cost) runs.push_back(&run);
    if (runs.empty()) {
      table.rows.push_back({name_html(one.name), "0", "–", "–", "–"});
      continue;
    }
    told += runs.size();
    const double count = static_cast<double>(runs.size());
    const double seconds = sum_of(runs, &RunCost::core_seconds);
    total += seconds;
    table.rows.push_back({name_html(one.name), std::to_string(runs.size()),
                          number_html(sum_of(runs, &RunCost::wall_time_s) / count, 3, 1.0 / 60),
                          number_html(seconds / count, 3, 1.0 / 3600),
                          number_html(seconds, 3, 1.0 / 3600)});
  }
  table.rows.push_back({"All", std::to_string(told), "", "", number_html(total, 3, 1.0 / 3600)});
  std::string html;
  if (const auto silent = study.runs.size() - told; silent > 0)
    html = "<p class=\"missing\">" + std::to_string(silent) +
           (silent == 1 ? " run has no log.liggghts that tells its time"
                        : " runs have no log.liggghts that tells their time") +
           ".</p>\n";
  return html + table_html(table) + cost_of_runs(study);
}

std::vector<Note> notes_of(const Study& study) {
  std::vector<Note> notes;
  for (const auto& note : study.ensemble.notes) notes.push_back({"", note});
  for (const auto& run : study.runs)
    for (const auto& note : run.summary.value("notes", Json::array()))
      if (note.is_string()) notes.push_back({run.case_name, note.get<std::string>()});
  return notes;
}

}  // namespace rodpack

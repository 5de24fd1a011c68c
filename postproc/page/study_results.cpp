// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/study_results.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "page/figures_section.h"
#include "page/html.h"
#include "page/tables.h"
#include "page/words.h"
#include "reading/table.h"
#include "reading/json_file.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path results(const Study& study) { return study.results; }

std::string missing(const Study& study, const std::string& file) {
  return "<p class=\"missing\">Missing: " + file + ". <code>rodpack ensemble " +
         escaped(study.folder) + "</code> writes it.</p>\n";
}

// What stands in all fields of a column that are not empty; empty where they differ.
std::string only_word(const Table& table, const std::string& column) {
  const auto& names = table.names();
  if (std::find(names.begin(), names.end(), column) == names.end()) return "";
  std::set<std::string> words(table.words(column).begin(), table.words(column).end());
  words.erase("");
  return words.size() == 1 ? *words.begin() : "";
}

std::string text_of(const Json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end() || found->is_null()) return "";
  return escaped(found->is_string() ? found->get<std::string>() : found->dump());
}

std::optional<double> number_of(const Json& row, const char* key) {
  const auto found = row.find(key);
  if (found == row.end() || !found->is_number()) return {};
  return found->get<double>();
}

std::string verdict_html(const std::string& verdict) {
  const std::string kind = verdict == "holds"           ? "holds"
                           : verdict == "does not hold" ? "fails"
                                                        : "open";
  return "<span class=\"verdict-" + kind + "\">" + verdict + "</span>";
}

std::vector<std::string> claim_row(const Json& claim) {
  std::string measured = text_of(claim, "measured");
  if (const auto value = number_of(claim, "value"))
    measured += (measured.empty() ? "" : ": ") + measured_html(*value, number_of(claim, "error"));
  if (const auto remark = text_of(claim, "remark"); !remark.empty())
    measured += "<br><span class=\"quiet\">" + remark + "</span>";
  std::string verdict = verdict_html(text_of(claim, "verdict"));
  if (const auto sigmas = number_of(claim, "sigmas"))
    verdict += "<br>" + number_html(*sigmas, 2) + "\u00a0σ";
  return {text_of(claim, "claim"), measured, text_of(claim, "test"), verdict};
}

/// A theme and the beginnings of the names of its numbers.
struct Theme {
  const char* name;
  std::vector<std::string> beginnings;
};

const std::vector<Theme>& themes() {
  static const std::vector<Theme> all{
      {"Solid fraction and bed",
       {"solid_fraction", "covered_area", "bed_height", "omega", "particles"}},
      {"Orientation", {"nematic", "director", "orientation"}},
      {"Radial distribution function", {"rdf"}},
      {"Contacts",
       {"mean_normal", "mean_tangential", "mobilised", "sliding", "coordination", "contacts_per",
        "rattlers"}},
      {"Pressure", {"janssen", "profile", "pressure"}},
      {"Energies and cost",
       {"kinetic", "elastic", "time", "timestep", "wall_time", "core_seconds"}},
      {"Other numbers", {""}}};
  return all;
}

bool begins_with_one_of(const std::string& name, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](const std::string& beginning) {
    return name.compare(0, beginning.size(), beginning) == 0;
  });
}

// One table: a row a case, a column a number.
std::string numbers_table(const Ensemble& ensemble, const std::vector<std::string>& names,
                          const std::string& caption) {
  HtmlTable table{caption, {"Case"}, {false}, {}};
  for (const auto& one : ensemble.cases) table.rows.push_back({name_html(one.name)});
  for (const auto& name : names) {
    const auto words = wording(name);
    double largest = 0;
    for (const auto& one : ensemble.cases)
      if (const auto found = one.numbers.find(name); found != one.numbers.end())
        largest = std::max(largest, std::fabs(found->second.mean));
    const auto unit = readable_unit(largest, words.unit);
    table.header.push_back("<span title=\"" + escaped(name) + "\">" + heading(name, unit.name) +
                           "</span>");
    table.numeric.push_back(true);
    for (std::size_t k = 0; k < ensemble.cases.size(); ++k) {
      const auto& one = ensemble.cases[k];
      const auto found = one.numbers.find(name);
      if (found == one.numbers.end() || found->second.n == 0 ||
          !std::isfinite(found->second.mean)) {
        table.rows[k].push_back("–");
        continue;
      }
      const auto& mean = found->second;
      const bool fewer = mean.n < static_cast<int>(one.runs.size());
      table.rows[k].push_back(measured_html(mean.mean, mean.sem, unit.factor) +
                              (fewer ? " (n\u00a0=\u00a0" + std::to_string(mean.n) + ")" : ""));
    }
  }
  return table_html(table);
}

// As many tables as fit on paper, with columns shared out evenly.
std::string numbers_tables(const Ensemble& ensemble, const std::vector<std::string>& names,
                           const std::string& theme) {
  constexpr std::size_t most_columns = 6;
  const std::size_t tables = (names.size() + most_columns - 1) / most_columns;
  std::string html;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < tables; ++k) {
    const std::size_t end = names.size() * (k + 1) / tables;
    html += numbers_table(ensemble,
                          {names.begin() + static_cast<std::ptrdiff_t>(begin),
                           names.begin() + static_cast<std::ptrdiff_t>(end)},
                          k == 0 ? "<b>" + theme + "</b>" : "");
    begin = end;
  }
  return html;
}

}  // namespace

std::string solid_fraction_html(const Study& study) {
  const auto file = (results(study) / "table2.csv").string();
  if (!fs::exists(file)) return missing(study, "table2.csv");
  std::set<std::string> left_out{"quantity", "rounding_error"};
  const auto source = only_word(read_table(file), "source");
  if (!source.empty()) left_out.insert("source");
  return "<p>Mean solid fraction φ ± standard error of the mean over n repetitions, beside "
         "published "
         "values" +
         (source.empty() ? "" : " (" + escaped(source) + ")") +
         "; the difference ± the combined error, which holds also the rounding of the published "
         "value, and in units of it.</p>\n<div class=\"dense\">" +
         csv_table(file, "", left_out) + "</div>\n";
}

std::string claims_html(const Study& study) {
  const auto file = results(study) / "claims.json";
  if (!fs::exists(file)) return missing(study, "claims.json");
  const Json json = read_json_object(file.string());
  HtmlTable table{"", {"Claim", "Measured", "Test", "Verdict"}, {}, {}};
  for (const auto& claim : json.value("claims", Json::array()))
    table.rows.push_back(claim_row(claim));
  std::string html;
  if (const auto sigmas = number_of(json, "decisive_sigmas"))
    html = "<p>A claim holds, or does not, from " + number_html(*sigmas, 3) +
           " standard deviations on; σ counts in favour of it.</p>\n";
  return html + "<div class=\"claims\">" + table_html(table) + "</div>\n";
}

std::string study_figures_html(const Study& study) {
  std::vector<FigureText> texts;
  std::vector<Note> not_drawn;
  const auto list = results(study) / "figures.json";
  if (fs::exists(list))
    for (const auto& figure : read_json_object(list.string()).value("figures", Json::array())) {
      const auto name = text_of(figure, "name"), paper = text_of(figure, "paper");
      if (const std::string why = figure.value("not_drawn", ""); !why.empty())
        not_drawn.push_back({"", figure.value("paper", name) + ": " + why});
      const bool numbered = paper.rfind("Fig", 0) == 0 || paper.rfind("Table", 0) == 0;
      texts.push_back(
          {name, (numbered ? "Paper's " : "") + paper, text_of(figure, "caption"), true});
    }
  int number = 0;
  std::string html = figures_html(results(study), texts, number, true);
  if (html.empty()) html = missing(study, "fig….png");
  if (!not_drawn.empty()) html += "<p>Not drawn:</p>\n" + notes_html(not_drawn);
  return html;
}

std::string numbers_html(const Study& study) {
  std::set<std::string> left;
  for (const auto& one : study.ensemble.cases)
    for (const auto& number : one.numbers) left.insert(number.first);
  std::string html =
      "<p>Means over the repetitions of a case ± standard error of the mean; n is told where fewer "
      "repetitions have the number.</p>\n";
  for (const auto& theme : themes()) {
    std::vector<std::string> names;
    for (auto name = left.begin(); name != left.end();)
      if (begins_with_one_of(*name, theme.beginnings)) {
        names.push_back(*name);
        name = left.erase(name);
      } else {
        ++name;
      }
    html += numbers_tables(study.ensemble, names, theme.name);
  }
  return html;
}

}  // namespace rodpack

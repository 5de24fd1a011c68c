// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "page/html.h"
#include "page/words.h"
#include "reading/number_text.h"
#include "reading/table.h"

namespace rodpack {
namespace {
using Json = nlohmann::ordered_json;

// The standard error of the value under `key`: its key says so in place of "mean", before the unit,
// or at the end.
std::optional<double> standard_error(const Json& values, const std::string& key) {
  const std::string says_so = "_standard_error", mean = "_mean";
  std::vector<std::string> candidates{key + says_so};
  for (auto at = key.find('_'); at != std::string::npos; at = key.find('_', at + 1))
    candidates.push_back(key.substr(0, at) + says_so + key.substr(at));
  if (key.size() > mean.size() && key.compare(key.size() - mean.size(), mean.size(), mean) == 0)
    candidates.push_back(key.substr(0, key.size() - mean.size()) + says_so);
  for (const auto& candidate : candidates)
    if (const auto error = values.find(candidate); error != values.end() && error->is_number())
      return error->get<double>();
  return {};
}

std::optional<double> as_number(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0') return {};
  return value;
}

bool is_none(const std::string& word) { return word.empty() || word == "nan"; }

}  // namespace

std::string name_html(const std::string& name) {
  const bool one_word = name.find(' ') == std::string::npos && name.size() < 40;
  return one_word ? "<span class=\"name\">" + escaped(name) + "</span>" : escaped(name);
}

std::string table_html(const HtmlTable& table) {
  const auto kind = [&](std::size_t column) {
    const bool numeric = column < table.numeric.size() && table.numeric[column];
    return std::string(numeric ? " class=\"number\"" : "");
  };
  std::string html = "<div class=\"wide\"><table>\n";
  if (!table.caption.empty()) html += "<caption>" + table.caption + "</caption>\n";
  html += "<thead><tr>";
  for (std::size_t c = 0; c < table.header.size(); ++c)
    html += "<th scope=\"col\"" + kind(c) + ">" + table.header[c] + "</th>";
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      html += c == 0 ? "<th scope=\"row\"" + kind(c) + ">" + row[c] + "</th>"
                     : "<td" + kind(c) + ">" + row[c] + "</td>";
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string values_table(const Json& values, const std::string& caption) {
  HtmlTable table{caption, {"Quantity", "Value", "Unit"}, {false, true, false}, {}};
  for (const auto& [key, value] : values.items()) {
    if (value.is_object() || value.is_array()) continue;
    if (key.find("_standard_error") != std::string::npos) continue;
    const auto words = wording(key);
    const std::string label = "<span title=\"" + escaped(key) + "\">" + words.label + "</span>";
    if (value.is_number()) {
      const double number = value.get<double>();
      const bool count = value.is_number_integer();
      const auto unit = count ? ScaledUnit{1, words.unit} : readable_unit(number, words.unit);
      const auto error = standard_error(values, key);
      table.rows.push_back({label,
                            error ? measured_html(number, error, unit.factor)
                                  : number_html(number, count ? 12 : 4, unit.factor),
                            unit.name});
    } else if (value.is_null()) {
      table.rows.push_back({label, "<span class=\"missing\">not measured</span>", ""});
    } else {
      table.rows.push_back(
          {label, escaped(value.is_string() ? value.get<std::string>() : value.dump()), ""});
    }
  }
  return table_html(table);
}

ScaledUnit readable_unit(double value, const std::string& unit) {
  if (unit == "N" || unit == "J" || unit == "m") return scaled_unit(std::fabs(value), unit);
  return {1, unit};
}

std::string csv_table(const std::string& file, const std::string& caption,
                      const std::set<std::string>& left_out) {
  const Table csv = read_table(file);
  HtmlTable table{caption, {}, {}, std::vector<std::vector<std::string>>(csv.rows())};
  const auto& names = csv.names();
  const auto holds_errors = [&](std::size_t c) {
    return c > 0 && c < names.size() &&
           (names[c] == "sem" || names[c] == "combined_error" ||
            names[c] == names[c - 1] + "_error");
  };
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (left_out.count(names[c]) || holds_errors(c)) continue;
    const auto& words = csv.words(names[c]);
    const bool numeric = std::all_of(words.begin(), words.end(), [](const std::string& word) {
      return is_none(word) || as_number(word);
    });
    table.header.push_back(heading(names[c]));
    table.numeric.push_back(numeric);
    for (std::size_t row = 0; row < words.size(); ++row) {
      const auto error =
          holds_errors(c + 1) ? as_number(csv.words(names[c + 1])[row]) : std::nullopt;
      table.rows[row].push_back(is_none(words[row]) ? "–"
                                : numeric           ? measured_html(*as_number(words[row]), error)
                                                    : name_html(words[row]));
    }
  }
  return table_html(table);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "reading/dump.h"
#include "reading/table.h"

namespace rodpack::test {

namespace {

/// The rows of a table, a frame of a dump or whatever else has columns with these names.
template <class Columns>
std::vector<std::vector<double>> rows_of(const Columns& table,
                                         const std::vector<std::string>& names, std::size_t count) {
  std::vector<std::vector<double>> rows(count);
  for (const std::string& name : names) {
    const std::vector<double>& column = table.column(name);
    for (std::size_t i = 0; i < count; ++i) rows[i].push_back(column[i]);
  }
  return rows;
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Whether all of `text` is one number, which then is in `value`.
bool is_number(const std::string& text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// The numbers of a line; none if it holds anything else.
std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  double number = 0;
  for (const std::string& word : words_of(line)) {
    if (!is_number(word, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

Table::Table(std::string origin, std::vector<std::string> names,
             const std::vector<std::vector<double>>& rows, long timestep)
    : origin_(std::move(origin)),
      names_(std::move(names)),
      columns_(names_.size()),
      rows_(rows.size()),
      timestep_(timestep) {
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i].push_back(row.at(i));
  }
}

const std::vector<double>& Table::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    std::string known;
    for (const std::string& each : names_) known += " " + each;
    throw std::out_of_range(origin_ + " has no column '" + name + "', only:" + known);
  }
  return columns_[static_cast<std::size_t>(found - names_.begin())];
}

Table read_table(const std::filesystem::path& file) {
  const rodpack::Table table = rodpack::read_table(file.string());
  return Table(file.string(), table.names(), rows_of(table, table.names(), table.rows()));
}

double number_or_nan(const rodpack::Table& table, std::size_t row, const std::string& column) {
  const std::string& field = table.words(column).at(row);
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double number = 0;
  if (!is_number(field, number)) table.refuse(row, column, "a number or nothing");
  return number;
}

Table read_thermo(const std::string& output, int run) {
  std::istringstream lines(output);
  std::vector<Table> tables;
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(lines, line);) {
    if (names.empty()) {
      const auto words = words_of(line);
      if (!words.empty() && words[0] == "Step") names = words;
    } else if (line.rfind("Loop time", 0) == 0) {
      tables.emplace_back("the thermo output", std::exchange(names, {}), std::exchange(rows, {}));
    } else if (const auto row = numbers_of(line); row.size() == names.size()) {
      rows.push_back(row);
    }
  }
  const auto count = static_cast<int>(tables.size());
  if (count == 0 || count <= run)
    throw std::runtime_error("expected a thermo table, from 'Step' to 'Loop time', of run " +
                             std::to_string(run) + " in:\n" + output);
  return tables[static_cast<std::size_t>(run < 0 ? count - 1 : run)];
}

Table read_dump(const std::filesystem::path& file, int wanted) {
  DumpReader reader(file.string());
  Frame frame;
  int count = 0;
  while ((wanted < 0 || count <= wanted) && reader.next(frame)) ++count;
  if (count == 0 || count <= wanted) {
    throw std::runtime_error(file.string() + " has " + std::to_string(count) +
                             " frames, no frame " + std::to_string(wanted));
  }
  return Table(file.string(), frame.names, rows_of(frame, frame.names, frame.rows), frame.timestep);
}

double observed_order(double error_coarse, double error_fine, double ratio) {
  return std::log(error_coarse / error_fine) / std::log(ratio);
}

}  // namespace rodpack::test

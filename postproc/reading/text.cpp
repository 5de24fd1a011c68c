// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "reading/dump.h"

namespace rodpack {

std::string number_text(double value, int significant_digits) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", significant_digits, value);
  return buffer;
}

ScaledUnit scaled_unit(double typical_value, const std::string& unit) {
  const struct {
    double size;
    const char* prefix;
  } prefixes[] = {{1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
  if (typical_value <= 0) return {1, unit};
  for (const auto& [size, prefix] : prefixes)
    if (typical_value >= size) return {1 / size, prefix + unit};
  return {1e9, "n" + unit};
}

double round_step(double limit) {
  const double decade = std::pow(10, std::floor(std::log10(limit)));
  const double mantissa = limit / decade * (1 + 1e-12);
  return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

std::string read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write_text(const std::string& file, const std::string& content) {
  std::ofstream out(file, std::ios::binary);
  out << content;
  out.close();
  if (!out) throw DataError(file + ": cannot be written");
}

void write_csv(const std::string& file,
               const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
  std::string text;
  for (const auto& [name, values] : columns) text += (text.empty() ? "" : ",") + name;
  text += '\n';
  for (std::size_t row = 0; row < columns.front().second.size(); ++row)
    for (std::size_t c = 0; c < columns.size(); ++c)
      text += number_text(columns[c].second[row]) + (c + 1 < columns.size() ? ',' : '\n');
  write_text(file, text);
}

CsvTable::CsvTable(const std::string& file) : file_(file) {
  std::ifstream in(file);
  if (!in) throw DataError(file + ": no such file, or it cannot be read");
  std::string line;
  std::string field;
  std::getline(in, line);
  std::istringstream header(line);
  while (std::getline(header, field, ',')) names_.push_back(field);
  if (names_.empty()) throw DataError(file + ":1: expected a line with the names of the columns");
  columns_.resize(names_.size());
  for (long number = 2; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    const auto where = file + ":" + std::to_string(number) + ": ";
    std::istringstream row(line);
    std::size_t c = 0;
    for (; std::getline(row, field, ','); ++c) {
      char* end = nullptr;
      const double value = std::strtod(field.c_str(), &end);
      if (field.empty() || *end != '\0')
        throw DataError(where + "expected a number, found '" + field + "'");
      if (c < columns_.size()) columns_[c].push_back(value);
    }
    if (c != names_.size())
      throw DataError(where + "expected " + std::to_string(names_.size()) + " fields, found " +
                      std::to_string(c));
  }
}

const std::vector<double>& CsvTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    std::string message = file_ + ":1: no column '" + name + "'; the columns are:";
    for (const auto& each : names_) message += " " + each;
    throw DataError(message);
  }
  return columns_[static_cast<std::size_t>(found - names_.begin())];
}

}  // namespace rodpack

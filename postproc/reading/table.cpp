// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "reading/data_error.h"
#include "reading/parsing.h"

namespace rodpack {
namespace {

std::string at_line(const std::string& file, long line) {
  return file + ":" + std::to_string(line);
}

bool has_comma(std::string_view line) { return line.find(',') != std::string_view::npos; }

std::string_view without_blanks(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

std::vector<std::string> split(std::string_view line, bool at_commas) {
  std::vector<std::string> fields;
  if (!at_commas) {
    for (auto word = take_word(line); !word.empty(); word = take_word(line))
      fields.emplace_back(word);
    return fields;
  }
  for (auto comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
    fields.emplace_back(without_blanks(line.substr(0, comma)));
    line.remove_prefix(comma + 1);
  }
  fields.emplace_back(without_blanks(line));
  return fields;
}

void require_text(const std::string& line, const std::string& where) {
  if (line.size() > longest_line)
    throw DataError(where + ": expected a line of at most " + std::to_string(longest_line) +
                    " characters, found a longer one");
  if (line.find('\0') != std::string::npos)
    throw DataError(where + ": expected text, found a NUL character");
}

void require_each_once(std::vector<std::string> names, const std::string& where) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end() && !twice->empty())
    throw DataError(where + ": expected each column once, found '" + shortened(*twice) + "' twice");
}

}  // namespace

std::size_t Table::index_of(const std::string& name) const {
  return column_index(names_, name, at_line(file_, header_line_));
}

const std::vector<double>& Table::column(const std::string& name) const {
  const auto index = index_of(name);
  if (!not_numbers_[index].empty()) refuse(not_numbers_[index].front(), name, "a number");
  return numbers_[index];
}

const std::vector<double>& Table::finite(const std::string& name) const {
  const auto& values = column(name);
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isfinite(values[row])) refuse(row, name, "a finite number");
  return values;
}

std::vector<long> Table::whole_numbers(const std::string& name) const {
  const auto& values = column(name);
  std::vector<long> result;
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(std::fabs(values[row]) < 1e15) || values[row] != std::round(values[row]))
      refuse(row, name, "a whole number");
    result.push_back(std::lround(values[row]));
  }
  return result;
}

const std::vector<std::string>& Table::words(const std::string& name) const {
  return words_[index_of(name)];
}

void Table::refuse(std::size_t row, const std::string& name, const std::string& expected) const {
  throw DataError(at_line(file_, lines_[row]) + ": expected " + expected + ", found '" +
                  shortened(words(name)[row]) + "' (column '" + name + "')");
}

Table read_table(const std::string& file, const std::string& header) {
  std::ifstream in(file);
  std::error_code ignored;
  if (!in || !std::filesystem::is_regular_file(file, ignored))
    throw DataError(file + ": no such file, or it cannot be read");
  Table table;
  table.file_ = file;
  std::string names_line;
  bool at_commas = false;
  const auto take_names = [&](std::string_view line, long number) {
    names_line = without_blanks(line);
    if (!header.empty() && names_line != header)
      throw DataError(at_line(file, number) + ": expected " + header + ", found '" +
                      shortened(names_line) + "'");
    table.header_line_ = number;
    at_commas = has_comma(names_line);
    table.names_ = split(names_line, at_commas);
  };
  bool named_by_comment = false;
  long number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    require_text(line, at_line(file, number));
    const auto content = without_blanks(line);
    if (content.empty()) continue;
    if (content.front() == '#') {
      if (table.rows() == 0) take_names(content.substr(1), number);
      named_by_comment = true;
      continue;
    }
    if (table.names_.empty() && !named_by_comment) {
      take_names(content, number);
      table.words_.resize(table.names_.size());
      continue;
    }
    if (table.names_.empty())
      throw DataError(at_line(file, number) +
                      ": expected a line with the names of the columns first, found '" +
                      shortened(content) + "'");
    const auto fields = split(content, at_commas);
    if (fields.size() != table.names_.size())
      throw DataError(at_line(file, number) + ": expected " + names_line + ", found '" +
                      shortened(content) + "'");
    table.words_.resize(fields.size());
    table.lines_.push_back(number);
    for (std::size_t c = 0; c < fields.size(); ++c) table.words_[c].push_back(fields[c]);
  }
  if (table.names_.empty())
    throw DataError(at_line(file, 1) + ": expected " +
                    (header.empty() ? "a line with the names of the columns" : header) +
                    ", found an empty file");
  // Of comments, the last one alone has the names: others may say a word twice.
  require_each_once(table.names_, at_line(file, table.header_line_));
  table.words_.resize(table.names_.size());
  table.numbers_.resize(table.names_.size());
  table.not_numbers_.resize(table.names_.size());
  for (std::size_t c = 0; c < table.names_.size(); ++c)
    for (std::size_t row = 0; row < table.rows(); ++row) {
      double value = 0;
      if (!parse_number(table.words_[c][row], value)) table.not_numbers_[c].push_back(row);
      table.numbers_[c].push_back(value);
    }
  return table;
}

}  // namespace rodpack

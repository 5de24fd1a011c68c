// SPDX-License-Identifier: GPL-2.0-or-later
#include "table.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace rodpack::test {

namespace {

using Rows = std::vector<std::vector<double>>;

std::vector<std::string> split(std::string line) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

[[noreturn]] void fail(const std::filesystem::path& file, int line_number,
                       const std::string& what) {
  throw std::runtime_error(file.string() + ":" + std::to_string(line_number) + ": " + what);
}

std::vector<double> to_numbers(const std::filesystem::path& file, int line_number,
                               const std::vector<std::string>& words, std::size_t expected) {
  if (words.size() != expected) {
    fail(file, line_number,
         std::to_string(words.size()) + " values, expected " + std::to_string(expected));
  }
  std::vector<double> numbers;
  for (const std::string& word : words) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0') fail(file, line_number, "'" + word + "' is not a number");
  }
  return numbers;
}

std::ifstream open(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return stream;
}

}  // namespace

Table::Table(std::string origin, std::vector<std::string> names, const Rows& rows, long timestep)
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
  std::ifstream stream = open(file);
  std::vector<std::string> names;
  bool named_by_comment = false;
  Rows rows;
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    if (!line.empty() && line[0] == '#') {
      if (rows.empty()) names = split(line.substr(1));
      named_by_comment = true;
      continue;
    }
    const std::vector<std::string> words = split(line);
    if (words.empty()) continue;
    if (names.empty() && !named_by_comment) {
      names = words;
    } else {
      rows.push_back(to_numbers(file, line_number, words, names.size()));
    }
  }
  return Table(file.string(), names, rows);
}

Table read_dump(const std::filesystem::path& file, int frame) {
  std::ifstream stream = open(file);
  std::vector<Table> frames;  // the wanted one only, or the latest so far
  int count = 0;
  int line_number = 0;
  long timestep = 0;
  std::size_t entries = 0;
  std::string line;
  const auto next = [&] {
    if (!std::getline(stream, line)) fail(file, line_number, "ends in the middle of a frame");
    ++line_number;
  };
  while (std::getline(stream, line)) {
    ++line_number;
    if (line.rfind("ITEM: TIMESTEP", 0) == 0) {
      next();
      timestep = std::stol(line);
    } else if (line.rfind("ITEM: NUMBER OF", 0) == 0) {
      next();
      entries = std::stoul(line);
    } else if (line.rfind("ITEM: ATOMS", 0) == 0 || line.rfind("ITEM: ENTRIES", 0) == 0) {
      std::vector<std::string> names = split(line);
      names.erase(names.begin(), names.begin() + 2);
      Rows rows;
      for (std::size_t i = 0; i < entries; ++i) {
        next();
        rows.push_back(to_numbers(file, line_number, split(line), names.size()));
      }
      if (frame < 0 || frame == count) {
        frames.assign(1, Table(file.string(), names, rows, timestep));
      }
      ++count;
    }
  }
  if (frames.empty() || frame >= count) {
    throw std::runtime_error(file.string() + " has " + std::to_string(count) +
                             " frames, no frame " + std::to_string(frame));
  }
  return frames.front();
}

double observed_order(double error_coarse, double error_fine, double ratio) {
  return std::log(error_coarse / error_fine) / std::log(ratio);
}

}  // namespace rodpack::test

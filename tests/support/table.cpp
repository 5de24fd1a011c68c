// SPDX-License-Identifier: GPL-2.0-or-later
#include "table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
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

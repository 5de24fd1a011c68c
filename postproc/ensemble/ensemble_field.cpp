// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/ensemble_field.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "ensemble/interpolation.h"
#include "ensemble/mean_columns.h"
#include "ensemble/statistics.h"
#include "reading/csv_file.h"
#include "reading/data_error.h"
#include "reading/table.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

/// The map of one run.
struct RunField {
  std::string file;
  std::vector<double> x, y;
  std::vector<double> solid_fraction, pressure;  // [row * x.size() + column]
};

// Places run through x first, then y.
void read_grid(const Table& table, RunField& field) {
  const auto &x = table.column("x_m"), &y = table.column("y_m");
  std::size_t columns = 0;
  while (columns < x.size() && y[columns] == y[0]) field.x.push_back(x[columns++]);
  for (std::size_t k = 0; k < y.size(); k += columns) field.y.push_back(y[k]);
  if (columns == 0 || columns * field.y.size() != x.size())
    throw DataError(field.file + ": the places are not those of a grid, row by row");
}

std::optional<RunField> read_field(const FinishedRun& run) {
  RunField field;
  field.file = (fs::path(run.folder) / "analysis" / "fields.csv").string();
  if (!fs::exists(field.file)) return std::nullopt;
  const Table table = read_table(field.file);
  read_grid(table, field);
  field.solid_fraction = table.column("solid_fraction");
  // Without contacts there are densities alone.
  for (const auto& name : table.names())
    if (name == "contact_stress_xx_N_m") {
      const auto &xx = table.column(name), &yy = table.column("contact_stress_yy_N_m");
      for (std::size_t k = 0; k < xx.size(); ++k) field.pressure.push_back((xx[k] + yy[k]) / 2);
    }
  return field;
}

// Places that a packed run (inputs/study/archive.py) has with six digits are the same as whole
// ones: a thousandth of the columns' distance is nothing on a map.
void refuse_other_columns(const RunField& field, const RunField& reference) {
  const auto& x = reference.x;
  const double spacing = (x.back() - x.front()) / std::max(1.0, static_cast<double>(x.size()) - 1);
  bool same = field.x.size() == x.size();
  for (std::size_t c = 0; same && c < x.size(); ++c)
    same = std::fabs(field.x[c] - x[c]) <= 1e-3 * spacing;
  if (!same)
    throw DataError(field.file + ": a grid of " + std::to_string(field.x.size()) +
                    " columns, expected the " + std::to_string(reference.x.size()) +
                    " of the same places as in " + reference.file);
}

std::vector<double> column_of(const std::vector<double>& values, std::size_t column,
                              std::size_t columns) {
  std::vector<double> result;
  for (std::size_t k = column; k < values.size(); k += columns) result.push_back(values[k]);
  return result;
}

std::vector<EnsembleMean> mean_map(const std::vector<std::optional<RunField>>& runs,
                                   const RunField& highest, std::vector<double> RunField::*part) {
  const std::size_t columns = highest.x.size();
  std::vector<EnsembleMean> means(columns * highest.y.size());
  for (std::size_t column = 0; column < columns; ++column) {
    std::vector<ValuesOfRuns> values(highest.y.size(), ValuesOfRuns(runs.size()));
    for (std::size_t run = 0; run < runs.size(); ++run) {
      if (!runs[run] || ((*runs[run]).*part).empty()) continue;
      const auto own = column_of((*runs[run]).*part, column, columns);
      for (std::size_t row = 0; row < highest.y.size(); ++row)
        values[row][run] = interpolated(runs[run]->y, own, highest.y[row]);
    }
    for (std::size_t row = 0; row < highest.y.size(); ++row)
      means[row * columns + column] = mean_over_runs(values[row]);
  }
  return means;
}

std::vector<EnsembleMean> means_from(const Table& table, const std::string& name) {
  const auto &mean = table.column(name), &sem = table.column(name + "_sem");
  const auto n = table.whole_numbers(name + "_n");
  std::vector<EnsembleMean> result;
  for (std::size_t k = 0; k < mean.size(); ++k)
    result.push_back({mean[k], std::isnan(sem[k]) ? std::nullopt : std::optional<double>(sem[k]),
                      static_cast<int>(n[k])});
  return result;
}

}  // namespace

std::optional<EnsembleField> mean_field(const CaseRuns& one) {
  std::vector<std::optional<RunField>> runs;
  const RunField* highest = nullptr;
  for (const auto& run : one.runs) runs.push_back(read_field(run));
  for (const auto& run : runs)
    if (run && (!highest || run->y.back() > highest->y.back())) highest = &*run;
  if (!highest) return std::nullopt;
  for (const auto& run : runs)
    if (run) refuse_other_columns(*run, *highest);
  EnsembleField field{highest->x, highest->y, {}, {}};
  field.solid_fraction = mean_map(runs, *highest, &RunField::solid_fraction);
  if (!highest->pressure.empty()) field.pressure = mean_map(runs, *highest, &RunField::pressure);
  return field;
}

void write_ensemble_field(const EnsembleField& field, const std::string& file) {
  CsvColumns table = {{"x_m", {}}, {"y_m", {}}};
  for (const double y : field.y)
    for (const double x : field.x) {
      table[0].second.push_back(x);
      table[1].second.push_back(y);
    }
  add_mean_columns("solid_fraction", field.solid_fraction, table);
  if (!field.pressure.empty()) add_mean_columns("pressure_N_m", field.pressure, table);
  write_csv(file, table);
}

EnsembleField read_ensemble_field(const std::string& file) {
  const Table table = read_table(file);
  RunField grid;
  grid.file = file;
  read_grid(table, grid);
  EnsembleField field{grid.x, grid.y, means_from(table, "solid_fraction"), {}};
  for (const auto& name : table.names())
    if (name == "pressure_N_m") field.pressure = means_from(table, name);
  return field;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_TABLE_H
#define RODPACK_TESTS_TABLE_H

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace rodpack {
class Table;
}

namespace rodpack::test {

/// Numbers in named columns.
class Table {
 public:
  /// `rows` each hold one value per name. `origin` (a file's name) goes into error messages.
  Table(std::string origin, std::vector<std::string> names,
        const std::vector<std::vector<double>>& rows, long timestep = 0);

  /// Throws std::out_of_range naming the column and those that exist.
  const std::vector<double>& column(const std::string& name) const;
  std::size_t rows() const { return rows_; }
  const std::vector<std::string>& names() const { return names_; }
  /// Time step of a dump's frame, 0 for other tables.
  long timestep() const { return timestep_; }

 private:
  std::string origin_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::size_t rows_;
  long timestep_;
};

/// Reads a whitespace- or comma-separated file of numbers with the post-processor's reader
/// (reading/table.h). Throws DataError, a std::runtime_error, naming file and line.
Table read_table(const std::filesystem::path& file);

/// Reads the field of a table of the post-processor's that lies in this row and column: NaN where
/// it is empty. Throws DataError naming file, line and field when it is neither that nor a number.
double number_or_nan(const rodpack::Table& table, std::size_t row, const std::string& column);

/// Reads the thermo table of run number `run` (0 the first, -1 the last) that `output` of LIGGGHTS
/// tells of: the columns as its header names them ("Step", "Atoms", ...), a row for each line of as
/// many numbers. Throws a std::runtime_error when there is none.
Table read_thermo(const std::string& output, int run = 0);

/// Reads frame number `frame` (0 the first, -1 the last) of a LIGGGHTS text dump with the
/// post-processor's reader (reading/dump.h). Throws a std::runtime_error naming file and line.
Table read_dump(const std::filesystem::path& file, int frame = -1);

/// Order p of a method whose error falls from `error_coarse` to `error_fine` when its step is
/// divided by `ratio`: error ~ step^p.
double observed_order(double error_coarse, double error_fine, double ratio = 2);

}  // namespace rodpack::test

#endif

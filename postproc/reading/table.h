// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_TABLE_H
#define RODPACK_READING_TABLE_H

#include <cstddef>
#include <string>
#include <vector>

namespace rodpack {

/// A table that was read from a file: named columns of one field per row.
class Table {
 public:
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return lines_.size(); }

  /// The fields of a column as numbers, one per row, in the file's own unit; "inf" and "nan" are
  /// numbers too.
  /// @throws DataError when there is no such column (the message lists those there are), or naming
  ///   file, line, field and column when a field of it is not a number.
  const std::vector<double>& column(const std::string& name) const;
  /// The same, finite numbers only. @throws DataError too when a field is "inf" or "nan".
  const std::vector<double>& finite(const std::string& name) const;
  /// The same as whole numbers. @throws DataError too when a field is none.
  std::vector<long> whole_numbers(const std::string& name) const;
  /// The fields of a column as they stand in the file, without blanks around them.
  /// @throws DataError when there is no such column.
  const std::vector<std::string>& words(const std::string& name) const;

  /// Refuses one field: @throws DataError naming file and line, what was `expected`, the field that
  /// was found and its column.
  [[noreturn]] void refuse(std::size_t row, const std::string& name,
                           const std::string& expected) const;

 private:
  friend Table read_table(const std::string& file, const std::string& header);

  std::size_t index_of(const std::string& name) const;

  std::string file_;
  long header_line_ = 1;     // that names the columns, counted from 1
  std::vector<long> lines_;  // of the rows
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> words_;        // per column
  std::vector<std::vector<double>> numbers_;           // per column, 0 where a field is none
  std::vector<std::vector<std::size_t>> not_numbers_;  // per column, rows of such fields
};

/// Reads a table: fields between commas if the line of the names holds one (CSV), else between
/// blanks (what LIGGGHTS's `fix print`, `fix ave/time` and `print` write). The names stand in the
/// last line that starts with '#' before the first row, or else in the first line; empty lines and
/// later comments are passed over. `header`: the line that has to name the columns, if that is
/// known.
/// @throws DataError naming file and line when the file is missing, names no columns or other ones
///   than `header`, or when a row has another number of fields than there are names.
Table read_table(const std::string& file, const std::string& header = "");

}  // namespace rodpack

#endif

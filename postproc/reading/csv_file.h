// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CSV_FILE_H
#define RODPACK_READING_CSV_FILE_H

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rodpack {

/// Writes a comma-separated table: a header line, then one line per row; columns of equal length.
/// @throws DataError when the file cannot be written.
void write_csv(const std::string& file,
               const std::vector<std::pair<std::string, std::vector<double>>>& columns);

/// Joins fields to one line of a comma-separated table, without line end.
std::string csv_line(const std::vector<std::string>& fields);

/// The field of a number with so many significant digits, empty where there is none.
std::string csv_number(const std::optional<double>& value, int significant_digits = 10);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TEXT_H
#define RODPACK_TEXT_H

#include <string>
#include <utility>
#include <vector>

namespace rodpack {

/// `value` with the given number of significant digits, shortest form ("0.25", "1e-09").
std::string number_text(double value, int significant_digits = 10);

/// A value in a unit with an SI prefix that keeps it readable, e.g. 2.3e-3 N: factor 1e3, "mN".
struct ScaledUnit {
  double factor;     // multiply the SI value with this
  std::string name;  // prefix + unit
};
ScaledUnit scaled_unit(double typical_value, const std::string& unit);

/// The largest of 1, 2, 5 times a power of ten that is not above `limit` (> 0).
double round_step(double limit);

/// Writes a comma-separated table: a header line, then one line per row; columns of equal length.
/// @throws DataError when the file cannot be written.
void write_csv(const std::string& file,
               const std::vector<std::pair<std::string, std::vector<double>>>& columns);

/// Contents of `file`, empty when there is none.
std::string read_text(const std::string& file);

/// Writes `content` to `file`, replacing it. @throws DataError when that fails.
void write_text(const std::string& file, const std::string& content);

/// A numeric CSV table with one header line, by column name.
class CsvTable {
 public:
  /// @throws DataError naming file and line when it is missing, ragged or not numeric.
  explicit CsvTable(const std::string& file);
  /// @throws DataError naming the column and those there are.
  const std::vector<double>& column(const std::string& name) const;

 private:
  std::string file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace rodpack

#endif

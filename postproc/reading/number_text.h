// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_NUMBER_TEXT_H
#define RODPACK_READING_NUMBER_TEXT_H

#include <string>

namespace rodpack {

/// Writes `value` with the given number of significant digits, shortest form ("0.25", "1e-09").
std::string number_text(double value, int significant_digits = 10);

/// Writes `value` with so many digits after the point, zeros too ("0.250").
std::string fixed_text(double value, int decimals);

/// A value in a unit with an SI prefix that keeps it readable, e.g. 2.3e-3 N: factor 1e3, "mN".
struct ScaledUnit {
  double factor;     // multiply the SI value with this
  std::string name;  // prefix + unit
};
/// Chooses the unit for values of about `typical_value`, in the SI unit `unit`.
ScaledUnit scaled_unit(double typical_value, const std::string& unit);

/// Returns the largest of 1, 2, 5 times a power of ten that is not above `limit` (> 0).
double round_step(double limit);

}  // namespace rodpack

#endif

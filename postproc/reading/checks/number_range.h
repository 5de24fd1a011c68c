// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_NUMBER_RANGE_H
#define RODPACK_READING_CHECKS_NUMBER_RANGE_H

#include <string>

namespace rodpack {

/// What a number from outside may be.
struct NumberRange {
  double low, high;
  bool whole = false;      // whole numbers only
  bool above_low = false;  // `low` itself is outside

  /// Whether `value` is a finite number in the range.
  bool contains(double value) const;
  /// "a number of 0 to 7", "a whole number of 1 to 1000", "a number above 0, at most 1000".
  std::string text() const;
};

/// Returns `value`. @throws DataError naming it, as `what`, when it is not above 0.
double require_positive(double value, const std::string& what);

}  // namespace rodpack

#endif

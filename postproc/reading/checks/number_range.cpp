// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/number_range.h"

#include <cmath>

#include "reading/data_error.h"
#include "reading/number_text.h"

namespace rodpack {

bool NumberRange::contains(double value) const {
  return std::isfinite(value) && value >= low && value <= high && !(above_low && value == low) &&
         !(whole && value != std::round(value));
}

std::string NumberRange::text() const {
  const std::string kind = whole ? "a whole number" : "a number";
  if (above_low) return kind + " above " + number_text(low) + ", at most " + number_text(high, 16);
  return kind + " of " + number_text(low) + " to " + number_text(high, 16);
}

double require_positive(double value, const std::string& what) {
  if (!(value > 0))
    throw DataError(what + ": expected a positive value, found " + number_text(value));
  return value;
}

}  // namespace rodpack

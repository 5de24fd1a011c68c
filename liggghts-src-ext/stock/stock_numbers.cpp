// SPDX-License-Identifier: GPL-2.0-or-later
#include "stock_numbers.h"

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <string>

#include "error.h"

namespace rodpack {

namespace {

bool read_whole_word(const char* text, long long& value) {
  char* end = nullptr;
  errno = 0;
  value = std::strtoll(text, &end, 10);
  return end != text && *end == '\0' && errno != ERANGE;
}

}  // namespace

void refuse_number(LAMMPS_NS::Error* error, const char* file, int line, const char* expected,
                   const char* text) {
  const std::string message = std::string("expected ") + expected + ", got '" + text + "'";
  error->all(file, line, message.c_str());
}

double whole_word_number(LAMMPS_NS::Error* error, const char* file, int line, const char* text) {
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || *end != '\0' || !std::isfinite(value))
    refuse_number(error, file, line, "a finite number", text);
  return value;
}

int whole_word_integer(LAMMPS_NS::Error* error, const char* file, int line, const char* text) {
  long long value = 0;
  if (!read_whole_word(text, value) || value > INT_MAX || value < -INT_MAX)
    refuse_number(error, file, line, "an integer of at most 2147483647", text);
  return static_cast<int>(value);
}

long long whole_word_steps(LAMMPS_NS::Error* error, const char* file, int line, const char* text) {
  long long value = 0;
  if (!read_whole_word(text, value))
    refuse_number(error, file, line, "a whole number of steps", text);
  return value;
}

}  // namespace rodpack

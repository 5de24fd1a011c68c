// SPDX-License-Identifier: GPL-2.0-or-later
#include "stock_numbers.h"

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <string>

#include "error.h"
#include "input.h"

namespace rodpack {

namespace {

bool read_whole_word(const char* text, long long& value) {
  char* end = nullptr;
  errno = 0;
  value = std::strtoll(text, &end, 10);
  return end != text && *end == '\0' && errno != ERANGE;
}

}  // namespace

void refuse_number(LAMMPS_NS::Error* error, const LAMMPS_NS::Input* input, const char* file,
                   int line, const char* expected, const char* text) {
  std::string message =
      std::string("expected ") + expected + ", got '" + text + "' in the arguments";
  for (int k = 0; k < input->narg; ++k) message += std::string(" ") + input->arg[k];
  error->all(file, line, message.c_str());
}

bool is_number(const char* text, double& value) {
  char* end = nullptr;
  value = std::strtod(text, &end);
  return end != text && *end == '\0' && std::isfinite(value);
}

bool is_integer(const char* text, int& value) {
  long long whole = 0;
  if (!read_whole_word(text, whole) || whole > INT_MAX || whole < -INT_MAX) return false;
  value = static_cast<int>(whole);
  return true;
}

long long whole_word_steps(LAMMPS_NS::Error* error, const LAMMPS_NS::Input* input, const char* file,
                           int line, const char* text) {
  long long value = 0;
  if (!read_whole_word(text, value))
    refuse_number(error, input, file, line, "a whole number of steps", text);
  return value;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "json_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace LAMMPS_NS {

std::string json_string(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) quoted += c;
  }
  return quoted + "\"";
}

std::string json_number(double number) {
  if (!std::isfinite(number)) return "null";
  char text[32];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::strtod(text, NULL) == number) break;
  }
  return text;
}

std::string json_vector(const double (&values)[3]) {
  return "[" + json_number(values[0]) + ", " + json_number(values[1]) + ", " +
         json_number(values[2]) + "]";
}

}  // namespace LAMMPS_NS

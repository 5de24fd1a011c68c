// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/number_text.h"

#include <cmath>
#include <cstdio>

namespace rodpack {

std::string number_text(double value, int significant_digits) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.*g", significant_digits, value);
  return buffer;
}

std::string fixed_text(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

ScaledUnit scaled_unit(double typical_value, const std::string& unit) {
  const struct {
    double size;
    const char* prefix;
  } prefixes[] = {{1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}};
  if (typical_value <= 0) return {1, unit};
  for (const auto& [size, prefix] : prefixes)
    if (typical_value >= size) return {1 / size, prefix + unit};
  return {1e9, "n" + unit};
}

double round_step(double limit) {
  const double decade = std::pow(10, std::floor(std::log10(limit)));
  const double mantissa = limit / decade * (1 + 1e-12);
  return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

}  // namespace rodpack

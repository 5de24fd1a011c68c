// SPDX-License-Identifier: GPL-2.0-or-later
#include "style_arguments.h"

#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "error.h"
#include "math_extra_liggghts.h"

namespace LAMMPS_NS {

StyleArguments::StyleArguments(LAMMPS* lmp, int narg, char** arg, int first, const char* kind)
    : Pointers(lmp), narg_(narg), arg_(arg), next_(first), kind_(kind) {}

std::string StyleArguments::word(const std::string& keyword, const std::string& expected) {
  if (!more()) fail("value of " + keyword + " is missing, expected " + expected);
  return arg_[next_++];
}

double StyleArguments::number(const std::string& keyword, const std::string& expected,
                              bool (*valid)(double)) {
  const std::string text = word(keyword, expected);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !std::isfinite(value) || !valid(value))
    reject(keyword, expected, text);
  return value;
}

int StyleArguments::integer(const std::string& keyword, const std::string& expected,
                            bool (*valid)(long)) {
  const std::string text = word(keyword, expected);
  char* end = nullptr;
  const long value = std::strtol(text.c_str(), &end, 10);
  if (end == text.c_str() || *end != '\0' || value > INT_MAX || value < INT_MIN || !valid(value))
    reject(keyword, expected, text);
  return static_cast<int>(value);
}

bool StyleArguments::yes_or_no(const std::string& keyword) {
  const std::string text = word(keyword, "yes or no");
  if (text != "yes" && text != "no") reject(keyword, "yes or no", text);
  return text == "yes";
}

void StyleArguments::fail(const std::string& message) const {
  const std::string text = std::string(kind_) + " " + arg_[2] + " (id " + arg_[0] + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();  // not reached: Error::all ends the run, but does not say so to the compiler
}

void StyleArguments::reject(const std::string& keyword, const std::string& expected,
                            const std::string& value) const {
  fail(keyword + " must be " + expected + ", got '" + value + "'");
}

std::string prime_seed(int seed) {
  // splitmix64's finaliser (Steele, Lea, Flood, OOPSLA 2014)
  std::uint64_t mixed = static_cast<std::uint64_t>(seed) + 0x9e3779b97f4a7c15ULL;
  mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
  mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
  mixed ^= mixed >> 31;
  // LIGGGHTS adds the rank to the seed of some generators: room for that below INT_MAX
  int prime = 10007 + static_cast<int>(mixed % (INT_MAX - 20000000));
  while (!MathExtraLiggghts::isPrime(prime)) ++prime;
  return std::to_string(prime);
}

}  // namespace LAMMPS_NS

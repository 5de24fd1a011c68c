// SPDX-License-Identifier: GPL-2.0-or-later
#include "style_arguments.h"

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "stop_run.h"

namespace LAMMPS_NS {

namespace {

/// The words in a row: "a, b or c".
std::string one_of(std::initializer_list<const char*> words) {
  std::string list;
  std::size_t k = 0;
  for (const char* word : words) {
    if (k > 0) list += k + 1 < words.size() ? ", " : " or ";
    list += word;
    ++k;
  }
  return list;
}

}  // namespace

const char* const a_length = "a length (m) in (0, 1e15]";
const char* const a_position = "a position (m) in [-1e15, 1e15]";
const char* const a_count = "a whole number in [1, 2147483647]";
const char* const an_atom_type = "an atom type in [1, 2147483647]";

StyleArguments::StyleArguments(LAMMPS* lmp, int narg, char** arg, int first, const char* kind)
    : StyleArguments(lmp, std::string(kind) + " " + arg[2] + " (id " + arg[0] + ")", narg, arg,
                     first) {}

StyleArguments::StyleArguments(LAMMPS* lmp, const std::string& who, int narg, char** arg, int first)
    : Pointers(lmp), who_(who), narg_(narg), arg_(arg), next_(first) {}

int StyleArguments::find(const std::string& keyword) {
  int place = -1;
  for (int k = next_; k < narg_; ++k) {
    if (keyword != arg_[k]) continue;
    if (place >= 0) fail("keyword " + keyword + " is given twice, expected once");
    place = k;
  }
  if (place >= 0) next_ = place + 1;
  return place;
}

std::string StyleArguments::word(const std::string& keyword, const std::string& expected) {
  if (more()) return arg_[next_++];
  fail("value of " + keyword + " is missing, expected " + expected);
}

std::string StyleArguments::new_keyword(const std::string& may_repeat) {
  const std::string keyword = arg_[next_++];
  if (!keywords_.insert(keyword).second && keyword != may_repeat)
    fail("keyword " + keyword + " is given twice, expected once");
  return keyword;
}

void StyleArguments::require(std::initializer_list<const char*> keywords) const {
  for (const char* needed : keywords)
    if (!given(needed)) fail(std::string("keyword ") + needed + " is missing, expected once");
}

double StyleArguments::number(const std::string& keyword, const std::string& expected) {
  const std::string text = word(keyword, expected);
  double value = 0.0;
  if (!read_number(text, value) || !in_interval(value, expected)) reject(keyword, expected, text);
  return value;
}

void StyleArguments::pair(const std::string& keyword, const std::string& expected, double& low,
                          double& high, bool ascending) {
  const std::string both = peek() + " " + peek(1);
  low = number(keyword, "two of " + expected);
  high = number(keyword, "two of " + expected);
  if (low > high || (ascending && low == high))
    reject(keyword, "two of " + expected + ", the lower one first", both);
}

void StyleArguments::vector(const std::string& keyword, const std::string& expected,
                            double (&values)[3]) {
  for (double& value : values) value = number(keyword, "three " + expected);
}

int StyleArguments::integer(const std::string& keyword, const std::string& expected) {
  const std::string text = peek();
  const bigint value = step(keyword, expected);
  if (value > INT_MAX || value < INT_MIN) reject(keyword, expected, text);
  return static_cast<int>(value);
}

bigint StyleArguments::step(const std::string& keyword, const std::string& expected) {
  const std::string text = word(keyword, expected);
  long long value = 0;
  if (!read_integer(text, value) || value > MAXBIGINT || value < -MAXBIGINT ||
      !in_interval(static_cast<double>(value), expected))
    reject(keyword, expected, text);
  return static_cast<bigint>(value);
}

bool StyleArguments::yes_or_no(const std::string& keyword) {
  return choice(keyword, {"yes", "no"}) == 0;
}

int StyleArguments::choice(const std::string& keyword, std::initializer_list<const char*> words) {
  const std::string text = word(keyword, one_of(words));
  int place = 0;
  for (const char* known : words) {
    if (text == known) return place;
    ++place;
  }
  reject(keyword, one_of(words), text);
}

void StyleArguments::require_end() const {
  if (more()) fail("unknown word '" + peek() + "', expected the end of the command");
}

void StyleArguments::require_group_all(const std::string& what) const {
  if (std::string(arg_[1]) != "all") fail(what + ": the group has to be 'all'");
}

void StyleArguments::fail(const std::string& message) const {
  stop_run(lmp, who_ + ": " + message);
}

void StyleArguments::reject(const std::string& keyword, const std::string& expected,
                            const std::string& value) const {
  fail(keyword + " is '" + value + "', expected " + expected);
}

void StyleArguments::reject_keyword(const std::string& keyword, const std::string& expected) const {
  fail("unknown keyword '" + keyword + "', expected " + expected);
}

bool read_number(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  const bool hexadecimal = text.find_first_of("xX") != std::string::npos;
  return end != text.c_str() && *end == '\0' && std::isfinite(value) && !hexadecimal;
}

bool read_integer(const std::string& text, long long& value) {
  char* end = nullptr;
  errno = 0;
  value = std::strtoll(text.c_str(), &end, 10);
  return end != text.c_str() && *end == '\0' && errno != ERANGE;
}

bool in_interval(double value, const std::string& text) {
  for (std::size_t open = text.find_first_of("[("); open != std::string::npos;
       open = text.find_first_of("[(", open + 1)) {
    const char *rest = text.c_str() + open + 1, *high_text = std::strchr(rest, ',');
    char *low_end = nullptr, *high_end = nullptr;
    const double low = std::strtod(rest, &low_end);
    if (!high_text || low_end == rest || low_end != high_text) continue;  // "(m)"
    const double high = std::strtod(high_text + 1, &high_end);
    return (text[open] == '[' ? value >= low : value > low) &&
           (*high_end == ']' ? value <= high : value < high);
  }
  return true;
}

}  // namespace LAMMPS_NS

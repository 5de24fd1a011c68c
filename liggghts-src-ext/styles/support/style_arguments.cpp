// SPDX-License-Identifier: GPL-2.0-or-later
#include "style_arguments.h"

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>

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

StyleArguments::StyleArguments(LAMMPS* lmp, int narg, char** arg, int first, const char* kind,
                               Wording wording)
    : StyleArguments(lmp, std::string(kind) + " " + arg[2] + " (id " + arg[0] + ")", narg, arg,
                     first, wording) {}

StyleArguments::StyleArguments(LAMMPS* lmp, const std::string& who, int narg, char** arg, int first,
                               Wording wording)
    : Pointers(lmp), who_(who), narg_(narg), arg_(arg), next_(first), wording_(wording) {}

int StyleArguments::find(const std::string& keyword) {
  for (int k = next_; k < narg_; ++k) {
    if (keyword != arg_[k]) continue;
    next_ = k + 1;
    return k;
  }
  return -1;
}

std::string StyleArguments::word(const std::string& keyword, const std::string& expected) {
  if (more()) return arg_[next_++];
  if (wording_ == Wording::is) fail(keyword + " needs a value, expected " + expected);
  fail("value of " + keyword + " is missing, expected " + expected);
}

std::string StyleArguments::new_keyword() {
  const std::string keyword = word("", "a keyword");
  if (!keywords_.insert(keyword).second) fail("keyword " + keyword + " is given twice");
  return keyword;
}

void StyleArguments::require(std::initializer_list<const char*> keywords) const {
  for (const char* needed : keywords)
    if (!given(needed)) fail(std::string("keyword ") + needed + " is missing");
}

double StyleArguments::number(const std::string& keyword, const std::string& expected,
                              bool (*valid)(double)) {
  const std::string text = word(keyword, expected);
  double value = 0.0;
  if (!read_number(text, value) || !valid(value)) reject(keyword, expected, text);
  return value;
}

int StyleArguments::integer(const std::string& keyword, const std::string& expected,
                            bool (*valid)(long)) {
  const std::string text = word(keyword, expected);
  long long value = 0;
  if (!read_integer(text, value) || value > INT_MAX || value < INT_MIN ||
      !valid(static_cast<long>(value)))
    reject(keyword, expected, text);
  return static_cast<int>(value);
}

bigint StyleArguments::step(const std::string& keyword, const std::string& expected,
                            bool (*valid)(bigint)) {
  const std::string text = word(keyword, expected);
  long long value = 0;
  if (!read_integer(text, value) || value > MAXBIGINT || value < -MAXBIGINT ||
      !valid(static_cast<bigint>(value)))
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
  if (more()) reject_keyword(peek(), "");
}

void StyleArguments::require_group_all(const std::string& what) const {
  if (std::string(arg_[1]) != "all") fail(what + ": the group has to be 'all'");
}

void StyleArguments::fail(const std::string& message) const {
  stop_run(lmp, who_ + ": " + message);
}

void StyleArguments::reject(const std::string& keyword, const std::string& expected,
                            const std::string& value) const {
  if (wording_ == Wording::is) fail(keyword + " is " + value + ", expected " + expected);
  fail(keyword + " must be " + expected + ", got '" + value + "'");
}

void StyleArguments::reject_keyword(const std::string& keyword, const std::string& expected) const {
  const std::string quote = wording_ == Wording::is ? "" : "'";
  fail("unknown keyword " + quote + keyword + quote +
       (expected.empty() ? "" : ", expected " + expected));
}

bool read_number(const std::string& text, double& value) {
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && std::isfinite(value);
}

bool read_integer(const std::string& text, long long& value) {
  char* end = nullptr;
  errno = 0;
  value = std::strtoll(text.c_str(), &end, 10);
  return end != text.c_str() && *end == '\0' && errno != ERANGE;
}

}  // namespace LAMMPS_NS

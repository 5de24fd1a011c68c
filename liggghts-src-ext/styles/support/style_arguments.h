// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STYLE_ARGUMENTS_H
#define RODPACK_STYLE_ARGUMENTS_H

#include <string>

#include "lammps.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Reads the words of a fix or compute command one after the other. Whatever is missing or wrong
/// ends the run with one line that names the keyword, the value and what was expected: LIGGGHTS's
/// own atof() would read a misspelt number as 0.
class StyleArguments : protected Pointers {
 public:
  /// Words from `arg[first]` on; arg[0] is the id, arg[2] the style of the `kind` of command.
  StyleArguments(LAMMPS* lmp, int narg, char** arg, int first = 3, const char* kind = "Fix");

  bool more() const { return next_ < narg_; }
  /// The next word, without moving on; empty at the end.
  std::string peek() const { return more() ? arg_[next_] : ""; }

  std::string word(const std::string& keyword, const std::string& expected);
  /// A finite number for which `valid` holds.
  double number(const std::string& keyword, const std::string& expected, bool (*valid)(double));
  int integer(const std::string& keyword, const std::string& expected, bool (*valid)(long));
  bool yes_or_no(const std::string& keyword);

  /// Ends the run on all ranks: "KIND STYLE (id ID): MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  /// Fails with "KEYWORD must be EXPECTED, got 'VALUE'".
  [[noreturn]] void reject(const std::string& keyword, const std::string& expected,
                           const std::string& value) const;

 private:
  int narg_;
  char** arg_;
  int next_;
  const char* kind_;
};

/// A seed for LIGGGHTS's generators, which insist on a prime above 10000: any positive integer is
/// scattered over the primes, so that runs with seeds 1, 2, 3 ... draw unrelated numbers (the first
/// numbers of Park and Miller's generator are proportional to the seed).
std::string prime_seed(int seed);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_REFUSALS_H
#define RODPACK_TESTS_REFUSALS_H

#include <iosfwd>
#include <string>
#include <vector>

namespace rodpack::test {

/// How a program has answered a sweep of wrong values. All but `clear` fail the test.
struct Refusals {
  int clear = 0, unclear = 0, accepted = 0, crash = 0;

  /// Counts an answer: a refusal has an exit code of 1 or 2, a clear one consists of one line that
  /// has all of `says` in it. `said`: all that the program has said; `what`: the wrong value.
  void judge(int exit_code, const std::vector<std::string>& lines,
             const std::vector<std::string>& says, const std::string& what,
             const std::string& said);
};

/// "clear 5, unclear 0, accepted wrongly 0, crash 0"
std::ostream& operator<<(std::ostream& out, const Refusals& refusals);

}  // namespace rodpack::test

#endif

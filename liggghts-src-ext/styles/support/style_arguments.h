// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STYLE_ARGUMENTS_H
#define RODPACK_STYLE_ARGUMENTS_H

#include <initializer_list>
#include <set>
#include <string>

#include "lammps.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// Reads the words of a command one after the other. Whatever is missing or wrong ends the run with
/// one line that names the command, the keyword, the value and what was expected: LIGGGHTS's own
/// atof() would read a misspelt number as 0.
class StyleArguments : protected Pointers {
 public:
  /// The two ways in which our styles speak of a wrong value.
  enum class Wording {
    must_be,  // "KEYWORD must be EXPECTED, got 'VALUE'"
    is        // "KEYWORD is VALUE, expected EXPECTED"
  };

  /// Words from `arg[first]` on; arg[0] is the id, arg[1] the group, arg[2] the style of the `kind`
  /// of command: "Fix", "Compute" or "Dump".
  StyleArguments(LAMMPS* lmp, int narg, char** arg, int first = 3, const char* kind = "Fix",
                 Wording wording = Wording::must_be);
  /// Words from `arg[first]` on of another command, which messages call `who`.
  StyleArguments(LAMMPS* lmp, const std::string& who, int narg, char** arg, int first,
                 Wording wording = Wording::is);

  bool more() const { return next_ < narg_; }
  /// Number of words that are left.
  int left() const { return narg_ - next_; }
  /// A word that is left, the next one or one `further` on, without moving on; empty beyond the
  /// end.
  std::string peek(int further = 0) const { return further < left() ? arg_[next_ + further] : ""; }

  /// Moves on to the word behind the next `keyword` and returns the index of the keyword among the
  /// words of the command; -1, without moving, if it is not there.
  int find(const std::string& keyword);
  /// The next word, the value of `keyword`; `expected` is for the message if there is none.
  std::string word(const std::string& keyword, const std::string& expected);
  /// The next word, a keyword that must not have been there before.
  std::string new_keyword();
  /// Whether new_keyword() has read it.
  bool given(const std::string& keyword) const { return keywords_.count(keyword) != 0; }
  /// Fails unless each of them was given.
  void require(std::initializer_list<const char*> keywords) const;

  /// A finite number for which `valid` holds.
  double number(const std::string& keyword, const std::string& expected,
                bool (*valid)(double) = any);
  int integer(const std::string& keyword, const std::string& expected, bool (*valid)(long));
  /// An integer as large as a number of steps may be.
  bigint step(const std::string& keyword, const std::string& expected, bool (*valid)(bigint));
  bool yes_or_no(const std::string& keyword);
  /// One of these words; returns which, counted from 0.
  int choice(const std::string& keyword, std::initializer_list<const char*> words);

  static bool any(double) { return true; }
  static bool positive(double value) { return value > 0.0; }

  /// Fails unless all words have been read.
  void require_end() const;
  /// Fails with "WHAT: the group has to be 'all'" unless it is.
  void require_group_all(const std::string& what) const;

  /// Ends the run on all ranks: "KIND STYLE (id ID): MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  /// Fails with a line on a wrong value, in this object's wording.
  [[noreturn]] void reject(const std::string& keyword, const std::string& expected,
                           const std::string& value) const;
  /// Fails with "unknown keyword KEYWORD", and what was expected unless that is empty.
  [[noreturn]] void reject_keyword(const std::string& keyword, const std::string& expected) const;

 private:
  std::string who_;
  int narg_;
  char** arg_;
  int next_;
  Wording wording_;
  std::set<std::string> keywords_;
};

/// Reads a finite number, or an integer; false unless the text is one from end to end.
bool read_number(const std::string& text, double& value);
bool read_integer(const std::string& text, long long& value);

}  // namespace LAMMPS_NS

#endif

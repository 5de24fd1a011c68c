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
///
/// What is `expected` of a number is a text with an interval, as "a length (m) in (0, 1e15]": the
/// number has to lie in it, so that message and check are one. A text without an interval takes
/// any finite number. The pages of the styles have the same intervals.
class StyleArguments : protected Pointers {
 public:
  /// Words from `arg[first]` on; arg[0] is the id, arg[1] the group, arg[2] the style of the `kind`
  /// of command: "Fix", "Compute" or "Dump".
  StyleArguments(LAMMPS* lmp, int narg, char** arg, int first = 3, const char* kind = "Fix");
  /// Words from `arg[first]` on of another command, which messages call `who`.
  StyleArguments(LAMMPS* lmp, const std::string& who, int narg, char** arg, int first);

  bool more() const { return next_ < narg_; }
  /// Number of words that are left.
  int left() const { return narg_ - next_; }
  /// A word that is left, the next one or one `further` on, without moving on; empty beyond the
  /// end.
  std::string peek(int further = 0) const { return further < left() ? arg_[next_ + further] : ""; }

  /// Moves on to the word behind the next `keyword` and returns the index of the keyword among the
  /// words of the command; -1, without moving, if it is not there. Fails if it is there twice.
  int find(const std::string& keyword);
  /// The next word, the value of `keyword`; `expected` is for the message if there is none.
  std::string word(const std::string& keyword, const std::string& expected);
  /// The next word, a keyword that must not have been there before, unless it is the one that
  /// `may_repeat`.
  std::string new_keyword(const std::string& may_repeat = "");
  /// Whether new_keyword() has read it.
  bool given(const std::string& keyword) const { return keywords_.count(keyword) != 0; }
  /// Fails unless each of them was given.
  void require(std::initializer_list<const char*> keywords) const;

  double number(const std::string& keyword, const std::string& expected);
  /// Two numbers of which the second is not below the first, and not equal to it if the pair has to
  /// be `ascending`.
  void pair(const std::string& keyword, const std::string& expected, double& low, double& high,
            bool ascending = false);
  /// Three numbers: "three VALUES in [LOW, HIGH]".
  void vector(const std::string& keyword, const std::string& expected, double (&values)[3]);
  int integer(const std::string& keyword, const std::string& expected);
  /// An integer as large as a number of steps may be.
  bigint step(const std::string& keyword, const std::string& expected);
  bool yes_or_no(const std::string& keyword);
  /// One of these words; returns which, counted from 0.
  int choice(const std::string& keyword, std::initializer_list<const char*> words);

  /// Fails unless all words have been read.
  void require_end() const;
  /// Fails with "WHAT: the group has to be 'all'" unless it is.
  void require_group_all(const std::string& what) const;

  /// Ends the run on all ranks: "KIND STYLE (id ID): MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;
  /// Fails with "KEYWORD is 'VALUE', expected EXPECTED".
  [[noreturn]] void reject(const std::string& keyword, const std::string& expected,
                           const std::string& value) const;
  /// Fails with "unknown keyword 'KEYWORD', expected EXPECTED".
  [[noreturn]] void reject_keyword(const std::string& keyword, const std::string& expected) const;

 private:
  std::string who_;
  int narg_;
  char** arg_;
  int next_;
  std::set<std::string> keywords_;
};

/// What StyleArguments expects of a length that is not 0, of a place along an axis, of a number of
/// things or a seed, and of an atom type.
extern const char* const a_length;
extern const char* const a_position;
extern const char* const a_count;
extern const char* const an_atom_type;

/// Reads a finite decimal number, or an integer; false unless the text is one from end to end.
bool read_number(const std::string& text, double& value);
bool read_integer(const std::string& text, long long& value);

/// Whether a value lies in the interval that a text names, "(0, 1e15]" for example: a square
/// bracket includes its end. True for a text without one; false for a NaN in any interval.
bool in_interval(double value, const std::string& text);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(halt,FixHalt)
// clang-format on
#else
#ifndef LMP_FIX_HALT_H
#define LMP_FIX_HALT_H

#include <string>
#include "fix.h"

namespace LAMMPS_NS {

/// fix halt: ends a run when an equal-style variable meets a condition, or has met it for a while;
/// the input script goes on. Its scalar is 1 if the last run was ended by this fix, else 0.
class FixHalt : public Fix {
 public:
  FixHalt(class LAMMPS* lmp, int narg, char** arg);
  int setmask();
  void init();
  void setup(int vflag);
  void end_of_step();
  void post_run();
  void write_restart(FILE* file);
  void restart(char* buffer);
  double compute_scalar() { return halted_ ? 1.0 : 0.0; }

 private:
  // They stand in the order of the words that the command knows.
  enum Operator { LESS, LESS_EQUAL, GREATER, GREATER_EQUAL, EQUAL, NOT_EQUAL };
  void read_keywords(class StyleArguments& arguments);
  bool holds(double left) const;

  std::string variable_;
  int index_;  // of the variable
  Operator operator_;
  std::string operator_text_;
  double value_;
  bigint start_;  // no check before this step
  bigint hold_;   // steps for which the condition has to have held at every check
  bigint since_;  // first step of the checks at which it has held; -1: it does not hold
  bool message_;
  bool halted_;
  bool quit_set_here_;
};

}  // namespace LAMMPS_NS

#endif
#endif

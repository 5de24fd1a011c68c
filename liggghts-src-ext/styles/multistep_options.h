// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_MULTISTEP_OPTIONS_H
#define LMP_MULTISTEP_OPTIONS_H

#include "pointers.h"

namespace LAMMPS_NS {

class Fix;

/// Keywords that the Adams-Bashforth fixes share: `order 1..4` and `planar auto|yes|no`.
class MultistepOptions : protected Pointers {
 public:
  MultistepOptions(class LAMMPS* lmp, Fix* owner) : Pointers(lmp), owner_(owner) {}

  /// Reads the keyword at arg[iarg] with its value. Returns the number of words taken, 0 if the
  /// keyword is not one of these. Ends the run when the value is missing or wrong.
  int read(int iarg, int narg, char** arg);

  /// Value of `keyword` at arg[iarg]; ends the run when there is none.
  const char* value(int iarg, int narg, char** arg) const;
  /// The same as a yes or no.
  bool yes_or_no(int iarg, int narg, char** arg) const;
  /// Ends the run: what is wrong with the keyword at arg[iarg].
  void refuse(const char* keyword, const char* value, const char* expected) const;

  int order() const { return order_; }
  /// True when only x, y and the rotation about z move: as the keyword says, or, with `auto`, when
  /// a fix enforce2d keeps the scene planar or the simulation is two-dimensional.
  bool planar() const;
  /// True when planar() can never be false.
  bool always_planar() const { return planar_ == YES; }

 private:
  enum Planar { AUTO, YES, NO };

  Fix* owner_;
  int order_ = 3;
  Planar planar_ = AUTO;
};

}  // namespace LAMMPS_NS

#endif

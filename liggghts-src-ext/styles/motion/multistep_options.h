// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MULTISTEP_OPTIONS_H
#define RODPACK_MULTISTEP_OPTIONS_H

#include <string>

#include "pointers.h"

namespace LAMMPS_NS {

class StyleArguments;

/// Keywords that the Adams-Bashforth fixes share: `order 1..4`, and 0 where the fix knows leapfrog,
/// and `planar auto|yes|no`.
class MultistepOptions : protected Pointers {
 public:
  explicit MultistepOptions(class LAMMPS* lmp, bool leapfrog = false)
      : Pointers(lmp), leapfrog_(leapfrog) {}

  /// Reads the value of `keyword`; false if it is none of these. Ends the run if the value is
  /// wrong.
  bool read(const std::string& keyword, StyleArguments& arguments);

  int order() const { return order_; }
  /// True when only x, y and the rotation about z move: as the keyword says, or, with `auto`, when
  /// a fix enforce2d keeps the scene planar or the simulation is two-dimensional.
  bool planar() const;
  /// True when planar() can never be false.
  bool always_planar() const { return planar_ == "yes"; }

 private:
  bool leapfrog_;
  int order_ = 3;
  std::string planar_ = "auto";
};

/// Warns, on the first rank, of bodies or spheres that start with an empty history: "Fix STYLE:
/// WHY, so the history of WHOSE starts anew".
void warn_of_new_histories(const class Fix& fix, class LAMMPS* lmp, const std::string& why,
                           const std::string& whose);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PLANAR_OWNERS_H
#define LMP_PLANAR_OWNERS_H

#include "pointers.h"

namespace LAMMPS_NS {

/// Knows which rank owns each atom and which rank keeps the body that the atom belongs to, for the
/// atoms of this rank and its ghosts: fix multisphere may keep a body on another rank than some of
/// its spheres.
class PlanarOwners : protected Pointers {
 public:
  explicit PlanarOwners(class LAMMPS* lmp) : Pointers(lmp) {}

  /// Adds the property of the atoms that carries this, unless there is one rank only. To be called
  /// before the first run; `caller` is the style that asks for it.
  static void create_property(class LAMMPS* lmp, const char* caller);
  /// Finds that property.
  void connect();

  /// Sets it anew after atoms or bodies have changed their rank; collective.
  void renew(class FixMultisphere& bodies);
  /// Rank that owns the atom with this local index.
  int of_atom(int i) const;
  /// Rank that keeps the body of the atom with this local index; -1 if no rank does.
  int of_body(int i) const;

 private:
  class FixPropertyAtom* ranks_ = NULL;  // per atom: rank of its body plus 1, its own rank
};

}  // namespace LAMMPS_NS

#endif

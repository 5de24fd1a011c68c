// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PLANAR_OWNERS_H
#define LMP_PLANAR_OWNERS_H

#include "pointers.h"

namespace LAMMPS_NS {

/// On which rank each atom is, and the body that it belongs to, for the atoms of this rank and its
/// ghosts: fix multisphere may keep a body elsewhere than a sphere of it.
class PlanarOwners : protected Pointers {
 public:
  explicit PlanarOwners(class LAMMPS* lmp) : Pointers(lmp) {}

  /// Makes the property of the atoms that carries this, unless there is one rank only. Before the
  /// first run; `caller`: style that asks for it.
  static void create_property(class LAMMPS* lmp, const char* caller);
  void connect();

  /// After atoms or bodies have changed their rank; collective.
  void renew(class FixMultisphere& bodies);
  int of_atom(int i) const;
  /// -1: no rank has its body.
  int of_body(int i) const;

 private:
  class FixPropertyAtom* ranks_ = NULL;  // of the body, plus 1; of the atom
};

}  // namespace LAMMPS_NS

#endif

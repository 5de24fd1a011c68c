// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MULTISPHERE_FIX_H
#define RODPACK_MULTISPHERE_FIX_H

#include "fix_multisphere.h"
#include "modify.h"

namespace LAMMPS_NS {

/// The fix that holds the rigid bodies, multisphere or multisphere/ab; NULL if there is none.
/// (LIGGGHTS finds fixes by the beginning of their style.)
inline FixMultisphere* multisphere_fix(Modify* modify) {
  return static_cast<FixMultisphere*>(modify->find_fix_style("multisphere", 0));
}

/// Of each body, which fix move/multisphere prescribes its motion, counted from 1, or 0; NULL where
/// no such fix can be. It is the property of this name.
const char* const prescribed_motion = "prescribed_motion";
inline const ScalarContainer<int>* prescribed_motions(Multisphere& bodies) {
  return bodies.prop().getElementProperty<ScalarContainer<int> >(prescribed_motion);
}

}  // namespace LAMMPS_NS

#endif

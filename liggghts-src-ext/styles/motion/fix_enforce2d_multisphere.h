// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(enforce2d/multisphere,FixEnforce2DMultisphere)
// clang-format on

#else

#ifndef RODPACK_FIX_ENFORCE2D_MULTISPHERE_H
#define RODPACK_FIX_ENFORCE2D_MULTISPHERE_H

#include "container.h"
#include "fix.h"

namespace LAMMPS_NS {

class Multisphere;

/// fix enforce2d/multisphere: keeps rigid bodies and plain spheres exactly in a plane z = const,
/// whatever integrates them:
/// after each half of the integrator it sets to zero (bitwise) whatever has left the plane, and
/// forces out of the plane before they are added up over the bodies.
class FixEnforce2DMultisphere : public Fix {
 public:
  FixEnforce2DMultisphere(LAMMPS* lmp, int narg, char** arg);

  int setmask();
  void init();
  void setup_pre_exchange();
  void setup(int);
  void pre_exchange();
  void initial_integrate(int);
  void pre_final_integrate();
  void final_integrate();

 private:
  void flatten_positions();
  void flatten_velocities();
  void flatten_forces();
  void flatten_body_forces();
  void check_flat() const;

  double plane_;                           // z, m
  Multisphere* bodies_;                    // NULL if there is no fix multisphere
  VectorContainer<double, 4>* reference_;  // per body: orientation of angle 0, 0 if not known yet
};

}  // namespace LAMMPS_NS

#endif
#endif

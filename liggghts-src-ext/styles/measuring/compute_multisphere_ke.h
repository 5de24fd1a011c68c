// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(multisphere/ke,ComputeMultisphereKe)
// clang-format on
#else
#ifndef LMP_COMPUTE_MULTISPHERE_KE_H
#define LMP_COMPUTE_MULTISPHERE_KE_H

#include "compute.h"

namespace LAMMPS_NS {

/// Kinetic energy of all particles, bodies and plain spheres, J: scalar total; vector
/// (translational, rotational).
class ComputeMultisphereKe : public Compute {
 public:
  ComputeMultisphereKe(class LAMMPS* lmp, int& iarg, int narg, char** arg);
  ~ComputeMultisphereKe();
  void init() {}
  double compute_scalar();
  void compute_vector();
};

}  // namespace LAMMPS_NS

#endif
#endif

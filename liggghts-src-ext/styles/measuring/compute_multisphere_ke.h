// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(multisphere/ke,ComputeMultisphereKe)
// clang-format on
#else
#ifndef LMP_COMPUTE_MULTISPHERE_KE_H
#define LMP_COMPUTE_MULTISPHERE_KE_H

#include "vector_compute.h"

namespace LAMMPS_NS {

/// compute multisphere/ke: the kinetic energy of all particles, bodies and plain spheres, J. Its
/// vector holds the translational and the rotational energy, its scalar the total.
class ComputeMultisphereKe : public VectorCompute {
 public:
  ComputeMultisphereKe(class LAMMPS* lmp, int& iarg, int narg, char** arg);

 protected:
  void evaluate();
  double scalar_of_vector() const { return vector[0] + vector[1]; }
};

}  // namespace LAMMPS_NS

#endif
#endif

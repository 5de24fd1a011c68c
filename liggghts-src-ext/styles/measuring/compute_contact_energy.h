// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(contact/energy,ComputeContactEnergy)
// clang-format on
#else
#ifndef LMP_COMPUTE_CONTACT_ENERGY_H
#define LMP_COMPUTE_CONTACT_ENERGY_H

#include "contact_recorder.h"
#include "vector_compute.h"

namespace LAMMPS_NS {

/// Elastic energy of all contacts, J: scalar sum k_n delta^2 / 2 + k_t s^2 / 2; vector (normal,
/// tangential).
class ComputeContactEnergy : public VectorCompute {
 public:
  ComputeContactEnergy(class LAMMPS* lmp, int& iarg, int narg, char** arg);
  void init();

 protected:
  void evaluate();
  double scalar_of_vector() const { return vector[0] + vector[1]; }

 private:
  ContactRecorder recorder_;
};

}  // namespace LAMMPS_NS

#endif
#endif

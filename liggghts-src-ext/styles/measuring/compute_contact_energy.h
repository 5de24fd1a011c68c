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

/// compute contact/energy: the elastic energy of all contacts, J. Its vector holds the sums of
/// k_n delta^2 / 2 and of k_t s^2 / 2 over the contacts, its scalar the total.
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

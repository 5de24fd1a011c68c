// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(contact/overlap,ComputeContactOverlap)
// clang-format on
#else
#ifndef LMP_COMPUTE_CONTACT_OVERLAP_H
#define LMP_COMPUTE_CONTACT_OVERLAP_H

#include "contact_recorder.h"
#include "vector_compute.h"

namespace LAMMPS_NS {

/// compute contact/overlap: counts particles that lie too deep in each other. Its scalar is the
/// number of pairs of particles with an overlap above the given length in at least one of their
/// contacts; its vector holds that number, the largest overlap of all contacts in m, and the number
/// of contacts, walls included in the last two.
class ComputeContactOverlap : public VectorCompute {
 public:
  ComputeContactOverlap(class LAMMPS* lmp, int& iarg, int narg, char** arg);
  void init();

 protected:
  void evaluate();
  double scalar_of_vector() const { return vector[0]; }

 private:
  ContactRecorder recorder_;
  double limit_;  // m
};

}  // namespace LAMMPS_NS

#endif
#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_VECTOR_COMPUTE_H
#define RODPACK_VECTOR_COMPUTE_H

#include "compute.h"

namespace LAMMPS_NS {

/// Base of our computes of a few global numbers: a vector, and a scalar that follows from it.
class VectorCompute : public Compute {
 public:
  /// The scalar and vector of a compute; `extensive` tells whether they grow with the system.
  VectorCompute(class LAMMPS* lmp, int& iarg, int narg, char** arg, int values, bool extensive);
  ~VectorCompute();
  void init() {}
  double compute_scalar();
  void compute_vector();

 protected:
  /// Sets `vector` for this step, on all ranks; collective.
  virtual void evaluate() = 0;
  /// The scalar, once `vector` is set.
  virtual double scalar_of_vector() const = 0;
};

}  // namespace LAMMPS_NS

#endif

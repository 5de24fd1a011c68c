// SPDX-License-Identifier: GPL-2.0-or-later
#include "vector_compute.h"

#include "update.h"

namespace LAMMPS_NS {

VectorCompute::VectorCompute(LAMMPS* lmp, int& iarg, int narg, char** arg, int values,
                             bool extensive)
    : Compute(lmp, iarg, narg, arg) {
  scalar_flag = vector_flag = 1;
  extscalar = extvector = extensive;
  size_vector = values;
  vector = new double[values];
}

VectorCompute::~VectorCompute() { delete[] vector; }

double VectorCompute::compute_scalar() {
  invoked_scalar = update->ntimestep;
  compute_vector();
  scalar = scalar_of_vector();
  return scalar;
}

void VectorCompute::compute_vector() {
  invoked_vector = update->ntimestep;
  evaluate();
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_contact_energy.h"

#include <mpi.h>
#include "style_arguments.h"
#include "update.h"

namespace LAMMPS_NS {

ComputeContactEnergy::ComputeContactEnergy(LAMMPS* lmp, int& iarg, int narg, char** arg)
    : Compute(lmp, iarg, narg, arg), recorder_(lmp) {
  const StyleArguments arguments(lmp, narg, arg, iarg, "Compute", StyleArguments::Wording::is);
  arguments.require_end();
  arguments.require_group_all("counts all contacts");
  scalar_flag = vector_flag = 1;
  extscalar = extvector = 1;
  size_vector = 2;
  vector = new double[size_vector];
}

ComputeContactEnergy::~ComputeContactEnergy() { delete[] vector; }

void ComputeContactEnergy::init() { recorder_.check_models(std::string("compute ") + style); }

double ComputeContactEnergy::compute_scalar() {
  invoked_scalar = update->ntimestep;
  compute_vector();
  scalar = vector[0] + vector[1];
  return scalar;
}

void ComputeContactEnergy::compute_vector() {
  invoked_vector = update->ntimestep;
  double own[2] = {0.0, 0.0};
  for (const ContactRecord& contact : recorder_.collect(std::string("compute ") + style)) {
    if (!contact.primary) continue;
    own[0] += 0.5 * contact.kn * contact.overlap * contact.overlap;
    own[1] += 0.5 * contact.kt * contact.spring * contact.spring;
  }
  MPI_Allreduce(own, vector, 2, MPI_DOUBLE, MPI_SUM, world);
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_contact_energy.h"

#include <mpi.h>
#include "rodpack/contact/power_law.h"
#include "style_arguments.h"

namespace LAMMPS_NS {

ComputeContactEnergy::ComputeContactEnergy(LAMMPS* lmp, int& iarg, int narg, char** arg)
    : VectorCompute(lmp, iarg, narg, arg, 2, true),
      recorder_(lmp, std::string("compute ") + style,
                [this](bigint step) { return matchstep(step) != 0; }) {
  timeflag = 1;
  const StyleArguments arguments(lmp, narg, arg, iarg, "Compute");
  arguments.require_end();
  arguments.require_group_all("counts all contacts");
}

void ComputeContactEnergy::init() {
  recorder_.check_models();
  recorder_.check_potentials();
}

void ComputeContactEnergy::evaluate() {
  double own[2] = {0.0, 0.0};
  for (const ContactRecord& contact : recorder_.collect()) {
    if (!contact.primary) continue;
    own[0] += rodpack::elastic_energy(contact.kn, contact.overlap, contact.exponent);
    own[1] += rodpack::elastic_energy(contact.kt, contact.spring, 1.0);
  }
  MPI_Allreduce(own, vector, 2, MPI_DOUBLE, MPI_SUM, world);
}

}  // namespace LAMMPS_NS

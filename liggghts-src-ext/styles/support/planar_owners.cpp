// SPDX-License-Identifier: GPL-2.0-or-later
#include "planar_owners.h"

#include "atom.h"
#include "atom_property.h"
#include "comm.h"
#include "fix_multisphere.h"
#include "fix_property_atom.h"
#include "lammps.h"
#include "modify.h"

namespace LAMMPS_NS {

namespace {

const char* const name = "planar_owners";

}  // namespace

void PlanarOwners::create_property(LAMMPS* lmp, const char* caller) {
  if (lmp->comm->nprocs > 1) add_atom_property(lmp->modify, name, 2, "no", "yes", "yes", caller);
}

void PlanarOwners::connect() {
  if (comm->nprocs > 1)
    ranks_ = static_cast<FixPropertyAtom*>(modify->find_fix_property(
        name, "property/atom", "vector", 2, 0, "run_style verlet/planar"));
}

void PlanarOwners::renew(FixMultisphere& bodies) {
  if (comm->nprocs == 1) return;
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    const int tag = bodies.belongs_to(i);
    const bool own_body = tag >= 0 && bodies.data().map(tag) >= 0;
    double* const ranks = ranks_->array_atom[i];
    ranks[0] = own_body ? comm->me + 1.0 : 0.0;
    ranks[1] = i < atom->nlocal ? comm->me : 0.0;
  }
  ranks_->do_reverse_comm();  // a sum, to which the owner of the body alone has added
  ranks_->do_forward_comm();
}

int PlanarOwners::of_atom(int i) const {
  return comm->nprocs == 1 ? 0 : static_cast<int>(ranks_->array_atom[i][1]);
}

int PlanarOwners::of_body(int i) const {
  return comm->nprocs == 1 ? 0 : static_cast<int>(ranks_->array_atom[i][0]) - 1;
}

}  // namespace LAMMPS_NS

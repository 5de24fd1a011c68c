// SPDX-License-Identifier: GPL-2.0-or-later
#include "particle_identity.h"

#include <mpi.h>
#include "atom.h"
#include "comm.h"
#include "fix_multisphere.h"
#include "modify.h"

namespace LAMMPS_NS {

ParticleIdentity::ParticleIdentity(LAMMPS* lmp) : Pointers(lmp), largest_body_id_(0) {
  bodies_ = static_cast<FixMultisphere*>(modify->find_fix_style("multisphere", 0));
  if (bodies_ && bodies_->n_body_all() > 0) largest_body_id_ = bodies_->tag_max_body();
}

int ParticleIdentity::body_of(int atom_index) const {
  return bodies_ ? bodies_->belongs_to(atom_index) : -1;
}

int ParticleIdentity::id_of(int atom_index) const {
  const int body = body_of(atom_index);
  return body >= 0 ? body : largest_body_id_ + atom->tag[atom_index];
}

std::vector<std::array<double, 3>> ParticleIdentity::all_body_centres() const {
  std::vector<std::array<double, 3>> centres(largest_body_id_ + 1, {{0.0, 0.0, 0.0}});
  if (!bodies_) return centres;
  for (int k = 0; k < bodies_->n_body(); ++k)
    bodies_->data().xcm(centres[bodies_->data().tag(k)].data(), k);
  // Each body is owned by one rank; the others contribute zeros.
  MPI_Allreduce(MPI_IN_PLACE, centres[0].data(), 3 * (largest_body_id_ + 1), MPI_DOUBLE, MPI_SUM,
                world);
  return centres;
}

}  // namespace LAMMPS_NS

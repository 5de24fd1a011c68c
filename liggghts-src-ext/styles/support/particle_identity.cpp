// SPDX-License-Identifier: GPL-2.0-or-later
#include "particle_identity.h"

#include <mpi.h>
#include <algorithm>
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "modify.h"
#include "multisphere_fix.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

ParticleIdentity::ParticleIdentity(LAMMPS* lmp) : Pointers(lmp), largest_body_id_(0) {
  bodies_ = multisphere_fix(modify);
  if (bodies_ && bodies_->n_body_all() > 0) largest_body_id_ = bodies_->tag_max_body();
}

int ParticleIdentity::body_of(int atom_index) const {
  return bodies_ ? bodies_->belongs_to(atom_index) : -1;
}

int ParticleIdentity::id_of(int atom_index) const {
  const int body = body_of(atom_index);
  return body >= 0 ? body : largest_body_id_ + atom->tag[atom_index];
}

std::vector<rodpack::Vector> ParticleIdentity::all_body_centres() const {
  std::vector<rodpack::Vector> centres(largest_body_id_ + 1, {{0.0, 0.0, 0.0}});
  if (!bodies_) return centres;
  for (int k = 0; k < bodies_->n_body(); ++k)
    bodies_->data().xcm(centres[bodies_->data().tag(k)].data(), k);
  // Each body is owned by one rank; the others contribute zeros.
  MPI_Allreduce(MPI_IN_PLACE, centres[0].data(), 3 * (largest_body_id_ + 1), MPI_DOUBLE, MPI_SUM,
                world);
  return centres;
}

int ParticleIdentity::largest_id() const {
  int largest = largest_body_id_;
  for (int i = 0; i < atom->nlocal; ++i) largest = std::max(largest, id_of(i));
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_INT, MPI_MAX, world);
  return largest;
}

rodpack::Vector ParticleIdentity::centre_near(int sphere,
                                              const std::vector<rodpack::Vector>& centres) const {
  const double* const x = atom->x[sphere];
  const int body = body_of(sphere);
  rodpack::Vector centre{{x[0], x[1], x[2]}};
  if (body < 0) return centre;
  double branch[3];
  vectorSubtract3D(centres[body].data(), x, branch);
  domain->minimum_image(branch);
  for (int d = 0; d < 3; ++d) centre[d] += branch[d];
  return centre;
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_multisphere_ke.h"

#include <mpi.h>
#include <string>
#include "atom.h"
#include "multisphere_fix.h"
#include "particle_identity.h"
#include "style_arguments.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

ComputeMultisphereKe::ComputeMultisphereKe(LAMMPS* lmp, int& iarg, int narg, char** arg)
    : VectorCompute(lmp, iarg, narg, arg, 2, true) {
  const StyleArguments arguments(lmp, narg, arg, iarg, "Compute");
  arguments.require_end();
  arguments.require_group_all("counts whole bodies");
  if (!atom->sphere_flag) arguments.fail("requires atom style sphere");
}

void ComputeMultisphereKe::evaluate() {
  const ParticleIdentity particles(lmp);
  double own[2] = {0.0, 0.0};

  if (particles.bodies() && particles.bodies()->n_body() > 0) {
    Multisphere& data = particles.bodies()->data();
    double** const inertia = data.extract_double_vector("inertia");
    double** const axes[3] = {data.extract_double_vector("ex_space"),
                              data.extract_double_vector("ey_space"),
                              data.extract_double_vector("ez_space")};
    const ScalarContainer<int>* const prescribed = prescribed_motions(data);
    for (int k = 0; k < data.n_body(); ++k) {
      if (prescribed && (*prescribed)(k) != 0) continue;  // its mass has no meaning
      double velocity[3], omega[3];
      data.vcm(velocity, k);
      data.omega(omega, k);
      own[0] += 0.5 * data.mass(k) * vectorMag3DSquared(velocity);
      for (int d = 0; d < 3; ++d) {
        const double about_axis = vectorDot3D(omega, axes[d][k]);
        own[1] += 0.5 * inertia[k][d] * about_axis * about_axis;
      }
    }
  }

  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0) continue;
    const double mass = atom->rmass[i];
    const double radius = atom->radius[i];
    own[0] += 0.5 * mass * vectorMag3DSquared(atom->v[i]);
    own[1] += 0.5 * (0.4 * mass * radius * radius) * vectorMag3DSquared(atom->omega[i]);
  }
  MPI_Allreduce(own, vector, 2, MPI_DOUBLE, MPI_SUM, world);
}

}  // namespace LAMMPS_NS

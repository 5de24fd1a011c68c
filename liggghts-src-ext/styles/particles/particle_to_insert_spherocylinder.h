// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PARTICLE_TO_INSERT_SPHEROCYLINDER_H
#define RODPACK_PARTICLE_TO_INSERT_SPHEROCYLINDER_H

#include "particleToInsert_multisphere.h"
#include "spherocylinder_options.h"

namespace LAMMPS_NS {

/// A spherocylinder on its way into the simulation. LIGGGHTS's fix insert/* draw an orientation
/// from all of space; a planar particle keeps of it the turn about z (uniform again), is put at z =
/// 0 and gets no velocity out of the plane.
class ParticleToInsertSpherocylinder : public ParticleToInsertMultisphere {
 public:
  ParticleToInsertSpherocylinder(LAMMPS* lmp, int nspheres, bool planar);

  /// Sets what the body will remember of its chain.
  void set_chain(const Spherocylinder& particle);

  int insert();
  int check_near_set_x_v_omega(double* x, double* v, double* omega, double* quat,
                               RegionNeighborList<interpolate_no>& near);
  int set_x_v_omega(double* x, double* v, double* omega, double* quat);

 private:
  bool planar_;
  double half_length_ = 0, radius_ = 0, curvature_ = 0, area_ = 0;
};

}  // namespace LAMMPS_NS

#endif

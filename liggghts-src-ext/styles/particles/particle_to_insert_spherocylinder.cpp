// SPDX-License-Identifier: GPL-2.0-or-later
#include "particle_to_insert_spherocylinder.h"

#include <cmath>

#include "modify.h"
#include "multisphere_fix.h"
#include "rod_properties.h"

namespace LAMMPS_NS {

namespace {

/// A pose and motion with all that leaves the plane taken out.
struct PlanarPose {
  double x[3], v[3], omega[3], quat[4];

  PlanarPose(const double* x_, const double* v_, const double* omega_, const double* q)
      : x{x_[0], x_[1], 0.}, v{v_[0], v_[1], 0.}, omega{0., 0., omega_[2]}, quat{1., 0., 0., 0.} {
    const double norm = std::hypot(q[0], q[3]);
    if (norm == 0) return;  // half a turn about an axis in the plane: has no turn about z
    quat[0] = q[0] / norm;
    quat[3] = q[3] / norm;
  }
};

}  // namespace

ParticleToInsertSpherocylinder::ParticleToInsertSpherocylinder(LAMMPS* lmp, int nspheres,
                                                               bool planar)
    : ParticleToInsertMultisphere(lmp, nspheres), planar_(planar) {}

void ParticleToInsertSpherocylinder::set_chain(const Spherocylinder& particle) {
  const bool is_sphere = particle.centres.size() == 1;
  radius_ = 0.5 * particle.shape.diameter;
  half_length_ = is_sphere ? radius_ : 0.5 * rodpack::axial_length(particle.shape);
  curvature_ = particle.shape.curvature_angle;
  area_ = particle.area;
}

int ParticleToInsertSpherocylinder::insert() {
  const int inserted = ParticleToInsertMultisphere::insert();
  FixMultisphere* const fix = multisphere_fix(modify);
  const RodProperties rods = rod_properties(fix->data());
  const int body = fix->data().n_body() - 1;
  rods.half_length->set(body, half_length_);
  rods.radius->set(body, radius_);
  rods.curvature->set(body, curvature_);
  rods.area->set(body, area_);
  return inserted;
}

int ParticleToInsertSpherocylinder::check_near_set_x_v_omega(
    double* x, double* v, double* omega, double* quat, RegionNeighborList<interpolate_no>& near) {
  if (!planar_)
    return ParticleToInsertMultisphere::check_near_set_x_v_omega(x, v, omega, quat, near);
  PlanarPose pose(x, v, omega, quat);
  const int placed = ParticleToInsertMultisphere::check_near_set_x_v_omega(
      pose.x, pose.v, pose.omega, pose.quat, near);
  if (placed) vectorConstruct3D(ez_space, 0., 0., 1.);  // the rotated one ends in cos^2 + sin^2
  return placed;
}

int ParticleToInsertSpherocylinder::set_x_v_omega(double* x, double* v, double* omega,
                                                  double* quat) {
  if (!planar_) return ParticleToInsertMultisphere::set_x_v_omega(x, v, omega, quat);
  PlanarPose pose(x, v, omega, quat);
  ParticleToInsertMultisphere::set_x_v_omega(pose.x, pose.v, pose.omega, pose.quat);
  vectorConstruct3D(ez_space, 0., 0., 1.);
  return nparticles;
}

}  // namespace LAMMPS_NS

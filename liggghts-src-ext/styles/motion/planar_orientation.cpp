// SPDX-License-Identifier: GPL-2.0-or-later
#include "planar_orientation.h"

#include <cmath>

#include "math_extra.h"

namespace LAMMPS_NS {

namespace {

// An axis within 0.01 rad of z is taken for z: the squared sine of half that angle.
const double snap = 0.005 * 0.005;

// A component of a unit vector below this is a rounding error.
const double rounding = 1e-12;

/// The part of q that turns about z, as (w, z) of a unit quaternion.
void turn_about_z(const double* q, double& w, double& z) {
  const double squared = q[0] * q[0] + q[3] * q[3];
  if (squared == 0) {
    w = 1.;
    z = 0.;
  } else if (std::abs(squared - 1.) < 4e-16) {  // normal already: stay the same bit by bit
    w = q[0];
    z = q[3];
  } else {
    const double norm = std::sqrt(squared);
    w = q[0] / norm;
    z = q[3] / norm;
  }
}

}  // namespace

void planar_reference(const double* quat, double* reference) {
  reference[0] = 1.;
  reference[1] = reference[2] = reference[3] = 0.;
  if (quat[1] * quat[1] + quat[2] * quat[2] < snap) return;
  double back[4] = {0., 0., 0., 0.};
  turn_about_z(quat, back[0], back[3]);
  back[3] = -back[3];
  MathExtra::quatquat(back, const_cast<double*>(quat), reference);
}

void flatten_orientation(const double* reference, double* quat, double* ex, double* ey,
                         double* ez) {
  double flat[4] = {0., 0., 0., 0.};
  if (reference[0] == 1.) {
    turn_about_z(quat, flat[0], flat[3]);
  } else {
    double inverse[4] = {reference[0], -reference[1], -reference[2], -reference[3]};
    double twist[4], turn[4] = {0., 0., 0., 0.};
    MathExtra::quatquat(quat, inverse, twist);
    turn_about_z(twist, turn[0], turn[3]);
    MathExtra::quatquat(turn, const_cast<double*>(reference), flat);
  }

  // The z components are those of the reference orientation, which a turn about z leaves alone.
  double rx[3], ry[3], rz[3];
  MathExtra::q_to_exyz(const_cast<double*>(reference), rx, ry, rz);
  double normal[3] = {rx[2], ry[2], rz[2]};
  for (double& component : normal) {
    if (std::abs(component) < rounding) component = 0.;
    if (1. - std::abs(component) <= rounding) component = component > 0 ? 1. : -1.;
  }

  // What is flat already stays the same bit by bit: the spheres were set from it, and a run that
  // goes on from a restart file sets them again.
  double* axes[3] = {ex, ey, ez};
  bool is_flat = true;
  for (int d = 0; d < 4; ++d) is_flat = is_flat && std::abs(flat[d] - quat[d]) < 1e-14;
  for (int k = 0; k < 3; ++k) is_flat = is_flat && axes[k][2] == normal[k];
  if (is_flat) return;

  for (int d = 0; d < 4; ++d) quat[d] = flat[d];
  MathExtra::q_to_exyz(quat, ex, ey, ez);

  for (int k = 0; k < 3; ++k) {
    axes[k][2] = normal[k];
    if (std::abs(normal[k]) == 1.) axes[k][0] = axes[k][1] = 0.;
  }
}

}  // namespace LAMMPS_NS

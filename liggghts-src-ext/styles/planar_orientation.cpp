// SPDX-License-Identifier: GPL-2.0-or-later
#include "planar_orientation.h"

#include <cmath>

#include "math_extra.h"

namespace LAMMPS_NS {

namespace {

// squared sine of half the angle between z and an axis within 0.01 rad of it
const double snap = 0.005 * 0.005;

// below this a component of a unit vector is rounding error
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
  const bool upright = reference[0] == 1.;
  if (upright) {
    turn_about_z(quat, quat[0], quat[3]);
    quat[1] = quat[2] = 0.;
  } else {
    double inverse[4] = {reference[0], -reference[1], -reference[2], -reference[3]};
    double twist[4], turn[4] = {0., 0., 0., 0.};
    MathExtra::quatquat(quat, inverse, twist);
    turn_about_z(twist, turn[0], turn[3]);
    MathExtra::quatquat(turn, const_cast<double*>(reference), quat);
  }
  MathExtra::q_to_exyz(quat, ex, ey, ez);

  // z components: those of the reference orientation, which a turn about z leaves alone
  double rx[3], ry[3], rz[3];
  MathExtra::q_to_exyz(const_cast<double*>(reference), rx, ry, rz);
  double* axes[3] = {ex, ey, ez};
  const double normal[3] = {rx[2], ry[2], rz[2]};
  for (int k = 0; k < 3; ++k) {
    axes[k][2] = std::abs(normal[k]) < rounding ? 0. : normal[k];
    if (1. - std::abs(normal[k]) > rounding) continue;
    axes[k][0] = axes[k][1] = 0.;
    axes[k][2] = normal[k] > 0 ? 1. : -1.;
  }
}

}  // namespace LAMMPS_NS

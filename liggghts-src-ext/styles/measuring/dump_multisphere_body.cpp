// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_multisphere_body.h"

#include <cmath>
#include "atom.h"
#include "body_chains.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "math_const.h"
#include "particle_identity.h"
#include "sort_buffer.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

using MathConst::MY_2PI;
using MathConst::MY_PI;

namespace {

/// Direction of a vector in the x-y plane, rad in [0, 2 pi).
double planar_angle(const double* axis) {
  const double angle = std::atan2(axis[1], axis[0]);
  if (angle > 0.0) return angle;
  const double positive = angle + MY_2PI;
  // The sum is 2 pi itself where the angle is zero or too small to change it.
  return positive < MY_2PI ? positive : 0.0;
}

}  // namespace

DumpMultisphereBody::DumpMultisphereBody(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg) {
  if (igroup != 0) stop("lists whole bodies: the group has to be 'all'");
  if (!atom->sphere_flag) stop("requires atom style sphere");
  set_columns("ATOMS",
              {{"id", true},      {"type", true},         {"nspheres", true}, {"x", false},
               {"y", false},      {"z", false},           {"angle", false},   {"vx", false},
               {"vy", false},     {"vz", false},          {"omegax", false},  {"omegay", false},
               {"omegaz", false}, {"qw", false},          {"qx", false},      {"qy", false},
               {"qz", false},     {"half_length", false}, {"radius", false},  {"curvature", false},
               {"area", false},   {"mass", false}});
  sortBuffer = new SortBuffer(lmp, true);
}

void DumpMultisphereBody::list_rows() {
  const ParticleIdentity particles(lmp);

  if (particles.bodies() && particles.bodies()->n_body() > 0) {
    Multisphere& data = particles.bodies()->data();
    const std::vector<BodyChain> chains = body_chains(lmp, particles);
    double** const axis = data.extract_double_vector("ex_space");
    auto& type = *data.prop().getElementProperty<ScalarContainer<int>>("clumptype");
    for (int k = 0; k < data.n_body(); ++k) {
      double x[3], v[3], omega[3], q[4];
      data.xcm(x, k);
      domain->remap(x);
      data.vcm(v, k);
      data.omega(omega, k);
      data.quat(q, k);
      const BodyChain& chain = chains[k];
      ids_.push_back(data.tag(k));
      const double row[] = {static_cast<double>(data.tag(k)),
                            static_cast<double>(type(k)),
                            static_cast<double>(data.nrigid(k)),
                            x[0],
                            x[1],
                            x[2],
                            planar_angle(axis[k]),
                            v[0],
                            v[1],
                            v[2],
                            omega[0],
                            omega[1],
                            omega[2],
                            q[0],
                            q[1],
                            q[2],
                            q[3],
                            chain.half_length,
                            chain.radius,
                            chain.curvature,
                            chain.area,
                            data.mass(k)};
      rows_.insert(rows_.end(), row, row + 22);
    }
  }

  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0) continue;
    double x[3];
    vectorCopy3D(atom->x[i], x);
    domain->remap(x);
    const double* const v = atom->v[i];
    const double* const omega = atom->omega[i];
    const double r = atom->radius[i];
    ids_.push_back(particles.id_of(i));
    const double row[] = {static_cast<double>(particles.id_of(i)),
                          static_cast<double>(atom->type[i]),
                          1.0,
                          x[0],
                          x[1],
                          x[2],
                          0.0,
                          v[0],
                          v[1],
                          v[2],
                          omega[0],
                          omega[1],
                          omega[2],
                          1.0,
                          0.0,
                          0.0,
                          0.0,
                          r,
                          r,
                          0.0,
                          MY_PI * r * r,
                          atom->rmass[i]};
    rows_.insert(rows_.end(), row, row + 22);
  }
}

}  // namespace LAMMPS_NS

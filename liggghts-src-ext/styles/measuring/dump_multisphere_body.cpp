// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_multisphere_body.h"

#include <algorithm>
#include <cmath>
#include "atom.h"
#include "body_chains.h"
#include "body_frames.h"
#include "domain.h"
#include "fix_multisphere.h"
#include "gather.h"
#include "math_const.h"
#include "particle_identity.h"
#include "sort_buffer.h"
#include "style_arguments.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

using MathConst::MY_2PI;
using MathConst::MY_PI;

namespace {

/// Direction of a vector in the x-y plane, rad in [0, 2 pi).
double planar_angle(const std::array<double, 3>& axis) {
  const double angle = std::atan2(axis[1], axis[0]);
  if (angle > 0.0) return angle;
  const double positive = angle + MY_2PI;
  // The sum is 2 pi itself where the angle is zero or too small to change it.
  return positive < MY_2PI ? positive : 0.0;
}

}  // namespace

DumpMultisphereBody::DumpMultisphereBody(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg) {
  if (!atom->sphere_flag)
    StyleArguments(lmp, narg, arg, 5, "Dump").fail("requires atom style sphere");
  set_columns("ATOMS", rodpack::body_dump::columns, rodpack::body_dump::id);
  sortBuffer = new SortBuffer(lmp, true);
}

void DumpMultisphereBody::list_rows() {
  const ParticleIdentity particles(lmp);
  list_bodies(particles);
  list_plain_spheres(particles);
}

/// Ids of the bodies with spheres in the group, on all ranks: a body and its spheres may have
/// different ones; collective.
std::set<int> DumpMultisphereBody::bodies_of_group(const ParticleIdentity& particles) const {
  std::vector<int> own;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) own.push_back(particles.body_of(i));
  const std::vector<int> all = gather_on_all(world, own);
  return {all.begin(), all.end()};
}

void DumpMultisphereBody::list_bodies(const ParticleIdentity& particles) {
  if (!particles.bodies()) return;
  const std::set<int> listed = bodies_of_group(particles);
  if (particles.bodies()->n_body() == 0) return;
  Multisphere& data = particles.bodies()->data();
  const std::vector<BodyChain> chains = body_chains(lmp, particles);
  const std::vector<BodyFrame> frames = body_frames(lmp, particles);
  auto& type = *data.prop().getElementProperty<ScalarContainer<int>>("clumptype");
  for (int k = 0; k < data.n_body(); ++k) {
    if (listed.count(data.tag(k)) == 0) continue;
    rodpack::body_dump::BodyRow row;
    row.id = data.tag(k);
    row.type = type(k);
    row.nspheres = data.nrigid(k);
    data.xcm(row.centre, k);
    domain->remap(row.centre);
    row.angle = planar_angle(frames[k].axis);
    data.vcm(row.velocity, k);
    data.omega(row.angular_velocity, k);
    std::copy(frames[k].quaternion.begin(), frames[k].quaternion.end(), row.quaternion);
    row.half_length = chains[k].half_length;
    row.radius = chains[k].radius;
    row.curvature = chains[k].curvature;
    row.area = chains[k].area;
    row.mass = data.mass(k);
    add_row(row);
  }
}

void DumpMultisphereBody::list_plain_spheres(const ParticleIdentity& particles) {
  for (int i = 0; i < atom->nlocal; ++i) {
    if (particles.body_of(i) >= 0 || !(atom->mask[i] & groupbit)) continue;
    const double radius = atom->radius[i];
    rodpack::body_dump::BodyRow row = {};
    row.id = particles.id_of(i);
    row.type = atom->type[i];
    row.nspheres = 1.0;
    vectorCopy3D(atom->x[i], row.centre);
    domain->remap(row.centre);
    vectorCopy3D(atom->v[i], row.velocity);
    vectorCopy3D(atom->omega[i], row.angular_velocity);
    row.quaternion[0] = 1.0;
    row.half_length = row.radius = radius;
    row.area = MY_PI * radius * radius;
    row.mass = atom->rmass[i];
    add_row(row);
  }
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_multisphere_sphere.h"

#include <array>
#include "atom.h"
#include "domain.h"
#include "particle_identity.h"
#include "sort_buffer.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

DumpMultisphereSphere::DumpMultisphereSphere(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg), recorder_(lmp, std::string("dump ") + style) {
  set_columns("ATOMS", rodpack::sphere_dump::columns, rodpack::sphere_dump::id);
  sortBuffer = new SortBuffer(lmp, true);
}

void DumpMultisphereSphere::init_style() {
  recorder_.check_models();
  TableDump::init_style();
}

void DumpMultisphereSphere::list_rows() {
  const ParticleIdentity particles(lmp);

  // Each rank has every contact of its own spheres in its list, so nothing needs to be sent.
  std::vector<std::array<double, 4>> forces(atom->nlocal, {{0.0, 0.0, 0.0, 0.0}});
  for (const ContactRecord& contact : recorder_.collect()) {
    const double magnitude = vectorMag3D(contact.force);
    const auto add = [&](int sphere, double sign) {
      for (int d = 0; d < 3; ++d) forces[sphere][d] += sign * contact.force[d];
      forces[sphere][3] += magnitude;
    };
    add(contact.i, 1.0);
    if (contact.j >= 0 && contact.j < atom->nlocal) add(contact.j, -1.0);
  }

  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    rodpack::sphere_dump::SphereRow row;
    row.id = atom->tag[i];
    row.body = particles.id_of(i);
    row.type = atom->type[i];
    vectorCopy3D(atom->x[i], row.centre);
    domain->remap(row.centre);
    row.radius = atom->radius[i];
    vectorCopy3D(forces[i].data(), row.force);
    row.force_sum = forces[i][3];
    add_row(row);
  }
}

}  // namespace LAMMPS_NS

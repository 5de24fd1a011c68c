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
    : TableDump(lmp, narg, arg), recorder_(lmp) {
  set_columns("ATOMS", {{"id", true},
                        {"body", true},
                        {"type", true},
                        {"x", false},
                        {"y", false},
                        {"z", false},
                        {"radius", false},
                        {"fx", false},
                        {"fy", false},
                        {"fz", false},
                        {"fsum", false}});
  sortBuffer = new SortBuffer(lmp, true);
}

void DumpMultisphereSphere::init_style() {
  recorder_.check_models(std::string("dump ") + style);
  TableDump::init_style();
}

void DumpMultisphereSphere::list_rows() {
  const ParticleIdentity particles(lmp);

  // Each rank has every contact of its own spheres in its list, so nothing needs to be sent.
  std::vector<std::array<double, 4>> forces(atom->nlocal, {{0.0, 0.0, 0.0, 0.0}});
  for (const ContactRecord& contact : recorder_.collect(std::string("dump ") + style)) {
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
    double x[3];
    vectorCopy3D(atom->x[i], x);
    domain->remap(x);
    ids_.push_back(atom->tag[i]);
    const double row[] = {static_cast<double>(atom->tag[i]),
                          static_cast<double>(particles.id_of(i)),
                          static_cast<double>(atom->type[i]),
                          x[0],
                          x[1],
                          x[2],
                          atom->radius[i],
                          forces[i][0],
                          forces[i][1],
                          forces[i][2],
                          forces[i][3]};
    rows_.insert(rows_.end(), row, row + 11);
  }
}

}  // namespace LAMMPS_NS

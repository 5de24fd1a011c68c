// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_contact_gran.h"

#include "atom.h"
#include "particle_identity.h"
#include "style_arguments.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

DumpContactGran::DumpContactGran(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg), recorder_(lmp, std::string("dump ") + style) {
  StyleArguments(lmp, narg, arg, 5, "Dump").require_group_all("lists all contacts");
  set_columns("ENTRIES", rodpack::contact_dump::columns);
}

void DumpContactGran::init_style() {
  recorder_.check_models();
  TableDump::init_style();
}

void DumpContactGran::list_rows() {
  const ParticleIdentity particles(lmp);
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();

  for (const ContactRecord& contact : recorder_.collect()) {
    if (!contact.primary) continue;
    const bool wall = contact.j < 0;
    const rodpack::SphereContact ends = contact_of(contact, particles, centres);

    rodpack::contact_dump::ContactRow row;
    row.body_i = static_cast<double>(ends.i);
    row.body_j = static_cast<double>(ends.j);
    row.sphere_i = atom->tag[contact.i];
    row.sphere_j = wall ? 0.0 : atom->tag[contact.j];
    row.wall = wall ? 1.0 : 0.0;
    vectorCopy3D(ends.point.data(), row.point);
    vectorCopy3D(ends.force.data(), row.force);
    vectorCopy3D(ends.centre_i.data(), row.centre_i);
    vectorCopy3D(ends.centre_j.data(), row.centre_j);
    row.overlap = contact.overlap;
    row.spring = contact.spring;
    vectorCopy3D(contact.normal, row.normal);
    add_row(atom->tag[contact.i], row);
  }
}

}  // namespace LAMMPS_NS

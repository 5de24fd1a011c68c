// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_contact_gran.h"

#include <utility>
#include "atom.h"
#include "particle_identity.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

namespace {

/// The contact as its other sphere sees it.
ContactRecord turned(ContactRecord contact) {
  std::swap(contact.i, contact.j);
  std::swap(contact.type_i, contact.type_j);
  vectorNegate3D(contact.normal);
  vectorNegate3D(contact.force);
  return contact;
}

}  // namespace

DumpContactGran::DumpContactGran(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg), recorder_(lmp, std::string("dump ") + style) {
  set_columns("ENTRIES", rodpack::contact_dump::columns, rodpack::contact_dump::sphere_i);
}

void DumpContactGran::init_style() {
  recorder_.check_models();
  TableDump::init_style();
}

void DumpContactGran::list_rows() {
  const ParticleIdentity particles(lmp);
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();
  const auto listed = [this](int sphere) {
    return sphere >= 0 && (atom->mask[sphere] & groupbit) != 0;
  };

  for (ContactRecord contact : recorder_.collect()) {
    if (!contact.primary || (!listed(contact.i) && !listed(contact.j))) continue;
    if (!listed(contact.i)) contact = turned(contact);
    // What is not in the group is a wall to those that are.
    if (!listed(contact.j)) contact.j = -1;
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
    row.type_i = contact.type_i;
    row.type_j = contact.type_j;
    add_row(row);
  }
}

}  // namespace LAMMPS_NS

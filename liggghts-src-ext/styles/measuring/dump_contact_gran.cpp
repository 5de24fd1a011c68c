// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_contact_gran.h"

#include "atom.h"
#include "particle_identity.h"

namespace LAMMPS_NS {

DumpContactGran::DumpContactGran(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg), recorder_(lmp) {
  if (igroup != 0) stop("lists all contacts: the group has to be 'all'");
  set_columns("ENTRIES",
              {{"body_i", true}, {"body_j", true},     {"sphere_i", true},   {"sphere_j", true},
               {"wall", true},   {"x", false},         {"y", false},         {"z", false},
               {"fx", false},    {"fy", false},        {"fz", false},        {"bix", false},
               {"biy", false},   {"biz", false},       {"bjx", false},       {"bjy", false},
               {"bjz", false},   {"overlap_n", false}, {"overlap_t", false}, {"nx", false},
               {"ny", false},    {"nz", false}});
}

void DumpContactGran::init_style() {
  recorder_.check_models(std::string("dump ") + style);
  TableDump::init_style();
}

void DumpContactGran::list_rows() {
  const ParticleIdentity particles(lmp);
  const std::vector<rodpack::Vector> centres = particles.all_body_centres();

  for (const ContactRecord& contact : recorder_.collect(std::string("dump ") + style)) {
    if (!contact.primary) continue;
    const bool wall = contact.j < 0;
    const rodpack::Contact ends = particles.contact_of(contact, centres);

    ids_.push_back(atom->tag[contact.i]);
    const double labels[] = {static_cast<double>(ends.i), static_cast<double>(ends.j),
                             static_cast<double>(atom->tag[contact.i]),
                             wall ? 0.0 : static_cast<double>(atom->tag[contact.j]),
                             wall ? 1.0 : 0.0};
    rows_.insert(rows_.end(), labels, labels + 5);
    for (const rodpack::Vector& vector : {ends.point, ends.force, ends.centre_i, ends.centre_j})
      rows_.insert(rows_.end(), vector.begin(), vector.end());
    rows_.push_back(contact.overlap);
    rows_.push_back(contact.spring);
    rows_.insert(rows_.end(), contact.normal, contact.normal + 3);
  }
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "dump_contact_gran.h"

#include "atom.h"
#include "domain.h"
#include "particle_identity.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

DumpContactGran::DumpContactGran(LAMMPS* lmp, int narg, char** arg)
    : TableDump(lmp, narg, arg), recorder_(lmp) {
  if (igroup != 0) stop("lists all contacts: the group has to be 'all'");
  set_columns("ENTRIES", {{"body_i", true},
                          {"body_j", true},
                          {"sphere_i", true},
                          {"sphere_j", true},
                          {"wall", true},
                          {"x", false},
                          {"y", false},
                          {"z", false},
                          {"fx", false},
                          {"fy", false},
                          {"fz", false},
                          {"bix", false},
                          {"biy", false},
                          {"biz", false},
                          {"bjx", false},
                          {"bjy", false},
                          {"bjz", false},
                          {"overlap_n", false},
                          {"overlap_t", false}});
}

void DumpContactGran::init_style() {
  recorder_.check_models(std::string("dump ") + style);
  TableDump::init_style();
}

void DumpContactGran::list_rows() {
  const ParticleIdentity particles(lmp);
  const std::vector<std::array<double, 3>> centres = particles.all_body_centres();

  // Centre of mass of the particle that a sphere belongs to, in the periodic image of that sphere.
  const auto centre_near = [&](int sphere, double* centre) {
    const double* const x = atom->x[sphere];
    const int body = particles.body_of(sphere);
    if (body < 0) {
      vectorCopy3D(x, centre);
      return;
    }
    double branch[3];
    vectorSubtract3D(centres[body].data(), x, branch);
    domain->minimum_image(branch);
    vectorAdd3D(x, branch, centre);
  };

  for (const ContactRecord& contact : recorder_.collect(std::string("dump ") + style)) {
    if (!contact.primary) continue;
    const bool wall = contact.j < 0;
    double centre_i[3], centre_j[3];
    centre_near(contact.i, centre_i);
    if (wall)
      vectorCopy3D(contact.point, centre_j);
    else
      centre_near(contact.j, centre_j);

    ids_.push_back(atom->tag[contact.i]);
    const double labels[] = {static_cast<double>(particles.id_of(contact.i)),
                             wall ? 0.0 : static_cast<double>(particles.id_of(contact.j)),
                             static_cast<double>(atom->tag[contact.i]),
                             wall ? 0.0 : static_cast<double>(atom->tag[contact.j]),
                             wall ? 1.0 : 0.0};
    rows_.insert(rows_.end(), labels, labels + 5);
    for (const double* vector : {contact.point, contact.force, static_cast<const double*>(centre_i),
                                 static_cast<const double*>(centre_j)})
      rows_.insert(rows_.end(), vector, vector + 3);
    rows_.push_back(contact.overlap);
    rows_.push_back(contact.spring);
  }
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_counts.h"

#include "atom.h"
#include "atom_property.h"
#include "comm.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "pair_gran.h"
#include "stop_run.h"

namespace LAMMPS_NS {

ContactCounts* ContactCounts::active_ = NULL;

void ContactCounts::create_property(const char* caller) {
  counts_ = add_atom_property(modify, "contact_counts", 1, "no", "yes", "no", caller);
}

void ContactCounts::check_models(const std::string& who) const {
  const auto refuse = [&](const std::string& whose) {
    stop_run(lmp, who + " needs 'model spring_dashpot', which counts contacts; " + whose +
                      " has another model");
  };
  PairGran* const pair = dynamic_cast<PairGran*>(force->pair_match("gran", 0));
  if (!pair || !pair->contact_match("normal", "spring_dashpot")) refuse("the pair style");
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k) {
    auto* const wall = static_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k));
    if (!wall->contact_match("normal", "spring_dashpot"))
      refuse(std::string("fix wall/gran (id ") + wall->id + ")");
  }
}

void ContactCounts::begin() {
  counts_->just_created = 0;  // or set-up would undo them after the pairs were counted
  for (int i = 0; i < atom->nlocal; ++i) counts_->vector_atom[i] = 0.0;
}

/// Each rank counts for its own spheres: the owner of a ghost sees this contact too.
void ContactCounts::add(const Contact& contact) {
  if (!counts_) return;
  if (contact.i < atom->nlocal) counts_->vector_atom[contact.i] += 1.0;
  if (!contact.is_wall && contact.j < atom->nlocal) counts_->vector_atom[contact.j] += 1.0;
}

void ContactCounts::complete() { counts_->do_forward_comm(); }

double ContactCounts::of(int atom_index) const { return counts_->vector_atom[atom_index]; }

}  // namespace LAMMPS_NS

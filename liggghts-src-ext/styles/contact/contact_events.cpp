// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_events.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "atom.h"
#include "atom_property.h"
#include "comm.h"
#include "fix_multisphere.h"
#include "fix_property_atom.h"
#include "force.h"
#include "modify.h"
#include "pair_gran.h"
#include "update.h"
#include "vector_liggghts.h"
#ifdef RODPACK_STAGED
#include "contact_ends.h"
#endif

namespace LAMMPS_NS {

using rodpack::ContactJump;
using rodpack::ForceChange;
using rodpack::SpatialJump;

namespace {

constexpr int force_values = sizeof(ForceChange) / sizeof(double) + 1;  // and how many jumped
constexpr int torque_values = sizeof(ForceChange) / sizeof(double);

}  // namespace

ContactEvents* ContactEvents::armed_ = NULL;

void ContactEvents::ask_for_ends() {
#ifdef RODPACK_STAGED
  rodpack::ends_are_told() = true;
#endif
}

void ContactEvents::create_properties(const char* caller) {
  const auto add = [&](const char* name, int values, const char* restart) {
    return add_atom_property(modify, name, values, restart, "yes", "yes", caller);
  };
  force_changes_ = add("contact_events_force", force_values, "no");
  torque_changes_ = add("contact_events_torque", torque_values, "no");
  last_jump_ = add("contact_events_motion", jump_values, "yes");
  jump_before_ = add("contact_events_before", jump_values, "yes");
}

void ContactEvents::init() {
  if (last_step_ < 0 || last_step_ == update->ntimestep) return;
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    stored(last_jump_, i) = StampedJump();
    stored(jump_before_, i) = StampedJump();
  }
}

void ContactEvents::arm() {
  armed_ = this;
  const PairGran* const pair = dynamic_cast<PairGran*>(force->pair_match("gran", 0));
  frozen_groups_ = pair ? pair->freeze_group_bit() : 0;
  last_step_ = update->ntimestep;
  follows_jump_ = pending_;
  pending_ = false;
}

void ContactEvents::disarm() {
  if (armed_ == this) armed_ = NULL;
}

ContactEvents::SphereChanges ContactEvents::changes(int i) const {
  const double* const force = force_changes_->array_atom[i];
  const double* const torque = torque_changes_->array_atom[i];
  return {
      {*reinterpret_cast<const ForceChange*>(force), *reinterpret_cast<const ForceChange*>(torque)},
      force[force_values - 1]};
}

ContactEvents::StampedJump& ContactEvents::stored(FixPropertyAtom* property, int i) {
  static_assert(offsetof(StampedJump, jump) == 0 &&
                    offsetof(StampedJump, step) == sizeof(SpatialJump) &&
                    sizeof(StampedJump) == 19 * sizeof(double),
                "jumps are stored, in restart files too, as plain doubles");
  return *reinterpret_cast<StampedJump*>(property->array_atom[i]);
}

const ContactEvents::StampedJump& ContactEvents::stored(const FixPropertyAtom* property,
                                                        int i) const {
  return *reinterpret_cast<const StampedJump*>(property->array_atom[i]);
}

void ContactEvents::add(const Contact& contact, const ForceChange& on_i, bool jumps) {
  if (bodies_->belongs_to(contact.i) < 0) return;
  if (!contact.is_wall && bodies_->belongs_to(contact.j) < 0) return;
  local_jump_ = local_jump_ || jumps;
  if (is_changed_.size() < static_cast<size_t>(atom->nmax)) is_changed_.resize(atom->nmax, 0);
  ForceChange shared = on_i;
  if (contact.is_wall) shared *= contact.area_ratio;
  rodpack::share_change(
      contact, shared,
      [&](int side, const ForceChange& force, const double(&lever)[3], const double(&rate)[3]) {
        const int sphere = side > 0 ? contact.i : contact.j;
        if (sphere >= atom->nlocal) return;  // its owner sees this contact too
        double* const sum = force_changes_->array_atom[sphere];
        *reinterpret_cast<ForceChange*>(sum) += force;
        *reinterpret_cast<ForceChange*>(torque_changes_->array_atom[sphere]) +=
            rodpack::torque_change(lever, rate, force);
        sum[force_values - 1] += jumps;
        if (is_changed_[sphere]) return;
        is_changed_[sphere] = 1;
        changed_.push_back(sphere);
      });
}

const SpatialJump* ContactEvents::last_jump(int i) const {
  const double now = static_cast<double>(update->ntimestep);
  for (const FixPropertyAtom* property : {last_jump_, jump_before_})
    if (stored(property, i).step == now) return &stored(property, i).jump;
  return NULL;
}

const SpatialJump* ContactEvents::jump_for_next_step(int i) const {
  const StampedJump& last = stored(last_jump_, i);
  return last.step == static_cast<double>(update->ntimestep + 1) ? &last.jump : NULL;
}

bool ContactEvents::find_jump(const Contact& contact, ContactJump& jump) const {
  const SpatialJump* of_i = last_jump(contact.i);
  const SpatialJump* of_j = contact.is_wall ? NULL : last_jump(contact.j);
  if (!of_i && !of_j) return false;
  jump = ContactJump();
  if (of_i) rodpack::add_jump(contact, 1.0, *of_i, jump);
  if (of_j) rodpack::add_jump(contact, -1.0, *of_j, jump);
  return true;
}

ContactEvents::Contact ContactEvents::as_if_in_contact(const ClosePair& pair) const {
  Contact contact;
  static_cast<ClosePair&>(contact) = pair;
  contact.r = std::sqrt(pair.rsq);
  contact.mi = contact.meff = atom->rmass[pair.i];  // each sphere carries the mass of its body
  contact.omega_i = atom->omega[pair.i];
  if (!pair.is_wall) {
    contact.mj = atom->rmass[pair.j];
    contact.meff = rodpack::effective_mass(contact.mi, contact.mj);
    // As PairGran has it: what is frozen, or moved as prescribed, is infinitely heavy.
    if (atom->mask[pair.i] & frozen_groups_) contact.meff = contact.mj;
    if (atom->mask[pair.j] & frozen_groups_) contact.meff = contact.mi;
    contact.omega_j = atom->omega[pair.j];
  }
  rodpack::complete_contact(contact);
  return contact;
}

bool ContactEvents::collect() {
  int state = local_jump_ ? 2 : changed_.empty() ? 0 : 1;
  if (comm->nprocs > 1) {
    const int mine = state;
    MPI_Allreduce(&mine, &state, 1, MPI_INT, MPI_MAX, world);
  }
  any_jumped_ = state == 2;
  local_jump_ = false;
  if (state == 0) return false;

  // Sums are made in the order of the atoms, whatever that of the contacts.
  std::sort(changed_.begin(), changed_.end());
  if (comm->nprocs > 1) {
    force_changes_->do_forward_comm();
    torque_changes_->do_forward_comm();
    for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; ++i) {
      const double* values = force_changes_->array_atom[i];
      if (std::any_of(values, values + force_values, [](double value) { return value != 0.0; }))
        changed_.push_back(i);
    }
  }
  return true;
}

void ContactEvents::clear() {
  for (int i : changed_) {
    std::fill_n(force_changes_->array_atom[i], force_values, 0.0);
    std::fill_n(torque_changes_->array_atom[i], torque_values, 0.0);
    if (i < atom->nlocal) is_changed_[i] = 0;
  }
  changed_.clear();
}

void ContactEvents::begin_publishing() {
  if (comm->nprocs == 1) return;  // the step in each entry says which ones count
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    StampedJump& last = stored(last_jump_, i);
    stored(jump_before_, i) = i < atom->nlocal ? last : StampedJump();
    last = StampedJump();
  }
}

void ContactEvents::publish(int i, const SpatialJump& jump) {
  StampedJump& last = stored(last_jump_, i);
  if (comm->nprocs == 1) stored(jump_before_, i) = last;
  last.jump = jump;
  last.step = static_cast<double>(update->ntimestep + 1);
}

void ContactEvents::end_publishing() {
  pending_ = true;
  if (comm->nprocs == 1) return;
  // A body belongs to one rank, which has set its spheres wherever they are owned.
  last_jump_->do_reverse_comm();
  renew_ghosts();
}

void ContactEvents::renew_ghosts() {
  if (!follows_jump_ && !pending_) return;
  last_jump_->do_forward_comm();
  jump_before_->do_forward_comm();
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_events.h"

#include <algorithm>
#include <cmath>

#include "atom.h"
#include "atom_property.h"
#include "comm.h"
#include "fix_multisphere.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "update.h"
#include "vector_liggghts.h"

namespace LAMMPS_NS {

using rodpack::ForceChange;

namespace {

constexpr int force_values = 13, torque_values = 12, motion_values = 19;
static_assert(sizeof(ForceChange) == 12 * sizeof(double) &&
                  sizeof(ContactEvents::RigidMotion) == motion_values * sizeof(double),
              "plain doubles, stored per atom");

}  // namespace

ContactEvents* ContactEvents::armed_ = NULL;

void ContactEvents::create_properties(const char* caller) {
  const auto add = [&](const char* name, int values, const char* restart) {
    return add_atom_property(modify, name, values, restart, "yes", "yes", caller);
  };
  force_changes_ = add("contact_events_force", force_values, "no");
  torque_changes_ = add("contact_events_torque", torque_values, "no");
  last_motion_ = add("contact_events_motion", motion_values, "yes");
  motion_before_ = add("contact_events_before", motion_values, "yes");
}

void ContactEvents::init() {
  if (last_step_ < 0 || last_step_ == update->ntimestep) return;
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    motion(last_motion_, i) = RigidMotion();
    motion(motion_before_, i) = RigidMotion();
  }
}

void ContactEvents::arm() {
  armed_ = this;
  last_step_ = update->ntimestep;
  follows_jump_ = pending_;
  pending_ = false;
}

void ContactEvents::disarm() {
  if (armed_ == this) armed_ = NULL;
}

ContactEvents::Changes ContactEvents::changes(int i) const {
  const double* force = force_changes_->array_atom[i];
  return {*reinterpret_cast<const ForceChange*>(force),
          *reinterpret_cast<const ForceChange*>(torque_changes_->array_atom[i]), force[12]};
}

ContactEvents::RigidMotion& ContactEvents::motion(FixPropertyAtom* property, int i) const {
  return *reinterpret_cast<RigidMotion*>(property->array_atom[i]);
}

void ContactEvents::add(const Contact& contact, const double (&now)[3], const double (&rate)[3],
                        double since, bool jumps) {
  // A force that keeps its components in the frame of the contact turns with it.
  double turning[3];
  rodpack::rate_in_space(contact, now, rate, turning);
  add(contact, rodpack::linear_change(now, turning, since), jumps);
}

void ContactEvents::add(const Contact& contact, const ForceChange& on_i, bool jumps) {
  if (bodies_->belongs_to(contact.i) < 0) return;
  if (!contact.is_wall && bodies_->belongs_to(contact.j) < 0) return;
  local_jump_ = local_jump_ || jumps;
  if (is_changed_.size() < static_cast<size_t>(atom->nmax)) is_changed_.resize(atom->nmax, 0);
  double turn[3], lever[3], rate[3];
  rodpack::normal_turning_rate(contact, turn);
  const double share = contact.is_wall ? contact.area_ratio : 1.0;
  const auto add_to = [&](int atom_index, double sign, double length) {
    if (atom_index >= atom->nlocal) return;  // its owner sees this contact too
    ForceChange force = on_i;
    force *= sign * share;
    rodpack::contact_lever(contact, turn, length, -sign, lever, rate);
    double* const sum = force_changes_->array_atom[atom_index];
    *reinterpret_cast<ForceChange*>(sum) += force;
    *reinterpret_cast<ForceChange*>(torque_changes_->array_atom[atom_index]) +=
        rodpack::torque_change(lever, rate, force);
    sum[12] += jumps;
    if (is_changed_[atom_index]) return;
    is_changed_[atom_index] = 1;
    changed_.push_back(atom_index);
  };
  add_to(contact.i, 1.0, contact.cri);
  if (!contact.is_wall) add_to(contact.j, -1.0, contact.crj);
}

const ContactEvents::RigidMotion* ContactEvents::changed_motion(int i) const {
  const double now = static_cast<double>(update->ntimestep);
  for (FixPropertyAtom* property : {last_motion_, motion_before_})
    if (motion(property, i).step == now) return &motion(property, i);
  return NULL;
}

const ContactEvents::RigidMotion* ContactEvents::motion_for_next_step(int i) const {
  const RigidMotion& last = motion(last_motion_, i);
  return last.step == static_cast<double>(update->ntimestep + 1) ? &last : NULL;
}

bool ContactEvents::find_change(const Contact& contact, Motion& change) const {
  const RigidMotion* of_i = changed_motion(contact.i);
  const RigidMotion* of_j = contact.is_wall ? NULL : changed_motion(contact.j);
  if (!of_i && !of_j) return false;
  change = Motion();
  const auto add = [&](const RigidMotion& atom_motion, double sign, double length) {
    double lever[3], moved[3];
    for (int d = 0; d < 3; ++d) lever[d] = -sign * length * contact.en[d];
    const auto surface = [&](const double* centre, const double* turn, double* sum) {
      vectorCross3D(turn, lever, moved);
      for (int d = 0; d < 3; ++d) sum[d] += sign * (centre[d] + moved[d]);
    };
    surface(atom_motion.acceleration, atom_motion.angular_acceleration, change.acceleration);
    surface(atom_motion.velocity, atom_motion.angular_velocity, change.velocity);
    surface(atom_motion.displacement, atom_motion.rotation, change.displacement);
  };
  if (of_i) add(*of_i, 1.0, contact.cri);
  if (of_j) add(*of_j, -1.0, contact.crj);
  return true;
}

ContactEvents::Contact ContactEvents::as_if_in_contact(const ClosePair& pair) const {
  Contact contact;
  static_cast<ClosePair&>(contact) = pair;
  contact.r = std::sqrt(pair.rsq);
  contact.rinv = 1.0 / contact.r;
  contact.deltan = pair.radsum - contact.r;
  contact.mi = contact.meff = atom->rmass[pair.i];  // each sphere carries the mass of its body
  contact.omega_i = atom->omega[pair.i];
  contact.cri = pair.radi - 0.5 * contact.deltan;
  double roll[3], spin[3], relative[3];
  vectorSubtract3D(pair.v_i, pair.v_j, relative);
  for (int d = 0; d < 3; ++d) {
    contact.en[d] = pair.delta[d] * contact.rinv;
    spin[d] = contact.cri * contact.omega_i[d];
  }
  if (!pair.is_wall) {
    contact.mj = atom->rmass[pair.j];
    contact.meff = contact.mi * contact.mj / (contact.mi + contact.mj);
    contact.omega_j = atom->omega[pair.j];
    contact.crj = pair.radj - 0.5 * contact.deltan;
    for (int d = 0; d < 3; ++d) spin[d] += contact.crj * contact.omega_j[d];
  }
  contact.vn = vectorDot3D(relative, contact.en);
  vectorCross3D(spin, contact.en, roll);
  contact.vtr1 = relative[0] - contact.vn * contact.en[0] - roll[0];
  contact.vtr2 = relative[1] - contact.vn * contact.en[1] - roll[1];
  contact.vtr3 = relative[2] - contact.vn * contact.en[2] - roll[2];
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

  // in the order of the atoms, whatever that of the contacts
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
    RigidMotion& last = motion(last_motion_, i);
    motion(motion_before_, i) = i < atom->nlocal ? last : RigidMotion();
    last = RigidMotion();
  }
}

void ContactEvents::publish(int i, const RigidMotion& changed) {
  RigidMotion& last = motion(last_motion_, i);
  if (comm->nprocs == 1) motion(motion_before_, i) = last;
  last = changed;
  last.step = static_cast<double>(update->ntimestep + 1);
}

void ContactEvents::end_publishing() {
  pending_ = true;
  if (comm->nprocs == 1) return;
  // A body belongs to one rank, which has set its spheres wherever they are owned.
  last_motion_->do_reverse_comm();
  renew_ghosts();
}

void ContactEvents::renew_ghosts() {
  if (!follows_jump_ && !pending_) return;
  last_motion_->do_forward_comm();
  motion_before_->do_forward_comm();
}

}  // namespace LAMMPS_NS

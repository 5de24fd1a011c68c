// SPDX-License-Identifier: GPL-2.0-or-later
// Events of contacts: what the last step has missed is added to the state of the bodies, and the
// records of the past are made to continue the new branch of the forces.
#include <algorithm>
#include <cstddef>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_multisphere_ab.h"
#include "math_extra.h"
#include "rodpack/contact/event_correction.h"
#include "rodpack/motion/rigid_motion.h"
#include "update.h"

using namespace LAMMPS_NS;
using rodpack::BodyChange;
using rodpack::ForceChange;
using rodpack::SpatialJump;

namespace {

/// Leaves of a change what acts on the components that `on` switches on.
void mask(const bool* on, ForceChange& change) {
  for (int d = 0; d < 3; ++d)
    if (!on[d])
      change.now[d] = change.rate[d] = change.impulse[d] = change.impulse_integral[d] = 0.0;
}

}  // namespace

void FixMultisphereAB::apply_events() {
  events_->disarm();
  if (!events_->collect()) return;
  sum_changes();
  std::vector<SpatialJump> jumps;
  for (size_t k = 0; k < changed_bodies_.size(); ++k) {
    const int body = changed_bodies_[k];
    BodyChange& sum = changes_[k].sum;
    mask(fflag_(body), sum.force);
    mask(tflag_(body), sum.torque);
    sum.force *= 1.0 / inertia_factor(body);
    sum.torque *= 1.0 / inertia_factor(body);
    jumps.push_back(planar_ ? correct_planar(body, sum) : correct_spatial(body, sum));
  }
  if (events_->jumped()) publish(jumps);
  for (int body : changed_bodies_) place_[body] = -1;
  events_->clear();
}

/// Sums the changes of the spheres' forces over the bodies that this rank owns, as calc_force does
/// with the forces. Prescribed motions know no forces.
void FixMultisphereAB::sum_changes() {
  changed_bodies_.clear();
  changes_.clear();
  place_.resize(n_body(), -1);
  for (int i : events_->changed()) {
    const int body = map(body_[i]);
    if (body < 0 || is_prescribed(body) || !domain->is_owned_or_first_ghost(i)) continue;
    if (place_[body] < 0) {
      place_[body] = static_cast<int>(changed_bodies_.size());
      changed_bodies_.push_back(body);
      changes_.push_back(ContactEvents::SphereChanges());
    }
    double unwrapped[3], lever[3], rate[3];
    domain->unmap(atom->x[i], atom->image[i], unwrapped);
    for (int d = 0; d < 3; ++d) {
      lever[d] = unwrapped[d] - xcm_(body)[d];
      rate[d] = atom->v[i][d] - vcm_(body)[d];
    }
    if (i >= atom->nlocal) domain->minimum_image(lever[0], lever[1], lever[2]);
    const ContactEvents::SphereChanges change = events_->changes(i);
    ContactEvents::SphereChanges& of_body = changes_[place_[body]];
    of_body.sum.force += change.sum.force;
    of_body.sum.torque += change.sum.torque;
    of_body.sum.torque += rodpack::torque_change(lever, rate, change.sum.force);
    of_body.jumps += change.jumps;
  }
}

SpatialJump FixMultisphereAB::correct_planar(int body, const BodyChange& sum) {
  const rodpack::PlanarCorrection correction = {mass_(body), moment_about_z(body)};
  const rodpack::PlanarBodyChange in_plane = rodpack::in_plane(sum);
  const SpatialJump jump = rodpack::to_space(correction.missed(in_plane));
  keep_missed_motion(body, jump, sum.torque.impulse);
  if (evaluations_->get(body) == 0) return jump;  // no past yet
  for (int k = 1; k < order_; ++k)
    *planar_record(body, k) += correction.past(in_plane, k * update->dt);
  return jump;
}

SpatialJump FixMultisphereAB::correct_spatial(int body, const BodyChange& sum) {
  rodpack::SpatialCorrection correction;
  correction.mass = mass_(body);
  std::copy(inertia_(body), inertia_(body) + 3, correction.inertia);
  std::copy(quat_(body), quat_(body) + 4, correction.quaternion);
  const SpatialJump jump = correction.missed(sum);
  keep_missed_motion(body, jump, sum.torque.impulse);
  if (evaluations_->get(body) == 0) return jump;
  for (int k = 1; k < order_; ++k) {
    void* const record = (*past_spatial_[order_ - 1 - k])(body);
    *static_cast<rodpack::SpatialRates*>(record) += correction.past(sum, k * update->dt);
  }
  return jump;
}

FixMultisphereAB::MissedMotion& FixMultisphereAB::missed_motion(int body) const {
  static_assert(offsetof(MissedMotion, displacement) == 0 &&
                    offsetof(MissedMotion, rotation) == 24 &&
                    offsetof(MissedMotion, velocity) == 48 &&
                    offsetof(MissedMotion, angular_momentum) == 72 && sizeof(MissedMotion) == 96,
                "it is stored, in restart files too, as twelve plain doubles");
  return *reinterpret_cast<MissedMotion*>((*missed_motion_)(body));
}

/// `momentum`: the angular momentum that is missing.
void FixMultisphereAB::keep_missed_motion(int body, const SpatialJump& jump,
                                          const double* momentum) {
  MissedMotion& missed = missed_motion(body);
  std::copy_n(jump.displacement, 3, missed.displacement);
  std::copy_n(jump.rotation, 3, missed.rotation);
  std::copy_n(jump.velocity, 3, missed.velocity);
  std::copy_n(momentum, 3, missed.angular_momentum);
}

void FixMultisphereAB::move_planar(int body) {
  MissedMotion& missed = missed_motion(body);
  for (int d = 0; d < 2; ++d) {
    xcm_(body)[d] += missed.displacement[d];
    vcm_(body)[d] += missed.velocity[d];
  }
  omega_(body)[2] += missed.angular_momentum[2] / moment_about_z(body);
  if (missed.rotation[2] != 0.0) {
    double q[4];
    std::copy(quat_(body), quat_(body) + 4, q);
    rodpack::rotate_about_z(missed.rotation[2], q);
    std::copy(q, q + 4, quat_(body));
  }
  missed = MissedMotion();
}

void FixMultisphereAB::move_spatial(int body) {
  MissedMotion& missed = missed_motion(body);
  for (int d = 0; d < 3; ++d) {
    xcm_(body)[d] += missed.displacement[d];
    vcm_(body)[d] += missed.velocity[d];
    angmom_(body)[d] += missed.angular_momentum[d];
  }
  if (missed.rotation[0] != 0.0 || missed.rotation[1] != 0.0 || missed.rotation[2] != 0.0) {
    double q[4], gain[4];
    std::copy(quat_(body), quat_(body) + 4, q);
    rodpack::half_product(missed.rotation, q, gain);
    for (int d = 0; d < 4; ++d) q[d] += gain[d];
    rodpack::normalise(q);
    std::copy(q, q + 4, quat_(body));
  }
  missed = MissedMotion();
}

/// Tells the contacts of the changed bodies, for the next step, how the motion of each sphere has
/// changed.
void FixMultisphereAB::publish(const std::vector<SpatialJump>& jumps) {
  events_->begin_publishing();
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    if (body_[i] < 0) continue;
    const int body = map(body_[i]);
    if (body < 0 || place_[body] < 0 || !(changes_[place_[body]].jumps > 0.0)) continue;
    // Ghosts of several ranks get theirs by communication.
    if (comm->nprocs > 1 && !domain->is_owned_or_first_ghost(i)) continue;
    double arm[3];
    MathExtra::matvec(ex_(body), ey_(body), ez_(body), displace_[i], arm);
    events_->publish(i, rodpack::jump_at(jumps[place_[body]], arm));
  }
  events_->end_publishing();
}

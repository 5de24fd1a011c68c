// SPDX-License-Identifier: GPL-2.0-or-later
// Events of contacts: what the last step has missed is added to the state of the bodies, and the
// records of the past are made to continue the new branch of the forces.
#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_multisphere_ab.h"
#include "math_extra.h"
#include "rodpack/motion/rigid_motion.h"
#include "update.h"
#include "vector_liggghts.h"

using namespace LAMMPS_NS;
using rodpack::ForceChange;

namespace {

/// Leaves of a change what acts on the components that `on` switches on.
void mask(const bool* on, ForceChange& change) {
  for (int d = 0; d < 3; ++d)
    if (!on[d]) change.now[d] = change.rate[d] = change.impulse[d] = change.sweep[d] = 0.0;
}

}  // namespace

void FixMultisphereAB::apply_events() {
  events_->disarm();
  if (!events_->collect()) return;
  sum_changes();
  std::vector<BodyMotion> motions(changed_bodies_.size(), BodyMotion());
  for (size_t k = 0; k < changed_bodies_.size(); ++k) {
    const int body = changed_bodies_[k];
    mask(fflag_(body), changes_[k].force);
    mask(tflag_(body), changes_[k].torque);
    if (planar_)
      correct_planar(body, changes_[k], motions[k]);
    else
      correct_spatial(body, changes_[k], motions[k]);
  }
  if (events_->jumped()) publish(motions);
  for (int body : changed_bodies_) place_[body] = -1;
  events_->clear();
}

/// Sums the changes of the spheres' forces over the bodies that this rank owns, as calc_force does
/// with the forces.
void FixMultisphereAB::sum_changes() {
  changed_bodies_.clear();
  changes_.clear();
  place_.resize(n_body(), -1);
  for (int i : events_->changed()) {
    const int body = map(body_[i]);
    if (body < 0 || !domain->is_owned_or_first_ghost(i)) continue;
    if (place_[body] < 0) {
      place_[body] = static_cast<int>(changed_bodies_.size());
      changed_bodies_.push_back(body);
      changes_.push_back(ContactEvents::Changes());
    }
    double unwrapped[3], lever[3], rate[3];
    domain->unmap(atom->x[i], atom->image[i], unwrapped);
    for (int d = 0; d < 3; ++d) {
      lever[d] = unwrapped[d] - xcm_(body)[d];
      rate[d] = atom->v[i][d] - vcm_(body)[d];
    }
    if (i >= atom->nlocal) domain->minimum_image(lever[0], lever[1], lever[2]);
    const ContactEvents::Changes change = events_->changes(i);
    ContactEvents::Changes& sum = changes_[place_[body]];
    sum.force += change.force;
    sum.torque += change.torque;
    sum.jumps += change.jumps;
    sum.torque += rodpack::torque_change(lever, rate, change.force);
  }
}

void FixMultisphereAB::correct_planar(int body, const ContactEvents::Changes& sum,
                                      BodyMotion& change) {
  const double mass = mass_(body), moment = moment_about_z(body);
  for (int d = 0; d < 2; ++d) {
    change.acceleration[d] = sum.force.now[d] / mass;
    change.velocity[d] = sum.force.impulse[d] / mass;
    change.displacement[d] = sum.force.sweep[d] / mass;
  }
  change.angular_acceleration[2] = sum.torque.now[2] / moment;
  change.angular_velocity[2] = sum.torque.impulse[2] / moment;
  change.rotation[2] = sum.torque.sweep[2] / moment;
  keep_motion(body, sum, change);

  if (evaluations_->get(body) == 0) return;  // no past yet
  for (int k = 1; k < order_; ++k) {
    const double age = k * update->dt;
    rodpack::PlanarRates& rates = *planar_record(body, k);
    for (int d = 0; d < 2; ++d) {
      rates.velocity[d] += sum.force.past_momentum(d, age) / mass;
      rates.acceleration[d] += sum.force.past_force(d, age) / mass;
    }
    rates.angular_velocity += sum.torque.past_momentum(2, age) / moment;
    rates.angular_acceleration += sum.torque.past_force(2, age) / moment;
  }
}

void FixMultisphereAB::correct_spatial(int body, const ContactEvents::Changes& sum,
                                       BodyMotion& change) {
  const double mass = mass_(body);
  double inertia[3], q[4];
  std::copy(inertia_(body), inertia_(body) + 3, inertia);
  std::copy(quat_(body), quat_(body) + 4, q);
  for (int d = 0; d < 3; ++d) {
    change.acceleration[d] = sum.force.now[d] / mass;
    change.velocity[d] = sum.force.impulse[d] / mass;
    change.displacement[d] = sum.force.sweep[d] / mass;
  }
  rodpack::angular_velocity(q, sum.torque.now, inertia, change.angular_acceleration);
  rodpack::angular_velocity(q, sum.torque.impulse, inertia, change.angular_velocity);
  rodpack::angular_velocity(q, sum.torque.sweep, inertia, change.rotation);

  keep_motion(body, sum, change);

  if (evaluations_->get(body) == 0) return;
  for (int k = 1; k < order_; ++k) {
    const double age = k * update->dt;
    rodpack::SpatialRates& rates =
        *reinterpret_cast<rodpack::SpatialRates*>((*past_spatial_[order_ - 1 - k])(body));
    double momentum[3], turn[3], gain[4];
    for (int d = 0; d < 3; ++d) {
      rates.velocity[d] += sum.force.past_momentum(d, age) / mass;
      rates.acceleration[d] += sum.force.past_force(d, age) / mass;
      rates.torque[d] += sum.torque.past_force(d, age);
      momentum[d] = sum.torque.past_momentum(d, age);
    }
    rodpack::angular_velocity(q, momentum, inertia, turn);
    MathExtra::vecquat(turn, q, gain);  // in the space frame dq/dt = (0, turn) q / 2
    for (int d = 0; d < 4; ++d) rates.quaternion_rate[d] += 0.5 * gain[d];
  }
}

void FixMultisphereAB::keep_motion(int body, const ContactEvents::Changes& sum,
                                   const BodyMotion& change) {
  double* missed = (*missed_motion_)(body);
  std::copy(change.displacement, change.displacement + 3, missed);
  std::copy(change.rotation, change.rotation + 3, missed + 3);
  std::copy(change.velocity, change.velocity + 3, missed + 6);
  std::copy(sum.torque.impulse, sum.torque.impulse + 3, missed + 9);
}

void FixMultisphereAB::move_planar(int body) {
  double* missed = (*missed_motion_)(body);
  for (int d = 0; d < 2; ++d) {
    xcm_(body)[d] += missed[d];
    vcm_(body)[d] += missed[6 + d];
  }
  omega_(body)[2] += missed[11] / moment_about_z(body);
  if (missed[5] != 0.0) {
    double q[4];
    std::copy(quat_(body), quat_(body) + 4, q);
    rodpack::rotate_about_z(missed[5], q);
    std::copy(q, q + 4, quat_(body));
  }
  std::fill_n(missed, 12, 0.0);
}

void FixMultisphereAB::move_spatial(int body) {
  double* missed = (*missed_motion_)(body);
  for (int d = 0; d < 3; ++d) {
    xcm_(body)[d] += missed[d];
    vcm_(body)[d] += missed[6 + d];
    angmom_(body)[d] += missed[9 + d];
  }
  if (missed[3] != 0.0 || missed[4] != 0.0 || missed[5] != 0.0) {
    double q[4], gain[4];
    std::copy(quat_(body), quat_(body) + 4, q);
    MathExtra::vecquat(missed + 3, q, gain);
    for (int d = 0; d < 4; ++d) q[d] += 0.5 * gain[d];
    rodpack::normalise(q);
    std::copy(q, q + 4, quat_(body));
  }
  std::fill_n(missed, 12, 0.0);
}

/// Tells the contacts of the changed bodies, for the next step, how the motion of each sphere has
/// changed.
void FixMultisphereAB::publish(const std::vector<BodyMotion>& motions) {
  events_->begin_publishing();
  for (int i = 0; i < atom->nlocal + atom->nghost; ++i) {
    if (body_[i] < 0) continue;
    const int body = map(body_[i]);
    if (body < 0 || place_[body] < 0 || !(changes_[place_[body]].jumps > 0.0)) continue;
    // Ghosts of several ranks get theirs by communication.
    if (comm->nprocs > 1 && !domain->is_owned_or_first_ghost(i)) continue;
    const BodyMotion& of_body = motions[place_[body]];
    double arm[3];
    MathExtra::matvec(ex_(body), ey_(body), ez_(body), displace_[i], arm);
    BodyMotion motion = of_body;
    const auto at_sphere = [&](const double* centre, const double* turn, double* result) {
      vectorCross3D(turn, arm, result);
      for (int d = 0; d < 3; ++d) result[d] += centre[d];
    };
    at_sphere(of_body.acceleration, of_body.angular_acceleration, motion.acceleration);
    at_sphere(of_body.velocity, of_body.angular_velocity, motion.velocity);
    at_sphere(of_body.displacement, of_body.rotation, motion.displacement);
    events_->publish(i, motion);
  }
  events_->end_publishing();
}

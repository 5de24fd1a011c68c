// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_EVENT_CORRECTION_H
#define RODPACK_CONTACT_EVENT_CORRECTION_H

#include <cstddef>

#include "../geometry/vector3.h"
#include "../motion/rigid_motion.h"
#include "contact_motion.h"
#include "force_change.h"
#include "planar_jump.h"

namespace rodpack {

// What an event of a contact (force_change.h) does to its two bodies, and what these bodies then do
// to their other contacts. SI units; vectors in the space frame.

// ---- from the contact to its bodies

/// The change of a contact's force on i, `since` seconds ago, that is `now` (N) and grows by `rate`
/// (N/s) in a frame that turns with the contact.
template <class Contact>
inline ForceChange change_in_space(const Contact& contact, const double (&now)[3],
                                   const double (&rate)[3], double since) {
  double turning[3];
  rate_in_space(contact, now, rate, turning);
  return linear_change(now, turning, since);
}

/// The component of a change along a unit vector.
inline ChangeOf<1> component(const ForceChange& change, const double (&axis)[3]) {
  return {{dot(change.now, axis)},
          {dot(change.rate, axis)},
          {dot(change.impulse, axis)},
          {dot(change.impulse_integral, axis)}};
}

/// The change in space of a force on i whose component along `direction`, a unit vector that turns
/// with the contact, changes so.
template <class Contact>
inline ForceChange change_along(const Contact& contact, const ChangeOf<1>& change,
                                const double (&direction)[3]) {
  const double fixed[3] = {0.0, 0.0, 0.0};
  double turning[3];
  rate_in_space(contact, direction, fixed, turning);
  ForceChange result;
  for (int d = 0; d < 3; ++d) {
    // int (e - (t_now - t) e') D dt, and the integral of the impulse is int (t_now - t) D dt
    result.now[d] = change.now[0] * direction[d];
    result.rate[d] = change.rate[0] * direction[d] + change.now[0] * turning[d];
    result.impulse[d] = change.impulse[0] * direction[d] - change.impulse_integral[0] * turning[d];
    result.impulse_integral[d] = change.impulse_integral[0] * direction[d];
  }
  return result;
}

/// Gives both sides of a contact their part of the change of the force on i: calls add(side, force,
/// lever, lever_rate) with side 1 for i and -1 for j, the change of the force on that side, and the
/// lever from the centre of its sphere; all with as many components as `on_i`. A wall gets none.
template <class Contact, int components, class Add>
inline void share_change(const Contact& contact, const ChangeOf<components>& on_i, Add add) {
  double turn[components], lever[components], rate[components];
  normal_turning_rate(contact, turn);
  contact_lever(contact, turn, 1.0, lever, rate);
  add(1, on_i, lever, rate);
  if (contact.is_wall) return;
  ChangeOf<components> on_j = on_i;
  on_j *= -1.0;
  contact_lever(contact, turn, -1.0, lever, rate);
  add(-1, on_j, lever, rate);
}

/// The changes of the forces of all contacts of a body, summed up.
struct BodyChange {
  ForceChange force, torque;  // torque about the centre of mass
};

/// The same of a body in planar motion, of which the rest of them changes nothing.
struct PlanarBodyChange {
  PlanarForceChange force;
  PlanarTorqueChange torque;
};
inline PlanarBodyChange in_plane(const BodyChange& change) {
  return {in_plane(change.force), about_z(change.torque)};
}

// ---- what it does to a body

/// A PlanarJump in space: the changes of the motion of a point of the body, and of its rotation.
struct SpatialJump {
  double acceleration[3], velocity[3], displacement[3];
  double angular_acceleration[3], angular_velocity[3], rotation[3];
};
static_assert(offsetof(SpatialJump, acceleration) == 0 && offsetof(SpatialJump, velocity) == 24 &&
                  offsetof(SpatialJump, displacement) == 48 &&
                  offsetof(SpatialJump, angular_acceleration) == 72 &&
                  offsetof(SpatialJump, angular_velocity) == 96 &&
                  offsetof(SpatialJump, rotation) == 120 && sizeof(SpatialJump) == 144,
              "jumps are stored for each sphere, in restart files too, as plain doubles");

/// The correction of a body in planar motion.
struct PlanarCorrection {
  double mass, moment;  // kg; kg m^2 about z

  /// What the motion of the last step has missed: displacement and velocity are still to be added
  /// to those of the body, whose orientation is to be set.
  PlanarJump missed(const PlanarBodyChange& change) const {
    PlanarJump result = {};
    divide(
        change, [](const auto& c, int d) { return c.now[d]; }, result.acceleration);
    divide(
        change, [](const auto& c, int d) { return c.impulse[d]; }, result.velocity);
    divide(
        change, [](const auto& c, int d) { return c.impulse_integral[d]; }, result.displacement);
    return result;
  }

  /// What is to be added to the rates that were recorded `age` seconds ago, for the records to
  /// continue the new branch of the forces backwards.
  PlanarRates past(const PlanarBodyChange& change, double age) const {
    double velocity[3], acceleration[3];
    divide(
        change, [=](const auto& c, int d) { return c.past_momentum(d, age); }, velocity);
    divide(
        change, [=](const auto& c, int d) { return c.past_force(d, age); }, acceleration);
    return {{velocity[0], velocity[1]},
            velocity[2],
            {acceleration[0], acceleration[1]},
            acceleration[2]};
  }

 private:
  /// x, y and rotation: a moment of the force over the mass, and of the torque over the moment of
  /// inertia.
  template <class MomentOf>
  void divide(const PlanarBodyChange& change, MomentOf moment_of, double (&result)[3]) const {
    for (int d = 0; d < 2; ++d) result[d] = moment_of(change.force, d) / mass;
    result[2] = moment_of(change.torque, 0) / moment;
  }
};

/// The correction of a body that moves in space.
struct SpatialCorrection {
  double mass;           // kg
  double inertia[3];     // principal moments, kg m^2
  double quaternion[4];  // body to space

  SpatialJump missed(const BodyChange& change) const {
    SpatialJump result;
    for (int d = 0; d < 3; ++d) {
      result.acceleration[d] = change.force.now[d] / mass;
      result.velocity[d] = change.force.impulse[d] / mass;
      result.displacement[d] = change.force.impulse_integral[d] / mass;
    }
    angular_velocity(quaternion, change.torque.now, inertia, result.angular_acceleration);
    angular_velocity(quaternion, change.torque.impulse, inertia, result.angular_velocity);
    angular_velocity(quaternion, change.torque.impulse_integral, inertia, result.rotation);
    return result;
  }

  SpatialRates past(const BodyChange& change, double age) const {
    SpatialRates result;
    double momentum[3], turn[3];
    for (int d = 0; d < 3; ++d) {
      result.velocity[d] = change.force.past_momentum(d, age) / mass;
      result.acceleration[d] = change.force.past_force(d, age) / mass;
      result.torque[d] = change.torque.past_force(d, age);
      momentum[d] = change.torque.past_momentum(d, age);
    }
    angular_velocity(quaternion, momentum, inertia, turn);
    half_product(turn, quaternion, result.quaternion_rate);
    return result;
  }
};

// ---- from a body to its contacts, in the step after

/// By how much the motion of i's surface relative to j's, at a contact, has changed in the step
/// before because forces on their bodies jumped; as seen at the end of that step.
struct ContactJump {
  double acceleration[3], velocity[3], displacement[3];
};

/// The component along a unit vector.
inline JumpAlong<double> component(const ContactJump& jump, const double (&axis)[3]) {
  return {dot(jump.acceleration, axis), dot(jump.velocity, axis), dot(jump.displacement, axis)};
}

/// The jump of another point of the body, `arm` away.
inline SpatialJump jump_at(const SpatialJump& jump, const double (&arm)[3]) {
  SpatialJump result = jump;
  velocity_at(jump.acceleration, jump.angular_acceleration, arm, result.acceleration);
  velocity_at(jump.velocity, jump.angular_velocity, arm, result.velocity);
  velocity_at(jump.displacement, jump.rotation, arm, result.displacement);
  return result;
}

/// The jump of a body in planar motion as that of its centre of mass in space.
inline SpatialJump to_space(const PlanarJump& jump) {
  SpatialJump result = {};
  for (int d = 0; d < 2; ++d) {
    result.acceleration[d] = jump.acceleration[d];
    result.velocity[d] = jump.velocity[d];
    result.displacement[d] = jump.displacement[d];
  }
  result.angular_acceleration[2] = jump.acceleration[2];
  result.angular_velocity[2] = jump.velocity[2];
  result.rotation[2] = jump.displacement[2];
  return result;
}

/// The jump of a point of a body in planar motion, in the plane; the body's orientation is to be
/// set.
inline PlanarJump to_plane(const SpatialJump& jump) {
  PlanarJump result = {};
  for (int d = 0; d < 2; ++d) {
    result.acceleration[d] = jump.acceleration[d];
    result.velocity[d] = jump.velocity[d];
    result.displacement[d] = jump.displacement[d];
  }
  result.acceleration[2] = jump.angular_acceleration[2];
  result.velocity[2] = jump.angular_velocity[2];
  result.displacement[2] = jump.rotation[2];
  return result;
}

/// Adds what a jump of the sphere on a side of a contact (1: i, -1: j) does to the contact.
template <class Contact>
inline void add_jump(const Contact& contact, double side, const SpatialJump& of_sphere,
                     ContactJump& sum) {
  double lever[3];
  lever_of(contact, side, lever);
  const SpatialJump surface = jump_at(of_sphere, lever);
  for (int d = 0; d < 3; ++d) {
    sum.acceleration[d] += side * surface.acceleration[d];
    sum.velocity[d] += side * surface.velocity[d];
    sum.displacement[d] += side * surface.displacement[d];
  }
}

/// Adds what a jump of the body on a side does that is in planar motion, and in whose frame the
/// sphere's centre is at `offset`.
template <class Contact>
inline void add_jump(const Contact& contact, double side, const PlanarJump& of_body,
                     const double (&offset)[2], ContactJump& sum) {
  const double length = length_of_lever(contact, side);
  const Vector2<double> arm = turned<double>(of_body.cosine, of_body.sine, {offset[0], offset[1]});
  const Vector2<double> to_contact =
      lever_in_plane<double>(arm, side * length, {contact.en[0], contact.en[1]});
  const auto add = [&](const double(&of_centre)[3], double(&result)[3]) {
    const Vector2<double> surface =
        velocity_at<double>({of_centre[0], of_centre[1]}, of_centre[2], to_contact);
    result[0] += side * surface.x;
    result[1] += side * surface.y;
  };
  add(of_body.acceleration, sum.acceleration);
  add(of_body.velocity, sum.velocity);
  add(of_body.displacement, sum.displacement);
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_MOTION_H
#define RODPACK_CONTACT_CONTACT_MOTION_H

#include "../geometry/vector3.h"
#include "contact_law.h"

namespace rodpack {

// How a contact of two spheres, or of a sphere and a wall, moves. A `Contact` is anything with
// these members: en (unit normal from j to i), r, rinv, radi, radj,
// radsum, deltan (overlap), delta (from the centre of j, or its wall, to that of i), v_i, v_j (of
// the centres), omega_i, omega_j, cri, crj (from the centres to the contact point), vn (positive
// when separating), vtr1..3 (tangential velocity), is_wall, kn, kt, gamman, gammat (stiffness and
// dashpot of the contact). SI units.

/// Velocity in the plane of contact from that of the centres, `relative`, and the sum `spin` of the
/// angular velocities times the levers of both; returns the velocity along the normal `en`.
inline double tangential_velocity(const double (&relative)[3], const double (&spin)[3],
                                  const double (&en)[3], double (&tangential)[3]) {
  const double separation = dot(relative, en);
  double roll[3];
  cross(spin, en, roll);
  for (int d = 0; d < 3; ++d) tangential[d] = relative[d] - separation * en[d] - roll[d];
  return separation;
}

/// Completes a contact of which radii, delta, r and the motion of both sides are set (of a wall:
/// its velocity), by what follows from them. The overlap may be negative.
template <class Contact>
inline void complete_contact(Contact& contact) {
  contact.rinv = 1.0 / contact.r;
  contact.deltan = contact.radsum - contact.r;
  contact.cri = lever_length(contact.radi, contact.deltan);
  contact.crj = contact.is_wall ? 0.0 : lever_length(contact.radj, contact.deltan);
  double relative[3], spin[3], tangential[3];
  for (int d = 0; d < 3; ++d) {
    contact.en[d] = contact.delta[d] * contact.rinv;
    relative[d] = contact.v_i[d] - contact.v_j[d];
    spin[d] = contact.cri * contact.omega_i[d];
    if (!contact.is_wall) spin[d] += contact.crj * contact.omega_j[d];
  }
  contact.vn = tangential_velocity(relative, spin, contact.en, tangential);
  contact.vtr1 = tangential[0];
  contact.vtr2 = tangential[1];
  contact.vtr3 = tangential[2];
}

/// Whether a contact that is evaluated for the first time can have begun within the step `dt`; not
/// when it was made with an overlap, or handed on by a neighbouring triangle of a mesh.
template <class Contact>
inline bool touched_in_step(const Contact& contact, double dt) {
  return contact.vn < 0.0 && contact.deltan < -1.5 * dt * contact.vn;
}

// Of what follows, a vector of two components is the part in the plane of x and y.

/// Rate at which the normal of a contact turns, 1/s; that of a wall does not.
template <class Contact, int components>
inline void normal_turning_rate(const Contact& contact, double (&rate)[components]) {
  for (int d = 0; d < components; ++d)
    rate[d] = contact.is_wall ? 0.0
                              : turning_rate_component(contact.v_i[d] - contact.v_j[d], contact.vn,
                                                       contact.en[d], contact.rinv);
}

/// Distance from the centre of the sphere on a side to the contact: `side` is 1 for i, from which
/// the contact lies against the normal, and -1 for j.
template <class Contact>
inline double length_of_lever(const Contact& contact, double side) {
  return side > 0.0 ? contact.cri : contact.crj;
}

/// Lever from that centre to the contact.
template <class Contact, int components>
inline void lever_of(const Contact& contact, double side, double (&lever)[components]) {
  const double length = side * length_of_lever(contact, side);
  for (int d = 0; d < components; ++d) lever[d] = lever_component(0.0, length, contact.en[d]);
}

/// The same and its rate: the overlap changes its length, and the normal turns by `turn`.
template <class Contact, int components>
inline void contact_lever(const Contact& contact, const double (&turn)[components], double side,
                          double (&lever)[components], double (&rate)[components]) {
  const double length = length_of_lever(contact, side);
  lever_of(contact, side, lever);
  for (int d = 0; d < components; ++d)
    rate[d] = lever_rate_component(0.0, side, length, contact.vn, contact.en[d], turn[d]);
}

/// The rate, in space, of a force `now` that grows by `rate` in a frame that turns with the
/// contact.
template <class Contact>
inline void rate_in_space(const Contact& contact, const double (&now)[3], const double (&rate)[3],
                          double (&result)[3]) {
  double turn[3];
  normal_turning_rate(contact, turn);
  const double normal = dot(now, contact.en), inwards = dot(now, turn);
  for (int d = 0; d < 3; ++d) result[d] = rate[d] + normal * turn[d] - inwards * contact.en[d];
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_MOTION_H
#define RODPACK_CONTACT_CONTACT_MOTION_H

#include "../geometry/vector3.h"

namespace rodpack {

// How a contact of two spheres, or of a sphere and a wall, moves. A `Contact` is anything with the
// members of LIGGGHTS's SurfacesIntersectData: en (unit normal from j to i), r, rinv, radsum,
// deltan (overlap), v_i, v_j (of the centres), cri, crj (from the centres to the contact point), vn
// (positive when separating), vtr1..3 (tangential velocity), is_wall, kn, kt, gamman, gammat
// (stiffness and dashpot of the contact). SI units.

/// By how much the motion of i's surface relative to j's, at the contact, has changed in the step
/// before because forces jumped; as seen at the end of that step, SI.
struct MotionChange {
  double acceleration[3], velocity[3], displacement[3];
};

/// Whether a contact that is evaluated for the first time can have begun within the step `dt`; not
/// when it was made with an overlap, or handed on by a neighbouring triangle of a mesh.
template <class Contact>
inline bool touched_in_step(const Contact& contact, double dt) {
  return contact.vn < 0.0 && contact.deltan < -1.5 * dt * contact.vn;
}

/// Rate at which the normal of a contact turns, 1/s; that of a wall does not.
template <class Contact>
inline void normal_turning_rate(const Contact& contact, double (&rate)[3]) {
  for (int d = 0; d < 3; ++d)
    rate[d] = contact.is_wall
                  ? 0.0
                  : (contact.v_i[d] - contact.v_j[d] - contact.vn * contact.en[d]) * contact.rinv;
}

/// Lever from the centre of a sphere to the contact, `length` in direction `sign` of the normal,
/// and its rate: the overlap changes its length, and the normal turns by `turn`.
template <class Contact>
inline void contact_lever(const Contact& contact, const double (&turn)[3], double length,
                          double sign, double (&lever)[3], double (&rate)[3]) {
  for (int d = 0; d < 3; ++d) {
    lever[d] = sign * length * contact.en[d];
    rate[d] = sign * (0.5 * contact.vn * contact.en[d] + length * turn[d]);
  }
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

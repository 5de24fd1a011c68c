// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_NETWORK_H
#define RODPACK_CONTACT_CONTACT_NETWORK_H

#include <array>
#include <vector>

namespace rodpack {

/// A rigid body of a network, and how it may move.
struct NetworkBody {
  double mass;                  // kg
  double moments[3][3];         // inertia tensor about the centre of mass, space frame, kg m^2
  std::array<bool, 6> is_free;  // translation along x, y, z; rotation about x, y, z
};

/// A linear spring and dashpot between two bodies, or a body and a wall.
struct NetworkContact {
  int i, j;                         // indices of the bodies; j < 0: a wall
  double normal[3];                 // unit vector, of either sign
  double arm_i[3], arm_j[3];        // from the centre of mass to the contact point, m
  double stiffness_n, stiffness_t;  // along the normal and in the plane of contact, N/m
  double damping_n, damping_t;      // kg/s
  // Rolling friction: against relative rotation about any axis, N m and N m s.
  double stiffness_r, damping_r;
};

/// Stability of a network at its present geometry.
struct NetworkLimit {
  double timestep;   // s, up to which no motion grows; infinite without contacts
  double stiffness;  // bound of the largest eigenvalue of M^-1 K, the highest frequency^2, 1/s^2
  double damping;    // bound of that of M^-1 C, 1/s
  int stiffest;      // body that is held the stiffest, the first of equals; -1 without contacts
  int contacts;      // of this body
};

/// The limit for the integrator `order` (0..4, as in stability_limit.h), from below. Exact for a
/// body on walls whose stiffest motion is also its most damped one, and for two spheres that meet.
///
/// Eigenvalues are bounded by bodies: with g = (d, r x d) for a contact along d at the arm r,
///   k (g_i.x_i - g_j.x_j)^2 <= k ((1 + s) (g_i.x_i)^2 + (1 + 1/s) (g_j.x_j)^2) for any s > 0,
/// so the largest one of the network is at most that of the stiffest body whose contacts count
/// 1 + s times (at a wall once). It begins with s = m_i / m_j, which is exact for two bodies that
/// meet centrally; bodies held less stiffly than their partners then take over more of the contact,
/// and the best of a few such rounds counts: about 2 % above the highest frequency of a bed of
/// rods.
///
/// The corners of timestep_limit() are the starting point. That of the strongly damped motions is
/// too strict where the stiff contacts are not the slow ones (c / k); there the fast root stays
/// within the real axis' limit R / dt as long as the largest eigenvalue of M^-1 (C - K dt / R) is
/// at most R / dt, which is tried instead.
///
/// @throws std::invalid_argument for an index out of range, inertia of free motions that is not
/// positive definite, a stiffness that is not > 0 along the normal or negative elsewhere.
NetworkLimit network_limit(int order, const std::vector<NetworkBody>& bodies,
                           const std::vector<NetworkContact>& contacts);

}  // namespace rodpack

#endif

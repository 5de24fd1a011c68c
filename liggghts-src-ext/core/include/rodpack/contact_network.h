// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_NETWORK_H
#define RODPACK_CONTACT_NETWORK_H

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
};

/// Upper bounds of the largest eigenvalues of M^-1 K (the square of the highest frequency, 1/s^2)
/// and M^-1 C (1/s) of the whole network at its present geometry.
struct NetworkBounds {
  double stiffness, damping;
  int stiffest;  // body that is held the stiffest, the first of equals; -1 without contacts
  int contacts;  // of this body
};

/// Bounds by bodies: with g = (d, r x d) for a contact along d at the arm r, its energy is
/// k (g_i.x_i - g_j.x_j)^2 / 2 <= k ((1 + s) (g_i.x_i)^2 + (1 + 1/s) (g_j.x_j)^2) / 2 for any s >
/// 0, so the largest eigenvalue of the network is at most that of the stiffest body whose contacts
/// count (1 + s) times. It begins with s = m_i / m_j, which is exact for two bodies that meet
/// centrally and doubles the contacts of equal ones; bodies held less stiffly than their partners
/// then take over more of the contact, and the best of a few such rounds counts. A wall's contact
/// counts once. @throws std::invalid_argument for an index out of range and for inertia of free
/// motions that is not positive definite.
NetworkBounds bound_network(const std::vector<NetworkBody>& bodies,
                            const std::vector<NetworkContact>& contacts);

}  // namespace rodpack

#endif

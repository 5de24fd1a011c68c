// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_BODY_STIFFNESS_H
#define RODPACK_BODY_STIFFNESS_H

#include <array>

namespace rodpack {

/// Springs and dashpots that hold one rigid body, as forms of its translation and rotation
/// (x, y, z; rotation about them through the centre of mass): a contact with constant k along the
/// unit vector d at the arm r adds k g g^T, g = (d, r x d). Only sums: bodies whose contacts are
/// listed in several places are added up number by number.
struct BodyStiffness {
  static constexpr int size = 36;
  std::array<double, size> stiffness{};  // 6 x 6, symmetric
  std::array<double, size> damping{};

  /// Adds a contact: `normal` a unit vector of either sign, `arm` from the centre of mass to the
  /// contact point (m), stiffnesses (N/m) and dashpot constants (kg/s) along the normal and in the
  /// plane of contact.
  void add_contact(const double* normal, const double* arm, double normal_stiffness,
                   double tangential_stiffness, double normal_damping, double tangential_damping);
};

/// A rigid body's inertia in the frame of its BodyStiffness, and how it may move.
struct BodyInertia {
  double mass;                  // kg
  double moments[3][3];         // inertia tensor about the centre of mass, kg m^2
  std::array<bool, 6> is_free;  // translation along x, y, z; rotation about x, y, z
};

/// Largest eigenvalue of M^-1 K (1/s^2, the square of the highest frequency on held partners) and
/// of M^-1 C (1/s) over the free motions; 0 when nothing is free.
/// @throws std::invalid_argument when the inertia of the free motions is not positive definite.
struct StiffestMotion {
  double stiffness, damping;
};
StiffestMotion stiffest_motion(const BodyStiffness& contacts, const BodyInertia& inertia);

}  // namespace rodpack

#endif

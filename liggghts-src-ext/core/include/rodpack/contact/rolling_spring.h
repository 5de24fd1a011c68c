// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_ROLLING_SPRING_H
#define RODPACK_CONTACT_ROLLING_SPRING_H

#include <cmath>

namespace rodpack {

/// The laws of LIGGGHTS's rolling friction that have a spring against relative rotation.
enum class RollingLaw { none, epsd, epsd2, epsd3 };

/// What the spring and dashpot of rolling friction are made of. SI units.
struct RollingContact {
  RollingLaw law;
  double kn, kt;          // secant stiffness along the normal, stiffness in the plane, N/m
  double reduced_radius;  // R_i R_j / (R_i + R_j), R_i at a wall, m
  double inertia;         // m_i R_i^2, reduced by that of the partner if there is one, kg m^2
  double friction;        // coefficient of rolling friction mu_r
  double damping_ratio;   // eta_r, "coefficientRollingViscousDamping"
  double factor;          // of epsd3, "rollingStiffness"
};

/// Stiffness k_r against relative rotation, N m: 9/4 k_n (mu_r R*)^2 of epsd, k_t R*^2 of epsd2,
/// factor k_n (mu_r R*)^2 of epsd3.
inline double rolling_stiffness(const RollingContact& contact) {
  const double r2 = contact.reduced_radius * contact.reduced_radius;
  const double mu2 = contact.friction * contact.friction;
  switch (contact.law) {
    case RollingLaw::epsd:
      return 2.25 * contact.kn * mu2 * r2;
    case RollingLaw::epsd2:
      return contact.kt * r2;
    case RollingLaw::epsd3:
      return contact.factor * contact.kn * mu2 * r2;
    default:
      return 0.0;
  }
}

/// Dashpot against relative rotation, 2 eta_r sqrt(I k_r) with I = 7/5 of the inertia above, N m s;
/// epsd2 has none.
inline double rolling_damping(const RollingContact& contact) {
  if (contact.law == RollingLaw::epsd2) return 0.0;
  return 2.0 * contact.damping_ratio *
         std::sqrt(1.4 * contact.inertia * rolling_stiffness(contact));
}

}  // namespace rodpack

#endif

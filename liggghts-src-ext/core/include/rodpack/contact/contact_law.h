// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_CONTACT_LAW_H
#define RODPACK_CONTACT_CONTACT_LAW_H

#include <cmath>

namespace rodpack {

// Linear spring-dashpot contact of Lu et al., Granular Matter 18:34 (2016), section 2. Header-only
// because it runs once per contact and step. Arguments are not checked.

// The formulas are written for registers of several contacts; to them one contact is a register of
// one lane.
inline bool lane_less(double a, double b) { return a < b; }
/// Returns a where the mask is true, else b.
template <class Value>
inline Value lane_choice(bool mask, Value a, Value b) {
  return mask ? a : b;
}
struct OneContact {
  typedef double Real;
  typedef bool Mask;
};

#include "contact_formulas.h"

/// Effective mass of two particles in contact, m_i m_j / (m_i + m_j), kg.
inline double effective_mass(double mass_i, double mass_j) {
  return mass_i * mass_j / (mass_i + mass_j);
}

/// Dashpot constant c = 2 eta sqrt(m_ij k_ij), kg/s, from the damping ratio eta (1: critical), the
/// effective mass (kg; for a wall the particle's own mass) and the contact stiffness (N/m).
inline double damping_coefficient(double damping_ratio, double effective_mass, double stiffness) {
  return 2.0 * damping_ratio * std::sqrt(effective_mass * stiffness);
}

struct NormalForce {
  double total;         // repulsive force, never negative, N
  double elastic;       // spring part alone, which the Coulomb cap uses, N
  double viscoelastic;  // spring and dashpot, before the force is cut off at 0, N
};

/// Normal force max(0, k delta - c v): `stiffness` k in N/m, `damping` c in kg/s, `overlap` delta
/// in m (positive in contact), `separation_velocity` v in m/s (positive when separating).
inline NormalForce normal_force(double stiffness, double damping, double overlap,
                                double separation_velocity) {
  const double whole = viscoelastic_force(stiffness, overlap, damping, separation_velocity);
  return {whole > 0.0 ? whole : 0.0, stiffness * overlap, whole};
}

/// Tangential force -(k s + c v) on particle i, N, limited to the magnitude `cap` (friction_cap.h).
/// `velocity` v is that of i's surface relative to j's in the plane of contact (m/s)
/// and `spring` s its integral over the life of the contact (m). Where the cap acts, the spring is
/// shortened so that it alone carries the cap (s = -force/k). Returns true when capped.
template <int D>
inline bool tangential_force(double stiffness, double damping, double cap, double (&spring)[D],
                             const double (&velocity)[D], double (&force)[D]) {
  double squared = 0.0;
  for (int d = 0; d < D; ++d) {
    force[d] = trial_force(stiffness, spring[d], damping, velocity[d]);
    squared += force[d] * force[d];
  }
  if (squared <= cap * cap) return false;
  const double scale = cap / std::sqrt(squared);
  for (int d = 0; d < D; ++d) {
    force[d] *= scale;
    // Without tangential stiffness there is no spring to carry anything.
    spring[d] = stiffness > 0.0 ? carrying_spring(force[d], stiffness) : 0.0;
  }
  return true;
}

/// Coefficient of restitution of a head-on collision under `normal_force`, which ends when the
/// force has fallen to zero: e = exp(-2 eta acos(eta) / sqrt(1 - eta^2)), continued to eta >= 1
/// (Schwager and Poeschel, Granular Matter 9, 465, 2007). It exceeds exp(-pi eta / sqrt(1 -
/// eta^2)), the value of a contact that may pull. @throws std::invalid_argument for a negative
/// damping ratio.
double restitution_coefficient(double damping_ratio);

/// The damping ratio at which restitution_coefficient() is `restitution`. @throws
/// std::invalid_argument unless exp(-2) <= restitution <= 1: damping ratios from 1 (critical) to 0.
double damping_ratio_for(double restitution);

}  // namespace rodpack

#endif

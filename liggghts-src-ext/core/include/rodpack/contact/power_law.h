// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_POWER_LAW_H
#define RODPACK_CONTACT_POWER_LAW_H

#include <cmath>
#include <limits>

#include "../geometry/pi.h"

namespace rodpack {

// An elastic normal force F = c delta^p of the overlap delta: p = 1 of a linear spring, 3/2 of
// Hertz. It is told by its secant k = F / delta (N/m) at the present overlap, and by p.

/// Energy that the contact has stored, the integral of F over the overlap: F delta / (p + 1), J.
inline double elastic_energy(double secant, double overlap, double exponent) {
  return secant * overlap * overlap / (exponent + 1.0);
}

/// Stiffness against a small change of the overlap, dF / d delta, N/m.
inline double tangent_stiffness(double secant, double exponent) { return exponent * secant; }

/// Half a period of a mass (kg) on a spring (N/m) and dashpot (kg/s), how long a collision with
/// them lasts, s; infinite where it does not swing.
inline double half_period(double stiffness, double damping, double mass) {
  const double decay = 0.5 * damping / mass;
  const double squared = stiffness / mass - decay * decay;
  return squared > 0.0 ? pi / std::sqrt(squared) : std::numeric_limits<double>::infinity();
}

}  // namespace rodpack

#endif

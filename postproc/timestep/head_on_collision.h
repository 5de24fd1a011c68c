// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TIMESTEP_HEAD_ON_COLLISION_H
#define RODPACK_TIMESTEP_HEAD_ON_COLLISION_H

#include <string>
#include <vector>

namespace rodpack {

/// An integrator that a deck can name.
struct Integrator {
  std::string name;             // as in `rodpack accuracy`, but for "relaxed"
  std::string fix;              // style and arguments of the fix
  int order;                    // 1 to 4; 0: velocity Verlet as LIGGGHTS has it, and leapfrog
  bool events;                  // whether it follows the events of contacts
  double relaxation_steps = 0;  // relaxation time of the dashpots over the step; 0: none

  /// What a dashpot counts in the limit of stability, over its constant (dashpot_relaxation.h).
  double dashpot_share() const;
};
/// Those to choose from: leapfrog; velocity Verlet of fix multisphere, which makes the same steps;
/// "relaxed", which is leapfrog with dashpots that relax in one step; multisphere/ab of orders 1 to
/// 3 without events, of orders 2 to 4 with them.
const std::vector<Integrator>& integrators();

/// Error of the rebound speed of a head-on collision under the contact law of Lu et al. (2016) with
/// this damping ratio, over its exact value (restitution_coefficient()): rms over 12 moments of
/// first touch, evenly spread over a step. `steps_per_collision`: pi / omega over the step, omega
/// that of the spring without its dashpot; > 1. The collision is made here, with the integrator's
/// own formulas and the contact law's own events; it has no unit, since the law is linear. A
/// collision that ends in nonsense, beyond the limit of stability, has an error above 1 or
/// infinity.
double rebound_error(const Integrator& integrator, double damping_ratio,
                     double steps_per_collision);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TIMESTEP_ADVICE_H
#define RODPACK_TIMESTEP_ADVICE_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "timestep/head_on_collision.h"

namespace rodpack {

/// A head-on collision of two equal particles under the contact law of Lu et al. (2016).
struct Collision {
  double stiffness = 0;      // k_n of a particle, N/m; two in contact have half of it
  double damping_ratio = 0;  // along the normal, 0 to 1
  double mass = 0;           // of a particle, kg

  /// pi / omega, omega that of the spring without its dashpot, s.
  double duration() const;
  /// Largest overlap at the closing speed (m/s), m: v/omega exp(-eta acos(eta) / sqrt(1 - eta^2)).
  double largest_overlap(double speed) const;
};

/// Largest stable time step of a body on so many such contacts with walls or heavy bodies, all
/// along one line, for an integrator of this order, s; with its equals, which give way, it is as
/// small. Their stiffnesses add up, and so do their dashpots: omega grows by sqrt(N) and the
/// damping ratio, too. `dashpot_share`: Integrator::dashpot_share().
double limit_of_contacts(int order, const Collision& collision, int contacts,
                         double dashpot_share = 1);

/// One point of the chart of error against cost.
struct ErrorAtStep {
  double steps_per_collision, error;
};

/// What one integrator needs.
struct TimestepAdvice {
  Integrator integrator;
  std::vector<ErrorAtStep> chart;      // from 4 to `most_steps` steps per collision
  double limit = 0;                    // of stability, s; 0: unstable at any step
  std::optional<double> fewest_steps;  // per collision, to the error; none within `most_steps`
  double timestep = 0;                 // s: the error's or `margin` of the limit, the smaller
  double steps_per_collision = 0;      // of that step
  double error = 0;                    // of that step, see rebound_error()
  bool held_by_stability = false;      // which of the two it is
};

/// The share of the stability limit that a step may have; fix check/timestep/multisphere warns
/// beyond.
constexpr double stability_margin = 0.8;
/// How far steps per collision are tried.
constexpr double most_steps = 3000;

/// What each of integrators() needs for the error (of the rebound speed, > 0) and a stability limit
/// (s) that `limit_of` returns for it. Those that cannot reach the error keep no `timestep`.
std::vector<TimestepAdvice> advise(const Collision& collision, double error,
                                   const std::function<double(const Integrator&)>& limit_of);

/// The one of the longest time step, and of equal ones the first; null if none reaches the error.
const TimestepAdvice* cheapest(const std::vector<TimestepAdvice>& all);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#include "timestep/advice.h"

#include <algorithm>
#include <cmath>

#include "rodpack/motion/stability_limit.h"

namespace rodpack {
namespace {

const double pi = std::acos(-1.0);

std::vector<ErrorAtStep> error_chart(const Integrator& integrator, double damping_ratio) {
  std::vector<ErrorAtStep> chart;
  for (int k = 0; 4 * std::pow(1.08, k) < most_steps; ++k) {
    // The fraction is the same everywhere: near whole numbers what the two ends of an undamped
    // contact leave in the velocity cancels.
    const double at = std::floor(4 * std::pow(1.08, k)) + 0.37;
    if (chart.empty() || at > chart.back().steps_per_collision)
      chart.push_back({at, rebound_error(integrator, damping_ratio, at)});
  }
  return chart;
}

}  // namespace

double Collision::duration() const { return pi * std::sqrt(mass / stiffness); }

double Collision::largest_overlap(double speed) const {
  // It is reached when omega sqrt(1 - eta^2) t = acos(eta).
  const double damped = std::sqrt(1 - damping_ratio * damping_ratio);
  const double loss = damped > 0 ? damping_ratio * std::acos(damping_ratio) / damped : 1;
  return speed * std::sqrt(mass / stiffness) * std::exp(-loss);
}

double limit_of_contacts(int order, const Collision& collision, int contacts,
                         double dashpot_share) {
  const double grown = std::sqrt(static_cast<double>(contacts));
  return stability_limit(order, grown * dashpot_share * collision.damping_ratio) *
         collision.duration() / (pi * grown);
}

std::vector<TimestepAdvice> advise(const Collision& collision, double error,
                                   const std::function<double(const Integrator&)>& limit_of) {
  std::vector<TimestepAdvice> all;
  for (const Integrator& integrator : integrators()) {
    TimestepAdvice advice;
    advice.integrator = integrator;
    advice.limit = limit_of(integrator);
    advice.chart = error_chart(integrator, collision.damping_ratio);
    // From the finest step down, so that no chance crossing at coarse steps counts.
    for (auto at = advice.chart.rbegin(); at != advice.chart.rend() && at->error <= error; ++at)
      advice.fewest_steps = at->steps_per_collision;
    if (advice.fewest_steps && advice.limit > 0) {
      const double for_error = collision.duration() / *advice.fewest_steps;
      const double for_stability = stability_margin * advice.limit;
      advice.held_by_stability = for_stability < for_error;
      advice.timestep = std::min(for_error, for_stability);
      advice.steps_per_collision = collision.duration() / advice.timestep;
      advice.error = rebound_error(integrator, collision.damping_ratio, advice.steps_per_collision);
    }
    all.push_back(advice);
  }
  return all;
}

const TimestepAdvice* cheapest(const std::vector<TimestepAdvice>& all) {
  const TimestepAdvice* best = nullptr;
  for (const TimestepAdvice& each : all)
    if (each.timestep > 0 && (!best || each.timestep > best->timestep)) best = &each;
  return best;
}

}  // namespace rodpack

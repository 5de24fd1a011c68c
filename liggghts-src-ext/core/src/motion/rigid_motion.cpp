// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/rigid_motion.h"

namespace rodpack {

void fill_kinematic_history(SpatialRates* history, int order, double dt, const SpatialMotion& birth,
                            const double (&inertia)[3]) {
  const SpatialRates& rates = history[order - 1];
  double q[4] = {birth.quaternion[0], birth.quaternion[1], birth.quaternion[2],
                 birth.quaternion[3]};
  // Quaternion rate at the time `steps` (negative) in units of dt after birth.
  const auto rate_at = [&](double steps, const double(&orientation)[4], double(&rate)[4]) {
    double momentum[3];
    for (int d = 0; d < 3; ++d)
      momentum[d] = birth.angular_momentum[d] + steps * dt * rates.torque[d];
    quaternion_rate(orientation, momentum, inertia, rate);
  };
  for (int k = 1; k < order; ++k) {
    double k1[4], k2[4], k3[4], k4[4], trial[4];
    rate_at(1 - k, q, k1);
    for (int d = 0; d < 4; ++d) trial[d] = q[d] - 0.5 * dt * k1[d];
    rate_at(0.5 - k, trial, k2);
    for (int d = 0; d < 4; ++d) trial[d] = q[d] - 0.5 * dt * k2[d];
    rate_at(0.5 - k, trial, k3);
    for (int d = 0; d < 4; ++d) trial[d] = q[d] - dt * k3[d];
    rate_at(-k, trial, k4);
    for (int d = 0; d < 4; ++d) q[d] -= dt / 6.0 * (k1[d] + 2.0 * k2[d] + 2.0 * k3[d] + k4[d]);
    normalise(q);

    SpatialRates& past = history[order - 1 - k];
    past = SpatialRates{};
    for (int d = 0; d < 3; ++d)
      past.velocity[d] = velocity_before_birth(rates.velocity[d], rates.acceleration[d], k * dt);
    rate_at(-k, q, past.quaternion_rate);
  }
}

}  // namespace rodpack

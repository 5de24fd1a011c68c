// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_MEAN_PROFILE_H
#define RODPACK_ENSEMBLE_MEAN_PROFILE_H

#include <cmath>
#include <optional>
#include <vector>

#include "analysis/pressure_profile.h"

namespace rodpack {

/// A mean P_0(h) as a profile, for fit_janssen().
/// @param depth_over_dp  h below the highest surface, d_p; the last one is that of the floor
/// @param pressure       P_0, N/m; depths without a value are left out
/// @param omega          the kernel's width, m
inline PressureProfile mean_profile(const std::vector<double>& depth_over_dp,
                                    const std::vector<std::optional<double>>& pressure,
                                    double particle_diameter, double omega) {
  PressureProfile profile;
  profile.particle_diameter = particle_diameter;
  profile.scale = omega;
  profile.depth_of_floor = depth_over_dp.back() * particle_diameter;
  for (std::size_t k = 0; k < depth_over_dp.size(); ++k) {
    if (!pressure[k] || !std::isfinite(*pressure[k])) continue;
    profile.depth.push_back(depth_over_dp[k] * particle_diameter);
    profile.pressure.push_back(*pressure[k]);
  }
  return profile;
}

}  // namespace rodpack

#endif

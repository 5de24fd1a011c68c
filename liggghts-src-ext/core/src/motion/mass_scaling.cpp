// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/mass_scaling.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "rodpack/motion/stability_limit.h"

namespace rodpack {

double mass_scaled_timestep_limit(int order, double scaling, const PackingLaw& law) {
  const auto require = [](bool holds, const std::string& name, double value, const char* expected) {
    if (!holds || !std::isfinite(value))
      throw std::invalid_argument("mass scaling: " + name + " is " + std::to_string(value) +
                                  ", expected " + expected);
  };
  require(order >= 0, "order", order, "0 to 4");
  require(scaling >= 1.0, "S", scaling, "a number >= 1");
  require(law.stiffness > 0.0, "stiffness", law.stiffness, "a stiffness > 0 (N/m)");
  require(law.lightest_mass > 0.0, "mass", law.lightest_mass, "a mass > 0 (kg)");
  require(law.dashpot_share > 0.0 && law.dashpot_share <= 1.0, "share of the dashpots",
          law.dashpot_share, "a share in (0, 1]");
  const double of_pair = std::sqrt(2.0 * law.stiffness / law.lightest_mass);
  const double damping_ratio = law.dashpot_share * law.damping_ratio;
  return stability_limit(order, scaling * damping_ratio) / (scaling * of_pair);
}

}  // namespace rodpack

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
  require(order >= 1, "order", order, "1 to 4");
  require(scaling >= 1.0, "S", scaling, "a number >= 1");
  require(law.stiffness > 0.0, "stiffness", law.stiffness, "a stiffness > 0 (N/m)");
  require(law.lightest_mass > 0.0, "mass", law.lightest_mass, "a mass > 0 (kg)");
  const double of_pair = std::sqrt(2.0 * law.stiffness / law.lightest_mass);
  return stability_limit(order, scaling * law.damping_ratio) / (scaling * of_pair);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_law.h"

#include <sstream>
#include <stdexcept>

namespace rodpack {

double restitution_coefficient(double damping_ratio) {
  const double eta = damping_ratio;
  if (!(eta >= 0.0)) {
    std::ostringstream message;
    message << "damping ratio = " << eta << ": expected 0 or more";
    throw std::invalid_argument(message.str());
  }
  // acos(eta) / sqrt(1 - eta^2) is analytic at eta = 1, where it is 1 - (eta - 1)/3 + ...
  const double excess = eta - 1.0;
  double ratio;
  if (std::fabs(excess) < 1e-5)
    ratio = 1.0 - excess / 3.0 + 2.0 / 15.0 * excess * excess;
  else if (eta < 1.0)
    ratio = std::acos(eta) / std::sqrt(1.0 - eta * eta);
  else
    ratio = std::acosh(eta) / std::sqrt(eta * eta - 1.0);
  return std::exp(-2.0 * eta * ratio);
}

double damping_ratio_for(double restitution) {
  if (!(restitution >= std::exp(-2.0) && restitution <= 1.0)) {
    std::ostringstream message;
    message << "restitution = " << restitution << ": expected exp(-2) = 0.1353 to 1";
    throw std::invalid_argument(message.str());
  }
  // It falls with the damping ratio; halving finds the root to the last bit of 1.
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (restitution_coefficient(middle) > restitution ? low : high) = middle;
  }
  return restitution == 1.0 ? 0.0 : high;
}

}  // namespace rodpack

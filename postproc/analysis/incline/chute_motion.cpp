// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/incline/chute_motion.h"

#include <cmath>
#include <numeric>

#include "analysis/line_fit.h"
#include "reading/dump.h"

namespace rodpack {

ChuteMotion measure_motion(const std::vector<double>& time, const std::vector<double>& velocity,
                           double speed) {
  constexpr double still = 1e-3, change = 0.1;
  if (time.empty()) throw TooFewParticles("incline: no frame to average");
  const auto n = static_cast<double>(time.size());
  ChuteMotion motion;
  motion.velocity = std::accumulate(velocity.begin(), velocity.end(), 0.0) / n;
  if (std::abs(motion.velocity) < still * speed) return motion;
  if (time.size() < 3)
    throw TooFewParticles("incline: the bed moves, expected at least 3 frames, found " +
                          std::to_string(time.size()));
  motion.acceleration = fit_line(time, velocity).b;
  const double changed = motion.acceleration * (time.back() - time.front());
  motion.state = std::abs(changed) < change * std::abs(motion.velocity) ? ChuteState::steady
                 : changed * motion.velocity > 0                        ? ChuteState::accelerating
                                                                        : ChuteState::slowing;
  return motion;
}

std::string describe(ChuteState state) {
  switch (state) {
    case ChuteState::at_rest:
      return "at rest";
    case ChuteState::steady:
      return "steady";
    case ChuteState::accelerating:
      return "accelerating";
    default:
      return "slowing down";
  }
}

}  // namespace rodpack

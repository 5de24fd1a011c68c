// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_INCLINE_CHUTE_MOTION_H
#define RODPACK_ANALYSIS_INCLINE_CHUTE_MOTION_H

#include <string>
#include <vector>

namespace rodpack {

enum class ChuteState { at_rest, steady, accelerating, slowing };

/// How the bed on an inclined plane moves as a whole.
struct ChuteMotion {
  double velocity = 0;      // mean down the slope, m/s
  double acceleration = 0;  // of the straight line of least squares, m/s^2
  ChuteState state = ChuteState::at_rest;
};

/// From the mean velocities of the bed, m/s, at increasing times, s. At rest: the mean is below
/// 1e-3 of `speed`, sqrt(g d_p). Steady: it changes by less than a tenth over all these times,
/// which takes at least three of them.
ChuteMotion measure_motion(const std::vector<double>& time, const std::vector<double>& velocity,
                           double speed);

/// Says "at rest", "steady", "accelerating" or "slowing down".
std::string describe(ChuteState state);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_DISCHARGE_HOPPER_FACTOR_H
#define RODPACK_ANALYSIS_DISCHARGE_HOPPER_FACTOR_H

#include <vector>

namespace rodpack {

/// Half angle of a flat bottom, degrees.
constexpr double flat_bottom = 90;

/// How much faster a conical hopper flows than a flat bottom with the same orifice, after Rose and
/// Tanaka (The Engineer 208, 465, 1959; in Nedderman, Statics and Kinematics of Granular Materials,
/// 1992, section 10.3): (tan a tan b)^-0.35 where that is above 1, a + b < 90 degrees, else 1.
/// `half_angle`: a, of the wall and the vertical, degrees in (0, 90]. `flow_angle`: b, of the
/// boundary of the stagnant zone above a flat bottom and the horizontal; 45 degrees where nothing
/// is known of it.
double rose_tanaka_factor(double half_angle, double flow_angle = 45);

/// A run's steady rate, in any unit that is common to all.
struct HopperRate {
  double width = 0;       // D / d_p
  double half_angle = 0;  // degrees
  double rate = 0, rate_error = 0;
};

/// Rate of hoppers of one width and half angle over that of flat bottoms of this width.
struct HopperFactor {
  double width = 0, half_angle = 0;
  std::size_t runs = 0;
  double factor = 0, factor_error = 0;
};

/// Factors of all widths of which there are flat bottoms, in the order of width, then half angle.
/// Mean over mean of the runs; a mean's standard error is the larger one of those that the runs'
/// own errors and the scatter between two runs or more give.
std::vector<HopperFactor> hopper_factors(const std::vector<HopperRate>& runs);

}  // namespace rodpack

#endif

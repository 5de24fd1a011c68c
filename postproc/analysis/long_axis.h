// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_LONG_AXIS_H
#define RODPACK_ANALYSIS_LONG_AXIS_H

#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// Direction of the long axis of each sphere's particle, degrees in [0, 180): the larger principal
/// axis of its sphere centres; NaN for single spheres. `body`: id of each sphere's particle; `x`,
/// `y`: of its centre, m; `period`: of x, m; 0 when not periodic.
std::vector<double> long_axis_degrees(const std::vector<double>& body, const std::vector<double>& x,
                                      const std::vector<double>& y, double period);

/// Angle of the long axis of each sphere's particle in space, the chord between the two of its
/// spheres that are farthest apart, to a coordinate axis (0 to 2); degrees in [0, 90]; NaN for
/// single spheres. `spheres`: of their dump, columns `body x y z`.
std::vector<double> degrees_to_axis(const Frame& spheres, std::size_t axis);

}  // namespace rodpack

#endif

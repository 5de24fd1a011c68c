// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_LONG_AXIS_H
#define RODPACK_ANALYSIS_LONG_AXIS_H

#include <vector>

namespace rodpack {

/// Direction of the long axis of each sphere's particle, degrees in [0, 180): the larger principal
/// axis of its sphere centres; NaN for single spheres. `body`: id of each sphere's particle; `x`,
/// `y`: of its centre, m; `period`: of x, m; 0 when not periodic.
std::vector<double> long_axis_degrees(const std::vector<double>& body, const std::vector<double>& x,
                                      const std::vector<double>& y, double period);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_ANGLES_H
#define RODPACK_READING_ANGLES_H

#include "rodpack/geometry/pi.h"

namespace rodpack {

/// One degree, rad: angles are radians in dumps, degrees in tables and figures.
constexpr double degree = pi / 180;
constexpr double degrees_in_radian = 180 / pi;

}  // namespace rodpack

#endif

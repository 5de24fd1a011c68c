// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/upright_container.h"

#include <cmath>

namespace rodpack {

bool UprightContainer::contains(const std::array<double, 3>& place, double slack) const {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!round || axis == vertical)
      if (place[axis] < low[axis] - slack || place[axis] > high[axis] + slack) return false;
  if (!round) return true;
  return std::hypot(place[horizontal(0)] - middle[0], place[horizontal(1)] - middle[1]) <=
         radius + slack;
}

}  // namespace rodpack

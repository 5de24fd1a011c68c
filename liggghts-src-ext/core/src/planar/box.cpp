// SPDX-License-Identifier: GPL-2.0-or-later
#include "box.h"

#include <algorithm>
#include <cmath>

#include "rodpack/contact/contact_formulas.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

PlanarBox box_of(const PlanarSphere* spheres, int count) {
  const PlanarSphere &first = spheres[0], &last = spheres[count - 1];
  const double length = std::hypot(last.x - first.x, last.y - first.y);
  Vector2<double> direction = {1.0, 0.0};
  if (length > 0.0) direction = {(last.x - first.x) / length, (last.y - first.y) / length};
  double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0};  // along and across, from the first sphere
  for (int k = 0; k < count; ++k) {
    const Vector2<double> from_first = {spheres[k].x - first.x, spheres[k].y - first.y};
    const double at[2] = {dot(direction, from_first), cross_z(direction, from_first)};
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], at[d]);
      high[d] = std::max(high[d], at[d]);
    }
  }
  const Vector2<double> to_middle = turned<double>(
      direction.x, direction.y, {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])});
  return {first.x + to_middle.x, first.y + to_middle.y,    direction.x,
          direction.y,           0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1])};
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidates.h"

#include <algorithm>
#include <cmath>

#include "rodpack/contact/contact_law.h"

namespace rodpack {

void find_candidates(const PlanarChain& of_i, const PlanarChain& of_j,
                     std::vector<PlanarCandidate>& candidates) {
  const PlanarReference &a = of_i.at, &b = of_j.at;
  // The x axis and the centre of i in the frame of j, to bring spheres of i there.
  const auto seen_from_j = [&](double x, double y) {
    return turned<double>(b.cosine, -b.sine, {x, y});
  };
  const Vector2<double> axis = seen_from_j(a.cosine, a.sine),
                        centre = seen_from_j(a.x - b.x, a.y - b.y);
  const double touch = of_i.radius + of_j.radius, near_by = touch + a.skin + b.skin;
  const double around_j = b.reach - of_j.radius + near_by;
  for (int k = 0; k < of_i.count; ++k) {
    const PlanarSphere& i = of_i.spheres[k];
    const double x = centre.x + axis.x * i.x - axis.y * i.y;
    const double y = centre.y + axis.y * i.x + axis.x * i.y;
    if (x * x + y * y > around_j * around_j) continue;
    for (int l = 0; l < of_j.count; ++l) {
      const PlanarSphere& j = of_j.spheres[l];
      const double rx = x - j.x, ry = y - j.y, square = rx * rx + ry * ry;
      if (square < near_by * near_by) candidates.push_back({std::sqrt(square) - touch, k, l});
    }
  }
}

void find_candidates(const PlanarChain& of_i, const PlanarWall& wall,
                     std::vector<PlanarCandidate>& candidates) {
  const PlanarReference& at = of_i.at;
  const double centre = (wall.axis == 0 ? at.x : at.y) - wall.position;
  if (wall.side_of(centre) * centre > at.reach + at.skin) return;
  const double along_x = wall.axis == 0 ? at.cosine : at.sine;
  const double along_y = wall.axis == 0 ? -at.sine : at.cosine;
  for (int k = 0; k < of_i.count; ++k) {
    const PlanarSphere& i = of_i.spheres[k];
    const double distance = centre + along_x * i.x + along_y * i.y;
    const double gap = wall.side_of(distance) * distance - of_i.radius;
    if (gap < at.skin) candidates.push_back({gap, k, 0});
  }
}

void sort_candidates(std::vector<PlanarCandidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(),
            [](const PlanarCandidate& a, const PlanarCandidate& b) {
              return a.gap != b.gap             ? a.gap < b.gap
                     : a.sphere_i != b.sphere_i ? a.sphere_i < b.sphere_i
                                                : a.sphere_j < b.sphere_j;
            });
}

}  // namespace rodpack

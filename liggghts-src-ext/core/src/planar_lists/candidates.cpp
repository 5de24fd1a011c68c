// SPDX-License-Identifier: GPL-2.0-or-later
#include "candidates.h"

#include <algorithm>
#include <cmath>

#include "rodpack/contact/contact_law.h"

namespace rodpack {

namespace {

/// Centres of candidates are less than this apart, m.
double reach_of_candidates(const PlanarChain& i, const PlanarChain& j) {
  return i.radius + j.radius + i.at.skin + j.at.skin;
}

/// A box at the reference position of its body.
struct PlacedBox {
  Vector2<double> middle, direction;
  double half_length, half_width;

  explicit PlacedBox(const PlanarChain& of)
      : direction(turned(of.at.cosine, of.at.sine, {of.box.cosine, of.box.sine})),
        half_length(of.box.half_length),
        half_width(of.box.half_width) {
    const Vector2<double> arm = turned(of.at.cosine, of.at.sine, {of.box.x, of.box.y});
    middle = {of.at.x + arm.x, of.at.y + arm.y};
  }
};

/// Whether the shadows of two boxes on both axes of the first come closer than `reach`.
bool shadows_meet(const PlacedBox& on, const PlacedBox& other, double reach) {
  const Vector2<double> away = {other.middle.x - on.middle.x, other.middle.y - on.middle.y};
  const double c = std::fabs(dot(on.direction, other.direction)),
               s = std::fabs(cross_z(on.direction, other.direction));
  const double along = on.half_length + c * other.half_length + s * other.half_width,
               across = on.half_width + s * other.half_length + c * other.half_width;
  return std::fabs(dot(on.direction, away)) < along + reach &&
         std::fabs(cross_z(on.direction, away)) < across + reach;
}

}  // namespace

bool are_close(const PlanarChain& i, const PlanarChain& j) {
  const PlacedBox of_i(i), of_j(j);
  const double reach = reach_of_candidates(i, j);
  return shadows_meet(of_i, of_j, reach) && shadows_meet(of_j, of_i, reach);
}

void find_candidates(const PlanarChain& of_i, const PlanarChain& of_j,
                     std::vector<PlanarCandidate>& candidates) {
  const PlanarReference &a = of_i.at, &b = of_j.at;
  // The x axis and the centre of i in the frame of j, to bring spheres of i there.
  const auto seen_from_j = [&](double x, double y) {
    return turned<double>(b.cosine, -b.sine, {x, y});
  };
  const Vector2<double> axis = seen_from_j(a.cosine, a.sine),
                        centre = seen_from_j(a.x - b.x, a.y - b.y);
  const double touch = of_i.radius + of_j.radius, near_by = reach_of_candidates(of_i, of_j);
  const PlanarBox& box = of_j.box;
  for (int k = 0; k < of_i.count; ++k) {
    const PlanarSphere& i = of_i.spheres[k];
    const double x = centre.x + axis.x * i.x - axis.y * i.y;
    const double y = centre.y + axis.y * i.x + axis.x * i.y;
    const Vector2<double> from_middle = {x - box.x, y - box.y}, along = {box.cosine, box.sine};
    if (std::fabs(dot(along, from_middle)) > box.half_length + near_by ||
        std::fabs(cross_z(along, from_middle)) > box.half_width + near_by)
      continue;
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

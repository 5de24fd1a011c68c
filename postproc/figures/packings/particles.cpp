// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/particles.h"

#include <algorithm>
#include <cmath>

namespace rodpack {

std::vector<std::size_t> visible_spheres(const Frame& spheres,
                                         const std::array<double, 4>& window) {
  const auto &x = spheres.column("x"), &y = spheres.column("y"), &radius = spheres.column("radius");
  std::vector<std::size_t> visible;
  for (std::size_t i = 0; i < spheres.rows; ++i)
    if (x[i] + radius[i] > window[0] && x[i] - radius[i] < window[1] &&
        y[i] + radius[i] > window[2] && y[i] - radius[i] < window[3])
      visible.push_back(i);
  return visible;
}

std::vector<Joint> joints_of(const Frame& spheres, const std::vector<std::size_t>& rows) {
  const auto &x = spheres.column("x"), &y = spheres.column("y"), &radius = spheres.column("radius");
  const auto& body = spheres.column("body");
  const auto* id = spheres.has("id") ? &spheres.column("id") : nullptr;
  const auto* z = spheres.has("z") ? &spheres.column("z") : nullptr;
  auto order = rows;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (body[a] != body[b]) return body[a] < body[b];
    return id && (*id)[a] < (*id)[b];
  });
  std::vector<Joint> joints;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const auto a = order[k - 1], b = order[k];
    if (body[a] != body[b]) continue;
    const double size = std::min(radius[a], radius[b]), joint = size / 2;
    const double half_distance =
        0.5 * std::hypot(x[b] - x[a], y[b] - y[a], z ? (*z)[b] - (*z)[a] : 0);
    // Deep overlaps need none; across a periodic side there is none. Drawn 5 % smaller, the spheres
    // of a coarse particle keep a gap.
    const bool deep = half_distance * half_distance < size * size - joint * joint;
    if (deep || half_distance > 1.5 * size) continue;
    joints.push_back({(x[a] + x[b]) / 2, (y[a] + y[b]) / 2, joint, a, b});
  }
  return joints;
}

void draw_particles(const PackingPicture& picture, Drawing& drawing, const Frame& spheres,
                    const std::vector<std::size_t>& rows, double diameter, const std::string& edge,
                    const std::function<std::string(std::size_t)>& shade) {
  const auto &x = spheres.column("x"), &y = spheres.column("y"), &radius = spheres.column("radius");
  const double per_metre = picture.per_metre();
  // All dark discs first, the shaded ones a little smaller on top: an outline around each particle,
  // none between the overlapping spheres of one.
  const double outline = std::clamp(0.06 * diameter * per_metre, 0.3, 3.0);
  const auto disc = [&](double at_x, double at_y, double size, const std::string& fill) {
    drawing.circle(picture.x(at_x), picture.y(at_y), size, fill);
  };
  const auto joints = joints_of(spheres, rows);
  for (const auto i : rows) disc(x[i], y[i], radius[i] * per_metre, edge);
  for (const auto& joint : joints) disc(joint.x, joint.y, joint.radius * per_metre, edge);
  for (const auto& joint : joints)
    disc(joint.x, joint.y, joint.radius * per_metre - outline, shade(joint.sphere));
  for (const auto i : rows) disc(x[i], y[i], radius[i] * per_metre - outline, shade(i));
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_CONTACT_SCENE_H
#define RODPACK_TESTS_CONTACT_SCENE_H

#include <string>
#include <vector>

#include "reading/space/spatial_packing.h"

namespace rodpack::test {

/// A frame of these columns and rows.
inline Frame frame_of(const std::vector<std::string>& names,
                      const std::vector<std::vector<double>>& rows) {
  Frame frame;
  frame.file = "made.dump";
  frame.names = names;
  frame.rows = rows.size();
  frame.columns.resize(names.size());
  frame.bad_fields.resize(names.size());
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) frame.columns[c].push_back(row[c]);
  return frame;
}

/// Spheres of diameter 1 and their contacts, in units of one's own.
struct ContactScene {
  std::vector<std::vector<double>> bodies, contacts;

  // A sphere of radius 1/2.
  void add_sphere(double x, double y, double z, double mass = 1, const Vector3& velocity = {}) {
    const double id = static_cast<double>(bodies.size()) + 1;
    bodies.push_back({x, y, z, 1, 0.5, 0.5, 0, mass, id, velocity[0], velocity[1], velocity[2]});
  }
  // `force` on i by j; j < 0: by a wall, at `to`.
  void add_contact(int i, int j, const Vector3& from, const Vector3& to, const Vector3& force) {
    contacts.push_back({i + 1.0, j + 1.0, j < 0 ? 1.0 : 0.0, (from[0] + to[0]) / 2,
                        (from[1] + to[1]) / 2, (from[2] + to[2]) / 2, force[0], force[1], force[2],
                        from[0], from[1], from[2], to[0], to[1], to[2]});
  }
  Frame body_frame() const {
    return frame_of({"x", "y", "z", "nspheres", "half_length", "radius", "curvature", "mass", "id",
                     "vx", "vy", "vz"},
                    bodies);
  }
  Frame contact_frame() const {
    return frame_of({"body_i", "body_j", "wall", "x", "y", "z", "fx", "fy", "fz", "bix", "biy",
                     "biz", "bjx", "bjy", "bjz"},
                    contacts);
  }
  // z up, d_p = 1, AR = 1, the bed from 0 to `surface`.
  SpatialPacking packing(const Vector3& size, double surface) const {
    SpatialPacking packing;
    packing.walls.high = size;
    packing.surface = surface;
    packing.particle_diameter = 1;
    for (const auto& row : bodies) packing.centre.push_back({row[0], row[1], row[2]});
    return packing;
  }
};

/// Spheres upon each other, each carrying those above; half of a weight goes into the side wall at
/// x = 0, which pushes with 0.3, as that at x = 1 does against it: all are at rest under the
/// gravity 9.81. `x`, `y`: of their centres; the floor is z = 0, and the k-th sphere, from below,
/// has the mass 1 + k / 10.
inline ContactScene pile_of_spheres(int number, double x, double y) {
  ContactScene scene;
  const auto mass = [](int k) { return 1 + 0.1 * k; };
  for (int k = 0; k < number; ++k) scene.add_sphere(x, y, k + 0.5, mass(k));
  double carried = 0;
  for (int k = number - 1; k >= 0; --k) {
    const double half = mass(k) * 9.81 / 2, z = k + 0.5;
    scene.add_contact(k, -1, {x, y, z}, {x - 0.5, y, z}, {0.3, 0, half});
    scene.add_contact(k, -1, {x, y, z}, {x + 0.5, y, z}, {-0.3, 0, 0});
    carried += half;
    // From below: the next sphere, or the floor.
    scene.add_contact(k, k > 0 ? k - 1 : -1, {x, y, z}, {x, y, k > 0 ? z - 1 : 0}, {0, 0, carried});
  }
  return scene;
}

}  // namespace rodpack::test

#endif

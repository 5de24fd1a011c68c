// SPDX-License-Identifier: GPL-2.0-or-later
// Rods with the contact law of the paper, for tests of the planar engine.
#ifndef RODPACK_TESTS_PLANAR_HEAP_H
#define RODPACK_TESTS_PLANAR_HEAP_H

#include <algorithm>
#include <cmath>
#include <vector>

#include "rodpack/geometry/chain_geometry.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

const PlanarLaw paper = {1000.0, 500.0, 0.2, 0.2, 0.3};
const double diameter = 3e-3, paper_step = 1.1e-5;

inline PlanarSettings settings_of(const PlanarLaw& law = paper) {
  PlanarSettings settings;
  settings.dt = paper_step;
  settings.laws = {law};
  return settings;
}

inline PlanarBody rod(double aspect_ratio, double x, double y, double angle, double curvature = 0) {
  ChainShape shape{aspect_ratio, diameter, 0.5, curvature, diameter};
  PlanarBody body;
  for (const auto& centre : sphere_centres(shape)) body.spheres.push_back({centre[0], centre[1]});
  body.radius = 0.5 * diameter;
  body.mass = 2500 * union_volume(shape);
  const double length = aspect_ratio * diameter;
  body.moment = body.mass * length * length / 12;
  body.position[0] = x;
  body.position[1] = y;
  body.cosine = std::cos(angle);
  body.sine = std::sin(angle);
  return body;
}

inline PlanarBody moving(PlanarBody body, double vx, double vy, double spin = 0) {
  body.velocity[0] = vx;
  body.velocity[1] = vy;
  body.velocity[2] = spin;
  return body;
}

/// A heap of rods that fall into a narrow box, from a fixed pseudo-random sequence.
inline std::vector<PlanarBody> heap(int rods, double aspect_ratio, double curvature = 0) {
  unsigned state = 12345;
  const auto draw = [&] { return (state = state * 1103515245u + 12345u) / 4294967296.0; };
  std::vector<PlanarBody> bodies;
  const double length = aspect_ratio * diameter;
  for (int k = 0; k < rods; ++k) {
    const double x = length * (0.7 + 1.1 * (k % 3)), y = length * (0.7 + 1.1 * (k / 3));
    bodies.push_back(moving(rod(aspect_ratio, x, y, 3.14 * draw(), curvature), 0.2 * draw() - 0.1,
                            -0.3, 20 * draw() - 10));
  }
  return bodies;
}

/// Such heaps of a dozen rods side by side on a long floor, some steps after the first has touched.
inline std::vector<PlanarBody> row_of_heaps(int heaps, PlanarSettings settings) {
  std::vector<PlanarBody> bodies;
  for (int k = 0; k < heaps; ++k)
    for (PlanarBody& body : heap(12, 5)) {
      body.position[0] += k * 3.4 * 5 * diameter;
      bodies.push_back(body);
    }
  PlanarScene scene(settings, bodies);
  scene.evaluate();
  scene.run(3000);
  for (int k = 0; k < scene.size(); ++k) bodies[k] = scene.body(k);
  return bodies;
}

inline PlanarSettings box(double aspect_ratio, const PlanarLaw& law = paper) {
  PlanarSettings settings = settings_of(law);
  settings.gravity[1] = -9.81;
  settings.walls = {{1, 0.0, 0}, {0, 0.0, 0}, {0, 3.5 * aspect_ratio * diameter, 0}};
  return settings;
}

inline std::vector<double> state_of(const PlanarScene& scene) {
  std::vector<double> state;
  for (int k = 0; k < scene.size(); ++k) {
    const PlanarBody body = scene.body(k);
    for (const double value : {body.position[0], body.position[1], body.cosine, body.sine,
                               body.velocity[0], body.velocity[1], body.velocity[2] * diameter})
      state.push_back(value);
  }
  return state;
}

inline double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k) worst = std::max(worst, std::fabs(a[k] - b[k]));
  return worst;
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/mass_properties.h"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rodpack {
namespace {

// What the reference particle shares with the coarse and the smooth one: straight, half overlap.
double reference_volume(ChainShape shape) {
  shape.overlap = 0.5;
  shape.curvature_angle = 0.0;
  return union_volume(shape);
}

std::array<double, 3> coarse_chain_inertia(ChainShape shape, double mass) {
  shape.overlap = 0.0;
  const auto centres = sphere_centres(shape);
  const double each = mass / static_cast<double>(centres.size());
  const double own = 0.1 * mass * shape.diameter * shape.diameter;  // 2/5 m r^2, all spheres
  std::array<double, 3> inertia = {{own, own, own}};
  for (const auto& c : centres) {
    inertia[0] += each * c[1] * c[1];
    inertia[1] += each * c[0] * c[0];
    inertia[2] += each * (c[0] * c[0] + c[1] * c[1]);
  }
  return inertia;
}

}  // namespace

MassProperties mass_properties(const ChainShape& drawn, double density, MassRule rule,
                               bool follow_drawn_size) {
  validate(drawn);
  if (!(density >= 1e-9 && density <= 1e9)) {
    std::ostringstream message;
    message << "density = " << density << ": expected 1e-9 to 1e9";
    throw std::invalid_argument(message.str());
  }
  ChainShape shape = drawn;
  if (!follow_drawn_size) shape.diameter = shape.nominal_diameter;

  if (rule == MassRule::own) {
    const UnionMoments solid = union_moments(shape);
    return {density * solid.volume,
            {{density * (solid.yy + solid.zz), density * (solid.xx + solid.zz),
              density * (solid.xx + solid.yy)}}};
  }
  const double mass = density * reference_volume(shape);
  return {mass, coarse_chain_inertia(shape, mass)};
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers of a spherocylinder's template: aspect ratio, nominal diameter, overlap, curvature,
// drawn diameter, density. What is taken has sphere centres, volume, mass and inertia that mean
// something.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "input_file.h"
#include "rodpack/geometry/chain_geometry.h"
#include "rodpack/geometry/mass_properties.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

bool is_size(double value) { return value > 0.0 && std::isfinite(value); }

void check(const rodpack::ChainShape& shape, double density) {
  const auto area = rodpack::covered_area(shape), volume = rodpack::union_volume(shape);
  require(is_size(area) && is_size(volume));
  for (const auto rule : {rodpack::MassRule::reference, rodpack::MassRule::own}) {
    for (const auto& centre : rodpack::sphere_centres(shape, rule))
      require(std::isfinite(centre[0]) && std::isfinite(centre[1]));
    require(is_size(rodpack::bounding_radius(shape, rule)));
    const auto mass = rodpack::mass_properties(shape, density, rule, true);
    require(is_size(mass.mass));
    for (const double moment : mass.inertia) require(is_size(moment));
  }
}

// A byte, of which a bit says whether a number is any double or one in its range or a little
// beyond, then six numbers of eight bytes.
double number(const std::uint8_t* data, int k, double low, double high) {
  std::uint64_t bits;
  std::memcpy(&bits, data + 1 + 8 * k, sizeof bits);
  if ((data[0] >> k & 1) == 0) return low + (high - low) * (std::ldexp(bits, -64) * 1.1 - 0.05);
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// The same over magnitudes.
double magnitude(const std::uint8_t* data, int k, double low, double high) {
  const double value = number(data, k, low, high);
  return (data[0] >> k & 1) == 0 ? std::pow(10.0, value) : value;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 + 6 * 8) return 0;
  rodpack::ChainShape shape;
  shape.aspect_ratio = magnitude(data, 0, 0, 4);
  shape.nominal_diameter = magnitude(data, 1, -12, 6);
  shape.overlap = number(data, 2, 0, 1);
  shape.curvature_angle = number(data, 3, 0, 3.1415926535897931);
  shape.diameter = shape.nominal_diameter * number(data, 4, 0.5, 2);
  try {
    check(shape, magnitude(data, 5, -9, 9));
  } catch (const std::invalid_argument&) {
  }
  return 0;
}

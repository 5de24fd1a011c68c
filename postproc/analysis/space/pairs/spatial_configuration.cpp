// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/pairs/spatial_configuration.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "analysis/pairs/pair_configuration.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

using Complex = std::complex<double>;

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 minus(const Vector3& a) { return {-a[0], -a[1], -a[2]}; }

double length(const Vector3& a) { return std::hypot(a[0], a[1], a[2]); }

// The component across x, in which a turn about x is a factor of modulus 1.
Complex across_of(const Vector3& a) { return {a[1], a[2]}; }

Vector3 turned(const Vector3& a, const Complex& turn) {
  const Complex b = across_of(a) * turn;
  return {a[0], b.real(), b.imag()};
}

// Some unit vector across another one.
Vector3 any_across(const Vector3& axis) {
  const Vector3 other = std::abs(axis[0]) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  auto result = cross(axis, other);
  const double size = length(result);
  for (auto& each : result) each /= size;
  return result;
}

// Of a pair whose neighbour's axis leaves the plane of the centres more than it tilts in it.
std::string twisted_name(const SpatialConfiguration& pair, double turn) {
  const bool near = pair.across() <= 1 + same_place;
  const auto shift = shift_in_words(pair.along());
  if (turn >= upright) return std::string(near ? "crossed" : "crossed and apart") + shift;
  return std::string(near ? "side by side" : "apart") + " twisted by " +
         number_text(std::round(turn)) + "°" + shift;
}

}  // namespace

double SpatialConfiguration::across() const { return std::hypot(place[1], place[2]); }

double SpatialConfiguration::distance() const { return length(place); }

double SpatialConfiguration::turn() const { return std::acos(std::min(1.0, std::abs(axis[0]))); }

double SpatialConfiguration::axis_to_line() const {
  const double r = distance();
  return r > 0 ? std::acos(std::min(1.0, std::abs(dot(axis, place)) / r)) : 0;
}

SpatialConfiguration spatial_configuration(const Vector3& to, const Vector3& axis_of_centre,
                                           const Vector3& axis_of_neighbour) {
  const auto& x = axis_of_centre;
  const double along = dot(to, x);
  Vector3 y{};
  for (std::size_t c = 0; c < 3; ++c) y[c] = to[c] - along * x[c];
  const double across = length(y);
  if (across > 1e-12 * length(to))
    for (auto& each : y) each /= across;
  else
    y = any_across(x);
  const auto z = cross(x, y);
  return {{along, across, 0},
          {dot(axis_of_neighbour, x), dot(axis_of_neighbour, y), dot(axis_of_neighbour, z)}};
}

std::vector<SpatialConfiguration> equal_configurations(const SpatialConfiguration& pair) {
  constexpr Vector3 x{1, 0, 0};
  std::vector<SpatialConfiguration> all;
  for (const auto& view : {spatial_configuration(pair.place, x, pair.axis),
                           spatial_configuration(minus(pair.place), pair.axis, x)})
    for (const double ahead : {1.0, -1.0})         // the centre particle's end
      for (const double forward : {1.0, -1.0})     // the neighbour's
        for (const double mirror : {1.0, -1.0}) {  // across the plane of the centres
          const auto& u = view.axis;
          all.push_back({{ahead * view.place[0], view.place[1], 0},
                         {ahead * forward * u[0], forward * u[1], forward * mirror * u[2]}});
        }
  return all;
}

SpatialConfiguration turned_towards(const SpatialConfiguration& reference,
                                    const SpatialConfiguration& pair, double arm) {
  const Complex product = across_of(reference.place) * std::conj(across_of(pair.place)) +
                          arm * arm * across_of(reference.axis) * std::conj(across_of(pair.axis));
  const double size = std::abs(product);
  if (!(size > 0)) return pair;
  return {turned(pair.place, product / size), turned(pair.axis, product / size)};
}

double distance_between(const SpatialConfiguration& a, const SpatialConfiguration& b, double arm) {
  const auto near = turned_towards(a, b, arm);
  double square = 0;
  for (std::size_t c = 0; c < 3; ++c)
    square +=
        std::pow(near.place[c] - a.place[c], 2) + std::pow(arm * (near.axis[c] - a.axis[c]), 2);
  return std::sqrt(square);
}

SpatialConfiguration reported_configuration(const SpatialConfiguration& pair) {
  constexpr double rounding = 1e-6;  // keeps equal views from being told apart by their last digits
  const auto all = equal_configurations(pair);
  const auto folded = [&](const SpatialConfiguration& view) {
    const auto& u = view.axis;
    const bool forward = u[0] > rounding || (u[0] > -rounding && u[1] >= -rounding);
    return view.along() >= 0 && forward && u[2] >= 0;
  };
  const SpatialConfiguration* best = nullptr;
  for (const auto& view : all) {
    if (!folded(view)) continue;
    if (!best || view.along() < best->along() - rounding ||
        (view.along() < best->along() + rounding && view.axis[1] > best->axis[1] + rounding))
      best = &view;
  }
  return best ? *best : all.front();
}

std::string configuration_name(const SpatialConfiguration& pair, const ChainShape& shape) {
  const double turn = pair.turn(), degrees = turn / degree;
  if (degrees > parallel && std::abs(pair.axis[2]) > std::abs(pair.axis[1]))
    return twisted_name(pair, degrees);
  const double sign = pair.axis[0] * pair.axis[1] < 0 ? -1 : 1;
  return configuration_name({pair.along(), pair.across(), sign * turn}, ParticleKind::straight,
                            shape, 0);
}

}  // namespace rodpack

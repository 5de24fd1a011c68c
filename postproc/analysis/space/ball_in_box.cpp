// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/ball_in_box.h"

#include <algorithm>
#include <cmath>

#include "reading/angles.h"

namespace rodpack {
namespace {

// All for the unit ball, cut by planes at the distances a, b, c from its centre, at right angles to
// each other.

constexpr double whole = 4 * pi / 3;

double arc_cosine(double x) { return std::acos(std::clamp(x, -1.0, 1.0)); }
double arc_sine(double x) { return std::asin(std::clamp(x, -1.0, 1.0)); }
double root(double square) { return std::sqrt(std::max(0.0, square)); }

// The angle by which the edge of the spherical surface turns where two planes meet.
double turn(double a, double b) {
  return arc_cosine(-a * b / std::sqrt((1 - a * a) * (1 - b * b)));
}

// Volume of the part with x >= a.
double cap(double a) {
  if (a >= 1) return 0;
  if (a <= -1) return whole;
  return pi * (1 - a) * (1 - a) * (2 + a) / 3;
}

// Volume of the part with x >= a and y >= b.
double wedge(double a, double b) {
  if (a < 0) return cap(b) - wedge(-a, b);
  if (b < 0) return cap(a) - wedge(a, -b);
  if (a * a + b * b >= 1) return 0;
  const double in_a = std::sqrt(1 - a * a), in_b = std::sqrt(1 - b * b);  // radii of the faces
  const double arc_a = arc_cosine(b / in_a), arc_b = arc_cosine(a / in_b);
  const double edge = root(1 - a * a - b * b);  // half of the faces' common chord
  const double surface = 2 * (pi - turn(a, b) - a * arc_a - b * arc_b);
  const double face_a = in_a * in_a * arc_a - b * edge;
  const double face_b = in_b * in_b * arc_b - a * edge;
  return (surface - a * face_a - b * face_b) / 3;
}

// Arc of the face at the distance a that two other planes leave, and the face's area.
struct Face {
  double arc, area;
};
Face face(double a, double b, double c) {
  const double square = 1 - a * a, radius = std::sqrt(square);
  const double arc = arc_cosine(b / radius) - arc_sine(c / radius);
  const double along_b = root(square - b * b) - c, along_c = root(square - c * c) - b;
  return {arc, (square * arc - b * along_b - c * along_c) / 2};
}

// Volume of the part with x >= a, y >= b and z >= c.
double corner(double a, double b, double c) {
  if (a < 0) return wedge(b, c) - corner(-a, b, c);
  if (b < 0) return wedge(a, c) - corner(a, -b, c);
  if (c < 0) return wedge(a, b) - corner(a, b, -c);
  if (a * a + b * b + c * c >= 1) return 0;
  const Face at_a = face(a, b, c), at_b = face(b, c, a), at_c = face(c, a, b);
  const double surface =
      2 * pi - turn(a, b) - turn(b, c) - turn(c, a) - a * at_a.arc - b * at_b.arc - c * at_c.arc;
  return (surface - a * at_a.area - b * at_b.area - c * at_c.area) / 3;
}

}  // namespace

double ball_volume_inside(const Box& box, const Vector3& centre, double r) {
  if (!(r > 0)) return 0;
  Vector3 low{}, high{};
  bool all_inside = true;
  for (std::size_t c = 0; c < 3; ++c) {
    low[c] = (box.low[c] - centre[c]) / r;
    high[c] = (box.high[c] - centre[c]) / r;
    all_inside = all_inside && low[c] <= -1 && high[c] >= 1;
  }
  const double unit = r * r * r;
  if (all_inside) return whole * unit;
  double volume = 0;
  for (unsigned sides = 0; sides < 8; ++sides) {
    double at[3];
    double sign = 1;
    for (unsigned c = 0; c < 3; ++c) {
      const bool upper = (sides >> c & 1U) != 0;
      at[c] = upper ? high[c] : low[c];
      if (upper) sign = -sign;
    }
    volume += sign * corner(at[0], at[1], at[2]);
  }
  return volume * unit;
}

}  // namespace rodpack

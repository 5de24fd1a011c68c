// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/geometry/chain_geometry.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "rodpack/geometry/pi.h"

namespace rodpack {
namespace {

// Lengths outside of these, m, are mistakes; within, no power of them that mass, inertia or area
// take leaves the range of a double.
constexpr double shortest = 1e-12, longest = 1e6;
constexpr int most_spheres = 10000;

// Below this angle the arc's height is lost in round-off and the chain is treated as straight.
constexpr double straight_angle = 1e-12;

void require(bool holds, const char* name, double value, const char* expected) {
  if (holds) return;
  std::ostringstream message;
  message.precision(15);
  message << name << " = " << value << ": expected " << expected;
  throw std::invalid_argument(message.str());
}

int chain_count(double aspect_ratio, double overlap) {
  // The margin keeps e.g. (1.9 - 1)/0.1 from asking for one sphere too many.
  return 1 + static_cast<int>(std::ceil((aspect_ratio - 1.0) / (1.0 - overlap) - 1e-9));
}

double mean_y(const std::vector<std::array<double, 2>>& points) {
  double sum = 0.0;
  for (const auto& p : points) sum += p[1];
  return sum / static_cast<double>(points.size());
}

// Area of the part of a disc of radius r about C that lies between the ray from O through C and the
// ray from O at `angle` to it; O lies inside the disc at distance R < r from C.
double area_of_wedge(double r, double R, double angle) {
  const double u = R * std::sin(angle);
  return 0.5 * (u * R * std::cos(angle) + r * r * angle + u * std::sqrt((r - u) * (r + u)) +
                r * r * std::asin(u / r));
}

}  // namespace

void validate(const ChainShape& shape) {
  // Written so that NaN fails; the bounds of aspect ratio and overlap keep the count within an int.
  require(shape.aspect_ratio >= 1.0 && shape.aspect_ratio <= 1e4, "aspect ratio",
          shape.aspect_ratio, "1 to 1e4");
  const auto is_length = [](double d) { return d >= shortest && d <= longest; };
  require(is_length(shape.nominal_diameter), "nominal primary diameter", shape.nominal_diameter,
          "a length from 1e-12 to 1e6");
  require(shape.overlap >= 0.0 && shape.overlap <= 0.9999, "overlap", shape.overlap, "0 to 0.9999");
  require(shape.curvature_angle >= 0.0 && shape.curvature_angle <= pi * (1.0 + 1e-12),
          "curvature angle", shape.curvature_angle, "0 to pi rad");
  require(is_length(shape.diameter), "primary diameter", shape.diameter,
          "a length from 1e-12 to 1e6");
  const int count = chain_count(shape.aspect_ratio, shape.overlap);
  require(count <= most_spheres, "number of primary spheres", count, "at most 10000");
  // Of thinner chains the moment of inertia about the chain is lost in the rounding of the others.
  if (count > 1)
    require(shape.diameter < axial_length(shape) && shape.diameter >= 1e-5 * axial_length(shape),
            "primary diameter", shape.diameter, "1e-5 of the axial length or more, less than it");
}

int sphere_count(const ChainShape& shape) {
  validate(shape);
  return chain_count(shape.aspect_ratio, shape.overlap);
}

std::vector<std::array<double, 2>> centreline_points(const ChainShape& shape, int count) {
  require(count >= 1, "number of points", count, "at least 1");
  const double length = axial_length(shape) - shape.diameter;
  const double theta = shape.curvature_angle;
  std::vector<std::array<double, 2>> points(count, {{0.0, 0.0}});
  for (int i = 0; i < count && count > 1; ++i) {
    const double fraction =
        (2 * i - (count - 1)) / (2.0 * (count - 1));  // -1/2 .. 1/2, exact mirror
    if (theta < straight_angle) {
      points[i][0] = fraction * length;
    } else {
      const double radius = length / theta;
      const double half_sine = std::sin(0.5 * fraction * theta);
      points[i] = {{radius * std::sin(fraction * theta), -2.0 * radius * half_sine * half_sine}};
    }
  }
  return points;
}

std::vector<std::array<double, 2>> sphere_centres(const ChainShape& shape, MassRule rule) {
  const int count = sphere_count(shape);
  auto centres = centreline_points(shape, count);
  const double origin =
      rule == MassRule::own
          ? union_moments(shape).centroid_y
          : mean_y(centreline_points(shape, chain_count(shape.aspect_ratio, 0.0)));
  for (auto& c : centres) c[1] -= origin;
  return centres;
}

double covered_area(const ChainShape& shape) {
  // The bisectors between centres on an arc all pass through the arc's centre O, so the union falls
  // into one wedge about O per disc, cut by the bisectors with its neighbours only.
  const int gaps = sphere_count(shape) - 1;
  const double r = 0.5 * shape.diameter;
  if (gaps == 0) return pi * r * r;
  const double theta = shape.curvature_angle;
  const double length = axial_length(shape) - shape.diameter;
  if (length < r * theta) {  // O lies inside every disc
    const double R = length / theta;
    return 2.0 * gaps * area_of_wedge(r, R, 0.5 * theta / gaps) +
           2.0 * area_of_wedge(r, R, pi - 0.5 * theta);
  }
  const auto centres = centreline_points(shape, gaps + 1);
  const double spacing = std::hypot(centres[1][0] - centres[0][0], centres[1][1] - centres[0][1]);
  const double h = std::min(0.5 * spacing, r);
  return pi * r * r + 2.0 * gaps * (h * std::sqrt((r - h) * (r + h)) + r * r * std::asin(h / r));
}

double bounding_radius(const ChainShape& shape, MassRule rule) {
  double farthest = 0.0;
  for (const auto& c : sphere_centres(shape, rule))
    farthest = std::max(farthest, std::hypot(c[0], c[1]));
  return farthest + 0.5 * shape.diameter;
}

}  // namespace rodpack

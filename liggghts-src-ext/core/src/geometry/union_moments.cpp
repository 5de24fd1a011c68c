// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "rodpack/geometry/chain_geometry.h"
#include "rodpack/geometry/pi.h"

// The union of equal balls on an arc about O is split by the bisecting planes between neighbours.
// All of them contain the axis through O normal to the arc's plane, so a ball that does not reach O
// keeps everything but one cap per neighbour, and balls that do contain O keep a wedge each.

namespace rodpack {
namespace {

// Integrals of 1, y, x^2, y^2, z^2 over a solid in the frame of the arc; x vanishes by symmetry.
struct Integrals {
  double volume = 0.0, y = 0.0, xx = 0.0, yy = 0.0, zz = 0.0;
};

// Balls of radius r about the centres, less a cap on either side of each bisecting plane.
Integrals balls_less_caps(const std::vector<std::array<double, 2>>& centres, double r) {
  Integrals sum;
  const double ball = 4.0 / 3.0 * pi * r * r * r;
  for (const auto& c : centres) {
    sum.volume += ball;
    sum.y += ball * c[1];
    sum.xx += ball * (c[0] * c[0] + r * r / 5.0);
    sum.yy += ball * (c[1] * c[1] + r * r / 5.0);
    sum.zz += ball * r * r / 5.0;
  }
  for (std::size_t i = 0; i + 1 < centres.size(); ++i) {
    const double dx = centres[i + 1][0] - centres[i][0], dy = centres[i + 1][1] - centres[i][1];
    const double spacing = std::hypot(dx, dy);
    const double h = std::min(0.5 * spacing, r);
    const double nx = dx / spacing, ny = dy / spacing;
    // Cap h < u < r along its axis: volume, integrals of u and u^2, and of the square of either
    // coordinate across the axis; all about the ball's centre.
    const double r2 = r * r, h2 = h * h;
    const double volume = pi / 3.0 * (r - h) * (r - h) * (2.0 * r + h);
    const double first = pi / 4.0 * (r2 - h2) * (r2 - h2);
    const double along =
        pi * ((r2 * r2 * r - r2 * h2 * h) / 3.0 - (r2 * r2 * r - h2 * h2 * h) / 5.0);
    const double across = 0.25 * pi *
                          (r2 * r2 * (r - h) - 2.0 / 3.0 * r2 * (r2 * r - h2 * h) +
                           (r2 * r2 * r - h2 * h2 * h) / 5.0);
    for (int side = 0; side < 2; ++side) {
      const auto& c = centres[i + side];
      const double sx = side == 0 ? nx : -nx, sy = side == 0 ? ny : -ny;
      sum.volume -= volume;
      sum.y -= volume * c[1] + first * sy;
      sum.xx -= volume * c[0] * c[0] + 2.0 * first * sx * c[0] + along * nx * nx + across * ny * ny;
      sum.yy -= volume * c[1] * c[1] + 2.0 * first * sy * c[1] + along * ny * ny + across * nx * nx;
      sum.zz -= across;
    }
  }
  return sum;
}

// Half-plane from the axis through O at the angle phi to the ball's centre (distance R < r from O):
// integrals of rho, rho^2, rho^3 and rho z^2 over its section with the ball, a disc of radius a
// centred at rho = c, restricted to rho > 0.
struct Section {
  double rho, rho2, rho3, rho_zz;
  Section(double r, double R, double phi) {
    const double c = R * std::cos(phi), s = R * std::sin(phi);
    const double a2 = (r - s) * (r + s);
    const double e = std::sqrt((r - R) * (r + R)),
                 e3 = e * e * e;  // half the section's length at O
    // Integrals over the disc's part rho > 0 of u^k, u = rho - c, k = 0..3.
    const double b0 = 0.5 * pi * a2 + c * e + a2 * std::atan2(c, e);
    const double b1 = 2.0 / 3.0 * e3;
    const double b2 = 0.25 * a2 * b0 - 0.5 * c * e3;
    const double b3 = e3 * (2.0 / 3.0 * a2 - 0.4 * e * e);
    rho = c * b0 + b1;
    rho2 = c * c * b0 + 2.0 * c * b1 + b2;
    rho3 = c * c * c * b0 + 3.0 * c * c * b1 + 3.0 * c * b2 + b3;
    rho_zz = c * (0.25 * a2 * b0 + c * e3 / 6.0) + 2.0 / 15.0 * e3 * e * e;
  }
};

// Adds, for each of `count` bisecting half-planes at angles beta to the y axis, the two wedges of
// angle `width` that meet there. Of the beta only the sums of cos(beta) and cos(2 beta) matter.
void add_wedges(double r, double R, double width, int count, double sum_cos, double sum_cos2,
                Integrals& sum) {
  // Tanh-sinh quadrature: for r close to R the section varies quickly near phi = pi/2, where it
  // resolves any scale once the range is split there.
  const double step = 1.0 / 32.0;
  const double bounds[3] = {0.0, std::min(width, 0.5 * pi), width};
  for (int part = 0; part < 2; ++part) {
    const double half = 0.5 * (bounds[part + 1] - bounds[part]);
    if (half <= 0.0) continue;
    const double middle = 0.5 * (bounds[part + 1] + bounds[part]);
    for (int k = -110; k <= 110; ++k) {
      const double t = k * step, inner = 0.5 * pi * std::sinh(t);
      const double weight =
          half * step * 0.5 * pi * std::cosh(t) / (std::cosh(inner) * std::cosh(inner));
      const double phi = middle + half * std::tanh(inner);
      const Section section(r, R, phi);
      const double gamma = width - phi;  // angle to the bisecting plane
      sum.volume += weight * 2.0 * count * section.rho;
      sum.y += weight * 2.0 * sum_cos * std::cos(gamma) * section.rho2;
      sum.xx += weight * (count - sum_cos2 * std::cos(2.0 * gamma)) * section.rho3;
      sum.yy += weight * (count + sum_cos2 * std::cos(2.0 * gamma)) * section.rho3;
      sum.zz += weight * 2.0 * count * section.rho_zz;
    }
  }
}

// Balls that all contain the arc's centre O. Origin: O.
Integrals wedges_about_arc_centre(double r, double R, double theta, int gaps) {
  Integrals sum;
  double sum_cos = 0.0, sum_cos2 = 0.0;
  for (int i = 0; i < gaps; ++i) {
    const double beta = theta * ((i + 0.5) / gaps - 0.5);
    sum_cos += std::cos(beta);
    sum_cos2 += std::cos(2.0 * beta);
  }
  add_wedges(r, R, 0.5 * theta / gaps, gaps, sum_cos, sum_cos2, sum);
  // The bisecting plane between the two ends lies opposite to the arc's middle, at beta = pi.
  add_wedges(r, R, pi - 0.5 * theta, 1, -1.0, 1.0, sum);
  return sum;
}

}  // namespace

UnionMoments union_moments(const ChainShape& shape) {
  const int gaps = sphere_count(shape) - 1;
  const double r = 0.5 * shape.diameter;
  const double theta = shape.curvature_angle;
  const double length = axial_length(shape) - shape.diameter;
  const bool contain_arc_centre = gaps > 0 && length < r * theta;
  const double R = contain_arc_centre ? length / theta : 0.0;
  const Integrals sum = contain_arc_centre ? wedges_about_arc_centre(r, R, theta, gaps)
                                           : balls_less_caps(centreline_points(shape, gaps + 1), r);
  UnionMoments moments;
  const double y = sum.y / sum.volume;
  moments.volume = sum.volume;
  moments.centroid_y = y - R;
  moments.xx = sum.xx;
  moments.yy = sum.yy - sum.volume * y * y;
  moments.zz = sum.zz;
  return moments;
}

}  // namespace rodpack

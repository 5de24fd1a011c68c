// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_SPATIAL_SCENE_H
#define RODPACK_TESTS_SPATIAL_SCENE_H

#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "reading/space/spatial_packing.h"

namespace rodpack::test {

/// Draws unit vectors u with density proportional to exp(kappa u_z^2) over solid angle (Watson's
/// distribution, Maier and Saupe's mean field): u_z by rejection, the azimuth uniform. kappa >= 0;
/// 0: isotropic.
inline std::vector<Vector3> watson_axes(double kappa, int number, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vector3> axes;
  while (static_cast<int>(axes.size()) < number) {
    const double up = 2 * uniform(random) - 1;
    if (uniform(random) > std::exp(kappa * (up * up - 1))) continue;
    const double azimuth = 2 * std::acos(-1.0) * uniform(random);
    const double across = std::sqrt(1 - up * up);
    axes.push_back({across * std::cos(azimuth), across * std::sin(azimuth), up});
  }
  return axes;
}

/// <u_z^2> of Watson's distribution: the integral of t^2 exp(kappa t^2) over [0, 1] by parts, over
/// that of exp(kappa t^2) = exp(kappa) D(sqrt(kappa)) / sqrt(kappa), D Dawson's function, here by
/// its series, the sum of (-2)^k x^(2k+1) / (2k+1)!!.
inline double watson_mean_square(double kappa) {
  const double x = std::sqrt(kappa);
  double dawson = 0, term = x;
  for (int k = 0; k < 200; ++k) {
    dawson += term;
    term *= -2 * x * x / (2 * k + 3);
  }
  return (x / dawson - 1) / (2 * kappa);
}

/// The same vectors with the axes renamed: z becomes y, x z, and y x, in the same order.
inline std::vector<Vector3> with_y_up(std::vector<Vector3> axes) {
  for (auto& u : axes) u = {u[1], u[2], u[0]};
  return axes;
}

/// A frame of the bodies' dump in a box from 0 to `size`, m: rods of AR = 5, d_p = 2 mm.
inline std::string spatial_bodies(const std::vector<Vector3>& centres,
                                  const std::vector<Vector3>& axes, const Vector3& size,
                                  const std::string& flags = "ff ff ff", int spheres = 9) {
  std::ostringstream out;
  out.precision(17);
  out << "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n"
      << centres.size() << "\nITEM: BOX BOUNDS " << flags << '\n';
  for (const double each : size) out << "0 " << each << '\n';
  out << "ITEM: ATOMS id type nspheres x y z angle qw qx qy qz half_length radius curvature area "
         "mass vx vy vz\n";
  for (std::size_t i = 0; i < centres.size(); ++i) {
    // The turn that takes the x axis to u about their common normal; u and -u are one rod.
    auto u = axes[i];
    if (u[0] < 0) u = {-u[0], -u[1], -u[2]};
    const double length = std::sqrt(2 * (1 + u[0]));
    out << i + 1 << " 1 " << spheres;
    for (const double each : centres[i]) out << ' ' << each;
    out << " 0 " << (1 + u[0]) / length << " 0 " << -u[2] / length << ' ' << u[1] / length
        << " 0.005 0.001 0 2e-5 1e-4 0 0 0\n";
  }
  return out.str();
}

/// So many places at random in a box from 0 to `size`.
inline std::vector<Vector3> random_places(const Vector3& size, int number, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Vector3> places;
  for (int i = 0; i < number; ++i) {
    Vector3 place{};
    for (std::size_t c = 0; c < 3; ++c) place[c] = size[c] * uniform(random);
    places.push_back(place);
  }
  return places;
}

}  // namespace rodpack::test

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_PERIODIC_BED_H
#define RODPACK_TESTS_PERIODIC_BED_H

#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "../synthetic_packing.h"
#include "reading/dump.h"

namespace rodpack::test {

/// Rods at random on a floor, periodic in x: places, angles and contacts of each with the next few,
/// with forces that grow with depth. The same bed can be written as it looks after all of it was
/// moved along x and what crossed the border came back in on the other side.
struct PeriodicBed {
  double width = 0.3, height = 0.25, diameter = 3e-3, ratio = 5;
  std::vector<double> x, y, angle;

  explicit PeriodicBed(int number = 600, unsigned seed = 7) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < number; ++i) {
      x.push_back(width * uniform(random));
      y.push_back(height * uniform(random));
      angle.push_back(std::acos(-1.0) * uniform(random));
    }
  }

  double moved(std::size_t i, double shift) const {
    const double place = x[i] + shift;
    return place - width * std::floor(place / width);
  }

  Frame bodies(double shift, const std::filesystem::path& folder) const {
    std::ostringstream rows;
    rows.precision(17);
    const double length = ratio * diameter;
    const double area = length * diameter - (1 - std::acos(-1.0) / 4) * diameter * diameter;
    for (std::size_t i = 0; i < x.size(); ++i)
      rows << i + 1 << ' ' << 1 + i % 2 << " 9 " << moved(i, shift) << ' ' << y[i] << " 0 "
           << angle[i] << ' ' << 0.1 * std::sin(13.0 * i) << ' ' << 0.1 * std::cos(7.0 * i)
           << " 0 0 0 0 1 0 0 0 " << length / 2 << ' ' << diameter / 2 << " 0 " << area
           << " 2e-4\n";
    return written(folder / "bodies.7.dump",
                   frame_head(7, x.size(), width, 1,
                              "id type nspheres x y z angle vx vy vz omegax omegay omegaz qw qx qy "
                              "qz half_length radius curvature area mass",
                              "pp ff pp") +
                       rows.str());
  }

  /// Each body with those within a particle's length, the nearer image.
  Frame contacts(double shift, const std::filesystem::path& folder) const {
    std::ostringstream rows;
    rows.precision(17);
    std::size_t count = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = i + 1; j < x.size(); ++j) {
        const double dx = std::remainder(x[j] - x[i], width), dy = y[j] - y[i];
        const double distance = std::hypot(dx, dy);
        if (distance > ratio * diameter / 2 || distance < diameter / 10) continue;
        const double force = 1e-3 * (1 + 20 * (height - y[i])), at = moved(i, shift);
        const double nx = -dx / distance, ny = -dy / distance;
        ++count;
        rows << i + 1 << ' ' << j + 1 << ' ' << i + 1 << ' ' << j + 1 << " 0 " << at + dx / 2 << ' '
             << y[i] + dy / 2 << " 0 " << force * nx - 0.1 * force * ny << ' '
             << force * ny + 0.1 * force * nx << " 0 " << at << ' ' << y[i] << " 0 " << at + dx
             << ' ' << y[j] << " 0 1e-6 1e-7 " << nx << ' ' << ny << " 0\n";
      }
    return written(folder / "contacts.7.dump",
                   frame_head(7, count, width, 1,
                              "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx "
                              "bjy bjz overlap_n overlap_t nx ny nz",
                              "pp ff pp") +
                       rows.str());
  }

 private:
  static Frame written(const std::filesystem::path& file, const std::string& text) {
    return last_frame({put(file, text)});
  }
};

}  // namespace rodpack::test

#endif

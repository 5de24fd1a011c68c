// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_SYNTHETIC_PACKING_H
#define RODPACK_TESTS_SYNTHETIC_PACKING_H

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "rodpack/geometry/chain_geometry.h"

namespace rodpack::test {

/// Writes `text` into a file, making its folder.
inline std::string put(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file.string();
}

/// Head of a dump's frame up to the names of its columns.
inline std::string frame_head(long timestep, std::size_t rows, double width, double height,
                              const std::string& columns, const std::string& flags = "ff ff pp") {
  std::ostringstream out;
  const bool contacts = columns.rfind("body_i", 0) == 0;
  out << "ITEM: TIMESTEP\n"
      << timestep << "\nITEM: NUMBER OF " << (contacts ? "ENTRIES" : "ATOMS") << '\n'
      << rows << "\nITEM: BOX BOUNDS " << flags << "\n0 " << width << "\n0 " << height
      << "\n-0.01 0.01\nITEM: " << (contacts ? "ENTRIES " : "ATOMS ") << columns << '\n';
  return out.str();
}

/// A made-up packing: the container is tiled with squares of one axial length; the particles of a
/// square lie side by side, flat (60 %), upright, or tilted by a few degrees. Forces are
/// exponentially distributed with a mean that grows with depth. It looks like a packing and has its
/// files, but no mechanics.
struct SyntheticPacking {
  ChainShape shape{5, 3e-3, 0.5, 0, 3e-3};
  double width = 0.3;   // of the container, m
  double height = 0.3;  // of the bed, m
  unsigned seed = 1;

  std::string bodies, spheres, contacts;  // the frames' rows
  std::size_t body_count = 0, sphere_count = 0, contact_count = 0;

  void fill() {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const double length = axial_length(shape);
    const double degree = std::acos(-1.0) / 180;
    const auto local = sphere_centres(shape);
    const double area = covered_area(shape);
    const int per_square = static_cast<int>(length / shape.diameter);
    std::ostringstream body_rows, sphere_rows, contact_rows;
    body_rows.precision(15);
    sphere_rows.precision(15);
    contact_rows.precision(15);
    for (int row = 0; (row + 1) * length <= height; ++row)
      for (int column = 0; (column + 1) * length <= width; ++column) {
        const bool flat = uniform(random) < 0.6;
        const bool flipped = uniform(random) < 0.4;
        const double tilt = (uniform(random) - 0.5) * 12;
        const double angle = ((flat ? 0 : 90) + (flipped ? 180 : 0) + tilt + 360) * degree;
        const double c = std::cos(angle), s = std::sin(angle);
        for (int k = 0; k < per_square; ++k) {
          const double offset = (k + 0.5) * shape.diameter - length / 2;
          const double x = (column + 0.5) * length - offset * s;
          const double y = (row + 0.5) * length + offset * c;
          ++body_count;
          const std::size_t first = sphere_count + 1;
          for (const auto& centre : local) {
            const double load = -std::log(1 - uniform(random)) * (1 + 20 * (height - y));
            ++sphere_count;
            sphere_rows << sphere_count << ' ' << body_count << " 1 "
                        << x + c * centre[0] - s * centre[1] << ' '
                        << y + s * centre[0] + c * centre[1] << " 0 " << shape.diameter / 2 << ' '
                        << 1e-3 * load << ' ' << -2e-3 * load << " 0 " << 5e-3 * load << '\n';
          }
          body_rows << body_count << " 1 " << local.size() << ' ' << x << ' ' << y << " 0 " << angle
                    << " 0 0 0 0 0 0 1 0 0 0 " << length / 2 << ' ' << shape.diameter / 2 << ' '
                    << shape.curvature_angle << ' ' << area << " 2.3e-4\n";
          if (k > 0) {  // touches the neighbour before it in the square
            ++contact_count;
            const double dx = s * shape.diameter, dy = -c * shape.diameter;
            contact_rows << body_count << ' ' << body_count - 1 << ' ' << first << ' '
                         << first - local.size() << " 0 " << x + dx / 2 << ' ' << y + dy / 2
                         << " 0 " << -1e-3 * dx << ' ' << -1e-3 * dy << " 0 " << x << ' ' << y
                         << " 0 " << x + dx << ' ' << y + dy << " 0 1e-6 2e-7 " << -s << ' ' << c
                         << " 0\n";
          }
        }
      }
    bodies = body_rows.str();
    spheres = sphere_rows.str();
    contacts = contact_rows.str();
  }

  std::string bodies_frame(long timestep) const {
    return frame_head(timestep, body_count, width, 2,
                      "id type nspheres x y z angle vx vy vz omegax omegay omegaz qw qx qy qz "
                      "half_length radius curvature area mass") +
           bodies;
  }
  std::string spheres_frame(long timestep) const {
    return frame_head(timestep, sphere_count, width, 2, "id body type x y z radius fx fy fz fsum") +
           spheres;
  }
  std::string contacts_frame(long timestep) const {
    return frame_head(timestep, contact_count, width, 2,
                      "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz "
                      "overlap_n overlap_t nx ny nz") +
           contacts;
  }

  /// A whole run folder as the deposition deck leaves it, frames at steps 1000 and 2000.
  void write_run(const std::filesystem::path& folder) const {
    std::ostringstream parameters, energies;
    parameters << "{\"format\": \"rodpack-run 1\", \"aspect_ratio\": " << shape.aspect_ratio
               << ", \"particle_diameter_m\": " << shape.nominal_diameter
               << ", \"container_width_m\": " << width
               << ", \"timestep_s\": 1.1e-5, \"friction\": 0.3}\n";
    put(folder / "parameters.json", parameters.str());
    energies << "step,time_s,particles,kinetic_translational_J,kinetic_rotational_J,"
                "elastic_normal_J,elastic_tangential_J,kinetic_over_elastic\n";
    for (int k = 0; k <= 100; ++k) {
      const double kinetic = 1e-2 * std::exp(-0.15 * k), elastic = 1e-4 * (1 - std::exp(-0.1 * k));
      energies << 1000 * k << ',' << 0.011 * k << ',' << body_count << ',' << 0.8 * kinetic << ','
               << 0.2 * kinetic << ',' << 0.9 * elastic << ',' << 0.1 * elastic << ','
               << (k > 0 ? kinetic / elastic : 0) << '\n';
    }
    put(folder / "energies.csv", energies.str());
    for (const long step : {1000L, 2000L}) {
      const auto name = "." + std::to_string(step) + ".dump";
      put(folder / "dumps" / ("bodies" + name), bodies_frame(step));
      put(folder / "dumps" / ("spheres" + name), spheres_frame(step));
      put(folder / "dumps" / ("contacts" + name), contacts_frame(step));
    }
  }
};

}  // namespace rodpack::test

#endif

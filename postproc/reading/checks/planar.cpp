// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/planar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reading/number_text.h"

namespace rodpack {
namespace {

std::string at_row(const Frame& frame, std::size_t row) {
  return frame.file + ":" + std::to_string(frame.header_line + 1 + static_cast<long>(row)) + ": ";
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How far the ends of each rod's axis are above or below its centre, m; 0 for spheres.
std::vector<double> rise_of_ends(const Frame& bodies) {
  std::vector<double> rise(bodies.rows, 0);
  for (const char* name : {"qw", "qx", "qy", "qz"})
    if (!bodies.has(name)) return rise;
  const auto &w = bodies.column("qw"), &x = bodies.column("qx"), &y = bodies.column("qy"),
             &z = bodies.column("qz");
  const auto& count = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto& curvature = bodies.column("curvature");
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    if (count[i] <= 1) continue;
    const double square = w[i] * w[i] + x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
    if (!(std::abs(square - 1) < 1e-2))  // a dump may print few digits
      throw DataError(at_row(bodies, i) +
                      "columns 'qw qx qy qz': expected a unit quaternion, found one of length " +
                      number_text(std::sqrt(square), 6));
    // z components of the body's x axis, its chord, and of its y axis, towards which it may bend.
    const double along = 2 * (x[i] * z[i] - w[i] * y[i]) / square;
    const double across = curvature[i] > 0 ? 2 * (y[i] * z[i] + w[i] * x[i]) / square : 0;
    rise[i] = std::max(0.0, half_length[i] - radius[i]) * std::hypot(along, across);
  }
  return rise;
}

void require_plane(const Frame& frame, const std::vector<double>& rise, double particle_diameter,
                   const std::string& what) {
  if (!frame.has("z") || frame.rows == 0) return;
  const auto& z = frame.column("z");
  const double plane = median(z);
  for (std::size_t i = 0; i < frame.rows; ++i) {
    const double off = std::abs(z[i] - plane) + rise[i];
    if (!(off <= planar_tolerance * particle_diameter))
      throw DataError(at_row(frame, i) + "expected a planar packing (all within " +
                      number_text(planar_tolerance) + " d_p of one plane z = constant), found " +
                      what + " that reaches " + number_text(off / particle_diameter, 3) +
                      " d_p out of the plane z = " + number_text(plane, 4) + " m");
  }
}

}  // namespace

void require_planar_bodies(const Frame& bodies, double particle_diameter) {
  require_plane(bodies, rise_of_ends(bodies), particle_diameter, "a particle");
}

void require_planar_spheres(const Frame& spheres, double particle_diameter) {
  require_plane(spheres, std::vector<double>(spheres.rows, 0), particle_diameter, "a sphere");
}

std::string why_contacts_not_planar(const Frame& contacts) {
  constexpr double steepest = 0.2;  // of two spheres that are each planar_tolerance off the plane
  if (!contacts.has("nz")) return "";
  const auto& nz = contacts.column("nz");
  for (std::size_t i = 0; i < contacts.rows; ++i)
    if (!(std::abs(nz[i]) <= steepest))
      return at_row(contacts, i) + "column 'nz': expected contacts of a planar packing (" +
             number_text(-steepest) + " to " + number_text(steepest) + "), found " +
             number_text(nz[i], 4);
  return "";
}

void require_planar_contacts(const Frame& contacts) {
  const auto reason = why_contacts_not_planar(contacts);
  if (!reason.empty()) throw DataError(reason);
}

}  // namespace rodpack

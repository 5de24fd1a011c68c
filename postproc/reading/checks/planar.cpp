// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/planar.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reading/checks/body_axes.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

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
  const BodyAxes axes(bodies);
  const auto& count = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto& curvature = bodies.column("curvature");
  for (std::size_t i = 0; i < bodies.rows; ++i) {
    if (count[i] <= 1) continue;
    const double along = axes.axis(i, 0)[2];
    const double across = curvature[i] > 0 ? axes.axis(i, 1)[2] : 0;
    rise[i] = std::max(0.0, half_length[i] - radius[i]) * std::hypot(along, across);
  }
  return rise;
}

std::string why_not_in_plane(const Frame& frame, const std::vector<double>& rise,
                             double particle_diameter, const std::string& what) {
  if (!frame.has("z") || frame.rows == 0) return "";
  const auto& z = frame.column("z");
  const double plane = median(z);
  for (std::size_t i = 0; i < frame.rows; ++i) {
    const double off = std::abs(z[i] - plane) + rise[i];
    if (!(off <= planar_tolerance * particle_diameter))
      return at_row(frame, i) + "expected a planar packing (all within " +
             number_text(planar_tolerance) + " d_p of one plane z = constant), found " + what +
             " that reaches " + number_text(off / particle_diameter, 3) +
             " d_p out of the plane z = " + number_text(plane, 4) + " m";
  }
  return "";
}

void refuse(const std::string& reason) {
  if (!reason.empty()) throw DataError(reason);
}

}  // namespace

std::string why_bodies_not_planar(const Frame& bodies, double particle_diameter) {
  return why_not_in_plane(bodies, rise_of_ends(bodies), particle_diameter, "a particle");
}

void require_planar_bodies(const Frame& bodies, double particle_diameter) {
  refuse(why_bodies_not_planar(bodies, particle_diameter));
}

std::string why_spheres_not_planar(const Frame& spheres, double particle_diameter) {
  return why_not_in_plane(spheres, std::vector<double>(spheres.rows, 0), particle_diameter,
                          "a sphere");
}

void require_planar_spheres(const Frame& spheres, double particle_diameter) {
  refuse(why_spheres_not_planar(spheres, particle_diameter));
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

void require_planar_contacts(const Frame& contacts) { refuse(why_contacts_not_planar(contacts)); }

}  // namespace rodpack

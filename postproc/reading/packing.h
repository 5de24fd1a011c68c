// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_PACKING_H
#define RODPACK_READING_PACKING_H

#include <optional>
#include <string>
#include <vector>

#include "reading/dump.h"
#include "reading/parameters.h"

namespace rodpack {

/// The container. The top is open.
struct Walls {
  double left = 0;                 // x of the left wall, m
  double right = 0;                // x of the right wall, m
  double floor = 0;                // y of the floor, m
  bool sides = true;               // false: periodic in x with period right - left
  bool bottom = true;              // false: periodic in y with period ceiling - floor, no floor
  double ceiling = 0;              // y of the period's end; nothing without one
  std::string source;              // where the numbers come from, for reports
  std::vector<std::string> notes;  // what of the scene is no wall of the container, and why
  /// Distance of the side walls, or the period in x, m.
  double width() const { return right - left; }
};

/// What the user states on the command line; everything left out is looked up.
struct PackingOptions {
  std::vector<double> walls;                // empty, or left, right, floor, m
  std::optional<double> particle_diameter;  // d_p, m
  std::optional<double> aspect_ratio;       // AR
  std::string parameters;                   // parameters.json, if not beside the dump
  bool out_of_plane_too = false;            // bodies that have left the plane count as well
};

/// One frame of the bodies' dump, ready to be measured. Vectors hold one entry per particle.
struct Packing {
  long timestep = 0;
  std::vector<double> x, y;       // centre of mass, m
  std::vector<double> angle;      // direction of the body's x axis (its chord), rad
  std::vector<double> curvature;  // arc angle theta, rad; 0 straight
  std::vector<double> area;       // covered area, m^2
  std::vector<bool> elongated;    // false for a plain sphere: it has no axis
  Walls walls;
  double particle_diameter = 0;  // d_p, m
  double aspect_ratio = 1;       // AR = l_axial / d_p
  double surface = 0;  // y of the bed's surface, m, see bed_surface(); without a floor the ceiling
  double inclination = 0;  // of gravity against -y, towards +x: inclination_deg, rad

  /// Number of particles.
  std::size_t size() const { return x.size(); }
  /// l_axial = AR d_p, m.
  double axial_length() const { return aspect_ratio * particle_diameter; }
};

/// Finds the walls: the options, else the run's scene (find_scene(), walls_of_scene()), else
/// container_width_m of parameters.json (walls x = 0 and x = width, floor y = 0), else the box
/// bounds of the dump. A direction that is periodic in the dump has no walls.
/// @throws DataError when the right wall is not beyond the left one, or a period in x is not the
///   dump's; as find_scene().
Walls find_walls(const Frame& frame, const PackingOptions& options,
                 const std::optional<RunParameters>& parameters);

/// Reads a frame with the columns `nspheres x y angle half_length radius curvature area`.
/// Walls as in find_walls(); parameters.json is looked for beside the dump and one folder up. d_p
/// and AR: the options, else parameters.json, else the mean 2 radius and the longest particle.
/// @throws DataError when a column is missing, the frame empty, a length not positive, d_p not that
///   of the spheres by a factor of 10, or as require_planar_bodies() and require_inside_walls().
Packing read_packing(const Frame& frame, const PackingOptions& options = {});

/// What has to be said of angles and depths where gravity is not along -y; empty where it is.
std::string note_on_slope(const Packing& packing);

/// Returns d_p of a frame of bodies or spheres (column `radius`), m: the options, else
/// parameters.json, else the mean 2 radius.
double sphere_diameter(const Frame& frame, const PackingOptions& options);

/// Returns y of the bed's surface, m: where the solid fraction of horizontal layers, 2 d_p or half
/// an axial length thick, falls through half of its bulk value (the area-weighted median over the
/// layers). Particles that still fall above the bed do not count, and an uneven surface gives its
/// mean level. @throws DataError when there would be more than 1e5 layers. `y`: of the centres of
/// mass, m; `area`: covered by each particle, m^2; `floor`, `width` and `layer`, the thickness of a
/// layer: m.
double bed_surface(const std::vector<double>& y, const std::vector<double>& area, double floor,
                   double width, double layer);

}  // namespace rodpack

#endif

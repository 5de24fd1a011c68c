// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_SPACE_SPATIAL_PACKING_H
#define RODPACK_READING_SPACE_SPATIAL_PACKING_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reading/checks/body_axes.h"
#include "reading/packing.h"
#include "rodpack/geometry/upright_container.h"

namespace rodpack {

/// What the user states about a scene in space, beside PackingOptions; everything left out is
/// looked up.
struct SpaceOptions {
  std::string vertical;           // axis that points up, x, y or z; empty: parameters.json
  std::vector<double> container;  // empty, or x, y, z of its walls, lower before upper, m
  std::vector<double> cylinder;   // empty, or the two horizontal coordinates of its axis, radius, m
};

/// The container in space, whose top is open: the box, along a periodic axis from end to end of a
/// period, and a cylinder within it if the side wall is round.
struct SpatialWalls : UprightContainer {
  std::array<bool, 3> periodic{};  // an axis without walls
  std::string source;              // where the numbers come from, for reports
  std::vector<std::string> notes;  // what of the scene is no wall of the container, and why

  /// Distance to the nearest side wall, negative beyond it; infinite without one. m.
  double distance_to_sides(const Vector3& place) const;
  /// Height above the floor; infinite without one. m.
  double height(const Vector3& place) const;
};

/// One frame of the bodies' dump in space, ready to be measured. Vectors hold one entry per
/// particle.
struct SpatialPacking {
  long timestep = 0;
  std::vector<Vector3> centre;  // of mass, m
  std::vector<Vector3> axis;    // the body's x axis (its chord), a unit vector
  std::vector<bool> elongated;  // false for a plain sphere: it has no axis
  SpatialWalls walls;
  double particle_diameter = 0;  // d_p, m
  double aspect_ratio = 1;       // AR = l_axial / d_p
  double surface = 0;            // of the bed, along the vertical, m; see bed_surface()

  /// Number of particles.
  std::size_t size() const { return centre.size(); }
  /// l_axial = AR d_p, m.
  double axial_length() const { return aspect_ratio * particle_diameter; }
};

/// Returns the axis that points up, 0 to 2, as SpaceOptions::vertical says, else the run's scene
/// (find_scene()), else `vertical_axis` of parameters.json (as find_parameters() finds it); none
/// where nobody says so. @throws DataError when it is none of x, y, z; as RunScene::vertical().
std::optional<std::size_t> find_vertical(const Frame& frame, const std::string& parameters,
                                         const SpaceOptions& space);

/// Whether the frame of bodies or of spheres is a scene in space: particles off their common plane
/// z = constant, or a vertical other than y. @throws DataError when particles are off their plane
/// and nobody says which axis is the vertical one (SpaceOptions::vertical, `vertical_axis` of
/// parameters.json).
bool is_in_space(const Frame& frame, const PackingOptions& options, const SpaceOptions& space);

/// Finds the container of a frame in space: the options, else the run's scene
/// (spatial_walls_of_scene()), else `container` ("box" or "cylinder", from 0 to container_width_m,
/// floor at 0) of parameters.json, else the box bounds of the dump.
/// @throws DataError when the vertical is unknown, or walls contradict each other or a period.
SpatialWalls read_spatial_walls(const Frame& frame, const PackingOptions& options,
                                const SpaceOptions& space);

/// Reads a frame with the columns `nspheres x y z qw qx qy qz half_length radius mass`. Walls: as
/// read_spatial_walls(); d_p and AR as in particle_sizes().
/// @throws DataError as read_spatial_walls(), when a column is missing, the frame is empty, the
///   container has no room for a particle, or as particle_sizes() and require_inside_walls().
SpatialPacking read_spatial_packing(const Frame& bodies, const PackingOptions& options,
                                    const SpaceOptions& space);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_SPACE_SPATIAL_PACKING_H
#define RODPACK_READING_SPACE_SPATIAL_PACKING_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reading/checks/body_axes.h"
#include "reading/packing.h"

namespace rodpack {

/// What the user states about a scene in space, beside PackingOptions; everything left out is
/// looked up.
struct SpaceOptions {
  std::string vertical;           // axis that points up, x, y or z; empty: parameters.json
  std::vector<double> container;  // empty, or x, y, z of its walls, lower before upper, m
  std::vector<double> cylinder;   // empty, or the two horizontal coordinates of its axis, radius, m
};

/// The container in space, a box or an upright cylinder. The top is open.
struct SpatialWalls {
  std::size_t vertical = 2;        // axis that points up, 0 to 2
  Vector3 low{}, high{};           // of the box; along a periodic axis the ends of a period, m
  std::array<bool, 3> periodic{};  // an axis without walls
  bool round = false;              // the side wall is a cylinder, within the box
  double radius = 0;               // of the cylinder, m
  std::array<double, 2> middle{};  // its axis along the axes horizontal(0) and horizontal(1), m
  std::string source;              // where the numbers come from, for reports
  std::vector<std::string> notes;  // what of the scene is no wall of the container, and why

  /// The two horizontal axes, in the order x, y, z, x after the vertical one.
  std::size_t horizontal(std::size_t which) const { return (vertical + 1 + which) % 3; }
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

/// Whether the frame of bodies is a scene in space: particles off their common plane z = constant,
/// or a vertical other than y. @throws DataError when particles are off their plane and nobody says
/// which axis is the vertical one (SpaceOptions::vertical, `vertical_axis` of parameters.json).
bool is_in_space(const Frame& bodies, const PackingOptions& options, const SpaceOptions& space);

/// Reads a frame with the columns `nspheres x y z qw qx qy qz half_length radius mass`. Walls: the
/// options, else the run's scene (spatial_walls_of_scene()), else `container` ("box" or "cylinder",
/// from 0 to container_width_m, floor at 0) of parameters.json, else the box bounds of the dump;
/// d_p and AR as in particle_sizes().
/// @throws DataError when the vertical is unknown, a column is missing, the frame is empty, the
///   container has no room for a particle, or as particle_sizes().
SpatialPacking read_spatial_packing(const Frame& bodies, const PackingOptions& options,
                                    const SpaceOptions& space);

}  // namespace rodpack

#endif

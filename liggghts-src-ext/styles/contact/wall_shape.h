// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_WALL_SHAPE_H
#define RODPACK_WALL_SHAPE_H

namespace LAMMPS_NS {

class FixWallGran;

/// What a primitive wall of LIGGGHTS is: an endless plane across an axis, or a cylinder along one.
struct WallShape {
  enum class Kind { none, plane, cylinder };
  Kind kind = Kind::none;  // none: a mesh wall
  int axis = 0;            // 0 to 2: normal of the plane, axis of the cylinder
  double position = 0;     // of the plane along its axis
  int free_side = 0;       // of the plane: where the particles may be, 1 or -1; 0: on both sides
  double middle[3] = {0, 0, 0};  // a point of the cylinder's axis, 0 along it
  double radius = 0;
};

/// Finds the shape of a wall, as its contacts have it.
WallShape shape_of(FixWallGran& wall);

}  // namespace LAMMPS_NS

#endif

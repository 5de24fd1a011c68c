// SPDX-License-Identifier: GPL-2.0-or-later
#include "wall_shape.h"

#include <utility>

#include "fix_wall_gran.h"
#include "fix_wall_gran_solid.h"
#include "primitive_wall.h"

namespace LAMMPS_NS {

namespace {

// LIGGGHTS keeps a wall's numbers to itself, but answers where a point is from it.

void find_plane(PrimitiveWall& wall, WallShape& shape) {
  // A point on the plane would have no distance, so that two points tell the normal.
  double origin[3] = {0.0, 0.0, 0.0}, other[3] = {1.1, 2.3, 4.7};
  double from[3] = {}, to[3] = {};
  wall.resolveContact(origin, 0.0, from);
  wall.resolveContact(other, 0.0, to);
  for (int axis = 0; axis < 3; ++axis)
    if (from[axis] != 0.0 || to[axis] != 0.0) shape.axis = axis;
  shape.kind = WallShape::Kind::plane;
  shape.position = from[shape.axis];
}

void find_cylinder(PrimitiveWall& wall, WallShape& shape) {
  shape.kind = WallShape::Kind::cylinder;
  shape.axis = wall.axis();
  double origin[3] = {0.0, 0.0, 0.0}, off[3] = {};
  wall.calcRadialDistance(origin, off);
  // Along y it hands out the distances of z and x in each other's place.
  if (shape.axis == 1) std::swap(off[0], off[2]);
  for (int d = 0; d < 3; ++d)
    if (d != shape.axis) shape.middle[d] = -off[d];
  // On the axis itself no direction leads to the wall.
  double beside[3] = {shape.middle[0], shape.middle[1], shape.middle[2]}, to_wall[3] = {};
  const int across = (shape.axis + 1) % 3;
  beside[across] += 1e-3;
  const double distance = wall.calcRadialDistance(beside, off);
  wall.resolveContact(beside, 0.0, to_wall);
  shape.radius = distance + to_wall[across];
}

}  // namespace

WallShape shape_of(FixWallGran& wall) {
  WallShape shape;
  if (const FixWallGranSolid* solid = dynamic_cast<FixWallGranSolid*>(&wall)) {
    shape.kind = WallShape::Kind::plane;
    shape.axis = solid->axis();
    shape.position = solid->position();
    shape.free_side = solid->free_side();
    return shape;
  }
  if (wall.is_mesh_wall() || !wall.primitiveWall()) return shape;
  PrimitiveWall& primitive = *wall.primitiveWall();
  if (primitive.axis() < 0)
    find_plane(primitive, shape);
  else
    find_cylinder(primitive, shape);
  return shape;
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_CAMERA_H
#define RODPACK_FIGURES_SPACE_CAMERA_H

#include <array>
#include <cstddef>

#include "reading/checks/body_axes.h"

namespace rodpack {

/// A place seen by a camera, in the unit of the scene: to the right, up, and into the picture.
using SeenPlace = Vector3;

/// A pinhole camera; in perspective, a place is drawn at right / depth and up / depth.
class Camera {
 public:
  /// Looks at `target` from a distance, in the direction that azimuth and elevation (degrees) say:
  /// azimuth about the coordinate axis `vertical` (0 to 2), from the next axis in the order x, y,
  /// z, x towards the one after; elevation above the horizontal, within +-90, not those.
  Camera(const Vector3& target, double distance, double azimuth, double elevation,
         std::size_t vertical);
  SeenPlace see(const Vector3& place) const;
  /// A direction in the camera's frame.
  SeenPlace turn(const Vector3& direction) const;

 private:
  Vector3 eye_{}, right_{}, up_{}, forward_{};
};

/// The part of the plane at depth 1 that a picture shows.
class Frustum {
 public:
  /// Widens it so that a ball shows wholly; it has to lie in front of the camera.
  void include(const SeenPlace& centre, double radius);
  /// Adds so much of the larger extent on every side.
  void widen(double share);
  double left = 0, right = 0, bottom = 0, top = 0;

 private:
  bool empty_ = true;
};

}  // namespace rodpack

#endif

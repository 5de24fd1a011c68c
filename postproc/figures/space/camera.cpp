// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/camera.h"

#include <algorithm>
#include <cmath>

#include "reading/angles.h"
#include "rodpack/geometry/vector3.h"

namespace rodpack {

Camera::Camera(const Vector3& target, double distance, double azimuth, double elevation,
               std::size_t vertical) {
  const auto first = (vertical + 1) % 3, second = (vertical + 2) % 3;
  const double level = std::cos(elevation * degree);
  Vector3 back{};  // from the target to the eye
  back[vertical] = std::sin(elevation * degree);
  back[first] = level * std::cos(azimuth * degree);
  back[second] = level * std::sin(azimuth * degree);
  for (std::size_t c = 0; c < 3; ++c) {
    eye_[c] = target[c] + distance * back[c];
    forward_[c] = -back[c];
  }
  right_[first] = -std::sin(azimuth * degree);
  right_[second] = std::cos(azimuth * degree);
  cross(right_.data(), forward_.data(), up_.data());
}

SeenPlace Camera::see(const Vector3& place) const {
  return turn({place[0] - eye_[0], place[1] - eye_[1], place[2] - eye_[2]});
}

SeenPlace Camera::turn(const Vector3& direction) const {
  const double* d = direction.data();
  return {dot(d, right_.data()), dot(d, up_.data()), dot(d, forward_.data())};
}

// The lines of sight that touch a ball, in the plane through one axis of the picture: those at the
// angle asin(radius / distance) from its centre's, distance and angle in that plane.
void Frustum::include(const SeenPlace& centre, double radius) {
  const auto ends = [&](double off) {
    const double middle = std::atan2(off, centre[2]);
    const double half = std::asin(std::min(1.0, radius / std::hypot(off, centre[2])));
    return std::array<double, 2>{std::tan(middle - half), std::tan(middle + half)};
  };
  const auto across = ends(centre[0]), along = ends(centre[1]);
  left = empty_ ? across[0] : std::min(left, across[0]);
  right = empty_ ? across[1] : std::max(right, across[1]);
  bottom = empty_ ? along[0] : std::min(bottom, along[0]);
  top = empty_ ? along[1] : std::max(top, along[1]);
  empty_ = false;
}

void Frustum::widen(double share) {
  const double edge = share * std::max(right - left, top - bottom);
  left -= edge;
  right += edge;
  bottom -= edge;
  top += edge;
}

}  // namespace rodpack

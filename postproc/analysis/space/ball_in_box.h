// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_BALL_IN_BOX_H
#define RODPACK_ANALYSIS_SPACE_BALL_IN_BOX_H

#include "reading/checks/body_axes.h"

namespace rodpack {

/// Corners of an upright box; infinite where it has no side.
struct Box {
  Vector3 low, high;
  bool contains(const Vector3& place) const {
    for (std::size_t c = 0; c < 3; ++c)
      if (place[c] < low[c] || place[c] > high[c]) return false;
    return true;
  }
  double volume() const { return (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]); }
};

/// Returns the volume of the part of a ball of radius r around `centre` that lies in the box; the
/// centre may be outside. In closed form: the divergence theorem gives a third of r times the
/// spherical surface, by Gauss and Bonnet, less the distances times the areas of the plane faces.
double ball_volume_inside(const Box& box, const Vector3& centre, double r);

}  // namespace rodpack

#endif

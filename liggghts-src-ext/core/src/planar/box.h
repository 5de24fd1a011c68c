// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BOX_H
#define RODPACK_PLANAR_BOX_H

namespace rodpack {

struct PlanarSphere;

/// The rectangle that holds the centres of a body's spheres and lies along the line from the first
/// to the last, in the frame of the body.
struct PlanarBox {
  double x, y;                     // of its middle, m
  double cosine, sine;             // of the direction of its length
  double half_length, half_width;  // m
};
PlanarBox box_of(const PlanarSphere* spheres, int count);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_PLANAR_JUMP_H
#define RODPACK_CONTACT_PLANAR_JUMP_H

#include <cstddef>

namespace rodpack {

/// By how much the motion of a body has changed in the last step because forces jumped, as seen at
/// the end of that step. Vectors of the plane: x, y and rotation about z.
struct alignas(16) PlanarJump {
  double acceleration[3], velocity[3], displacement[3];
  double cosine, sine;  // orientation of the body then
};
static_assert(offsetof(PlanarJump, acceleration) == 0 && offsetof(PlanarJump, velocity) == 24 &&
                  offsetof(PlanarJump, displacement) == 48 && offsetof(PlanarJump, cosine) == 72 &&
                  offsetof(PlanarJump, sine) == 80 && sizeof(PlanarJump) == 96,
              "kernel_jumps.h reads jumps four doubles at a time, in this order");

}  // namespace rodpack

#endif

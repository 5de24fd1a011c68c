// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_KINEMATICS_H
#define RODPACK_PLANAR_KINEMATICS_H

#include <cstddef>

namespace rodpack {

/// Position, orientation and velocity of a body, as contacts see it; one cache line.
struct alignas(64) PlanarKinematics {
  double x, y, cosine, sine;
  double velocity[3];  // x, y, about z
  double radius;       // of its spheres, m
};
// Registers take these numbers two or four at a time, by their places.
static_assert(offsetof(PlanarKinematics, x) == 0 && offsetof(PlanarKinematics, y) == 8 &&
                  offsetof(PlanarKinematics, cosine) == 16 &&
                  offsetof(PlanarKinematics, sine) == 24 &&
                  offsetof(PlanarKinematics, velocity) == 32 &&
                  offsetof(PlanarKinematics, radius) == 56 && sizeof(PlanarKinematics) == 64,
              "kernel.h and kernel_motion.h read kinematics as eight doubles in this order");

}  // namespace rodpack

#endif

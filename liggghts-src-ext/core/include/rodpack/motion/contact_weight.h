// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_CONTACT_WEIGHT_H
#define RODPACK_MOTION_CONTACT_WEIGHT_H

namespace rodpack {

/// Weight of a contact of a body in planar motion with a sphere of its (mass_scaling.h): base +
/// per_square times the square of the distance of the sphere's centre from the centre of mass, m.
/// Data alone, aligned to be read into a register: the SIMD loops have it too.
struct alignas(16) ContactWeight {
  double base, per_square;
};

}  // namespace rodpack

#endif

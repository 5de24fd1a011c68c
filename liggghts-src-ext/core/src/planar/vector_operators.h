// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_VECTOR_OPERATORS_H
#define RODPACK_PLANAR_VECTOR_OPERATORS_H

#include "../planar_simd/arguments.h"

namespace rodpack {

// Arithmetic with planar vectors, component by component: the compiler takes one register for the
// four. Not in arguments.h, which says why.

inline PlanarVector operator+(const PlanarVector& a, const PlanarVector& b) {
  return {{a.d[0] + b.d[0], a.d[1] + b.d[1], a.d[2] + b.d[2], a.d[3] + b.d[3]}};
}
inline PlanarVector operator-(const PlanarVector& a, const PlanarVector& b) {
  return {{a.d[0] - b.d[0], a.d[1] - b.d[1], a.d[2] - b.d[2], a.d[3] - b.d[3]}};
}
inline PlanarVector operator*(const PlanarVector& a, const PlanarVector& b) {
  return {{a.d[0] * b.d[0], a.d[1] * b.d[1], a.d[2] * b.d[2], a.d[3] * b.d[3]}};
}
inline PlanarVector operator*(double a, const PlanarVector& b) {
  return {{a * b.d[0], a * b.d[1], a * b.d[2], a * b.d[3]}};
}

}  // namespace rodpack

#endif

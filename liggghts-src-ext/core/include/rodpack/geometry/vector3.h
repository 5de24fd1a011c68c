// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_VECTOR3_H
#define RODPACK_GEOMETRY_VECTOR3_H

namespace rodpack {

// Plain arrays of three doubles, as LIGGGHTS keeps them.

inline double dot(const double* a, const double* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Sets result = a x b; it must not be a or b itself.
inline void cross(const double* a, const double* b, double* result) {
  result[0] = a[1] * b[2] - a[2] * b[1];
  result[1] = a[2] * b[0] - a[0] * b[2];
  result[2] = a[0] * b[1] - a[1] * b[0];
}

/// Velocity (or its change, or a small displacement) of the point at `lever` of a body whose centre
/// has `centre` and that turns at `spin`.
inline void velocity_at(const double* centre, const double* spin, const double* lever,
                        double* result) {
  cross(spin, lever, result);
  for (int d = 0; d < 3; ++d) result[d] += centre[d];
}

}  // namespace rodpack

#endif

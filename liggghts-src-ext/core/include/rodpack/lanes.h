// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_LANES_H
#define RODPACK_LANES_H

#include <cmath>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace rodpack {

// Four doubles at a time, by the vector types of GCC and Clang: arithmetic, comparisons and ?: act
// per lane. Without AVX the compiler splits them into what the processor has.
typedef double Lanes __attribute__((vector_size(32)));
typedef long long LaneMask __attribute__((vector_size(32)));  // all bits set: true

inline Lanes load_lanes(const double* values) { return *reinterpret_cast<const Lanes*>(values); }
inline void store_lanes(double* values, Lanes x) { *reinterpret_cast<Lanes*>(values) = x; }
inline Lanes all_lanes(double x) { return Lanes{x, x, x, x}; }

inline Lanes lane_sqrt(Lanes x) {
#ifdef __AVX__
  return (Lanes)_mm256_sqrt_pd((__m256d)x);
#else
  return Lanes{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// Bit k: lane k is true.
inline int lane_bits(LaneMask mask) {
#ifdef __AVX__
  return _mm256_movemask_pd((__m256d)mask);
#else
  return (mask[0] ? 1 : 0) | (mask[1] ? 2 : 0) | (mask[2] ? 4 : 0) | (mask[3] ? 8 : 0);
#endif
}

inline LaneMask lanes_of_bits(int bits) {
  const LaneMask bit = {1, 2, 4, 8};
  return (LaneMask{bits, bits, bits, bits} & bit) == bit;
}

/// The sums over the lanes of a, b, c and d.
inline Lanes lane_sums(Lanes a, Lanes b, Lanes c, Lanes d) {
#ifdef __AVX__
  const __m256d ab = _mm256_hadd_pd((__m256d)a, (__m256d)b);
  const __m256d cd = _mm256_hadd_pd((__m256d)c, (__m256d)d);
  return (Lanes)_mm256_add_pd(_mm256_blend_pd(ab, cd, 0b1100),
                              _mm256_permute2f128_pd(ab, cd, 0x21));
#else
  Lanes sum;
  sum[0] = (a[0] + a[1]) + (a[2] + a[3]);
  sum[1] = (b[0] + b[1]) + (b[2] + b[3]);
  sum[2] = (c[0] + c[1]) + (c[2] + c[3]);
  sum[3] = (d[0] + d[1]) + (d[2] + d[3]);
  return sum;
#endif
}

}  // namespace rodpack

#endif

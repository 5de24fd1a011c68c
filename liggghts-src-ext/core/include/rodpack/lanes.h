// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_LANES_H
#define RODPACK_LANES_H

#include <cmath>

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace rodpack {

// Four doubles at a time, by the vector types of GCC and Clang: arithmetic acts per lane. Without
// AVX the compiler splits them into what the processor has; comparisons and choices it would make
// one by one, hence the functions below.
typedef double Lanes __attribute__((vector_size(32), may_alias));
typedef long long LaneMask __attribute__((vector_size(32), may_alias));  // all bits set: true

#if defined(__GNUC__) && !defined(__AVX__)
#pragma GCC diagnostic ignored "-Wpsabi"  // everything here is inline: no calling convention
#endif

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

inline LaneMask lane_less(Lanes a, Lanes b) {
#if defined(__SSE2__) && !defined(__AVX__)
  union {
    __m128d half[2];
    LaneMask mask;
  } result;
  const double *x = reinterpret_cast<const double*>(&a), *y = reinterpret_cast<const double*>(&b);
  result.half[0] = _mm_cmplt_pd(_mm_load_pd(x), _mm_load_pd(y));
  result.half[1] = _mm_cmplt_pd(_mm_load_pd(x + 2), _mm_load_pd(y + 2));
  return result.mask;
#else
  return a < b;
#endif
}

/// a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
#ifdef __AVX__
  return mask ? a : b;
#else
  return (Lanes)((mask & (LaneMask)a) | (~mask & (LaneMask)b));
#endif
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
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
  static const LaneMask masks[16] = {
      {0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
      {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
      {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
      {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
  return masks[bits];
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

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_LANES_H
#define RODPACK_LANES_H

#include <cmath>

#ifdef __AVX__
#include <immintrin.h>
#else
#include "lane_halves.h"
#endif

namespace rodpack {

// Four doubles at a time; arithmetic and logic act per lane. With AVX they are one register, by the
// vector types of GCC and Clang; without, two halves of two (lane_halves.h): the compiler would
// split the types too, but sends each operation through memory.
#ifdef __AVX__

typedef double Lanes __attribute__((vector_size(32), may_alias));
typedef long long LaneMask __attribute__((vector_size(32), may_alias));  // all bits set: true

inline Lanes load_lanes(const double* values) { return *reinterpret_cast<const Lanes*>(values); }
inline void store_lanes(double* values, Lanes x) { *reinterpret_cast<Lanes*>(values) = x; }
inline Lanes lane_sqrt(Lanes x) { return (Lanes)_mm256_sqrt_pd((__m256d)x); }
inline LaneMask lane_less(Lanes a, Lanes b) { return a < b; }
/// a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) { return mask ? a : b; }
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
/// Bit k: lane k is true.
inline int lane_bits(LaneMask mask) { return _mm256_movemask_pd((__m256d)mask); }
/// The sums over the lanes of a, b, c and d.
inline Lanes lane_sums(Lanes a, Lanes b, Lanes c, Lanes d) {
  const __m256d ab = _mm256_hadd_pd((__m256d)a, (__m256d)b);
  const __m256d cd = _mm256_hadd_pd((__m256d)c, (__m256d)d);
  return (Lanes)_mm256_add_pd(_mm256_blend_pd(ab, cd, 0b1100),
                              _mm256_permute2f128_pd(ab, cd, 0x21));
}

#endif

inline Lanes all_lanes(double x) { return Lanes{x, x, x, x}; }

inline LaneMask lanes_of_bits(int bits) {
  static const LaneMask masks[16] = {
      {0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
      {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
      {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
      {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
  return masks[bits];
}

}  // namespace rodpack

#endif

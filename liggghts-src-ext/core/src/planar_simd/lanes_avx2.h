// SPDX-License-Identifier: GPL-2.0-or-later
// Four doubles at a time in one register of AVX2; see kernel.h.

constexpr int lane_blocks = 2;  // blocks that are evaluated at a time
constexpr int lane_runs = 1;    // of blocks that are neighbours

#include "lane_runs.h"

typedef double Lanes __attribute__((vector_size(32)));
typedef double StoredLanes __attribute__((vector_size(32), may_alias));  // what lies in memory
typedef long long LaneMask __attribute__((vector_size(32)));             // all bits set: true

inline Lanes load_lanes(const double* values) {
  return *reinterpret_cast<const StoredLanes*>(values);
}
inline void store_lanes(double* values, Lanes x) { *reinterpret_cast<StoredLanes*>(values) = x; }
inline Lanes load_lanes(LaneValues values) { return load_lanes(values.of[0]); }
inline void store_lanes(LaneValues values, Lanes x) { store_lanes(values.of[0], x); }
inline Lanes all_lanes(double x) { return Lanes{x, x, x, x}; }
inline Lanes lane_abs(Lanes x) { return (Lanes)_mm256_andnot_pd(_mm256_set1_pd(-0.0), (__m256d)x); }
/// Sets the square root and its inverse.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  root = (Lanes)_mm256_sqrt_pd((__m256d)square);
  inverse = 1.0 / root;
}
inline LaneMask lane_less(Lanes a, Lanes b) { return a < b; }
/// Takes a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return (Lanes)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)mask);
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
/// Bit k tells whether lane k is true.
inline int lane_bits(LaneMask mask) { return _mm256_movemask_pd((__m256d)mask); }
inline LaneMask lanes_of_bits(int bits) {
  static const LaneMask masks[16] = {
      {0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
      {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
      {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
      {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
  return masks[bits];
}

/// Turns bundles, four numbers of a body each, into lanes of one number of all bodies each, or
/// back.
inline void bundles_to_numbers(Lanes (&of)[4]) {
  const __m256d a = (__m256d)of[0], b = (__m256d)of[1];
  const __m256d c = (__m256d)of[2], d = (__m256d)of[3];
  const __m256d low_ab = _mm256_unpacklo_pd(a, b), high_ab = _mm256_unpackhi_pd(a, b);
  const __m256d low_cd = _mm256_unpacklo_pd(c, d), high_cd = _mm256_unpackhi_pd(c, d);
  of[0] = (Lanes)_mm256_permute2f128_pd(low_ab, low_cd, 0x20);
  of[1] = (Lanes)_mm256_permute2f128_pd(high_ab, high_cd, 0x20);
  of[2] = (Lanes)_mm256_permute2f128_pd(low_ab, low_cd, 0x31);
  of[3] = (Lanes)_mm256_permute2f128_pd(high_ab, high_cd, 0x31);
}
/// The last number of a bundle in all lanes.
inline Lanes fourth_of_each(Lanes bundle) {
  return (Lanes)_mm256_permute4x64_pd((__m256d)bundle, 0xff);
}

/// Loads two numbers of each block b, those at of[b] + index and after it: each fills all lanes of
/// its block.
inline void each_two(const double* const (&of)[lane_blocks], int index, Lanes& first,
                     Lanes& second) {
  const __m256d both = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_load_pd(of[0] + index)),
                                            _mm_load_pd(of[1] + index), 1);
  first = (Lanes)_mm256_movedup_pd(both);
  second = (Lanes)_mm256_permute_pd(both, 0b1111);
}
#include "lanes_of_two_blocks.h"

/// Adds the sums over the lanes of a block: a, b and c to one load, -a, -b and -d to the other,
/// whose last values may become anything.
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[lane_blocks],
                      double* const (&on_j)[lane_blocks]) {
  const __m256d ab = _mm256_hadd_pd((__m256d)a, (__m256d)b);
  const __m256d cd = _mm256_hadd_pd((__m256d)c, (__m256d)d);
  const __m256d of[2] = {_mm256_permute2f128_pd(ab, cd, 0x20),
                         _mm256_permute2f128_pd(ab, cd, 0x31)};
  for (int k = 0; k < 2; ++k) {  // the two may act on the same body
    _mm256_store_pd(on_i[k], _mm256_add_pd(_mm256_load_pd(on_i[k]), of[k]));
    _mm256_store_pd(on_j[k],
                    _mm256_sub_pd(_mm256_load_pd(on_j[k]), _mm256_permute_pd(of[k], 0b1110)));
  }
}
/// The same with last values: the sums of weight_i and weight_j are added to them.
inline void add_weighted_loads(Lanes a, Lanes b, Lanes c, Lanes d, Lanes weight_i, Lanes weight_j,
                               double* const (&on_i)[lane_blocks],
                               double* const (&on_j)[lane_blocks]) {
  const __m256d ab = _mm256_hadd_pd((__m256d)a, (__m256d)b);
  const __m256d of_i = _mm256_hadd_pd((__m256d)c, (__m256d)weight_i),
                of_j = _mm256_hadd_pd((__m256d)d, (__m256d)-weight_j);
  const __m256d on_both[2][2] = {
      {_mm256_permute2f128_pd(ab, of_i, 0x20), _mm256_permute2f128_pd(ab, of_j, 0x20)},
      {_mm256_permute2f128_pd(ab, of_i, 0x31), _mm256_permute2f128_pd(ab, of_j, 0x31)}};
  for (int k = 0; k < 2; ++k) {
    _mm256_store_pd(on_i[k], _mm256_add_pd(_mm256_load_pd(on_i[k]), on_both[k][0]));
    _mm256_store_pd(on_j[k], _mm256_sub_pd(_mm256_load_pd(on_j[k]), on_both[k][1]));
  }
}

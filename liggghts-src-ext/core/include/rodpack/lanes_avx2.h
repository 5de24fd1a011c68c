// SPDX-License-Identifier: GPL-2.0-or-later
// Four doubles at a time in one register of AVX2; see planar_kernel.h.

constexpr int lane_blocks = 1;  // blocks that are evaluated at a time

typedef double Lanes __attribute__((vector_size(32), may_alias));
typedef long long LaneMask __attribute__((vector_size(32), may_alias));  // all bits set: true

inline Lanes load_lanes(const double* values) { return *reinterpret_cast<const Lanes*>(values); }
inline void store_lanes(double* values, Lanes x) { *reinterpret_cast<Lanes*>(values) = x; }
inline Lanes all_lanes(double x) { return Lanes{x, x, x, x}; }
inline Lanes lane_sqrt(Lanes x) { return (Lanes)_mm256_sqrt_pd((__m256d)x); }
/// The root and its inverse.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  root = lane_sqrt(square);
  inverse = 1.0 / root;
}
inline LaneMask lane_less(Lanes a, Lanes b) { return a < b; }
/// a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return (Lanes)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)mask);
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
/// Bit k: lane k is true.
inline int lane_bits(LaneMask mask) { return _mm256_movemask_pd((__m256d)mask); }
inline LaneMask lanes_of_bits(int bits) {
  static const LaneMask masks[16] = {
      {0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
      {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
      {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
      {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
  return masks[bits];
}

/// Makes rows of columns.
inline void transpose_lanes(Lanes (&rows)[4]) {
  const __m256d a = (__m256d)rows[0], b = (__m256d)rows[1];
  const __m256d c = (__m256d)rows[2], d = (__m256d)rows[3];
  const __m256d low_ab = _mm256_unpacklo_pd(a, b), high_ab = _mm256_unpackhi_pd(a, b);
  const __m256d low_cd = _mm256_unpacklo_pd(c, d), high_cd = _mm256_unpackhi_pd(c, d);
  rows[0] = (Lanes)_mm256_permute2f128_pd(low_ab, low_cd, 0x20);
  rows[1] = (Lanes)_mm256_permute2f128_pd(high_ab, high_cd, 0x20);
  rows[2] = (Lanes)_mm256_permute2f128_pd(low_ab, low_cd, 0x31);
  rows[3] = (Lanes)_mm256_permute2f128_pd(high_ab, high_cd, 0x31);
}

/// of[b][index] in all lanes of block b.
inline Lanes each_block(const double* const (&of)[1], int index) { return all_lanes(of[0][index]); }
/// Four values for block b, from of[b] + index.
inline Lanes lanes_of(double* const (&of)[1], int index) { return load_lanes(of[0] + index); }
inline void keep_lanes(LaneMask where, double* const (&of)[1], int index, Lanes x) {
  store_lanes(of[0] + index, lane_choice(where, x, load_lanes(of[0] + index)));
}
/// Adds the sums over the lanes of a block: a, b and c to one load, -a, -b and -d to the other,
/// whose last values may become anything.
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[1],
                      double* const (&on_j)[1]) {
  const __m256d ab = _mm256_hadd_pd((__m256d)a, (__m256d)b);
  const __m256d cd = _mm256_hadd_pd((__m256d)c, (__m256d)d);
  const Lanes sums = (Lanes)_mm256_add_pd(_mm256_blend_pd(ab, cd, 0b1100),
                                          _mm256_permute2f128_pd(ab, cd, 0x21));
  store_lanes(on_i[0], load_lanes(on_i[0]) + sums);
  store_lanes(on_j[0], load_lanes(on_j[0]) - (Lanes)_mm256_permute_pd((__m256d)sums, 0b1110));
}

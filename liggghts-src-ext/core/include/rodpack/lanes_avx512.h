// SPDX-License-Identifier: GPL-2.0-or-later
// Two blocks of four doubles at a time in one register of AVX-512; see planar_kernel.h.

constexpr int lane_blocks = 2;  // blocks that are evaluated at a time

typedef double Lanes __attribute__((vector_size(64), may_alias));

/// Bit k: lane k.
struct LaneMask {
  __mmask8 bits;
};
inline LaneMask operator&(LaneMask a, LaneMask b) { return {static_cast<__mmask8>(a.bits & b.bits)}; }
inline LaneMask operator|(LaneMask a, LaneMask b) { return {static_cast<__mmask8>(a.bits | b.bits)}; }
inline LaneMask operator^(LaneMask a, LaneMask b) { return {static_cast<__mmask8>(a.bits ^ b.bits)}; }
inline LaneMask operator~(LaneMask a) { return {static_cast<__mmask8>(~a.bits)}; }
inline LaneMask& operator|=(LaneMask& a, LaneMask b) { return a = a | b; }

inline Lanes all_lanes(double x) { return (Lanes)_mm512_set1_pd(x); }
/// The root and its inverse.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  root = (Lanes)_mm512_sqrt_pd((__m512d)square);
  inverse = 1.0 / root;
}
inline LaneMask lane_less(Lanes a, Lanes b) {
  return {_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ)};
}
/// a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return (Lanes)_mm512_mask_blend_pd(mask.bits, (__m512d)b, (__m512d)a);
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline int lane_bits(LaneMask mask) { return mask.bits; }
inline LaneMask lanes_of_bits(int bits) { return {static_cast<__mmask8>(bits)}; }

/// of[b][index] in all lanes of block b.
inline Lanes each_block(const double* const (&of)[2], int index) {
  return (Lanes)_mm512_mask_broadcastsd_pd(_mm512_set1_pd(of[0][index]), 0xf0,
                                           _mm_load_sd(of[1] + index));
}
/// Four values for block b, from of[b] + index.
inline Lanes lanes_of(double* const (&of)[2], int index) {
  const __m512d first = _mm512_castpd256_pd512(_mm256_load_pd(of[0] + index));
  return (Lanes)_mm512_mask_broadcast_f64x4(first, 0xf0, _mm256_load_pd(of[1] + index));
}
inline void keep_lanes(LaneMask where, double* const (&of)[2], int index, Lanes x) {
  const __m512d kept = (__m512d)lane_choice(where, x, lanes_of(of, index));
  _mm256_store_pd(of[1] + index, _mm512_extractf64x4_pd(kept, 1));
  _mm256_store_pd(of[0] + index, _mm512_castpd512_pd256(kept));
}
/// Adds the sums over the lanes of a block: a, b and c to one load, -a, -b and -d to the other,
/// whose last values may become anything.
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[2],
                      double* const (&on_j)[2]) {
  const __m512d ab = _mm512_add_pd(_mm512_unpacklo_pd((__m512d)a, (__m512d)b),
                                   _mm512_unpackhi_pd((__m512d)a, (__m512d)b));
  const __m512d cd = _mm512_add_pd(_mm512_unpacklo_pd((__m512d)c, (__m512d)d),
                                   _mm512_unpackhi_pd((__m512d)c, (__m512d)d));
  const __m512d sums = _mm512_add_pd(
      _mm512_permutex2var_pd(ab, _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13), cd),
      _mm512_permutex2var_pd(ab, _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15), cd));
  const __m256d of[2] = {_mm512_castpd512_pd256(sums), _mm512_extractf64x4_pd(sums, 1)};
  for (int k = 0; k < 2; ++k) {  // the two may act on the same body
    _mm256_store_pd(on_i[k], _mm256_add_pd(_mm256_load_pd(on_i[k]), of[k]));
    _mm256_store_pd(on_j[k], _mm256_sub_pd(_mm256_load_pd(on_j[k]),
                                           _mm256_permute_pd(of[k], 0b1110)));
  }
}

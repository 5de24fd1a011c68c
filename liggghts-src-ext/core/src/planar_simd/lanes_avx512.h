// SPDX-License-Identifier: GPL-2.0-or-later
// Eight doubles at a time in one register of AVX-512; see kernel.h.

constexpr int lane_blocks = 4;  // blocks that are evaluated at a time

typedef double Lanes __attribute__((vector_size(64)));
typedef double StoredLanes __attribute__((vector_size(64), may_alias));  // what lies in memory

/// Bit k tells whether lane k is true.
struct LaneMask {
  __mmask8 bits;
};
inline LaneMask operator&(LaneMask a, LaneMask b) {
  return {static_cast<__mmask8>(a.bits & b.bits)};
}
inline LaneMask operator|(LaneMask a, LaneMask b) {
  return {static_cast<__mmask8>(a.bits | b.bits)};
}
inline LaneMask operator^(LaneMask a, LaneMask b) {
  return {static_cast<__mmask8>(a.bits ^ b.bits)};
}
inline LaneMask operator~(LaneMask a) { return {static_cast<__mmask8>(~a.bits)}; }

inline Lanes load_lanes(const double* values) {
  return *reinterpret_cast<const StoredLanes*>(values);
}
inline void store_lanes(double* values, Lanes x) { *reinterpret_cast<StoredLanes*>(values) = x; }
inline Lanes all_lanes(double x) { return (Lanes)_mm512_set1_pd(x); }
/// Sets the square root and its inverse, to one or two units in the last place: two Newton steps
/// from an estimate of 14 bits take a third of the time of a root and a division.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  const Lanes half = 0.5 * square;
  inverse = (Lanes)_mm512_rsqrt14_pd((__m512d)square);
  for (int k = 0; k < 2; ++k) inverse = inverse * (1.5 - half * inverse * inverse);
  root = square * inverse;
}
inline LaneMask lane_less(Lanes a, Lanes b) {
  return {_mm512_cmp_pd_mask((__m512d)a, (__m512d)b, _CMP_LT_OQ)};
}
/// Takes a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return (Lanes)_mm512_mask_blend_pd(mask.bits, (__m512d)b, (__m512d)a);
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline int lane_bits(LaneMask mask) { return mask.bits; }
inline LaneMask lanes_of_bits(int bits) { return {static_cast<__mmask8>(bits)}; }

/// Loads two numbers of each block b, those at of[b] + index and after it: each fills all lanes of
/// its block.
inline void each_two(const double* const (&of)[lane_blocks], int index, Lanes& first,
                     Lanes& second) {
  __m512d both = _mm512_broadcast_f64x2(_mm_load_pd(of[0] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0x0c, _mm_load_pd(of[1] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0x30, _mm_load_pd(of[2] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0xc0, _mm_load_pd(of[3] + index));
  first = (Lanes)_mm512_movedup_pd(both);
  second = (Lanes)_mm512_permute_pd(both, 0xff);
}
/// The same of four numbers.
inline void each_four(const double* const (&of)[lane_blocks], int index, Lanes& first,
                      Lanes& second, Lanes& third, Lanes& fourth) {
  const auto of_two = [&](int b) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(of[b] + index)),
                              _mm256_loadu_pd(of[b + 1] + index), 1);
  };
  const __m512d low = of_two(0), high = of_two(2);
  const auto number = [&](long long k) {
    const __m512i places = _mm512_setr_epi64(k, k, k + 4, k + 4, k + 8, k + 8, k + 12, k + 12);
    return (Lanes)_mm512_permutex2var_pd(low, places, high);
  };
  first = number(0);
  second = number(1);
  third = number(2);
  fourth = number(3);
}

/// The sums of a and b over the lanes of each block, side by side.
inline __m512d sums_of_lanes(Lanes a, Lanes b) {
  return _mm512_add_pd(_mm512_unpacklo_pd((__m512d)a, (__m512d)b),
                       _mm512_unpackhi_pd((__m512d)a, (__m512d)b));
}
/// Sets the vectors of the blocks from their first and last two numbers.
inline void set_vectors(__m512d first, __m512d last, __m256d (&of)[lane_blocks]) {
  const __m512d low =
      _mm512_permutex2var_pd(first, _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11), last);
  const __m512d high =
      _mm512_permutex2var_pd(first, _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15), last);
  of[0] = _mm512_castpd512_pd256(low);
  of[1] = _mm512_extractf64x4_pd(low, 1);
  of[2] = _mm512_castpd512_pd256(high);
  of[3] = _mm512_extractf64x4_pd(high, 1);
}

/// Adds the sums over the lanes of a block: a, b and c to one load, -a, -b and -d to the other,
/// whose last values may become anything.
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[lane_blocks],
                      double* const (&on_j)[lane_blocks]) {
  __m256d of[lane_blocks];
  set_vectors(sums_of_lanes(a, b), sums_of_lanes(c, d), of);
  for (int k = 0; k < lane_blocks; ++k) {  // they may act on the same body
    _mm256_store_pd(on_i[k], _mm256_add_pd(_mm256_load_pd(on_i[k]), of[k]));
    _mm256_store_pd(on_j[k],
                    _mm256_sub_pd(_mm256_load_pd(on_j[k]), _mm256_permute_pd(of[k], 0b1110)));
  }
}
/// The same with last values: the sums of weight_i and weight_j are added to them.
inline void add_weighted_loads(Lanes a, Lanes b, Lanes c, Lanes d, Lanes weight_i, Lanes weight_j,
                               double* const (&on_i)[lane_blocks],
                               double* const (&on_j)[lane_blocks]) {
  __m256d of_i[lane_blocks], of_j[lane_blocks];
  const __m512d ab = sums_of_lanes(a, b);
  set_vectors(ab, sums_of_lanes(c, weight_i), of_i);
  set_vectors(ab, sums_of_lanes(d, -weight_j), of_j);
  for (int k = 0; k < lane_blocks; ++k) {
    _mm256_store_pd(on_i[k], _mm256_add_pd(_mm256_load_pd(on_i[k]), of_i[k]));
    _mm256_store_pd(on_j[k], _mm256_sub_pd(_mm256_load_pd(on_j[k]), of_j[k]));
  }
}

/// Whether the bodies of some block, i and j as PlanarGroupHeads has them, have travelled as far as
/// its gap together, m.
inline bool any_has_met(const double* travelled, const std::uint32_t* i, const std::int32_t* j,
                        const float* gap) {
  const auto four = [](const void* places) {
    return _mm_load_si128(static_cast<const __m128i*>(places));
  };
  const __m256i places = _mm256_inserti128_si256(_mm256_castsi128_si256(four(i)), four(j), 1);
  const __m256i bodies = _mm256_srli_epi32(places, planar_stride_bits);
  const __m512d of_both = _mm512_i32gather_pd(bodies, travelled, sizeof(double));
  const __m256d together =
      _mm256_add_pd(_mm512_castpd512_pd256(of_both), _mm512_extractf64x4_pd(of_both, 1));
  return _mm256_cmp_pd_mask(together, _mm256_cvtps_pd(_mm_load_ps(gap)), _CMP_NLT_UQ) != 0;
}

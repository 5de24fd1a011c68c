// SPDX-License-Identifier: GPL-2.0-or-later
// Eight doubles at a time in one register of AVX-512; see kernel.h.

constexpr int lane_blocks = 4;  // blocks that are evaluated at a time
constexpr int lane_runs = 1;    // of blocks that are neighbours

#include "lane_runs.h"

// A structure, so that the compiler joins products and sums as it does for two registers
// (lanes_avx512_twice.h), and both have the same results to the last bit.
struct Lanes {
  __m512d all;
  Lanes() = default;
  Lanes(__m512d x) : all(x) {}
  operator __m512d() const { return all; }
};
inline Lanes operator+(Lanes a, Lanes b) { return a.all + b.all; }
inline Lanes operator-(Lanes a, Lanes b) { return a.all - b.all; }
inline Lanes operator*(Lanes a, Lanes b) { return a.all * b.all; }
inline Lanes operator-(Lanes a) { return -a.all; }
inline Lanes operator+(double a, Lanes b) { return a + b.all; }
inline Lanes operator-(double a, Lanes b) { return a - b.all; }
inline Lanes operator*(double a, Lanes b) { return a * b.all; }
inline Lanes operator/(double a, Lanes b) { return a / b.all; }
inline Lanes& operator+=(Lanes& a, Lanes b) { return a = a + b; }

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

inline Lanes load_lanes(const double* values) { return _mm512_load_pd(values); }
inline void store_lanes(double* values, Lanes x) { _mm512_store_pd(values, x); }
inline Lanes load_lanes(LaneValues values) { return load_lanes(values.of[0]); }
inline void store_lanes(LaneValues values, Lanes x) { store_lanes(values.of[0], x); }
inline Lanes all_lanes(double x) { return _mm512_set1_pd(x); }
/// Sets the square root and its inverse, to one or two units in the last place: two Newton steps
/// from an estimate of 14 bits take a third of the time of a root and a division.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  const Lanes half = 0.5 * square;
  inverse = _mm512_rsqrt14_pd(square);
  for (int k = 0; k < 2; ++k) inverse = inverse * (1.5 - half * inverse * inverse);
  root = square * inverse;
}
inline LaneMask lane_less(Lanes a, Lanes b) { return {_mm512_cmp_pd_mask(a, b, _CMP_LT_OQ)}; }
/// Takes a where the mask is true, b elsewhere.
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return _mm512_mask_blend_pd(mask.bits, b, a);
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline int lane_bits(LaneMask mask) { return mask.bits; }
inline LaneMask lanes_of_bits(int bits) { return {static_cast<__mmask8>(bits)}; }

inline Lanes lane_abs(Lanes x) { return _mm512_abs_pd(x); }

inline __m512d of_two(__m256d first, __m256d second) {
  return _mm512_insertf64x4(_mm512_castpd256_pd512(first), second, 1);
}

/// Loads two numbers of each block b, those at of[b] + index and after it: each fills all lanes of
/// its block.
inline void each_two(const double* const (&of)[lane_blocks], int index, Lanes& first,
                     Lanes& second) {
  __m512d both = _mm512_broadcast_f64x2(_mm_load_pd(of[0] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0x0c, _mm_load_pd(of[1] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0x30, _mm_load_pd(of[2] + index));
  both = _mm512_mask_broadcast_f64x2(both, 0xc0, _mm_load_pd(of[3] + index));
  first = _mm512_movedup_pd(both);
  second = _mm512_permute_pd(both, 0xff);
}
/// The same of four numbers.
inline void each_four(const double* const (&of)[lane_blocks], int index, Lanes& first,
                      Lanes& second, Lanes& third, Lanes& fourth) {
  const auto of_blocks = [&](int b) {
    return of_two(_mm256_loadu_pd(of[b] + index), _mm256_loadu_pd(of[b + 1] + index));
  };
  const __m512d low = of_blocks(0), high = of_blocks(2);
  const auto number = [&](long long k) {
    const __m512i places = _mm512_setr_epi64(k, k, k + 4, k + 4, k + 8, k + 8, k + 12, k + 12);
    return _mm512_permutex2var_pd(low, places, high);
  };
  first = number(0);
  second = number(1);
  third = number(2);
  fourth = number(3);
}

/// The sums of a and b over the lanes of each block, side by side.
inline __m512d sums_of_lanes(Lanes a, Lanes b) {
  return _mm512_add_pd(_mm512_unpacklo_pd(a, b), _mm512_unpackhi_pd(a, b));
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
/// its gap together, m. One load for each: a gather is slow on processors that guard what it reads.
inline bool any_has_met(const double* travelled, const std::uint32_t* i, const std::int32_t* j,
                        const float* gap) {
  const auto of = [&](std::uint32_t place) { return travelled + place / planar_stride; };
  const auto of_four = [&](const auto* places) {
    const __m128d low = _mm_loadh_pd(_mm_load_sd(of(places[0])), of(places[1]));
    const __m128d high = _mm_loadh_pd(_mm_load_sd(of(places[2])), of(places[3]));
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
  };
  const __m256d together = _mm256_add_pd(of_four(i), of_four(j));
  return _mm256_cmp_pd_mask(together, _mm256_cvtps_pd(_mm_load_ps(gap)), _CMP_NLT_UQ) != 0;
}

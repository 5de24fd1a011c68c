// SPDX-License-Identifier: GPL-2.0-or-later
// Bundles of two bodies in a register of AVX-512; see kernel_motion.h. Included after
// lanes_avx512.h.

constexpr int bundle_bodies = 2;  // bodies in a bundle

/// Four numbers of each body, which lie where these point.
inline Lanes load_each(const double* const (&places)[bundle_bodies]) {
  return of_two(_mm256_load_pd(places[0]), _mm256_load_pd(places[1]));
}
inline void store_each(double* const (&places)[bundle_bodies], Lanes x) {
  _mm256_store_pd(places[0], _mm512_castpd512_pd256(x));
  _mm256_store_pd(places[1], _mm512_extractf64x4_pd(x, 1));
}
/// The last of the four numbers of each body in all its lanes.
inline Lanes fourth_of_each(Lanes bundle) { return _mm512_permutex_pd(bundle, 0xff); }
/// The same four numbers for every body.
inline Lanes of_every_body(const double* vector) {
  return _mm512_broadcast_f64x4(_mm256_load_pd(vector));
}
/// One number of each body, in all lanes of that body.
inline Lanes each_number(const double* const (&of)[bundle_bodies], int index) {
  const __m512d first = _mm512_set1_pd(of[0][index]);
  return _mm512_mask_broadcastsd_pd(first, 0xf0, _mm_load_sd(of[1] + index));
}
/// Sets the first two of four registers to what `first` picks, by number, from the first numbers of
/// each two neighbours in them, and from the second ones; the last two to what `last` picks.
inline void shuffle(Lanes (&of)[4], __m512i first, __m512i last) {
  const __m512d low_ab = _mm512_unpacklo_pd(of[0], of[1]);
  const __m512d high_ab = _mm512_unpackhi_pd(of[0], of[1]);
  const __m512d low_cd = _mm512_unpacklo_pd(of[2], of[3]);
  const __m512d high_cd = _mm512_unpackhi_pd(of[2], of[3]);
  of[0] = _mm512_permutex2var_pd(low_ab, first, low_cd);
  of[1] = _mm512_permutex2var_pd(high_ab, first, high_cd);
  of[2] = _mm512_permutex2var_pd(low_ab, last, low_cd);
  of[3] = _mm512_permutex2var_pd(high_ab, last, high_cd);
}
/// Turns bundles, four numbers of two bodies each, into lanes of one number of all bodies each.
inline void bundles_to_numbers(Lanes (&of)[4]) {
  shuffle(of, _mm512_setr_epi64(0, 4, 1, 5, 8, 12, 9, 13),
          _mm512_setr_epi64(2, 6, 3, 7, 10, 14, 11, 15));
}
/// Stores the positions and directions of so many bodies, given as lanes of x, y, cosine and sine.
inline void store_poses(Lanes (&numbers)[4], PlanarKinematics* of, int members) {
  shuffle(numbers, _mm512_setr_epi64(0, 1, 8, 9, 2, 3, 10, 11),
          _mm512_setr_epi64(4, 5, 12, 13, 6, 7, 14, 15));
  const auto store = [&](int body, __m512d both) {  // of body and the second one after it
    if (body < members) _mm256_store_pd(&of[body].x, _mm512_castpd512_pd256(both));
    if (body + 2 < members) _mm256_store_pd(&of[body + 2].x, _mm512_extractf64x4_pd(both, 1));
  };
  store(0, numbers[0]);
  store(1, numbers[1]);
  store(4, numbers[2]);
  store(5, numbers[3]);
}

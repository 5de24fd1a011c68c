// SPDX-License-Identifier: GPL-2.0-or-later
// Four doubles at a time, as two halves of two, for any processor whose registers hold that many;
// see kernel.h. The compiler would split vectors of four too, but sends each operation
// through memory.

constexpr int lane_blocks = 2;  // blocks that are evaluated at a time
constexpr int lane_runs = 1;    // of blocks that are neighbours

#include "lane_runs.h"

typedef double HalfLanes __attribute__((vector_size(16), may_alias));
typedef long long HalfMask __attribute__((vector_size(16), may_alias));

struct Lanes {
  HalfLanes low, high;
  Lanes() = default;
  Lanes(HalfLanes l, HalfLanes h) : low(l), high(h) {}
  Lanes(double a, double b, double c, double d) : low{a, b}, high{c, d} {}
};

struct LaneMask {
  HalfMask low, high;
  LaneMask() = default;
  LaneMask(HalfMask l, HalfMask h) : low(l), high(h) {}
  LaneMask(long long a, long long b, long long c, long long d) : low{a, b}, high{c, d} {}
};

#include "operators_of_halves.h"

inline Lanes load_lanes(const double* values) {
  const HalfLanes* halves = reinterpret_cast<const HalfLanes*>(values);
  return {halves[0], halves[1]};
}
inline void store_lanes(double* values, Lanes x) {
  HalfLanes* halves = reinterpret_cast<HalfLanes*>(values);
  halves[0] = x.low;
  halves[1] = x.high;
}
inline Lanes load_lanes(LaneValues values) { return load_lanes(values.of[0]); }
inline void store_lanes(LaneValues values, Lanes x) { store_lanes(values.of[0], x); }
inline HalfLanes half_sqrt(HalfLanes x) {
#ifdef __SSE2__
  return (HalfLanes)_mm_sqrt_pd((__m128d)x);
#else
  return HalfLanes{__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
#endif
}
inline Lanes lane_abs(Lanes x) {
  const HalfMask magnitude = {0x7fffffffffffffff, 0x7fffffffffffffff};
  return {(HalfLanes)((HalfMask)x.low & magnitude), (HalfLanes)((HalfMask)x.high & magnitude)};
}
/// Sets the square root and its inverse.
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  root = {half_sqrt(square.low), half_sqrt(square.high)};
  inverse = 1.0 / root;
}
inline LaneMask lane_less(Lanes a, Lanes b) { return {a.low < b.low, a.high < b.high}; }
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return {(HalfLanes)((mask.low & (HalfMask)a.low) | (~mask.low & (HalfMask)b.low)),
          (HalfLanes)((mask.high & (HalfMask)a.high) | (~mask.high & (HalfMask)b.high))};
}
/// Bit k tells whether lane k is true.
inline int lane_bits(LaneMask mask) {
#ifdef __SSE2__
  return _mm_movemask_pd((__m128d)mask.low) | _mm_movemask_pd((__m128d)mask.high) << 2;
#else
  return (mask.low[0] ? 1 : 0) | (mask.low[1] ? 2 : 0) | (mask.high[0] ? 4 : 0) |
         (mask.high[1] ? 8 : 0);
#endif
}
inline Lanes all_lanes(double x) { return {x, x, x, x}; }
inline LaneMask lanes_of_bits(int bits) {
  return {-static_cast<long long>(bits & 1), -static_cast<long long>(bits >> 1 & 1),
          -static_cast<long long>(bits >> 2 & 1), -static_cast<long long>(bits >> 3 & 1)};
}

/// Turns bundles, four numbers of a body each, into lanes of one number of all bodies each, or
/// back.
inline void bundles_to_numbers(Lanes (&of)[4]) {
  const Lanes a = of[0], b = of[1], c = of[2], d = of[3];
  of[0] = {a.low[0], b.low[0], c.low[0], d.low[0]};
  of[1] = {a.low[1], b.low[1], c.low[1], d.low[1]};
  of[2] = {a.high[0], b.high[0], c.high[0], d.high[0]};
  of[3] = {a.high[1], b.high[1], c.high[1], d.high[1]};
}
/// The last number of a bundle in all lanes.
inline Lanes fourth_of_each(Lanes bundle) { return all_lanes(bundle.high[1]); }

/// Loads two numbers of each block b, those at of[b] + index and after it: each fills all lanes of
/// its block.
inline void each_two(const double* const (&of)[lane_blocks], int index, Lanes& first,
                     Lanes& second) {
  first = {of[0][index], of[0][index], of[1][index], of[1][index]};
  second = {of[0][index + 1], of[0][index + 1], of[1][index + 1], of[1][index + 1]};
}
#include "lanes_of_two_blocks.h"

/// The sums of x and y over the lanes of a block.
inline HalfLanes sums_of_lanes(HalfLanes x, HalfLanes y) {
  return HalfLanes{x[0], y[0]} + HalfLanes{x[1], y[1]};
}

/// Adds the sums over the lanes of a block: a, b and c to one load, -a, -b and -d to the other,
/// whose last values may become anything.
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[lane_blocks],
                      double* const (&on_j)[lane_blocks]) {
  const HalfLanes force[2] = {sums_of_lanes(a.low, b.low), sums_of_lanes(a.high, b.high)};
  const HalfLanes torque[2] = {sums_of_lanes(c.low, d.low), sums_of_lanes(c.high, d.high)};
  for (int k = 0; k < 2; ++k) {  // the two may act on the same body
    HalfLanes* const i = reinterpret_cast<HalfLanes*>(on_i[k]);
    i[0] += force[k];
    i[1] += torque[k];
    HalfLanes* const j = reinterpret_cast<HalfLanes*>(on_j[k]);
    j[0] -= force[k];
    j[1] -= HalfLanes{torque[k][1], torque[k][1]};
  }
}
/// The same with last values: the sums of weight_i and weight_j are added to them.
inline void add_weighted_loads(Lanes a, Lanes b, Lanes c, Lanes d, Lanes weight_i, Lanes weight_j,
                               double* const (&on_i)[lane_blocks],
                               double* const (&on_j)[lane_blocks]) {
  const HalfLanes force[2] = {sums_of_lanes(a.low, b.low), sums_of_lanes(a.high, b.high)};
  const HalfLanes of_i[2] = {sums_of_lanes(c.low, weight_i.low),
                             sums_of_lanes(c.high, weight_i.high)};
  const HalfLanes of_j[2] = {sums_of_lanes(d.low, -weight_j.low),
                             sums_of_lanes(d.high, -weight_j.high)};
  for (int k = 0; k < 2; ++k) {
    HalfLanes* const i = reinterpret_cast<HalfLanes*>(on_i[k]);
    i[0] += force[k];
    i[1] += of_i[k];
    HalfLanes* const j = reinterpret_cast<HalfLanes*>(on_j[k]);
    j[0] -= force[k];
    j[1] -= of_j[k];
  }
}

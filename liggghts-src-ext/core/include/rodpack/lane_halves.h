// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_LANE_HALVES_H
#define RODPACK_LANE_HALVES_H

#include <cmath>

namespace rodpack {

// lanes.h for processors whose registers hold two doubles.

typedef double HalfLanes __attribute__((vector_size(16), may_alias));
typedef long long HalfMask __attribute__((vector_size(16), may_alias));

struct Lanes {
  HalfLanes low, high;
  Lanes() = default;
  Lanes(HalfLanes l, HalfLanes h) : low(l), high(h) {}
  Lanes(double a, double b, double c, double d) : low{a, b}, high{c, d} {}
  double operator[](int lane) const { return lane < 2 ? low[lane] : high[lane - 2]; }
};

struct LaneMask {
  HalfMask low, high;
  LaneMask(HalfMask l, HalfMask h) : low(l), high(h) {}
  LaneMask(long long a, long long b, long long c, long long d) : low{a, b}, high{c, d} {}
};

inline Lanes operator+(Lanes a, Lanes b) { return {a.low + b.low, a.high + b.high}; }
inline Lanes operator-(Lanes a, Lanes b) { return {a.low - b.low, a.high - b.high}; }
inline Lanes operator*(Lanes a, Lanes b) { return {a.low * b.low, a.high * b.high}; }
inline Lanes operator/(Lanes a, Lanes b) { return {a.low / b.low, a.high / b.high}; }
inline Lanes operator-(Lanes a) { return {-a.low, -a.high}; }
inline Lanes operator+(double a, Lanes b) { return {a + b.low, a + b.high}; }
inline Lanes operator-(double a, Lanes b) { return {a - b.low, a - b.high}; }
inline Lanes operator*(double a, Lanes b) { return {a * b.low, a * b.high}; }
inline Lanes operator/(double a, Lanes b) { return {a / b.low, a / b.high}; }
inline Lanes operator*(Lanes a, double b) { return {a.low * b, a.high * b}; }
inline Lanes& operator+=(Lanes& a, Lanes b) { return a = a + b; }

inline LaneMask operator&(LaneMask a, LaneMask b) { return {a.low & b.low, a.high & b.high}; }
inline LaneMask operator|(LaneMask a, LaneMask b) { return {a.low | b.low, a.high | b.high}; }
inline LaneMask operator^(LaneMask a, LaneMask b) { return {a.low ^ b.low, a.high ^ b.high}; }
inline LaneMask operator~(LaneMask a) { return {~a.low, ~a.high}; }
inline LaneMask& operator|=(LaneMask& a, LaneMask b) { return a = a | b; }

inline Lanes load_lanes(const double* values) {
  const HalfLanes* halves = reinterpret_cast<const HalfLanes*>(values);
  return {halves[0], halves[1]};
}
inline void store_lanes(double* values, Lanes x) {
  HalfLanes* halves = reinterpret_cast<HalfLanes*>(values);
  halves[0] = x.low;
  halves[1] = x.high;
}
inline Lanes lane_sqrt(Lanes x) {
  return {std::sqrt(x.low[0]), std::sqrt(x.low[1]), std::sqrt(x.high[0]), std::sqrt(x.high[1])};
}
inline LaneMask lane_less(Lanes a, Lanes b) { return {a.low < b.low, a.high < b.high}; }
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return {(HalfLanes)((mask.low & (HalfMask)a.low) | (~mask.low & (HalfMask)b.low)),
          (HalfLanes)((mask.high & (HalfMask)a.high) | (~mask.high & (HalfMask)b.high))};
}
inline int lane_bits(LaneMask mask) {
  return (mask.low[0] ? 1 : 0) | (mask.low[1] ? 2 : 0) | (mask.high[0] ? 4 : 0) |
         (mask.high[1] ? 8 : 0);
}
inline Lanes lane_sums(Lanes a, Lanes b, Lanes c, Lanes d) {
  const HalfLanes p = a.low + a.high, q = b.low + b.high;
  const HalfLanes r = c.low + c.high, s = d.low + d.high;
  return {p[0] + p[1], q[0] + q[1], r[0] + r[1], s[0] + s[1]};
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
// Sixteen doubles at a time in two registers of AVX-512; see kernel.h. One evaluation is a chain of
// operations that wait for each other, so long that the processor looks ahead to little beyond its
// end; with two side by side there is something to do while one waits. Every operation is that of
// one register, so that both kinds of lanes have the same results to the last bit: which of two
// ranks evaluates a contact in which is left to chance.

constexpr int lane_blocks = 8;  // blocks that are evaluated at a time
constexpr int lane_runs = 2;

#include "lane_runs.h"

using one_register::any_has_met;

typedef one_register::Lanes Half;
typedef one_register::LaneMask HalfMask;

struct Lanes {
  Half low, high;
};
struct LaneMask {
  HalfMask low, high;
};

#include "operators_of_halves.h"

inline Lanes load_lanes(LaneValues values) {
  return {one_register::load_lanes(values.of[0]), one_register::load_lanes(values.of[1])};
}
inline void store_lanes(LaneValues values, Lanes x) {
  one_register::store_lanes(values.of[0], x.low);
  one_register::store_lanes(values.of[1], x.high);
}
inline Lanes all_lanes(double x) {
  return {one_register::all_lanes(x), one_register::all_lanes(x)};
}
inline void lane_roots(Lanes square, Lanes& root, Lanes& inverse) {
  one_register::lane_roots(square.low, root.low, inverse.low);
  one_register::lane_roots(square.high, root.high, inverse.high);
}
inline LaneMask lane_less(Lanes a, Lanes b) {
  return {one_register::lane_less(a.low, b.low), one_register::lane_less(a.high, b.high)};
}
inline Lanes lane_choice(LaneMask mask, Lanes a, Lanes b) {
  return {one_register::lane_choice(mask.low, a.low, b.low),
          one_register::lane_choice(mask.high, a.high, b.high)};
}
inline LaneMask lane_choice(LaneMask mask, LaneMask a, LaneMask b) {
  return (mask & a) | (~mask & b);
}
inline int lane_bits(LaneMask mask) { return mask.low.bits | mask.high.bits << 8; }
inline LaneMask lanes_of_bits(int bits) {
  return {one_register::lanes_of_bits(bits & 255), one_register::lanes_of_bits(bits >> 8)};
}

/// The blocks of each register.
template <class Of>
inline auto of_low(Of* const (&of)[lane_blocks]) -> Of* const (&)[run_blocks] {
  return reinterpret_cast<Of* const(&)[run_blocks]>(of[0]);
}
template <class Of>
inline auto of_high(Of* const (&of)[lane_blocks]) -> Of* const (&)[run_blocks] {
  return reinterpret_cast<Of* const(&)[run_blocks]>(of[run_blocks]);
}
inline void each_two(const double* const (&of)[lane_blocks], int index, Lanes& first,
                     Lanes& second) {
  one_register::each_two(of_low(of), index, first.low, second.low);
  one_register::each_two(of_high(of), index, first.high, second.high);
}
inline void each_four(const double* const (&of)[lane_blocks], int index, Lanes& first,
                      Lanes& second, Lanes& third, Lanes& fourth) {
  one_register::each_four(of_low(of), index, first.low, second.low, third.low, fourth.low);
  one_register::each_four(of_high(of), index, first.high, second.high, third.high, fourth.high);
}
inline void add_loads(Lanes a, Lanes b, Lanes c, Lanes d, double* const (&on_i)[lane_blocks],
                      double* const (&on_j)[lane_blocks]) {
  one_register::add_loads(a.low, b.low, c.low, d.low, of_low(on_i), of_low(on_j));
  one_register::add_loads(a.high, b.high, c.high, d.high, of_high(on_i), of_high(on_j));
}
inline void add_weighted_loads(Lanes a, Lanes b, Lanes c, Lanes d, Lanes weight_i, Lanes weight_j,
                               double* const (&on_i)[lane_blocks],
                               double* const (&on_j)[lane_blocks]) {
  one_register::add_weighted_loads(a.low, b.low, c.low, d.low, weight_i.low, weight_j.low,
                                   of_low(on_i), of_low(on_j));
  one_register::add_weighted_loads(a.high, b.high, c.high, d.high, weight_i.high, weight_j.high,
                                   of_high(on_i), of_high(on_j));
}

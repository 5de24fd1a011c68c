// SPDX-License-Identifier: GPL-2.0-or-later
// How far a body moves at most (theory.md, section 8). A text to be included inside a namespace in
// which lane_abs(x) is known, as contact_formulas.h is.

constexpr double octagon_excess = 1.0824;  // 1 / cos(pi / 8), rounded up

/// At least the length of the vector (x, y), and at most octagon_excess times that, without a root:
/// the norm max + (sqrt(2) - 1) min of the components, whose circle is an octagon.
template <class Real>
inline Real length_bound(Real x, Real y) {
  const Real a = lane_abs(x), b = lane_abs(y);
  return 0.7071067812 * (a + b) + 0.2928932189 * lane_abs(a - b);
}

/// No point of a body moves farther, m, whose centre goes (x, y), m, and whose cosine and sine
/// change by so much; `reach`: of its farthest point from there, m.
template <class Real>
inline Real motion_bound(Real x, Real y, Real reach, Real cosine, Real sine) {
  return length_bound(x, y) + reach * length_bound(cosine, sine);
}

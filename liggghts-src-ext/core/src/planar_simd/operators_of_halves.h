// SPDX-License-Identifier: GPL-2.0-or-later
// Operators of lanes and masks that consist of two halves, low and high; included after these.

inline Lanes operator+(Lanes a, Lanes b) { return {a.low + b.low, a.high + b.high}; }
inline Lanes operator-(Lanes a, Lanes b) { return {a.low - b.low, a.high - b.high}; }
inline Lanes operator*(Lanes a, Lanes b) { return {a.low * b.low, a.high * b.high}; }
inline Lanes operator-(Lanes a) { return {-a.low, -a.high}; }
inline Lanes operator+(double a, Lanes b) { return {a + b.low, a + b.high}; }
inline Lanes operator-(double a, Lanes b) { return {a - b.low, a - b.high}; }
inline Lanes operator*(double a, Lanes b) { return {a * b.low, a * b.high}; }
inline Lanes operator/(double a, Lanes b) { return {a / b.low, a / b.high}; }
inline Lanes& operator+=(Lanes& a, Lanes b) { return a = a + b; }

inline LaneMask operator&(LaneMask a, LaneMask b) { return {a.low & b.low, a.high & b.high}; }
inline LaneMask operator|(LaneMask a, LaneMask b) { return {a.low | b.low, a.high | b.high}; }
inline LaneMask operator^(LaneMask a, LaneMask b) { return {a.low ^ b.low, a.high ^ b.high}; }
inline LaneMask operator~(LaneMask a) { return {~a.low, ~a.high}; }

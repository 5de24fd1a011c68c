// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_MULTISTEP_H
#define RODPACK_MOTION_MULTISTEP_H

#include <array>

namespace rodpack {

constexpr int max_multistep_order = 4;

using MultistepWeights = std::array<double, max_multistep_order>;

/// Weights w[k] of f_{n-k} in y_{n+1} = y_n + dt sum_k w[k] f_{n-k}; unused ones are 0.
///
/// `order` is 1..4. `evaluations` counts the values of f since the start, the newest included, so
/// it is n+1 on the step from n to n+1. Arguments are not checked: this sits in the integration
/// loop.
///
/// Beyond `order` evaluations these are the Adams-Bashforth weights. Up to there the order rises
/// with the number of known values, and each step also repairs what the lower orders before it
/// missed: with P_n the polynomial through f_0..f_n,
///   y_{n+1} - y_n = dt (int_0^{n+1} P_n ds - int_0^n P_{n-1} ds),
/// so that y_order = y_0 + dt int_0^order P_{order-1} ds. A chain of plain lower-order steps would
/// leave an error of dt^2 f'/2 for good, which caps the order at 2.
inline const MultistepWeights& multistep_weights(int order, int evaluations) {
  static constexpr MultistepWeights start_up[max_multistep_order] = {
      {{1.0, 0.0, 0.0, 0.0}},
      {{2.0, -1.0, 0.0, 0.0}},
      {{9.0 / 4, -2.0, 3.0 / 4, 0.0}},
      {{8.0 / 3, -43.0 / 12, 8.0 / 3, -3.0 / 4}}};
  static constexpr MultistepWeights adams_bashforth[max_multistep_order] = {
      {{1.0, 0.0, 0.0, 0.0}},
      {{3.0 / 2, -1.0 / 2, 0.0, 0.0}},
      {{23.0 / 12, -4.0 / 3, 5.0 / 12, 0.0}},
      {{55.0 / 24, -59.0 / 24, 37.0 / 24, -9.0 / 24}}};
  return evaluations <= order ? start_up[evaluations - 1] : adams_bashforth[order - 1];
}

/// Plain Adams-Bashforth weights, for rates whose history before the start is known (order 1..4).
inline const MultistepWeights& adams_bashforth_weights(int order) {
  return multistep_weights(order, order + 1);
}

/// Increment dt sum_k w[k] f(k) over k = 0..order-1, where f(k) returns the rate k steps back
/// (f(0) the newest).
template <class RateOf>
inline double multistep_increment(const MultistepWeights& weights, int order, double dt, RateOf f) {
  double sum = 0.0;
  for (int k = 0; k < order; ++k) sum += weights[k] * f(k);
  return dt * sum;
}

}  // namespace rodpack

#endif

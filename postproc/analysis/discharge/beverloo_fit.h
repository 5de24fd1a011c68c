// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_DISCHARGE_BEVERLOO_FIT_H
#define RODPACK_ANALYSIS_DISCHARGE_BEVERLOO_FIT_H

#include <optional>
#include <vector>

namespace rodpack {

/// Beverloo's law, Q sqrt(d_p / g) = C (D / d_p - k)^n with n = 3/2 in the plane and 5/2 in space:
/// Q particles per second through an orifice of width D. In the usual form of the mass,
/// C rho_b sqrt(g) (D - k d_p)^n, the C of here holds the particles per area d_p^2 or volume d_p^3
/// too.
struct BeverlooFit {
  double law = 1.5;  // n
  double c = 0, c_error = 0;
  double k = 0, k_error = 0;
  // The exponent where it is fitted together with C and k; none with fewer than four widths.
  std::optional<double> exponent, exponent_error;
};

/// The exponent n of the law: `dimension` - 1/2.
constexpr double beverloo_exponent(int dimension) { return dimension - 0.5; }

/// Fits the law by least squares, a straight line of (Q sqrt(d_p/g))^(1/n) over D / d_p; standard
/// errors from the residuals. The free exponent n is the one of the least squares of the logarithm,
/// ln Q = ln C + n ln(D/d_p - k), with k from 0 to the narrowest orifice.
/// `width`: D / d_p; `rate`: Q sqrt(d_p / g), above 0, one per run; `dimension`: 2 or 3.
/// @throws TooFewParticles with fewer than three widths, or rates that do not rise with the width.
BeverlooFit fit_beverloo(const std::vector<double>& width, const std::vector<double>& rate,
                         int dimension);

}  // namespace rodpack

#endif

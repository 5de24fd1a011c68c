// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/claims/significance.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unsupported/Eigen/SpecialFunctions>

namespace rodpack {
namespace {

using Number = Eigen::Array<double, 1, 1>;

double incomplete_beta(double a, double b, double x) {
  const Number as(a), bs(b), xs(std::clamp(x, 0.0, 1.0));
  return Number(Eigen::betainc(as, bs, xs))(0);
}

}  // namespace

double student_tail(double t, double dof) {
  const double beyond = 0.5 * incomplete_beta(0.5 * dof, 0.5, dof / (dof + t * t));
  return t > 0 ? beyond : 1 - beyond;
}

double f_tail(double f, double above, double below) {
  if (!(f > 0)) return 1;
  return incomplete_beta(0.5 * below, 0.5 * above, below / (below + above * f));
}

double sigmas_of(double probability) {
  // Bisection on the tail of the normal distribution, which erfc gives to full accuracy.
  double low = -37, high = 37;
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(middle / std::sqrt(2.0)) > probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double Contrast::sigmas_above(double level) const {
  if (!(error > 0)) return value > level ? 37 : value < level ? -37 : 0;
  const double t = (value - level) / error;
  // The smaller tail has the digits.
  return t > 0 ? sigmas_of(student_tail(t, dof)) : -sigmas_of(student_tail(-t, dof));
}

std::optional<Contrast> contrast_of(const std::vector<ContrastTerm>& terms) {
  Contrast sum;
  double variance = 0, spread = 0;
  for (const auto& [weight, mean] : terms) {
    if (!mean.sem || mean.n < 2) return std::nullopt;
    const double part = std::pow(weight * *mean.sem, 2);
    sum.value += weight * mean.mean;
    variance += part;
    spread += part * part / (mean.n - 1);
  }
  sum.error = std::sqrt(variance);
  if (spread > 0) sum.dof = variance * variance / spread;
  return sum;
}

std::optional<Contrast> slope_of(const std::vector<double>& x,
                                 const std::vector<EnsembleMean>& means) {
  const double middle = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  double squares = 0;
  for (const double each : x) squares += (each - middle) * (each - middle);
  if (!(squares > 0)) return std::nullopt;
  std::vector<ContrastTerm> terms;
  for (std::size_t k = 0; k < x.size(); ++k) terms.push_back({(x[k] - middle) / squares, means[k]});
  return contrast_of(terms);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/claims/histogram_tests.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "reading/angles.h"
#include "study/claims/significance.h"

namespace rodpack {
namespace {

bool has_errors(const EnsembleCurve& curve) {
  return std::all_of(curve.y.begin(), curve.y.end(), [](const EnsembleMean& value) {
    return value.sem && value.n >= 2 && std::isfinite(value.mean);
  });
}

// Weighted least squares of the five harmonics; the fitted density per bin.
Eigen::VectorXd fit_harmonics(const Eigen::MatrixXd& basis, const Eigen::VectorXd& density,
                              const Eigen::VectorXd& variance) {
  const Eigen::VectorXd weight = variance.cwiseInverse().cwiseSqrt();
  const Eigen::MatrixXd scaled = weight.asDiagonal() * basis;
  const Eigen::VectorXd amplitudes =
      scaled.colPivHouseholderQr().solve(weight.cwiseProduct(density));
  return basis * amplitudes;
}

}  // namespace

double Departure::sigmas() const {
  if (!(noise > 0)) return mean_square > 0 ? 37 : 0;
  return sigmas_of(f_tail(f(), above, below));
}

double Departure::relative_square_error() const {
  return std::sqrt(2 * mean_square * mean_square / above + 2 * noise * noise / below) / density;
}

double Departure::relative() const { return std::sqrt(std::max(0.0, relative_square())); }

std::optional<Departure> narrow_peaks(const EnsembleCurve& distribution) {
  const auto bins = static_cast<Eigen::Index>(distribution.x.size());
  if (bins < 12 || !has_errors(distribution)) return std::nullopt;
  Eigen::MatrixXd basis(bins, 5);
  Eigen::VectorXd density(bins), squared_error(bins);
  for (Eigen::Index k = 0; k < bins; ++k) {
    const auto bin = static_cast<std::size_t>(k);
    const double g = distribution.x[bin] * degree;
    basis.row(k) << 1, std::cos(2 * g), std::sin(2 * g), std::cos(4 * g), std::sin(4 * g);
    density[k] = distribution.y[bin].mean;
    squared_error[k] = std::pow(*distribution.y[bin].sem, 2);
  }
  // First with equal weights, for the densities that the weights are made of. Where the fit comes
  // close to 0, or below, a tenth of the mean keeps the weights finite.
  const double mean = density.mean();
  if (!(mean > 0)) return std::nullopt;
  Eigen::VectorXd shape = fit_harmonics(basis, density, Eigen::VectorXd::Ones(bins));
  const Eigen::VectorXd expected = shape.cwiseMax(0.1 * mean);
  shape = fit_harmonics(basis, density, expected);

  Departure departure;
  departure.density = mean;
  departure.above = static_cast<double>(bins - basis.cols());
  departure.mean_square =
      ((density - shape).array().square() / expected.array()).sum() / departure.above;
  departure.noise = (squared_error.array() / expected.array()).mean();
  departure.below = static_cast<double>(bins) * (distribution.y.front().n - 1);
  return departure;
}

std::optional<Departure> asymmetry(const EnsembleCurve& distribution) {
  const std::size_t bins = distribution.x.size();
  if (bins < 12 || !has_errors(distribution)) return std::nullopt;
  const double width = 360.0 / static_cast<double>(bins);
  double squares = 0, noise = 0, density = 0;
  int pairs = 0;
  for (std::size_t k = 0; k < bins; ++k) {
    const double g = distribution.x[k];
    if (!(std::cos(g * degree) > 1e-9)) continue;  // its partner points the other way
    const double mirrored = std::fmod(540 - g, 360);
    std::size_t other = 0;
    while (other < bins && std::fabs(distribution.x[other] - mirrored) > 1e-3 * width) ++other;
    if (other == bins) return std::nullopt;
    const auto &a = distribution.y[k], &b = distribution.y[other];
    const double sum = a.mean + b.mean;
    density += sum;
    if (!(sum > 0)) continue;
    squares += std::pow(a.mean - b.mean, 2) / sum;
    noise += (*a.sem * *a.sem + *b.sem * *b.sem) / sum;
    ++pairs;
  }
  if (pairs == 0) return std::nullopt;
  Departure departure;
  departure.above = pairs;
  departure.below = 2.0 * pairs * (distribution.y.front().n - 1);
  departure.mean_square = squares / pairs;
  departure.noise = noise / pairs;
  departure.density = density / pairs;
  return departure;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/stability_limit.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <stdexcept>
#include <string>

#include "../eigen_dense.h"
#include "rodpack/motion/multistep.h"

namespace rodpack {
namespace {

using Complex = std::complex<double>;

void check(int order, double damping_ratio) {
  if (order < 0 || order > max_multistep_order)
    throw std::invalid_argument("stability limit: order " + std::to_string(order) +
                                ", expected 0 (velocity Verlet) or 1 to 4 (Adams-Bashforth)");
  if (!(damping_ratio >= 0.0) || !std::isfinite(damping_ratio))
    throw std::invalid_argument("stability limit: damping ratio " + std::to_string(damping_ratio) +
                                ", expected a finite number >= 0");
}

/// Largest modulus of the roots of z^p + c[p-1] z^(p-1) + ... + c[0], the eigenvalues of its
/// companion matrix.
double largest_root(const Complex* c, int p) {
  using Matrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, 0, max_multistep_order,
                               max_multistep_order>;
  Matrix companion = Matrix::Zero(p, p);
  for (int row = 1; row < p; ++row) companion(row, row - 1) = 1.0;
  for (int row = 0; row < p; ++row) companion(row, p - 1) = -c[row];
  const Eigen::ComplexEigenSolver<Matrix> solver(companion, false);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

double adams_bashforth_amplification(int order, Complex lambda_dt) {
  const MultistepWeights& weights = adams_bashforth_weights(order);
  Complex c[max_multistep_order];
  for (int k = 0; k < order; ++k) c[order - 1 - k] = -lambda_dt * weights[k];
  c[order - 1] -= 1.0;
  return largest_root(c, order);
}

double verlet_amplification(double eta, double y) {
  // z^2 - (2 - y^2 - 2 eta y) z + 1 - 2 eta y = 0
  const Complex c[2] = {1.0 - 2.0 * eta * y, y * y + 2.0 * eta * y - 2.0};
  return largest_root(c, 2);
}

double unchecked_amplification(int order, double eta, double y) {
  if (order == 0) return verlet_amplification(eta, y);
  // The two motions are conjugate, so one will do, or real ones, of which the faster one goes
  // astray first.
  if (eta < 1.0)
    return adams_bashforth_amplification(order, Complex(-eta, std::sqrt(1.0 - eta * eta)) * y);
  const double fast = eta + std::sqrt(eta * eta - 1.0);
  return std::max(adams_bashforth_amplification(order, -y * fast),
                  adams_bashforth_amplification(order, -y / fast));
}

}  // namespace

double amplification(int order, double damping_ratio, double omega_dt) {
  check(order, damping_ratio);
  if (!(omega_dt >= 0.0) || !std::isfinite(omega_dt))
    throw std::invalid_argument("amplification: omega dt " + std::to_string(omega_dt) +
                                ", expected a finite number >= 0");
  return unchecked_amplification(order, damping_ratio, omega_dt);
}

double stability_limit(int order, double damping_ratio) {
  check(order, damping_ratio);
  if ((order == 1 || order == 2) && damping_ratio == 0.0) return 0.0;
  const auto grows = [&](double y) {
    // Undamped motions may keep their amplitude: more than rounding has to be seen.
    return unchecked_amplification(order, damping_ratio, y) > 1.0 + 1e-13;
  };
  // The stable steps begin at 0; none reaches 2 (velocity Verlet without damping), nor 2 of the
  // decay rate 2 eta. Coming from above, lengths of small steps cannot be mistaken for rounding.
  const double top = 2.01 / std::max(1.0, damping_ratio);
  const int scan = 200;
  int last_stable = 0;
  while (last_stable < scan && !grows(top * (last_stable + 1) / scan)) ++last_stable;
  double low = top * last_stable / scan, high = top * (last_stable + 1) / scan;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

double timestep_limit(int order, const MotionBounds& bounds) {
  const auto require = [](bool holds, const char* what, double value) {
    if (!holds || !std::isfinite(value))
      throw std::invalid_argument("timestep limit: " + std::string(what) + ", got " +
                                  std::to_string(value));
  };
  require(bounds.stiffness > 0.0, "stiffness has to be > 0", bounds.stiffness);
  require(bounds.damping >= 0.0, "damping has to be >= 0", bounds.damping);
  require(bounds.delay_min >= 0.0, "delay_min has to be >= 0", bounds.delay_min);
  require(bounds.delay_max >= bounds.delay_min, "delay_max has to be >= delay_min",
          bounds.delay_max);
  const auto limit = [order](double kappa, double c) {
    const double omega = std::sqrt(kappa);
    return stability_limit(order, 0.5 * c / omega) / omega;
  };
  const double kappa = bounds.stiffness, c = bounds.damping;
  double least = std::min(limit(kappa, c), limit(kappa, std::min(c, bounds.delay_min * kappa)));
  if (bounds.delay_max > 0.0 && c > 0.0)
    least = std::min(least, limit(std::min(kappa, c / bounds.delay_max), c));
  return least;
}

}  // namespace rodpack

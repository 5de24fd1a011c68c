// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/janssen_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

#include "reading/number_text.h"
#include "rodpack/geometry/pi.h"

namespace rodpack {
namespace {

// Residuals of P_j (1 - exp(-h / h_c)) and their derivatives by ln P_j and ln h_c, which keeps both
// positive. Lengths and pressures are in units of their largest, so that the step sizes fit.
struct JanssenResiduals {
  Eigen::VectorXd depth, pressure;

  int inputs() const { return 2; }
  int values() const { return static_cast<int>(depth.size()); }
  int operator()(const Eigen::VectorXd& logs, Eigen::VectorXd& residual) const {
    const double p = std::exp(logs[0]), h = std::exp(logs[1]);
    residual = (p * (1 - (-depth.array() / h).exp()) - pressure.array()).matrix();
    return 0;
  }
  int df(const Eigen::VectorXd& logs, Eigen::MatrixXd& jacobian) const {
    const double p = std::exp(logs[0]), h = std::exp(logs[1]);
    const Eigen::ArrayXd decay = (-depth.array() / h).exp();
    jacobian.resize(values(), 2);
    jacobian.col(0) = (p * (1 - decay)).matrix();
    jacobian.col(1) = (-p * decay * depth.array() / h).matrix();
    return 0;
  }
};

}  // namespace

JanssenFit fit_janssen(const PressureProfile& profile) {
  if (profile.inclination != 0)
    throw TooFewParticles(
        "Janssen fit: none where gravity is off -y, for side walls do not carry "
        "such a bed alone");
  const double floor = profile.depth_of_floor;
  if (floor < 6 * profile.scale)
    throw TooFewParticles("Janssen fit: the bed is too low, " +
                          number_text(floor / profile.scale, 3) +
                          " w high, expected at least 6 w: the kernel's smoothing would be fitted");
  std::vector<double> depth, pressure;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    const double h = profile.depth[k];
    if (h < 0 || h > floor - 3 * profile.scale) continue;
    depth.push_back(h);
    pressure.push_back(profile.pressure[k]);
  }
  if (depth.size() < 5)
    throw TooFewParticles("Janssen fit: " + std::to_string(depth.size()) +
                          " depths are left, expected at least 5: give a smaller spacing");
  const auto n = static_cast<Eigen::Index>(depth.size());
  JanssenResiduals residuals{Eigen::Map<Eigen::VectorXd>(depth.data(), n),
                             Eigen::Map<Eigen::VectorXd>(pressure.data(), n)};
  const double deepest = residuals.depth.maxCoeff(), largest = residuals.pressure.maxCoeff();
  if (!(largest > 0)) throw TooFewParticles("Janssen fit: there is no pressure in the slice");
  residuals.depth /= deepest;
  residuals.pressure /= largest;

  Eigen::VectorXd logs(2);
  logs << 0, std::log(0.5);
  Eigen::LevenbergMarquardt<JanssenResiduals> solver(residuals);
  solver.parameters.maxfev = 2000;
  const auto status = solver.minimize(logs);
  const double p = std::exp(logs[0]), h = std::exp(logs[1]);
  if (status <= 0 || status == Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation ||
      !std::isfinite(p) || !std::isfinite(h) || p > 1e6)
    throw TooFewParticles("Janssen fit: P_0 grows like a straight line or faster, no P_j fits");

  Eigen::VectorXd residual(n);
  Eigen::MatrixXd jacobian(n, 2);
  residuals(logs, residual);
  residuals.df(logs, jacobian);
  const double spacing = std::fabs(depth[1] - depth[0]);
  const double correlated = std::max(1.0, 2 * std::sqrt(pi) * profile.scale / spacing);
  const double variance = residual.squaredNorm() / static_cast<double>(n - 2) * correlated;
  const Eigen::Matrix2d covariance = (jacobian.transpose() * jacobian).inverse() * variance;
  JanssenFit fit;
  fit.pressure = p * largest;
  fit.depth = h * deepest;
  fit.pressure_error = fit.pressure * std::sqrt(covariance(0, 0));
  fit.depth_error = fit.depth * std::sqrt(covariance(1, 1));
  fit.rms_residual = std::sqrt(residual.squaredNorm() / static_cast<double>(n)) * largest;
  fit.from = *std::min_element(depth.begin(), depth.end());
  fit.to = deepest;
  fit.saturates = fit.depth < fit.to;
  return fit;
}

std::string describe(const JanssenFit& fit, double particle_diameter, const std::string& unit) {
  if (!fit.saturates)
    return "the pressure does not saturate within the bed: h_c = " +
           number_text(fit.depth / particle_diameter, 3) + " d_p is beyond the fitted depth of " +
           number_text(fit.to / particle_diameter, 3) + " d_p";
  return "Janssen: P_j = " + number_text(fit.pressure, 4) + " +- " +
         number_text(fit.pressure_error, 2) + " " + unit +
         ", h_c = " + number_text(fit.depth / particle_diameter, 4) + " +- " +
         number_text(fit.depth_error / particle_diameter, 2) + " d_p, rms residual " +
         number_text(fit.rms_residual, 2) + " " + unit;
}

}  // namespace rodpack

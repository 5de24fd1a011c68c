// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/order_tensor.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "reading/angles.h"
#include "reading/dump.h"

namespace rodpack {
namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

Eigen::Matrix3d order_of(const Vector3& axis) {
  const Eigen::Vector3d u(axis[0], axis[1], axis[2]);
  return (3 * u * u.transpose() - Eigen::Matrix3d::Identity()) / 2;
}

// Eigen orders values from the smallest on.
Eigen::Vector3d values_of(const Solver& solver) { return solver.eigenvalues().reverse(); }

void require_two(const std::vector<Vector3>& axes) {
  if (axes.size() < 2)
    throw TooFewParticles("order tensor: expected at least 2 directions, found " +
                          std::to_string(axes.size()));
}

}  // namespace

OrderTensor order_tensor(const std::vector<Vector3>& axes) {
  require_two(axes);
  const double n = static_cast<double>(axes.size());
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& axis : axes) sum += order_of(axis);
  const Solver whole(sum / n);
  const Eigen::Vector3d values = values_of(whole), director = whole.eigenvectors().col(2);

  // The jackknife: all axes but one, each in turn. What the values deviate by is of order 1 / n, so
  // that sums of their squares keep all digits.
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(), square = Eigen::Vector3d::Zero();
  double tilt = 0;
  for (const auto& axis : axes) {
    const Solver rest((sum - order_of(axis)) / (n - 1));
    const Eigen::Vector3d deviation = values_of(rest) - values;
    shift += deviation;
    square += deviation.cwiseAbs2();
    tilt += director.cross(rest.eigenvectors().col(2)).squaredNorm();
  }
  const Eigen::Vector3d variance = (square - shift.cwiseAbs2() / n).cwiseMax(0.0) * ((n - 1) / n);

  OrderTensor result;
  result.number = axes.size();
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<std::size_t>(k);
    result.value[at] = values[k];
    result.standard_error[at] = std::sqrt(variance[k]);
    const Eigen::Vector3d direction = whole.eigenvectors().col(2 - k);
    result.direction[at] = {direction[0], direction[1], direction[2]};
  }
  result.order_without_bias = values[0] - (n - 1) * shift[0] / n;
  result.director_standard_error = std::sqrt(tilt * (n - 1) / n) * degrees_in_radian;
  return result;
}

OrderAbout order_about(const std::vector<Vector3>& axes, std::size_t axis) {
  require_two(axes);
  const double n = static_cast<double>(axes.size());
  const auto order = [&](const Vector3& u) { return (3 * u[axis] * u[axis] - 1) / 2; };
  double mean = 0, square = 0;
  for (const auto& u : axes) mean += order(u) / n;
  for (const auto& u : axes) square += std::pow(order(u) - mean, 2);
  return {mean, std::sqrt(square / (n * (n - 1)))};
}

IsotropicOrder isotropic_order(std::size_t number) {
  const double n = static_cast<double>(number);
  const double mean = 9.0 / 4 * std::sqrt(2 / (5 * pi * n));
  return {mean, std::sqrt(29 / (40 * n) - mean * mean)};
}

}  // namespace rodpack

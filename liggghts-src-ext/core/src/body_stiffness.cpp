// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/body_stiffness.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "rodpack/eigen_dense.h"

namespace rodpack {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Eigen::Vector3d;
using Small = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;  // up to 6 x 6

Vector6 motion_along(const Vector3d& direction, const Vector3d& arm) {
  Vector6 g;
  g << direction, arm.cross(direction);
  return g;
}

double largest_eigenvalue(const std::array<double, BodyStiffness::size>& form, const Small& mass,
                          const std::vector<int>& free) {
  const Eigen::Map<const Matrix6> full(form.data());
  const auto n = static_cast<int>(free.size());
  Small part(n, n);
  for (int a = 0; a < n; ++a)
    for (int b = 0; b < n; ++b) part(a, b) = full(free[a], free[b]);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Small> solver(part, mass, Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues().maxCoeff());
}

}  // namespace

void BodyStiffness::add_contact(const double* normal, const double* arm, double normal_stiffness,
                                double tangential_stiffness, double normal_damping,
                                double tangential_damping) {
  const Vector3d n(normal[0], normal[1], normal[2]), r(arm[0], arm[1], arm[2]);
  const Vector3d t = n.unitOrthogonal(), b = n.cross(t);
  const Vector6 gn = motion_along(n, r), gt = motion_along(t, r), gb = motion_along(b, r);
  const Matrix6 along_n = gn * gn.transpose();
  const Matrix6 across = gt * gt.transpose() + gb * gb.transpose();
  Eigen::Map<Matrix6>(stiffness.data()) +=
      normal_stiffness * along_n + tangential_stiffness * across;
  Eigen::Map<Matrix6>(damping.data()) += normal_damping * along_n + tangential_damping * across;
}

StiffestMotion stiffest_motion(const BodyStiffness& contacts, const BodyInertia& inertia) {
  std::vector<int> free;
  for (int k = 0; k < 6; ++k)
    if (inertia.is_free[k]) free.push_back(k);
  if (free.empty()) return {0.0, 0.0};
  const auto n = static_cast<int>(free.size());
  Small mass = Small::Zero(n, n);
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < n; ++b) {
      const int p = free[a], q = free[b];
      if (p < 3 || q < 3)
        mass(a, b) = p == q ? inertia.mass : 0.0;
      else
        mass(a, b) = inertia.moments[p - 3][q - 3];
    }
  }
  // Rows of a tensor have other units than those of a mass: the pivots tell, whatever their size.
  const Eigen::LLT<Small> factor(mass);
  if (factor.info() != Eigen::Success || !mass.allFinite())
    throw std::invalid_argument("stiffest motion: mass and moments of inertia have to be positive");
  return {largest_eigenvalue(contacts.stiffness, mass, free),
          largest_eigenvalue(contacts.damping, mass, free)};
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact_network.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "rodpack/eigen_dense.h"

namespace rodpack {
namespace {

// Not aligned: in C++14 a std::vector of them has no room for more than the usual alignment.
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
using Vector3 = Eigen::Vector3d;

/// L^-1 of the body's mass matrix M = L L^T in its free motions, 0 in the others: it turns forms of
/// (x, y, z; rotations) into such of coordinates in which the mass is 1.
Matrix6 unit_mass(const NetworkBody& body, std::size_t index) {
  Matrix6 mass = Matrix6::Identity();
  for (int a = 0; a < 6; ++a) {
    for (int b = 0; b < 6; ++b) {
      if (!body.is_free[a] || !body.is_free[b]) continue;
      if (a < 3 || b < 3)
        mass(a, b) = a == b ? body.mass : 0.0;
      else
        mass(a, b) = body.moments[a - 3][b - 3];
    }
  }
  const Eigen::LLT<Matrix6> factor(mass);
  if (factor.info() != Eigen::Success || !mass.allFinite())
    throw std::invalid_argument("contact network: body " + std::to_string(index) +
                                ": mass and moments of inertia have to be positive");
  Matrix6 result = factor.matrixL().solve(Matrix6::Identity());
  for (int a = 0; a < 6; ++a)
    if (!body.is_free[a]) result.row(a).setZero();
  return result;
}

/// Forms of one side of a contact, in coordinates of unit mass.
struct Side {
  int body;
  Matrix6 stiffness, damping;
};

Side side_of(const NetworkContact& contact, int body, const double* arm, const Matrix6& scale) {
  const Vector3 n(contact.normal[0], contact.normal[1], contact.normal[2]);
  const Vector3 t = n.unitOrthogonal(), b = n.cross(t), r(arm[0], arm[1], arm[2]);
  Side side = {body, Matrix6::Zero(), Matrix6::Zero()};
  const auto add = [&](const Vector3& along, double k, double c) {
    Vector6 g;
    g << along, r.cross(along);
    g = scale * g;
    const Matrix6 form = g * g.transpose();
    side.stiffness += k * form;
    side.damping += c * form;
  };
  add(n, contact.stiffness_n, contact.damping_n);
  add(t, contact.stiffness_t, contact.damping_t);
  add(b, contact.stiffness_t, contact.damping_t);
  return side;
}

double largest_eigenvalue(const Matrix6& form) {
  using Aligned = Eigen::Matrix<double, 6, 6>;  // the solver compiles for no other
  const Eigen::SelfAdjointEigenSolver<Aligned> solver(Aligned(form), Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues().maxCoeff());
}

/// One of the two forms of every body, each contact counted 1 + u_j / u_i times on side i: their
/// largest eigenvalues.
std::vector<double> stiffness_by_body(const std::vector<NetworkContact>& contacts,
                                      const std::vector<Side>& sides, Matrix6 Side::*form,
                                      const std::vector<double>& u) {
  std::vector<Matrix6> sums(u.size(), Matrix6::Zero());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Side &here = sides[2 * k], &there = sides[2 * k + 1];
    const double s = there.body < 0 ? 0.0 : u[there.body] / u[here.body];
    sums[here.body] += (1.0 + s) * (here.*form);
    if (there.body >= 0) sums[there.body] += (1.0 + 1.0 / s) * (there.*form);
  }
  std::vector<double> result;
  for (const Matrix6& sum : sums) result.push_back(largest_eigenvalue(sum));
  return result;
}

}  // namespace

NetworkBounds bound_network(const std::vector<NetworkBody>& bodies,
                            const std::vector<NetworkContact>& contacts) {
  const auto n = static_cast<int>(bodies.size());
  std::vector<Matrix6> scales;
  for (const NetworkBody& body : bodies) scales.push_back(unit_mass(body, scales.size()));
  std::vector<Side> sides;
  std::vector<int> counts(bodies.size(), 0);
  for (const NetworkContact& contact : contacts) {
    if (contact.i < 0 || contact.i >= n || contact.j >= n || contact.i == contact.j)
      throw std::invalid_argument("contact network: bodies " + std::to_string(contact.i) + " and " +
                                  std::to_string(contact.j) + " of " + std::to_string(n));
    sides.push_back(side_of(contact, contact.i, contact.arm_i, scales[contact.i]));
    ++counts[contact.i];
    if (contact.j >= 0) {
      sides.push_back(side_of(contact, contact.j, contact.arm_j, scales[contact.j]));
      ++counts[contact.j];
    } else {
      sides.push_back({-1, Matrix6::Zero(), Matrix6::Zero()});
    }
  }

  NetworkBounds bounds = {0.0, 0.0, -1, 0};
  if (contacts.empty()) return bounds;
  const int rounds = 8;
  for (Matrix6 Side::*form : {&Side::stiffness, &Side::damping}) {
    const bool is_stiffness = form == &Side::stiffness;
    std::vector<double> u;
    for (const NetworkBody& body : bodies) u.push_back(1.0 / body.mass);
    double best = 0.0;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<double> held = stiffness_by_body(contacts, sides, form, u);
      const auto top = std::max_element(held.begin(), held.end());
      if (round == 0 && is_stiffness) {
        bounds.stiffest = static_cast<int>(top - held.begin());
        bounds.contacts = counts[bounds.stiffest];
      }
      best = round == 0 ? *top : std::min(best, *top);
      // As in the power method for the matrix of the blocks' norms: bodies held stiffly weigh
      // more, which leaves them a smaller part of their contacts. The floor keeps s moderate.
      if (*top > 0.0)
        for (std::size_t b = 0; b < u.size(); ++b) u[b] *= std::max(0.05, held[b] / *top);
    }
    (is_stiffness ? bounds.stiffness : bounds.damping) = best;
  }
  return bounds;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/contact/contact_network.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "../eigen_dense.h"
#include "rodpack/motion/stability_limit.h"

namespace rodpack {
namespace {

using Vector3 = Eigen::Vector3d;

/// Which of the six coordinates (x, y, z; rotations about them) a network of bodies moves in:
/// `each` of them in turn, the last ones rotations.
struct InSpace {
  static constexpr int count = 6, rotations = 3;
  static constexpr int each(int k) { return k; }
};
struct InPlane {
  static constexpr int count = 3, rotations = 1;
  static constexpr int each(int k) { return k < 2 ? k : 5; }
};

// Not aligned: in C++14 a std::vector of them has no room for more than the usual alignment.
template <class Coordinates>
using Form = Eigen::Matrix<double, Coordinates::count, Coordinates::count, Eigen::DontAlign>;

/// L^-1 of the body's mass matrix M = L L^T in its free motions, 0 in the others: it turns forms of
/// the coordinates into such of coordinates in which the mass is 1.
template <class Coordinates>
Form<Coordinates> unit_mass(const NetworkBody& body, std::size_t index) {
  using Matrix = Form<Coordinates>;
  Matrix mass = Matrix::Identity();
  for (int row = 0; row < Coordinates::count; ++row) {
    for (int column = 0; column < Coordinates::count; ++column) {
      const int a = Coordinates::each(row), b = Coordinates::each(column);
      if (!body.is_free[a] || !body.is_free[b]) continue;
      if (a < 3 || b < 3)
        mass(row, column) = a == b ? body.mass : 0.0;
      else
        mass(row, column) = body.moments[a - 3][b - 3];
    }
  }
  const Eigen::LLT<Matrix> factor(mass);
  if (factor.info() != Eigen::Success || !mass.allFinite())
    throw std::invalid_argument("contact network: body " + std::to_string(index) +
                                ": mass and moments of inertia have to be positive");
  Matrix result = factor.matrixL().solve(Matrix::Identity());
  for (int row = 0; row < Coordinates::count; ++row)
    if (!body.is_free[Coordinates::each(row)]) result.row(row).setZero();
  return result;
}

/// Forms g g^T of one side of a contact along its normal, in its plane, and of rotations about all
/// axes, coordinates of unit mass.
template <class Coordinates>
struct Side {
  Form<Coordinates> along, across, turning;
};

template <class Coordinates>
Side<Coordinates> side_of(const NetworkContact& contact, const double* arm,
                          const Form<Coordinates>& scale) {
  const Vector3 n(contact.normal[0], contact.normal[1], contact.normal[2]);
  const Vector3 t = n.unitOrthogonal(), b = n.cross(t), r(arm[0], arm[1], arm[2]);
  const auto form = [&](const Vector3& direction) -> Form<Coordinates> {
    const Vector3 about = r.cross(direction);
    Eigen::Matrix<double, Coordinates::count, 1> g;
    for (int k = 0; k < Coordinates::count; ++k) {
      const int a = Coordinates::each(k);
      g(k) = a < 3 ? direction(a) : about(a - 3);
    }
    g = scale * g;
    return g * g.transpose();
  };
  const auto about_axes = scale.template rightCols<Coordinates::rotations>();
  return {form(n), form(t) + form(b), about_axes * about_axes.transpose()};
}

template <class Coordinates>
double largest_eigenvalue(const Form<Coordinates>& form) {
  // The solver compiles for no other.
  using Aligned = Eigen::Matrix<double, Coordinates::count, Coordinates::count>;
  const Eigen::SelfAdjointEigenSolver<Aligned> solver(Aligned(form), Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues().maxCoeff());
}
/// In the plane from the characteristic polynomial, which takes a quarter of the time; the largest
/// is good to 5e-9 where it coincides with the next one.
template <>
double largest_eigenvalue<InPlane>(const Form<InPlane>& form) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(Eigen::Matrix3d(form), Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues().maxCoeff());
}

/// A contact's constants along the normal, in its plane and against rotation.
struct Constants {
  double n, t, r;

  template <class Coordinates>
  Form<Coordinates> times(const Side<Coordinates>& side) const {
    Form<Coordinates> sum = n * side.along + t * side.across;
    if (r > 0.0) sum += r * side.turning;
    return sum;
  }
};

template <class Coordinates>
class Network {
 public:
  Network(const std::vector<NetworkBody>& bodies, const std::vector<NetworkContact>& contacts)
      : bodies_(bodies), contacts_(contacts), counts_(bodies.size(), 0) {
    const auto n = static_cast<int>(bodies.size());
    std::vector<Form<Coordinates>> scales;
    for (const NetworkBody& body : bodies)
      scales.push_back(unit_mass<Coordinates>(body, scales.size()));
    for (const NetworkContact& contact : contacts) {
      if (contact.i < 0 || contact.i >= n || contact.j >= n || contact.i == contact.j)
        throw std::invalid_argument("contact network: bodies " + std::to_string(contact.i) +
                                    " and " + std::to_string(contact.j) + " of " +
                                    std::to_string(n));
      if (!(contact.stiffness_n > 0.0) || !(contact.stiffness_t >= 0.0) ||
          !(contact.stiffness_r >= 0.0))
        throw std::invalid_argument(
            "contact network: stiffnesses " + std::to_string(contact.stiffness_n) + ", " +
            std::to_string(contact.stiffness_t) + " and " + std::to_string(contact.stiffness_r) +
            ", expected > 0 along the normal, >= 0 across and in rolling");
      here_.push_back(side_of<Coordinates>(contact, contact.arm_i, scales[contact.i]));
      there_.push_back(contact.j < 0
                           ? here_.back()
                           : side_of<Coordinates>(contact, contact.arm_j, scales[contact.j]));
      ++counts_[contact.i];
      if (contact.j >= 0) ++counts_[contact.j];
    }
  }

  /// Bound of the largest eigenvalue of the form sum k g g^T with these `constants` of each contact
  /// (>= 0), no closer than it takes to be at most `enough`. `stiffest`, if given: the body of the
  /// largest eigenvalue in the first round.
  template <class ConstantsOf>
  double bound(ConstantsOf constants, double enough, int* stiffest = nullptr) const {
    std::vector<double> weights;
    for (const NetworkBody& body : bodies_) weights.push_back(1.0 / body.mass);
    const int rounds = 5;
    double best = 0.0;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<double> held = by_body(constants, weights);
      const auto top = std::max_element(held.begin(), held.end());
      if (round == 0 && stiffest) *stiffest = static_cast<int>(top - held.begin());
      best = round == 0 ? *top : std::min(best, *top);
      if (best <= enough) break;
      // As in the power method for the matrix of the blocks' norms: bodies held stiffly weigh more,
      // which leaves them a smaller part of their contacts. The floor keeps s moderate.
      for (std::size_t b = 0; b < weights.size(); ++b) weights[b] *= std::max(0.05, held[b] / *top);
    }
    return best;
  }

  int contacts_of(int body) const { return counts_[body]; }

 private:
  bool moves(int body) const {
    const auto& is_free = bodies_[body].is_free;
    return std::any_of(std::begin(is_free), std::end(is_free), [](bool free) { return free; });
  }

  template <class ConstantsOf>
  std::vector<double> by_body(ConstantsOf constants, const std::vector<double>& weights) const {
    using Matrix = Form<Coordinates>;
    std::vector<Matrix> sums(bodies_.size(), Matrix::Zero());
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const NetworkContact& contact = contacts_[k];
      const Constants value = constants(contact);
      // A partner that is held is a wall: it has no part in the motion.
      const bool both = contact.j >= 0 && moves(contact.i) && moves(contact.j);
      const double s = both ? weights[contact.j] / weights[contact.i] : 0.0;
      sums[contact.i] += (1.0 + s) * value.times(here_[k]);
      if (contact.j >= 0) sums[contact.j] += (both ? 1.0 + 1.0 / s : 1.0) * value.times(there_[k]);
    }
    std::vector<double> result;
    for (const Matrix& sum : sums) result.push_back(largest_eigenvalue<Coordinates>(sum));
    return result;
  }

  const std::vector<NetworkBody>& bodies_;
  const std::vector<NetworkContact>& contacts_;
  std::vector<int> counts_;
  std::vector<Side<Coordinates>> here_, there_;
};

/// Largest dt |lambda| of a decay without oscillation: the real axis.
double real_axis_limit(int order) { return stability_limit(order, 1.0); }

template <class Coordinates>
NetworkLimit limit_of(int order, const std::vector<NetworkBody>& bodies,
                      const std::vector<NetworkContact>& contacts) {
  const Network<Coordinates> network(bodies, contacts);
  NetworkLimit result = {std::numeric_limits<double>::infinity(), 0.0, 0.0, -1, 0};
  if (contacts.empty()) return result;

  MotionBounds motions = {0.0, 0.0, std::numeric_limits<double>::max(), 0.0};
  for (const NetworkContact& contact : contacts) {
    const auto include = [&motions](double delay) {
      motions.delay_min = std::min(motions.delay_min, delay);
      motions.delay_max = std::max(motions.delay_max, delay);
    };
    include(contact.damping_n / contact.stiffness_n);
    if (contact.stiffness_t > 0.0) include(contact.damping_t / contact.stiffness_t);
    if (contact.stiffness_r > 0.0) include(contact.damping_r / contact.stiffness_r);
  }
  motions.stiffness = network.bound(
      [](const NetworkContact& c) {
        return Constants{c.stiffness_n, c.stiffness_t, c.stiffness_r};
      },
      0.0, &result.stiffest);
  if (!(motions.stiffness > 0.0)) return result;  // nothing can move
  motions.damping = network.bound(
      [](const NetworkContact& c) {
        return Constants{c.damping_n, c.stiffness_t > 0.0 ? c.damping_t : 0.0,
                         c.stiffness_r > 0.0 ? c.damping_r : 0.0};
      },
      0.0);
  result.stiffness = motions.stiffness;
  result.damping = motions.damping;
  result.contacts = network.contacts_of(result.stiffest);

  double safe = timestep_limit(order, motions);
  MotionBounds not_slow = motions;  // without the corner of strongly damped motions
  not_slow.delay_max = std::max(motions.delay_min, motions.damping / motions.stiffness);
  double open = timestep_limit(order, not_slow);
  // For real roots c <= R + kappa / R, R = rate, and c <= 2 R mean that the faster one is at most
  // R; the second holds for steps up to `open`, whose corner has the largest c.
  const auto fast_decay_is_stable = [&](double dt) {
    const double rate = real_axis_limit(order) / dt;
    const auto rest = [rate](double damping, double stiffness) {
      return stiffness > 0.0 ? std::max(0.0, damping - stiffness / rate) : 0.0;
    };
    const auto fast = [&rest](const NetworkContact& c) {
      return Constants{rest(c.damping_n, c.stiffness_n), rest(c.damping_t, c.stiffness_t),
                       rest(c.damping_r, c.stiffness_r)};
    };
    return network.bound(fast, rate) <= rate;
  };
  if (open > 1.001 * safe && fast_decay_is_stable(open)) safe = open;
  for (int k = 0; k < 6 && open > 1.01 * safe; ++k) {
    const double middle = 0.5 * (safe + open);
    (fast_decay_is_stable(middle) ? safe : open) = middle;
  }
  result.timestep = safe;
  return result;
}

}  // namespace

NetworkLimit network_limit(int order, const std::vector<NetworkBody>& bodies,
                           const std::vector<NetworkContact>& contacts) {
  const bool is_planar = std::all_of(bodies.begin(), bodies.end(), [](const NetworkBody& body) {
    return !body.is_free[2] && !body.is_free[3] && !body.is_free[4];
  });
  return is_planar ? limit_of<InPlane>(order, bodies, contacts)
                   : limit_of<InSpace>(order, bodies, contacts);
}

}  // namespace rodpack

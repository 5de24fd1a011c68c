// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/mass_scaling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "eigen_dense.h"
#include "rodpack/motion/stability_limit.h"

namespace rodpack {
namespace {

using Eigen::Vector3d;

const double radius = 1.5e-3, mass = 2.3e-4, kn = 1000, kt = 500;

/// A smooth rod of AR 5: nine spheres half a diameter apart.
const double arms[] = {-4, -3, -2, -1, 0, 1, 2, 3, 4};  // radii
const double inertia[3] = {0.4 * mass * radius * radius, 8.4 * mass* radius* radius,
                           8.4 * mass* radius* radius};

/// Largest eigenvalue of M^-1 K, over that of a pair (2 k_n / m), of `bodies` rods with random
/// contacts between each and the next, all bodies with their own inertia times `factor`. `spatial`:
/// six motions a body, else x, y and the turn about z. Contacts are anywhere on their spheres.
struct Network {
  int bodies;
  bool spatial;
  std::mt19937 random;
  std::vector<double> weights;
  Eigen::MatrixXd stiffness;

  Network(int count, bool in_space, int seed)
      : bodies(count), spatial(in_space), random(seed), weights(count) {
    stiffness = Eigen::MatrixXd::Zero(6 * count, 6 * count);
    for (int i = 0; i + 1 < count; ++i)
      for (int k = 0; k < 8; ++k) add(i, i + 1);
  }

  Vector3d direction() {
    std::normal_distribution<double> normal;
    Vector3d result(normal(random), normal(random), spatial ? normal(random) : 0.0);
    return result.normalized();
  }

  void add(int i, int j) {
    const Vector3d n = direction(), t = n.unitOrthogonal(), b = n.cross(t);
    const int at[2] = {pick(), pick()};
    for (const auto& [axis, k] : {std::make_pair(n, kn), {t, kt}, {b, kt}}) {
      Eigen::VectorXd form = Eigen::VectorXd::Zero(6 * bodies);
      for (const int side : {0, 1}) {
        const int body = side == 0 ? i : j;
        const double sign = side == 0 ? 1 : -1;
        const Vector3d lever = Vector3d(radius * arms[at[side]], 0, 0) - sign * radius * n;
        form.segment<3>(6 * body) = sign * axis;
        form.segment<3>(6 * body + 3) = sign * lever.cross(axis);
      }
      stiffness += k * form * form.transpose();
    }
    for (const int side : {0, 1}) {
      const double arm[3] = {radius * arms[at[side]], 0, 0};
      weights[side == 0 ? i : j] +=
          spatial
              ? spatial_contact_weight(mass, inertia, radius, arm)
              : contact_weight(planar_contact_weight(mass, inertia[2], radius), arm[0] * arm[0]);
    }
  }
  int pick() { return std::uniform_int_distribution<int>(0, 8)(random); }

  double largest(double scaling) const {
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(6 * bodies);
    for (int b = 0; b < bodies; ++b) {
      const double factor = scaling > 0 ? inertia_factor(weights[b], scaling) : 1.0;
      for (int d = 0; d < 3; ++d) {
        if (spatial || d < 2) scale[6 * b + d] = 1 / std::sqrt(factor * mass);
        if (spatial || d == 2) scale[6 * b + 3 + d] = 1 / std::sqrt(factor * inertia[d]);
      }
    }
    const Eigen::MatrixXd unit = scale.asDiagonal() * stiffness * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(unit).eigenvalues().maxCoeff() /
           (2 * kn / mass);
  }
};

}  // namespace

// The whole claim: whatever the network, s <= S. Without mass scaling these have s up to 5.
TEST(MassScaling, NoMotionOfANetworkIsStifferThanItSays) {
  for (const bool spatial : {false, true}) {
    double stiffest = 0, tightest = 0;
    for (int seed = 1; seed <= 40; ++seed) {
      const Network network(2 + seed % 4, spatial, seed);
      stiffest = std::max(stiffest, network.largest(0));
      for (const double scaling : {1.0, 2.0, 3.0}) {
        const double ratio = network.largest(scaling) / (scaling * scaling);
        EXPECT_LE(ratio, 1 + 1e-12) << spatial << ' ' << seed << ' ' << scaling;
        tightest = std::max(tightest, ratio);
      }
    }
    EXPECT_GT(stiffest, 9);
    // and it does not give away much more than that a bound of sums costs
    EXPECT_GT(tightest, spatial ? 0.2 : 0.4);
  }
}

// One contact on a sphere in the middle, its tangent: k_t (1/m + R^2/I) of 2 k_n/m (1 + R^2 m/I)/2.
TEST(MassScaling, WeightsAreThoseOfTheirGeometry) {
  const double moment = 0.4 * mass * radius * radius;
  const ContactWeight sphere = planar_contact_weight(mass, moment, radius);
  EXPECT_NEAR(contact_weight(sphere, 0), 1 + 1 / 0.4, 1e-12);
  EXPECT_NEAR(contact_weight(sphere, radius * radius), 1 + 2 / 0.4, 1e-12);
  const double moments[3] = {moment, moment, moment}, arm[3] = {radius, 0, 0};
  EXPECT_NEAR(spatial_contact_weight(mass, moments, radius, arm), 1 + (1 + 2 + 2) / 0.4, 1e-12);
}

TEST(MassScaling, FewContactsAreNotFelt) {
  EXPECT_EQ(inertia_factor(0, 2), 1);
  EXPECT_EQ(inertia_factor(4, 2), 1);
  EXPECT_EQ(inertia_factor(10, 2), 2.5);
}

// At the limit the stiffest motion, S omega_0 with the damping ratio S eta, neither grows nor dies.
TEST(MassScaling, TheLimitIsThatOfTheStiffestMotion) {
  const PackingLaw law = {kn, 0.2, mass};
  const double of_pair = std::sqrt(2 * kn / mass);
  for (const int order : {0, 1, 2, 3, 4})
    for (const double scaling : {1.0, 3.0, 5.0}) {
      const double limit = mass_scaled_timestep_limit(order, scaling, law);
      EXPECT_NEAR(amplification(order, 0.2 * scaling, scaling * of_pair * limit), 1, 1e-9);
      EXPECT_GT(amplification(order, 0.2 * scaling, scaling * of_pair * 1.01 * limit), 1 + 1e-6);
    }
  // theory.md, Stability in a bed
  EXPECT_NEAR(of_pair * mass_scaled_timestep_limit(2, 3, law), 0.31, 0.005);
  EXPECT_EQ(mass_scaled_timestep_limit(2, 3, {kn, 0, mass}), 0);
  EXPECT_EQ(mass_scaled_timestep_limit(0, 3, {kn, 0.2, mass, 0.5}),
            mass_scaled_timestep_limit(0, 3, {kn, 0.1, mass}));
}

TEST(MassScaling, ValuesOutOfRangeAreNamed) {
  EXPECT_THROW(mass_scaled_timestep_limit(-1, 3, {kn, 0.2, mass}), std::invalid_argument);
  EXPECT_THROW(mass_scaled_timestep_limit(0, 3, {kn, 0.2, mass, 2}), std::invalid_argument);
  EXPECT_THROW(mass_scaled_timestep_limit(2, 0.5, {kn, 0.2, mass}), std::invalid_argument);
  EXPECT_THROW(mass_scaled_timestep_limit(2, 3, {0, 0.2, mass}), std::invalid_argument);
  EXPECT_THROW(mass_scaled_timestep_limit(2, 3, {kn, -1, mass}), std::invalid_argument);
  EXPECT_THROW(mass_scaled_timestep_limit(2, 3, {kn, 0.2, NAN}), std::invalid_argument);
}

}  // namespace rodpack

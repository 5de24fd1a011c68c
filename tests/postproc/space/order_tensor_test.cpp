// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/order_tensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "reading/dump.h"
#include "spatial_scene.h"

namespace {
using namespace rodpack;
using rodpack::test::watson_axes;
using rodpack::test::watson_mean_square;

void expect_values(const OrderTensor& order, double first, double second, double third) {
  EXPECT_NEAR(order.value[0], first, 1e-12);
  EXPECT_NEAR(order.value[1], second, 1e-12);
  EXPECT_NEAR(order.value[2], third, 1e-12);
}

TEST(OrderTensor, ParallelAxesHaveOrderOneWhicheverEndIsTheHead) {
  const Vector3 u{2.0 / 3, -1.0 / 3, 2.0 / 3}, opposite{-2.0 / 3, 1.0 / 3, -2.0 / 3};
  const auto order = order_tensor({u, opposite, u, u});
  expect_values(order, 1, -0.5, -0.5);
  EXPECT_NEAR(std::abs(order.direction[0][0]), 2.0 / 3, 1e-12);
  EXPECT_NEAR(order.direction[0][0] * order.direction[0][1], -2.0 / 9, 1e-12);
  EXPECT_NEAR(order.standard_error[0], 0, 1e-12);
  EXPECT_NEAR(order.director_standard_error, 0, 1e-6);
}

// Three axes at 60 degrees to each other in a plane have <u u> = 1/2 there: 3/2 (1/2 - 1/3) = 1/4,
// and -1/2 along its normal. The three coordinate axes have <u u> = 1/3.
TEST(OrderTensor, EvenInAPlaneAndEvenInSpace) {
  const double h = std::sqrt(0.75);
  const auto planar = order_tensor({{1, 0, 0}, {0.5, 0, h}, {-0.5, 0, h}});
  expect_values(planar, 0.25, 0.25, -0.5);
  EXPECT_NEAR(std::abs(planar.direction[2][1]), 1, 1e-12);
  expect_values(order_tensor({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), 0, 0, 0);
}

// S = diag of 3/2 (shares - 1/3) for axes along x, y and z alone.
TEST(OrderTensor, BiaxialSharesOfTheCoordinateAxes) {
  std::vector<Vector3> axes(5, {0, 0, 1});
  axes.insert(axes.end(), 3, {1, 0, 0});
  axes.insert(axes.end(), 2, {0, 1, 0});
  const auto order = order_tensor(axes);
  expect_values(order, 0.25, -0.05, -0.2);
  EXPECT_NEAR(std::abs(order.direction[1][0]), 1, 1e-12);
  EXPECT_EQ(order.number, 10U);
}

// Isotropic axes: <P_2> and <P_4> of any component are 0, with variances 1/5 and 1/9 per axis.
TEST(OrderTensor, LegendreMomentsOfRandomAxesAreZero) {
  const auto axes = watson_axes(0, 20000, 1);
  const double n = static_cast<double>(axes.size());
  for (std::size_t c = 0; c < 3; ++c) {
    double p2 = 0, p4 = 0;
    for (const auto& u : axes) {
      const double t = u[c] * u[c];
      p2 += (3 * t - 1) / 2 / n;
      p4 += (35 * t * t - 30 * t + 3) / 8 / n;
    }
    EXPECT_NEAR(p2, 0, 4 / std::sqrt(5 * n));
    EXPECT_NEAR(p4, 0, 4 / std::sqrt(9 * n));
  }
}

// S2 = (3 <u_z^2> - 1) / 2 of Watson's distribution, by Dawson's function; the others are -S2 / 2.
TEST(OrderTensor, WatsonDistributedAxesHaveTheClosedForm) {
  for (const double kappa : {1.0, 4.0, 9.0}) {
    const double exact = (3 * watson_mean_square(kappa) - 1) / 2;
    const auto order = order_tensor(watson_axes(kappa, 4000, 7));
    EXPECT_NEAR(order.value[0], exact, 4 * order.standard_error[0]) << kappa;
    EXPECT_NEAR(order.value[1], -exact / 2, 5 * order.standard_error[1]) << kappa;
    EXPECT_NEAR(order.value[2], -exact / 2, 5 * order.standard_error[2]) << kappa;
    const double off = std::acos(std::min(1.0, std::abs(order.direction[0][2])));
    EXPECT_LT(off * 180 / std::acos(-1.0), 3 * order.director_standard_error) << kappa;
    EXPECT_LT(order.standard_error[0], 0.02);  // the checks above mean something
  }
}

// What many samples of the same distribution show.
struct Spread {
  double mean = 0, deviation = 0, error = 0, without_bias = 0, tilt = 0, tilt_error = 0;
};
Spread spread_of(double kappa, int number, int samples) {
  Spread result;
  std::vector<double> orders;
  for (int k = 0; k < samples; ++k) {
    const auto order = order_tensor(watson_axes(kappa, number, 1000 + static_cast<unsigned>(k)));
    orders.push_back(order.value[0]);
    result.without_bias += order.order_without_bias / samples;
    result.error += std::pow(order.standard_error[0], 2) / samples;
    const double off = std::acos(std::min(1.0, std::abs(order.direction[0][2])));
    result.tilt += off * off / samples;
    result.tilt_error += std::pow(order.director_standard_error, 2) / samples;
  }
  result.mean = std::accumulate(orders.begin(), orders.end(), 0.0) / samples;
  for (const double each : orders)
    result.deviation += std::pow(each - result.mean, 2) / (samples - 1);
  result.deviation = std::sqrt(result.deviation);
  result.error = std::sqrt(result.error);
  result.tilt = std::sqrt(result.tilt) * 180 / std::acos(-1.0);
  result.tilt_error = std::sqrt(result.tilt_error);
  return result;
}

// A standard deviation from m samples is known to 1 / sqrt(2 m), the director's (two components)
// to 1 / sqrt(4 m): 4 of them, and the two further terms of order 1 / number.
TEST(OrderTensor, JackknifeErrorsAreTheSpreadOverManySamples) {
  const auto spread = spread_of(4, 200, 800);
  EXPECT_NEAR(spread.error / spread.deviation, 1, 4 / std::sqrt(1600) + 2.0 / 200);
  EXPECT_NEAR(spread.tilt_error / spread.tilt, 1, 4 / std::sqrt(3200) + 4.0 / 200);
}

// Second-order perturbation: the sample's S mixes the director with the two directions across, at
// which S is lower by 3/2 S2, through components of variance 9/4 <u_z^2 (1 - u_z^2) / 2> / number
// each, which lifts S2 by twice their ratio. The jackknife takes that off, to order 1 / number^2.
TEST(OrderTensor, BiasOfSmallSamplesIsThatOfPerturbationTheoryAndIsTakenOff) {
  const double kappa = 4;
  const int number = 40, samples = 3000;
  const auto spread = spread_of(kappa, number, samples);
  const double square = watson_mean_square(kappa);
  // <u_z^4> by parts, as <u_z^2>: 2 kappa <t^4> = (2 kappa <t^2> + 1) - 3 <t^2>.
  const double fourth = (2 * kappa * square + 1 - 3 * square) / (2 * kappa);
  const double exact = (3 * square - 1) / 2;
  const double bias = 9.0 / 4 * (square - fourth) / (1.5 * exact) / number;
  const double error = 4 * spread.deviation / std::sqrt(samples) + 4.0 / (number * number);
  EXPECT_NEAR(spread.mean - exact, bias, error);
  EXPECT_NEAR(spread.without_bias, exact, error);
  EXPECT_GT(bias, error);  // the checks above mean something
}

TEST(OrderTensor, RandomAxesHaveTheOrderThatIsExpectedOfThem) {
  const int samples = 2000;
  const auto spread = spread_of(0, 200, samples);
  const auto expected = isotropic_order(200);
  EXPECT_NEAR(spread.mean, expected.mean, 4 * expected.deviation / std::sqrt(samples) + 1e-3);
  EXPECT_NEAR(spread.deviation / expected.deviation, 1, 4 / std::sqrt(2.0 * samples) + 1.0 / 200);
}

TEST(OrderTensor, ASingleAxisHasNoError) {
  EXPECT_THROW(order_tensor({}), TooFewParticles);
  EXPECT_THROW(order_tensor({{1, 0, 0}}), TooFewParticles);
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/rigid_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "table.h"

namespace rodpack {
namespace {

using test::observed_order;
using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

// Runs `steps` steps from birth, order 0 by leapfrog; force(t, motion) gives {ax, ay, angular
// acceleration}.
template <class Force>
PlanarMotion run_planar(PlanarMotion motion, int order, double dt, int steps, Force force) {
  std::vector<PlanarRates> history(std::max(1, order));
  for (int n = 0; n < steps; ++n) {
    const Vector a = force(n * dt, motion);
    std::rotate(history.begin(), history.begin() + 1, history.end());
    history.back() = {
        {motion.velocity[0], motion.velocity[1]}, motion.angular_velocity, {a[0], a[1]}, a[2]};
    if (order == 0) {
      leap(motion, history.back(), n + 1, dt);
      continue;
    }
    if (n == 0) fill_kinematic_history(history.data(), order, dt);
    advance(motion, history.data(), order, n + 1, dt);
  }
  return motion;
}

double planar_angle(const PlanarMotion& m) {
  return 2 * std::atan2(m.quaternion[3], m.quaternion[0]);
}

const double inertia[3] = {1.0, 1.7, 2.3};  // kg m^2, asymmetric

// The same in three dimensions, unit mass; force(t) gives {acceleration, torque}.
template <class Force>
SpatialMotion run_spatial(SpatialMotion motion, int order, double dt, int steps, Force force) {
  std::vector<SpatialRates> history(std::max(1, order));
  for (int n = 0; n < steps; ++n) {
    std::rotate(history.begin(), history.begin() + 1, history.end());
    SpatialRates& newest = history.back();
    const std::array<Vector, 2> f = force(n * dt);
    for (int d = 0; d < 3; ++d) {
      newest.velocity[d] = motion.velocity[d];
      newest.acceleration[d] = f[0][d];
      newest.torque[d] = f[1][d];
    }
    quaternion_rate(motion.quaternion, motion.angular_momentum, inertia, newest.quaternion_rate);
    if (order == 0) {
      leap(motion, newest, inertia, n + 1, dt);
      continue;
    }
    if (n == 0) fill_kinematic_history(history.data(), order, dt, motion, inertia);
    advance(motion, history.data(), order, n + 1, dt);
  }
  return motion;
}

// Body axes in the space frame, as columns.
Matrix axes(const SpatialMotion& m) {
  Matrix result;
  for (int column = 0; column < 3; ++column) {
    double unit[3] = {0, 0, 0}, turned[3];
    unit[column] = 1;
    rotate(m.quaternion, unit, false, turned);
    for (int row = 0; row < 3; ++row) result[row][column] = turned[row];
  }
  return result;
}

double difference(const Matrix& a, const Matrix& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::fabs(a[i][j] - b[i][j]));
  return largest;
}

// Reference that shares nothing with the code under test: Euler's equations for the body-frame
// angular velocity w and R' = R [w]x, by many fourth-order Runge-Kutta steps. Torque in the space
// frame.
struct Gyration {
  Vector w;
  Matrix R;
};

template <class Torque>
Gyration derivative(double t, const Gyration& g, Torque torque) {
  Gyration d;
  const Vector space = torque(t);
  Vector body = {0, 0, 0};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) body[i] += g.R[j][i] * space[j];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    d.w[i] = (body[i] + (inertia[j] - inertia[k]) * g.w[j] * g.w[k]) / inertia[i];
    for (int row = 0; row < 3; ++row) d.R[row][i] = g.R[row][j] * g.w[k] - g.R[row][k] * g.w[j];
  }
  return d;
}

Gyration moved(const Gyration& g, double h, const Gyration& d) {
  Gyration result = g;
  for (int i = 0; i < 3; ++i) {
    result.w[i] += h * d.w[i];
    for (int j = 0; j < 3; ++j) result.R[i][j] += h * d.R[i][j];
  }
  return result;
}

template <class Torque>
Gyration runge_kutta(Gyration g, double end, int steps, Torque torque) {
  const double h = end / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const Gyration a = derivative(t, g, torque),
                   b = derivative(t + h / 2, moved(g, h / 2, a), torque),
                   c = derivative(t + h / 2, moved(g, h / 2, b), torque),
                   d = derivative(t + h, moved(g, h, c), torque);
    g = moved(moved(moved(moved(g, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  return g;
}

SpatialMotion tumbling() {
  SpatialMotion m = {{0, 0, 0}, {0.3, -0.2, 0.1}, {0.9, 1.4, -1.1}, {0.5, -0.5, 0.1, 0.7}};
  normalise(m.quaternion);
  return m;
}

Gyration gyration(const SpatialMotion& m) {
  Gyration g;
  g.R = axes(m);
  for (int i = 0; i < 3; ++i) {
    g.w[i] = 0;
    for (int j = 0; j < 3; ++j) g.w[i] += g.R[j][i] * m.angular_momentum[j] / inertia[i];
  }
  return g;
}

double rotational_energy(const SpatialMotion& m) {
  double w[3], sum = 0;
  angular_velocity(m.quaternion, m.angular_momentum, inertia, w);
  for (int d = 0; d < 3; ++d) sum += 0.5 * w[d] * m.angular_momentum[d];
  return sum;
}

TEST(RigidMotion, RotateTurnsBodyAxesIntoTheSpaceFrameAndBack) {
  // 120 degrees about (1,1,1): x -> y -> z -> x; quaternion (1,1,1,1)/2.
  const double q[4] = {0.5, 0.5, 0.5, 0.5}, u[3] = {1, 2, 3};
  double space[3], back[3];
  rotate(q, u, false, space);
  rotate(q, space, true, back);
  const double expected[3] = {3, 1, 2};
  for (int d = 0; d < 3; ++d) {
    EXPECT_NEAR(space[d], expected[d], 1e-15);
    EXPECT_NEAR(back[d], u[d], 1e-15);
  }
}

TEST(RigidMotion, FreeFallIsExactFromOrderTwo) {
  // x = x0 + v0 t + g t^2 / 2 and the same for the angle, from the first step on.
  const PlanarMotion start = {{1, 2}, {0.3, -0.4}, 5, {1, 0, 0, 0}};
  const auto gravity = [](double, const PlanarMotion&) { return Vector{0.7, -9.81, -3}; };
  for (int order = 2; order <= 4; ++order)
    for (int steps : {1, 2, 3, 4, 100}) {
      const double dt = 1e-3, t = steps * dt;
      const PlanarMotion end = run_planar(start, order, dt, steps, gravity);
      EXPECT_NEAR(end.position[0], 1 + 0.3 * t + 0.35 * t * t, 1e-14);
      EXPECT_NEAR(end.position[1], 2 - 0.4 * t - 9.81 / 2 * t * t, 1e-14);
      EXPECT_NEAR(end.velocity[1], -0.4 - 9.81 * t, 1e-14);
      EXPECT_NEAR(planar_angle(end), 5 * t - 1.5 * t * t, 1e-14);
      EXPECT_EQ(end.quaternion[1], 0.0);
      EXPECT_EQ(end.quaternion[2], 0.0);
    }
}

TEST(RigidMotion, FreeFallInThreeDimensionsIsExactFromOrderTwo) {
  const auto gravity = [](double) { return std::array<Vector, 2>{{{1, -9.81, 2}, {0, 0, 0}}}; };
  for (int order = 2; order <= 4; ++order)
    for (int steps : {1, 2, 3, 100}) {
      const double t = steps * 1e-3;
      const SpatialMotion end = run_spatial(tumbling(), order, 1e-3, steps, gravity);
      EXPECT_NEAR(end.position[1], -0.2 * t - 9.81 / 2 * t * t, 1e-14);
      EXPECT_NEAR(end.position[2], 0.1 * t + t * t, 1e-14);
      EXPECT_NEAR(end.velocity[2], 0.1 + 2 * t, 1e-14);
    }
}

// Velocities are those of half a step before the positions.
TEST(RigidMotion, FreeFallByLeapfrogIsExactAndItsVelocityHalfAStepOld) {
  const PlanarMotion start = {{1, 2}, {0.3, -0.4}, 5, {1, 0, 0, 0}};
  const auto gravity = [](double, const PlanarMotion&) { return Vector{0.7, -9.81, -3}; };
  for (int steps : {1, 2, 100}) {
    const double dt = 1e-3, t = steps * dt;
    const PlanarMotion end = run_planar(start, 0, dt, steps, gravity);
    EXPECT_NEAR(end.position[1], 2 - 0.4 * t - 9.81 / 2 * t * t, 1e-14);
    EXPECT_NEAR(end.velocity[1], -0.4 - 9.81 * (t - 0.5 * dt), 1e-14);
    EXPECT_NEAR(planar_angle(end), 5 * t - 1.5 * t * t, 1e-14);
    EXPECT_NEAR(end.angular_velocity, 5 - 3 * (t - 0.5 * dt), 1e-13);
    EXPECT_EQ(end.quaternion[1], 0.0);
  }
}

// x'' = -x from (0, 1): x_n = dt sin(n phi) / sin(phi), cos(phi) = 1 - dt^2 / 2, over 1000 periods
// as in the first one, for steps up to 2.
TEST(RigidMotion, AnOscillatorKeepsItsAmplitudeByLeapfrogAndIsOfSecondOrder) {
  const PlanarMotion start = {{0, 0}, {1, 0}, 0, {1, 0, 0, 0}};
  const auto spring = [](double, const PlanarMotion& m) { return Vector{-m.position[0], 0, 0}; };
  double error[2];
  for (int i = 0; i < 2; ++i) {
    const int steps = 400 << i;
    const double dt = 2.0 / steps;
    const auto end = run_planar(start, 0, dt, steps, spring);
    error[i] =
        std::hypot(end.position[0] - std::sin(2.0), end.velocity[0] - std::cos(2.0 - dt / 2));
  }
  EXPECT_NEAR(observed_order(error[0], error[1]), 2, 0.02);
  for (double dt : {0.1, 0.7, 1.9}) {
    double largest = 0;
    PlanarMotion motion = start;
    for (int n = 0; n < static_cast<int>(6300 / dt); ++n) {
      PlanarRates now = {};
      now.acceleration[0] = -motion.position[0];
      leap(motion, now, n + 1, dt);
      largest = std::max(largest, std::fabs(motion.position[0]));
    }
    EXPECT_NEAR(largest, dt / std::sin(std::acos(1 - dt * dt / 2)), 1e-2) << dt;
  }
}

TEST(RigidMotion, FreeFallOfOrderOneMissesHalfAStep) {
  // Explicit Euler: x_n = v0 t + g dt^2 n(n-1)/2, short of the parabola by g t dt / 2.
  const PlanarMotion start = {{0, 0}, {0, 0}, 0, {1, 0, 0, 0}};
  const auto end = run_planar(start, 1, 0.01, 50, [](double, const PlanarMotion&) {
    return Vector{0, -10, 0};
  });
  EXPECT_NEAR(end.position[1], -5 * 0.25 + 10 * 0.5 * 0.01 / 2, 1e-14);
}

TEST(RigidMotion, ConstantPlanarSpinIsExactOverManyTurns) {
  const PlanarMotion start = {{0, 0}, {0, 0}, 20, {1, 0, 0, 0}};
  const auto end = run_planar(start, 3, 1e-3, 100000, [](double, const PlanarMotion&) {
    return Vector{0, 0, 0};
  });
  EXPECT_NEAR(std::remainder(planar_angle(end) - 2000.0, 4 * std::acos(0.0)), 0, 1e-9);
  EXPECT_NEAR(std::hypot(end.quaternion[0], end.quaternion[3]), 1, 1e-15);
}

TEST(RigidMotion, PlanarForceInTimeShowsTheOrderFromBirth) {
  // a = cos(2t), angular acceleration sin(2t): v = v0 + sin(2t)/2, x = v0 t + (1 - cos(2t))/4,
  // omega = w0 + (1 - cos(2t))/2, angle = w0 t + t/2 - sin(2t)/4. Velocities reach the full order.
  // Positions do where the force has no slope at birth (a), so that the first step misses nothing;
  // where it changes at once (angular: slope 2), the first omega misses dt^2 before the start-up
  // repairs it, and the angle keeps dt times that: order 3 at most.
  const PlanarMotion start = {{0, 0}, {0.3, 0}, 0.5, {1, 0, 0, 0}};
  const auto force = [](double t, const PlanarMotion&) {
    return Vector{std::cos(2 * t), 0, std::sin(2 * t)};
  };
  const int angle_order[] = {1, 2, 3, 3};
  for (int order = 1; order <= 4; ++order) {
    double x[2], v[2], omega[2], angle[2];
    for (int i = 0; i < 2; ++i) {
      const int steps = 800 << i;
      const auto end = run_planar(start, order, 1.0 / steps, steps, force);
      x[i] = std::fabs(end.position[0] - (0.3 + (1 - std::cos(2.0)) / 4));
      v[i] = std::fabs(end.velocity[0] - (0.3 + std::sin(2.0) / 2));
      omega[i] = std::fabs(end.angular_velocity - (0.5 + (1 - std::cos(2.0)) / 2));
      angle[i] = std::fabs(planar_angle(end) - (1 - std::sin(2.0) / 4));
    }
    EXPECT_NEAR(observed_order(v[0], v[1]), order, 0.15) << order;
    EXPECT_NEAR(observed_order(omega[0], omega[1]), order, 0.15) << order;
    EXPECT_NEAR(observed_order(x[0], x[1]), order, 0.15) << order;
    EXPECT_NEAR(observed_order(angle[0], angle[1]), angle_order[order - 1], 0.15) << order;
  }
}

TEST(RigidMotion, OscillatorStartedInMotionReachesOrderThree) {
  // x'' = -x from (0, 1): x = sin t. The force has slope -1 at birth, so orders 1, 2, 3, and 3 for
  // order 4 (see above).
  const PlanarMotion start = {{0, 0}, {1, 0}, 0, {1, 0, 0, 0}};
  const auto spring = [](double, const PlanarMotion& m) { return Vector{-m.position[0], 0, 0}; };
  const int expected[] = {1, 2, 3, 3};
  for (int order = 1; order <= 4; ++order) {
    double error[2];
    for (int i = 0; i < 2; ++i) {
      const int steps = 400 << i;
      const auto end = run_planar(start, order, 2.0 / steps, steps, spring);
      error[i] = std::hypot(end.position[0] - std::sin(2.0), end.velocity[0] - std::cos(2.0));
    }
    EXPECT_NEAR(observed_order(error[0], error[1]), expected[order - 1], 0.15) << order;
  }
}

TEST(RigidMotion, KinematicHistoryIsTheFreeMotionBackwards) {
  // v(-k dt) = v0 - k dt a0; the orientation against the reference run backwards in time.
  const double dt = 0.01;
  const SpatialMotion birth = tumbling();
  const Vector torque = {0.2, -0.3, 0.4};
  SpatialRates history[4] = {};
  SpatialRates& newest = history[3];
  for (int d = 0; d < 3; ++d) {
    newest.velocity[d] = birth.velocity[d];
    newest.acceleration[d] = d + 1;
    newest.torque[d] = torque[d];
  }
  quaternion_rate(birth.quaternion, birth.angular_momentum, inertia, newest.quaternion_rate);
  fill_kinematic_history(history, 4, dt, birth, inertia);
  for (int k = 1; k <= 3; ++k) {
    const SpatialRates& past = history[3 - k];
    for (int d = 0; d < 3; ++d) {
      EXPECT_NEAR(past.velocity[d], birth.velocity[d] - k * dt * (d + 1), 1e-15);
      EXPECT_EQ(past.acceleration[d], 0.0);
      EXPECT_EQ(past.torque[d], 0.0);
    }
    // |dq/dt| = |omega| / 2.
    const auto g = runge_kutta(gyration(birth), -k * dt, 1000, [&](double) { return torque; });
    double squared = 0;
    for (double r : past.quaternion_rate) squared += r * r;
    EXPECT_NEAR(2 * std::sqrt(squared), std::hypot(g.w[0], g.w[1], g.w[2]), 1e-9);
  }
}

TEST(RigidMotion, FreeAsymmetricBodyShowsTheFullOrderFromBirth) {
  const SpatialMotion birth = tumbling();
  const auto free = [](double) { return std::array<Vector, 2>{}; };
  const auto reference = runge_kutta(gyration(birth), 3.0, 30000, [](double) {
    return Vector{0, 0, 0};
  });
  for (int order = 1; order <= 4; ++order) {
    double orientation[2], energy[2];
    for (int i = 0; i < 2; ++i) {
      const int steps = (order == 1 ? 4000 : 600) << i;
      const auto end = run_spatial(birth, order, 3.0 / steps, steps, free);
      orientation[i] = difference(axes(end), reference.R);
      energy[i] = std::fabs(rotational_energy(end) - rotational_energy(birth));
      // Without torque the angular momentum is not touched, whatever the order.
      for (int d = 0; d < 3; ++d) EXPECT_EQ(end.angular_momentum[d], birth.angular_momentum[d]);
    }
    EXPECT_NEAR(observed_order(orientation[0], orientation[1]), order, 0.15) << order;
    EXPECT_NEAR(observed_order(energy[0], energy[1]), order, 0.15) << order;
  }
}

// The same body and torque as below, by leapfrog.
TEST(RigidMotion, ABodyUnderTorqueIsOfSecondOrderByLeapfrog) {
  const SpatialMotion birth = tumbling();
  const auto torque = [](double t) { return Vector{std::cos(t), 0, -std::cos(t)}; };
  const auto reference = runge_kutta(gyration(birth), 2.0, 20000, torque);
  double momentum[2], orientation[2];
  for (int i = 0; i < 2; ++i) {
    const int steps = 400 << i;
    const double dt = 2.0 / steps;
    const auto end = run_spatial(birth, 0, dt, steps, [&](double t) {
      return std::array<Vector, 2>{{{0, 0, 0}, torque(t)}};
    });
    momentum[i] =
        std::fabs(end.angular_momentum[0] - birth.angular_momentum[0] - std::sin(2.0 - 0.5 * dt));
    orientation[i] = difference(axes(end), reference.R);
  }
  EXPECT_NEAR(observed_order(momentum[0], momentum[1]), 2, 0.1);
  EXPECT_NEAR(observed_order(orientation[0], orientation[1]), 2, 0.1);
}

TEST(RigidMotion, TorqueInTimeShowsTheOrderFromBirth) {
  // Torque (cos t, 0, -cos t): L = L0 + (sin t, 0, -sin t). Its slope vanishes at birth, so that
  // the orientation too keeps order 4.
  const SpatialMotion birth = tumbling();
  const auto torque = [](double t) { return Vector{std::cos(t), 0, -std::cos(t)}; };
  const auto reference = runge_kutta(gyration(birth), 2.0, 20000, torque);
  for (int order = 1; order <= 4; ++order) {
    double momentum[2], orientation[2];
    for (int i = 0; i < 2; ++i) {
      const int steps = (order == 1 ? 4000 : 400) << i;
      const auto end = run_spatial(birth, order, 2.0 / steps, steps, [&](double t) {
        return std::array<Vector, 2>{{{0, 0, 0}, torque(t)}};
      });
      momentum[i] = std::fabs(end.angular_momentum[0] - birth.angular_momentum[0] - std::sin(2.0));
      orientation[i] = difference(axes(end), reference.R);
    }
    EXPECT_NEAR(observed_order(momentum[0], momentum[1]), order, 0.15) << order;
    EXPECT_NEAR(observed_order(orientation[0], orientation[1]), order, 0.15) << order;
  }
}

}  // namespace
}  // namespace rodpack

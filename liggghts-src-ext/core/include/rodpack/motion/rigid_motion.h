// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_RIGID_MOTION_H
#define RODPACK_MOTION_RIGID_MOTION_H

#include <cmath>
#include <cstddef>

#include "multistep.h"

namespace rodpack {

// One Adams-Bashforth step of a rigid body. The caller keeps the history: `order` records, oldest
// first and newest last, all `dt` apart. Quaternions are (w, x, y, z) and turn body into space
// frame.
//
// At birth (the first step of a body) the caller stores the newest record and calls
// fill_kinematic_history. Velocities then always enter with full-order Adams-Bashforth weights,
// while forces, unknown before birth, enter with the start-up weights of their own count
// `evaluations` (newest included, 1 at birth).
//
// A body born in free motion shows its full order 1-4 from birth. Where the force depends on the
// position and changes at once, order 4 falls to 3: the first velocity is off by O(dt^2) until the
// start-up repairs it, and the second position has by then used it.

/// Motion in the x-y plane, space frame.
struct PlanarMotion {
  double position[2];       // centre of mass, m
  double velocity[2];       // m/s
  double angular_velocity;  // about z, rad/s
  double quaternion[4];     // x = y = 0 for a body whose own z axis is the z axis
};

struct PlanarRates {
  double velocity[2];           // m/s
  double angular_velocity;      // rad/s
  double acceleration[2];       // m/s^2
  double angular_acceleration;  // rad/s^2

  /// Adds, to a record, what an event of the forces makes it gain.
  PlanarRates& operator+=(const PlanarRates& gain) {
    for (int d = 0; d < 2; ++d) {
      velocity[d] += gain.velocity[d];
      acceleration[d] += gain.acceleration[d];
    }
    angular_velocity += gain.angular_velocity;
    angular_acceleration += gain.angular_acceleration;
    return *this;
  }
};

/// Motion in three dimensions, space frame.
struct SpatialMotion {
  double position[3];          // centre of mass, m
  double velocity[3];          // m/s
  double angular_momentum[3];  // about the centre of mass, kg m^2/s
  double quaternion[4];
};

struct SpatialRates {
  double velocity[3];         // m/s
  double acceleration[3];     // m/s^2
  double torque[3];           // about the centre of mass, N m
  double quaternion_rate[4];  // dq/dt, 1/s

  SpatialRates& operator+=(const SpatialRates& gain) {
    for (int d = 0; d < 3; ++d) {
      velocity[d] += gain.velocity[d];
      acceleration[d] += gain.acceleration[d];
      torque[d] += gain.torque[d];
    }
    for (int d = 0; d < 4; ++d) quaternion_rate[d] += gain.quaternion_rate[d];
    return *this;
  }
};

// The records lie in arrays of doubles of the bodies, in restart files too.
static_assert(offsetof(PlanarRates, velocity) == 0 &&
                  offsetof(PlanarRates, angular_velocity) == 16 &&
                  offsetof(PlanarRates, acceleration) == 24 &&
                  offsetof(PlanarRates, angular_acceleration) == 40 && sizeof(PlanarRates) == 48,
              "six doubles in this order");
static_assert(offsetof(SpatialRates, velocity) == 0 && offsetof(SpatialRates, acceleration) == 24 &&
                  offsetof(SpatialRates, torque) == 48 &&
                  offsetof(SpatialRates, quaternion_rate) == 72 && sizeof(SpatialRates) == 104,
              "thirteen doubles in this order");

inline void normalise(double (&q)[4]) {
  const double scale = 1.0 / std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& c : q) c *= scale;
}

/// Turns the body about the space z axis by `angle`, rad. Components x and y that are 0 stay 0.
inline void rotate_about_z(double angle, double (&q)[4]) {
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  q[0] = c * w - s * z;
  q[1] = c * x - s * y;
  q[2] = c * y + s * x;
  q[3] = c * z + s * w;
  normalise(q);
}

/// Turns `vector` by the unit quaternion q (body to space), or by its inverse (space to body).
inline void rotate(const double (&q)[4], const double (&vector)[3], bool inverse,
                   double (&result)[3]) {
  const double w = inverse ? -q[0] : q[0];
  // t = 2 q_v x u; u' = u + w t + q_v x t
  const double t[3] = {2.0 * (q[2] * vector[2] - q[3] * vector[1]),
                       2.0 * (q[3] * vector[0] - q[1] * vector[2]),
                       2.0 * (q[1] * vector[1] - q[2] * vector[0])};
  result[0] = vector[0] + w * t[0] + q[2] * t[2] - q[3] * t[1];
  result[1] = vector[1] + w * t[1] + q[3] * t[0] - q[1] * t[2];
  result[2] = vector[2] + w * t[2] + q[1] * t[1] - q[2] * t[0];
}

/// Angular velocity in the space frame, rad/s, from the angular momentum (space frame, kg m^2/s)
/// and the principal moments of inertia (kg m^2, all positive).
inline void angular_velocity(const double (&q)[4], const double (&angular_momentum)[3],
                             const double (&inertia)[3], double (&omega)[3]) {
  double body[3];
  rotate(q, angular_momentum, true, body);
  for (int d = 0; d < 3; ++d) body[d] /= inertia[d];
  rotate(q, body, false, omega);
}

/// Quaternion rate dq/dt = q (0, omega_body) / 2, 1/s; arguments as for angular_velocity.
inline void quaternion_rate(const double (&q)[4], const double (&angular_momentum)[3],
                            const double (&inertia)[3], double (&rate)[4]) {
  double w[3];
  rotate(q, angular_momentum, true, w);
  for (int d = 0; d < 3; ++d) w[d] /= inertia[d];
  rate[0] = 0.5 * (-q[1] * w[0] - q[2] * w[1] - q[3] * w[2]);
  rate[1] = 0.5 * (q[0] * w[0] + q[2] * w[2] - q[3] * w[1]);
  rate[2] = 0.5 * (q[0] * w[1] + q[3] * w[0] - q[1] * w[2]);
  rate[3] = 0.5 * (q[0] * w[2] + q[1] * w[1] - q[2] * w[0]);
}

/// (0, omega) q / 2: the rate of a quaternion, 1/s, of a body that turns at `omega` (space frame,
/// rad/s), or its small change by a small rotation.
inline void half_product(const double (&omega)[3], const double (&q)[4], double (&result)[4]) {
  result[0] = 0.5 * (-omega[0] * q[1] - omega[1] * q[2] - omega[2] * q[3]);
  result[1] = 0.5 * (q[0] * omega[0] + omega[1] * q[3] - omega[2] * q[2]);
  result[2] = 0.5 * (q[0] * omega[1] + omega[2] * q[1] - omega[0] * q[3]);
  result[3] = 0.5 * (q[0] * omega[2] + omega[0] * q[2] - omega[1] * q[1]);
}

/// A component of a velocity `age` seconds before birth, as the acceleration at birth, held
/// constant, has it.
inline double velocity_before_birth(double velocity, double acceleration, double age) {
  return velocity - age * acceleration;
}

/// Fills the records before birth, history[0..order-2], from the newest one, history[order-1]: the
/// free motion backwards in time under the forces at birth, held constant. Force entries become 0.
inline void fill_kinematic_history(PlanarRates* history, int order, double dt) {
  const PlanarRates& birth = history[order - 1];
  for (int k = 1; k < order; ++k) {
    PlanarRates& past = history[order - 1 - k];
    past = PlanarRates{};
    for (int d = 0; d < 2; ++d)
      past.velocity[d] = velocity_before_birth(birth.velocity[d], birth.acceleration[d], k * dt);
    past.angular_velocity =
        velocity_before_birth(birth.angular_velocity, birth.angular_acceleration, k * dt);
  }
}

/// Fills the records before birth in three dimensions; the orientation is carried back from `birth`
/// by Runge-Kutta steps of fourth order. `inertia`: principal moments, kg m^2.
void fill_kinematic_history(SpatialRates* history, int order, double dt, const SpatialMotion& birth,
                            const double (&inertia)[3]);

// One leapfrog step, for order 0: velocities are those of half a step before the positions,
//   v_{n+1/2} = v_{n-1/2} + dt a_n,  x_{n+1} = x_n + dt v_{n+1/2}.
// At birth they are those of the positions' time, so the first kick lasts half a step.

/// How long the accelerations act on the velocities in the step after so many `evaluations`, s.
inline double leapfrog_kick(int evaluations, double dt) { return evaluations == 1 ? 0.5 * dt : dt; }

/// Advances the body by one leapfrog step, from the accelerations in `now`. The orientation turns
/// exactly by the increment of the angle.
inline void leap(PlanarMotion& motion, const PlanarRates& now, int evaluations, double dt) {
  const double kick = leapfrog_kick(evaluations, dt);
  for (int d = 0; d < 2; ++d) {
    motion.velocity[d] += kick * now.acceleration[d];
    motion.position[d] += dt * motion.velocity[d];
  }
  motion.angular_velocity += kick * now.angular_acceleration;
  rotate_about_z(dt * motion.angular_velocity, motion.quaternion);
}

/// The same in space, from the accelerations and torques in `now`. The angular momentum of the
/// middle of the step turns the body at the rate that it has there, to second order.
inline void leap(SpatialMotion& motion, const SpatialRates& now, const double (&inertia)[3],
                 int evaluations, double dt) {
  const double kick = leapfrog_kick(evaluations, dt);
  for (int d = 0; d < 3; ++d) {
    motion.velocity[d] += kick * now.acceleration[d];
    motion.position[d] += dt * motion.velocity[d];
    motion.angular_momentum[d] += kick * now.torque[d];
  }
  double rate[4], midway[4];
  quaternion_rate(motion.quaternion, motion.angular_momentum, inertia, rate);
  for (int d = 0; d < 4; ++d) midway[d] = motion.quaternion[d] + 0.5 * dt * rate[d];
  normalise(midway);
  quaternion_rate(midway, motion.angular_momentum, inertia, rate);
  for (int d = 0; d < 4; ++d) motion.quaternion[d] += dt * rate[d];
  normalise(motion.quaternion);
}

/// Advances the body by one step. The orientation turns exactly by the increment of the angle.
inline void advance(PlanarMotion& motion, const PlanarRates* history, int order, int evaluations,
                    double dt) {
  const PlanarRates* newest = history + order - 1;
  const MultistepWeights& of_velocity = adams_bashforth_weights(order);
  const MultistepWeights& of_force = multistep_weights(order, evaluations);
  for (int d = 0; d < 2; ++d) {
    motion.position[d] +=
        multistep_increment(of_velocity, order, dt, [=](int k) { return newest[-k].velocity[d]; });
    motion.velocity[d] +=
        multistep_increment(of_force, order, dt, [=](int k) { return newest[-k].acceleration[d]; });
  }
  rotate_about_z(multistep_increment(of_velocity, order, dt,
                                     [=](int k) { return newest[-k].angular_velocity; }),
                 motion.quaternion);
  motion.angular_velocity += multistep_increment(
      of_force, order, dt, [=](int k) { return newest[-k].angular_acceleration; });
}

/// Advances the body by one step; the quaternion is normalised after it.
inline void advance(SpatialMotion& motion, const SpatialRates* history, int order, int evaluations,
                    double dt) {
  const SpatialRates* newest = history + order - 1;
  const MultistepWeights& of_velocity = adams_bashforth_weights(order);
  const MultistepWeights& of_force = multistep_weights(order, evaluations);
  for (int d = 0; d < 3; ++d) {
    motion.position[d] +=
        multistep_increment(of_velocity, order, dt, [=](int k) { return newest[-k].velocity[d]; });
    motion.velocity[d] +=
        multistep_increment(of_force, order, dt, [=](int k) { return newest[-k].acceleration[d]; });
    motion.angular_momentum[d] +=
        multistep_increment(of_force, order, dt, [=](int k) { return newest[-k].torque[d]; });
  }
  for (int d = 0; d < 4; ++d)
    motion.quaternion[d] += multistep_increment(
        of_velocity, order, dt, [=](int k) { return newest[-k].quaternion_rate[d]; });
  normalise(motion.quaternion);
}

}  // namespace rodpack

#endif

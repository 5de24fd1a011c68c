// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts to which nothing happens but that a body of theirs had an event in the step before: nine
// in ten of those that cannot take the short way, where a bed is being hit.
#include <cmath>

#include "force_evaluator.h"

namespace rodpack {

namespace {

/// Components of a MotionChange along a unit vector.
struct AlongAxis {
  double acceleration, velocity, displacement;
  AlongAxis(const MotionChange& change, double x, double y)
      : acceleration(change.acceleration[0] * x + change.acceleration[1] * y),
        velocity(change.velocity[0] * x + change.velocity[1] * y),
        displacement(change.displacement[0] * x + change.displacement[1] * y) {}
};

}  // namespace

/// What the general way does with such a contact (normal_history.h, tangential_history.h), along
/// normal and tangent; false, with nothing done, if it is none.
bool PlanarForceEvaluator::outlast_jump(PlanarBlockPool& pool, int place, int lane,
                                        const PlanarContact& contact) {
  const PlanarBlockHead& head = pool.heads[place];
  const int bit = 1 << lane;
  MotionChange change;
  if (!follows || !(head.mature & bit) || pool.births[place].fresh[lane] ||
      !(contact.gammat > 0.0) || !events.motion_changed(contact, change))
    return false;
  const double nx = contact.en[0], ny = contact.en[1];
  const AlongAxis normal(change, nx, ny), tangential(change, -ny, nx);
  double* const values = pool.values(place) + lane;
  const PlanarLawConstants& law = laws[pool.laws[place]];

  // The dashpot of the last evaluation did not know of the event.
  const double uncut = contact.kn * contact.deltan - contact.gamman * contact.vn;
  const bool pushes = uncut > 0.0;
  if (pushes != (values[planar_uncut] - contact.gamman * normal.velocity > 0.0)) return false;

  const double dt = settings.dt;
  const MultistepWeights& weights = adams_bashforth_weights(settings.order);
  const double spring_before = values[planar_spring] + tangential.displacement;
  double spring = spring_before, velocity[max_multistep_order];
  for (int k = 0; k < slots; ++k) {
    velocity[k] = values[pool.velocity(k)] + tangential.velocity - k * dt * tangential.acceleration;
    if (k < settings.order) spring += dt * weights[k] * velocity[k];
  }
  const double vt = contact.vtr2 * nx - contact.vtr1 * ny;
  const double trial = -(contact.kt * spring + contact.gammat * vt);
  const double cap = law.friction * contact.deltan;
  const bool slides = (head.sliding & bit) != 0;
  // Sliding goes on while the velocity keeps the direction of the spring.
  if (slides ? !(vt * spring_before > 0.0) : std::fabs(trial) > cap) return false;

  const double friction = slides ? std::copysign(cap, trial) : trial;
  const double along_tangent[3] = {-friction * ny, friction * nx, 0.0};
  apply(contact, pushes ? uncut : 0.0, along_tangent);
  values[planar_spring] = slides ? -friction * law.inverse_kt : spring;
  values[planar_uncut] = uncut;
  for (int k = 0; k < slots; ++k) values[pool.velocity(k)] = velocity[k];
  values[pool.velocity(0, true)] = vt;

  const double gamma_n = pushes ? contact.gamman : 0.0, gamma_t = slides ? 0.0 : contact.gammat;
  if (gamma_n == 0.0 && gamma_t == 0.0) return true;
  const auto force = [&](double along_n, double along_t, double(&result)[3]) {
    result[0] = gamma_n * along_n * nx - gamma_t * along_t * ny;
    result[1] = gamma_n * along_n * ny + gamma_t * along_t * nx;
    result[2] = 0.0;
  };
  double of_acceleration[3], of_velocity[3], of_displacement[3];
  force(normal.acceleration, tangential.acceleration, of_acceleration);
  force(normal.velocity, tangential.velocity, of_velocity);
  force(normal.displacement, tangential.displacement, of_displacement);
  events.add(contact, dashpot_change(1.0, of_acceleration, of_velocity, of_displacement, dt),
             false);
  return true;
}

}  // namespace rodpack

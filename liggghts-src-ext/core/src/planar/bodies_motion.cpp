// SPDX-License-Identifier: GPL-2.0-or-later
// How bodies move in a step, and what the events of their contacts correct.
#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "events.h"

namespace rodpack {

void PlanarBodies::make_missed_motion(int body) {
  PlanarFrame& frame = frames[body];
  PlanarVector &displacement = missed_displacement[body], &velocity = missed_velocity[body];
  frame.x += displacement.d[0];
  frame.y += displacement.d[1];
  const double c = std::cos(displacement.d[2]), s = std::sin(displacement.d[2]);
  const double cosine = frame.cosine * c - frame.sine * s;
  frame.sine = frame.sine * c + frame.cosine * s;
  frame.cosine = cosine;
  for (int d = 0; d < 3; ++d) frame.velocity[d] += velocity.d[d];
  displacement = velocity = PlanarVector();
}

/// As fill_kinematic_history() in rigid_motion.h.
void PlanarBodies::fill_past(int body, long step) {
  for (int k = 0; k < settings.order - 1; ++k) {
    past_acceleration[past(k, step)][body] = PlanarVector();
    for (int d = 0; d < 3; ++d)
      past_velocity[past(k, step)][body].d[d] =
          frames[body].velocity[d] - (k + 1) * settings.dt * inertia[body].d[d] * loads_[body].d[d];
  }
}

void PlanarBodies::prepare(int part, long step) {
  for (int body : missed[part]) make_missed_motion(body);
  missed[part].clear();
  for (int body : newborn_[part]) fill_past(body, step);
  newborn_[part].clear();
}

void PlanarBodies::set_arguments(int part, long step, PlanarAdvance& motions) {
  const int order = settings.order;
  motions.bodies = parts.bodies(part);
  motions.order = order;
  motions.dt = settings.dt;
  motions.frames = frames.data();
  motions.loads = loads_.data();
  motions.gravity = {{settings.gravity[0], settings.gravity[1], 0.0, 0.0}};
  motions.inertia = inertia.data();
  for (int k = 0; k < order - 1; ++k) {
    motions.past_velocity[k] = past_velocity[past(k, step)].data();
    motions.past_acceleration[k] = past_acceleration[past(k, step)].data();
  }
  motions.evaluations = evaluations.data();
  const MultistepWeights& of_velocity = adams_bashforth_weights(order);
  std::copy(of_velocity.begin(), of_velocity.end(), motions.velocity_weights);
  for (int known = 1; known <= order + 1; ++known) {
    const MultistepWeights& of_force = multistep_weights(order, known);
    std::copy(of_force.begin(), of_force.end(), motions.force_weights[known]);
  }
}

void PlanarBodies::begin_loads() {
  std::fill(loads_.begin(), loads_.end(), PlanarVector());
  for (int b = 0; b < owned(); ++b)
    for (int d = 0; d < 2; ++d) loads_[b].d[d] = inertia[b].d[3] * settings.gravity[d];
}

/// Keeps what the forces' changes of branch have missed, and corrects the records of the past so
/// that they continue the new branches backwards (event_correction.h).
void PlanarBodies::apply_events(int part, long step, PlanarEvents& events) {
  events.forget_jumps(part);
  for (const PlanarEvents::Changes& change : events.changes(part)) {
    const int b = change.body;
    if (b >= owned()) continue;  // its own rank sees all of its contacts
    typedef KnownInverse<double> Inverse;
    const PlanarCorrection<Inverse> correction = {Inverse{inertia[b].d[0]},
                                                  Inverse{inertia[b].d[2]}};
    PlanarJump jump = correction.missed(change.sum);
    jump.cosine = frames[b].cosine;
    jump.sine = frames[b].sine;
    std::copy(jump.velocity, jump.velocity + 3, missed_velocity[b].d);
    std::copy(jump.displacement, jump.displacement + 3, missed_displacement[b].d);
    missed[part].push_back(b);
    if (change.jumps) events.set_jumped(b, jump);
    if (evaluations[b] == 0) continue;  // no past yet
    for (int k = 1; k < settings.order; ++k) {
      const PlanarRates gain = correction.past(change.sum, k * settings.dt);
      double *const velocity = past_velocity[past(k - 1, step)][b].d,
                    *const acceleration = past_acceleration[past(k - 1, step)][b].d;
      for (int d = 0; d < 2; ++d) {
        velocity[d] += gain.velocity[d];
        acceleration[d] += gain.acceleration[d];
      }
      velocity[2] += gain.angular_velocity;
      acceleration[2] += gain.angular_acceleration;
    }
  }
  events.forget_changes(part);
}

}  // namespace rodpack

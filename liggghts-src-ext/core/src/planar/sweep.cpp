// SPDX-License-Identifier: GPL-2.0-or-later
// Steps: how bodies move, and when each part of them does.
#include <algorithm>
#include <cmath>

#include "halo.h"
#include "scene_data.h"

namespace rodpack {

void PlanarScene::Data::make_missed_motion(int body) {
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

void PlanarScene::Data::fill_past(int body) {
  for (int k = 0; k < settings.order - 1; ++k) {
    past_acceleration[past(k)][body] = PlanarVector();
    for (int d = 0; d < 3; ++d)
      past_velocity[past(k)][body].d[d] =
          frames[body].velocity[d] - (k + 1) * settings.dt * inertia[body].d[d] * loads[body].d[d];
  }
}

/// Makes some steps in one go through memory: a part of the bodies goes on to the next step as soon
/// as the forces on all of them are complete, while it is still near the processor. Each step takes
/// the parts in their order, so that nothing but the time of the work differs from one step after
/// the other.
void PlanarScene::Data::sweep(int steps) {
  if (statistics.steps % 256 == 128) sort_blocks();
  std::fill_n(made, steps, 0);
  steps_of_sweep = steps;
  while (made[steps - 1] < parts.count()) {
    if (made[0] < parts.count()) step(0);
    for (int stage = 1; stage < steps; ++stage)
      while (made[stage] < parts.count() && completed_by[made[stage]] < made[stage - 1])
        step(stage);
  }
  statistics.steps += steps;
  now = statistics.steps;
  pairs.turn(steps);
  at_walls.turn(steps);
  if (!follows) return;
  for (int part = 0; part < parts.count(); ++part) apply_events(part);
}

/// Makes the next part of a step, the stage of the sweep.
void PlanarScene::Data::step(int stage) {
  const int part = made[stage];
  now = statistics.steps + stage;
  if (stage > 0 && follows) apply_events(part);
  if (part < parts.last()) {
    move(part, steps_of_sweep - 1 - stage);
    if (stage > 0 && !to_list.empty()) {
      // The steps before must not meet the new blocks.
      std::vector<int> listed_later;
      listed_later.swap(to_list);
      for (int before = 0; before < stage; ++before)
        while (made[before] < parts.count()) step(before);
      to_list.swap(listed_later);
      now = statistics.steps + stage;
    }
  } else if (halo) {
    halo->update(*this);
  }
  ++now;
  for (PlanarBlockPool* pool : {&pairs, &at_walls}) pool->look_ahead(stage);
  renew_lists();
  evaluate_forces(part);
  ++made[stage];
}

void PlanarScene::Data::move(int part, int steps_ahead) {
  for (int body : missed[part]) make_missed_motion(body);
  missed[part].clear();
  for (int body : newborn[part]) fill_past(body);
  newborn[part].clear();
  PlanarMotions of_part = motions();
  of_part.bodies = parts.bodies(part);
  of_part.steps_ahead = steps_ahead;
  to_list.resize(of_part.bodies.end - of_part.bodies.first);
  of_part.to_list = to_list.data();
  to_list.resize(kernel.advance(of_part));
}

PlanarMotions PlanarScene::Data::motions() {
  const int order = settings.order;
  PlanarMotions motions = PlanarMotions();
  motions.order = order;
  motions.dt = settings.dt;
  motions.frames = frames.data();
  motions.loads = loads.data();
  motions.gravity = {{settings.gravity[0], settings.gravity[1], 0.0, 0.0}};
  motions.inertia = inertia.data();
  for (int k = 0; k < order - 1; ++k) {
    motions.past_velocity[k] = past_velocity[past(k)].data();
    motions.past_acceleration[k] = past_acceleration[past(k)].data();
  }
  motions.evaluations = evaluations.data();
  const MultistepWeights& of_velocity = adams_bashforth_weights(order);
  std::copy(of_velocity.begin(), of_velocity.end(), motions.velocity_weights);
  for (int known = 1; known <= order + 1; ++known) {
    const MultistepWeights& of_force = multistep_weights(order, known);
    std::copy(of_force.begin(), of_force.end(), motions.force_weights[known]);
  }
  motions.listed = listed_lanes.data();
  motions.moved = moved.data();
  return motions;
}

void PlanarScene::Data::begin_forces() {
  std::fill(loads.begin(), loads.end(), PlanarVector());
  for (int b = 0; b < owned; ++b)
    for (int d = 0; d < 2; ++d) loads[b].d[d] = inertia[b].d[3] * settings.gravity[d];
}

/// Keeps what the forces' changes of branch have missed, and corrects the records of the past so
/// that they continue the new branches backwards (event_correction.h).
void PlanarScene::Data::apply_events(int part) {
  events.forget_jumps(part);
  for (const PlanarEvents::Changes& change : events.changes(part)) {
    const int b = change.body;
    if (b >= owned) continue;  // its own rank sees all of its contacts
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
      double *const velocity = past_velocity[past(k - 1)][b].d,
                    *const acceleration = past_acceleration[past(k - 1)][b].d;
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

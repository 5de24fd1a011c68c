// SPDX-License-Identifier: GPL-2.0-or-later
// How bodies move in a step, and what the events of their contacts correct.
#include <algorithm>
#include <cmath>

#include "bodies.h"
#include "events.h"
#include "vector_operators.h"
#include "../planar_lists/neighbours.h"

namespace rodpack {

namespace {

/// What changes of the forces on a body do to its motion: accelerations, velocities and
/// displacements in the place of forces and their impulses (PlanarCorrection).
ChangeMoments<PlanarVector> motion_change(const PlanarChangeSums& of_forces, double answer,
                                          const PlanarVector& inertia) {
  const PlanarVector share = answer * inertia;
  return {share * of_forces.now, share * of_forces.rate, share * of_forces.impulse,
          share * of_forces.impulse_integral};
}

PlanarJump jump_of(const ChangeMoments<PlanarVector>& change, const PlanarKinematics& now) {
  PlanarJump jump = PlanarJump();
  std::copy_n(change.now.d, 3, jump.acceleration);
  std::copy_n(change.impulse.d, 3, jump.velocity);
  std::copy_n(change.impulse_integral.d, 3, jump.displacement);
  jump.cosine = now.cosine;
  jump.sine = now.sine;
  return jump;
}

}  // namespace

void PlanarBodyStates::make_missed_motion(int body) {
  PlanarKinematics& kinematics = kinematics_[body];
  PlanarVector &displacement = missed_displacement_[body], &velocity = missed_velocity_[body];
  kinematics.x += displacement.d[0];
  kinematics.y += displacement.d[1];
  const Vector2<double> direction =
      turned<double>(std::cos(displacement.d[2]), std::sin(displacement.d[2]),
                     {kinematics.cosine, kinematics.sine});
  kinematics.cosine = direction.x;
  kinematics.sine = direction.y;
  for (int d = 0; d < 3; ++d) kinematics.velocity[d] += velocity.d[d];
  displacement = velocity = PlanarVector();
}

double PlanarBodyStates::answer(int body) const {
  if (!(settings_.mass_scaling > 0.0)) return 1.0;
  return 1.0 / inertia_factor(loads_[body].d[3], settings_.mass_scaling);
}

/// Gives a body that has not moved yet the past of constant acceleration that
/// fill_kinematic_history() in rigid_motion.h derives.
void PlanarBodyStates::fill_past(int body, long step) {
  for (int k = 0; k < settings_.order - 1; ++k) {
    past_acceleration_[past(k, step)][body] = PlanarVector();
    for (int d = 0; d < 3; ++d)
      past_velocity_[past(k, step)][body].d[d] = velocity_before_birth(
          kinematics_[body].velocity[d], answer(body) * inertia_[body].d[d] * loads_[body].d[d],
          (k + 1) * settings_.dt);
  }
}

void PlanarBodyStates::prepare(int part, long step, PlanarNeighbours& neighbours) {
  for (int body : missed_[part]) {
    neighbours.add_path(body, missed_displacement_[body].d);
    make_missed_motion(body);
  }
  missed_[part].clear();
  for (int body : newborn_[part]) fill_past(body, step);
  newborn_[part].clear();
}

void PlanarBodyStates::advance(int part, long step, const PlanarKernel& kernel,
                               PlanarNeighbours& neighbours, int steps_ahead,
                               std::vector<int>& to_list) {
  PlanarAdvanceArguments of_part = arguments(part, step);
  neighbours.set_arguments(steps_ahead, of_part);
  to_list.resize(of_part.bodies.end - of_part.bodies.first);
  of_part.to_list = to_list.data();
  to_list.resize(kernel.advance(of_part));
}

PlanarAdvanceArguments PlanarBodyStates::arguments(int part, long step) {
  PlanarAdvanceArguments arguments = PlanarAdvanceArguments();
  const int order = std::max(1, settings_.order);
  arguments.leapfrog = settings_.order == 0;
  arguments.bodies = parts_.bodies(part);
  arguments.order = order;
  arguments.dt = settings_.dt;
  arguments.kinematics = kinematics_.data();
  arguments.loads = loads_.data();
  arguments.gravity = {{settings_.gravity[0], settings_.gravity[1], 0.0, 0.0}};
  arguments.inertia = inertia_.data();
  if (settings_.mass_scaling > 0.0)
    arguments.inverse_square_scaling = 1.0 / (settings_.mass_scaling * settings_.mass_scaling);
  for (int k = 0; k < order - 1; ++k) {
    arguments.past_velocity[k] = past_velocity_[past(k, step)].data();
    arguments.past_acceleration[k] = past_acceleration_[past(k, step)].data();
  }
  arguments.evaluations = evaluations_.data();
  const auto first = evaluations_.begin() + arguments.bodies.first;
  arguments.any_young =
      std::any_of(first, first + (arguments.bodies.end - arguments.bodies.first),
                  [order](std::int8_t evaluations) { return evaluations <= order; });
  const MultistepWeights& of_velocity = adams_bashforth_weights(order);
  std::copy(of_velocity.begin(), of_velocity.end(), arguments.velocity_weights);
  for (int known = 1; known <= order + 1; ++known) {
    const MultistepWeights& of_force = multistep_weights(order, known);
    std::copy(of_force.begin(), of_force.end(), arguments.force_weights[known]);
  }
  if (arguments.leapfrog) arguments.force_weights[1][0] = leapfrog_kick(1, 1.0);
  return arguments;
}

void PlanarBodyStates::set_arguments(PlanarForceArguments& arguments) {
  arguments.kinematics = kinematics_.data();
  arguments.loads = loads_.data();
}

void PlanarBodyStates::begin_loads() {
  std::fill(loads_.begin(), loads_.end(), PlanarVector());
  for (int b = 0; b < owned(); ++b)
    for (int d = 0; d < 2; ++d) loads_[b].d[d] = inertia_[b].d[3] * settings_.gravity[d];
}

/// Keeps what the forces' changes of branch have missed, and corrects the records of the past so
/// that they continue the new branches backwards (event_correction.h).
void PlanarBodyStates::apply_events(int part, long step, PlanarEvents& events) {
  events.forget_jumps(part);
  // The records of each step of the past, newest first.
  const int records = settings_.order - 1;
  PlanarVector *velocities[max_multistep_order], *accelerations[max_multistep_order];
  for (int k = 0; k < records; ++k) {
    velocities[k] = past_velocity_[past(k, step)].data();
    accelerations[k] = past_acceleration_[past(k, step)].data();
  }
  events.each_changed(part, [&](int b, bool jumps) {
    if (b >= owned()) return;  // its own rank sees all of its contacts
    const ChangeMoments<PlanarVector> of_motion =
        motion_change(events.changes(b), answer(b), inertia_[b]);
    missed_velocity_[b] = of_motion.impulse;
    missed_displacement_[b] = of_motion.impulse_integral;
    missed_[part].push_back(b);
    if (jumps) events.set_jumped(b, jump_of(of_motion, kinematics_[b]));
    if (evaluations_[b] == 0) return;  // no past yet
    for (int k = 0; k < records; ++k) {
      const double age = (k + 1) * settings_.dt;
      velocities[k][b] = velocities[k][b] + past_momentum(of_motion, age);
      accelerations[k][b] = accelerations[k][b] + past_force(of_motion, age);
    }
  });
  events.forget_changes(part);
}

}  // namespace rodpack

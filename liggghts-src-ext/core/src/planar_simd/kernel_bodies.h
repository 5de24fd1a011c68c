// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts with walls and the motion of bodies; included after kernel.h, for lanes of four.

#include "motion_bound.h"

/// Evaluates lasting contacts with walls of the blocks from `first` on; returns the lanes that need
/// the general path.
template <class Load, class Jumps>
inline int evaluate_wall_blocks(int first, const PlanarForceArguments& forces) {
  const LaneHeads heads(forces, first);
  double* const values = values_of(forces, first);
  const double *body[lane_blocks], *wall[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    body[b] = kinematics_at(forces, heads.i()[b]);
    wall[b] = reinterpret_cast<const double*>(&forces.walls[-1 - heads.j()[b]]);
  }
  const LaneBody i = bodies_of(body, values + planar_xi, values + planar_yi);
  Lanes along_x, along_y, position, free_side;
  each_four(wall, 0, along_x, along_y, position, free_side);
  const Lanes distance = (i.x + i.arm.x) * along_x + (i.y + i.arm.y) * along_y - position;
  const Lanes zero = all_lanes(0.0);
  const Lanes own_side = lane_choice(lane_less(distance, zero), all_lanes(-1.0), all_lanes(1.0));
  const Lanes side = lane_choice(lane_less(zero, free_side * free_side), free_side, own_side);
  const int touching =
      ~lane_bits(lane_less(i.radius, distance * side)) & heads.bits(heads.group.used);
  const int here = touching | heads.bits(heads.group.alive);
  if (here == 0) return 0;
  const int lasting = touching & heads.bits(heads.group.full_history);
  const int general = here & ~lasting;
  if (lasting == 0) return general;

  const Vector2<Lanes> still = {zero, zero};
  LaneMotion motion;
  motion.normal = {along_x * side, along_y * side};
  motion.overlap = i.radius - distance * side;
  motion.length_i = lever_length(i.radius, motion.overlap);
  motion.length_j = zero;
  motion.lever_i = lever_in_plane(i.arm, motion.length_i, motion.normal);
  motion.lever_j = still;
  const Vector2<Lanes> of_centre = {i.velocity_x, i.velocity_y};
  set_velocities(motion, velocity_at(of_centre, i.spin, motion.lever_i));
  int sliding = heads.bits(heads.group.sliding);
  const Jumps jumps = Jumps::of(heads, values, motion, forces);
  const LaneForces force =
      lasting_forces<Load>(first, values, motion, lasting, sliding, jumps, forces);
  heads.set_sliding(sliding);
  alignas(64) PlanarVector on_walls = PlanarVector();
  double *load[lane_blocks], *load_of_wall[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load[b] = load_at(forces, heads.i()[b]);
    load_of_wall[b] = on_walls.d;
  }
  add_forces(motion, in_space(motion.normal, force.normal, force.tangential), force.acts, values,
             load, load_of_wall, forces);
  report_jumps(heads, motion, {of_centre, i.arm, still, i.spin, zero, zero}, values, force, jumps,
               forces);
  return general | force.general;
}

template <class Load>
int evaluate_walls(const PlanarForceArguments& forces) {
  int entries = 0;
  for (const PlanarRange& range : {forces.touching, forces.others})
    for (int first = range.first; first < range.end; first += lane_blocks) {
      const int general = have_jumped_at_wall(LaneHeads(forces, first), forces)
                              ? evaluate_wall_blocks<Load, LaneJumps>(first, forces)
                              : evaluate_wall_blocks<Load, NoJumps>(first, forces);
      if (general != 0) enter_general(first, general, forces, entries);
    }
  return entries;
}

/// One multistep step of the velocity; returns the displacement over dt. `ahead`: becomes about the
/// displacement in the steps that are looked ahead.
inline Lanes advance_velocity(const PlanarAdvanceArguments& arguments, int body, Lanes& ahead) {
  const int order = arguments.order;
  if (arguments.evaluations[body] <= order) ++arguments.evaluations[body];
  const double* const of_force = arguments.force_weights[arguments.evaluations[body]];
  double *const load = arguments.loads[body].d, *const velocity =
                                                    arguments.kinematics[body].velocity;
  const Lanes v = load_lanes(velocity);
  const double* const inertia = arguments.inertia[body].d;
  Lanes a = load_lanes(load) * load_lanes(inertia);
  const double factor = load[3] * arguments.inverse_square_scaling;
  if (factor > 1.0) a = (1.0 / factor) * a;
  store_lanes(load, all_lanes(inertia[3]) * load_lanes(arguments.gravity.d));
  Lanes dx = arguments.velocity_weights[0] * v, dv = of_force[0] * a;
  for (int k = 0; k < order - 1; ++k) {
    dx += arguments.velocity_weights[k + 1] * load_lanes(arguments.past_velocity[k][body].d);
    dv += of_force[k + 1] * load_lanes(arguments.past_acceleration[k][body].d);
  }
  // The oldest rates make room for those of this step.
  if (order > 1) {
    store_lanes(arguments.past_velocity[order - 2][body].d, v);
    store_lanes(arguments.past_acceleration[order - 2][body].d, a);
  }
  const Lanes but_the_radius = {1.0, 1.0, 1.0, 0.0};
  const Lanes change = arguments.dt * (dv * but_the_radius), after = v + change;
  store_lanes(velocity, after);
  const double steps = arguments.steps_ahead;
  ahead = (steps * arguments.dt) * (after + (0.5 * steps) * change);
  return arguments.leapfrog ? after : dx;
}

inline void cosine_and_sine(Lanes angle, Lanes& c, Lanes& s) {
  const Lanes one = all_lanes(1.0);
  const Lanes most = all_lanes(1e-4);
  Lanes square = angle * angle;
  int halvings = 0;
  // An angle beyond all numbers, of bodies that blow up, ends as one that is none.
  while (lane_bits(lane_less(most, square)) != 0 && halvings < 1100) {
    angle = 0.5 * angle;
    square = 0.25 * square;
    ++halvings;
  }
  // The first terms left out are below 1e-20.
  c = one - 0.5 * square * (one - (1.0 / 12) * square * (one - (1.0 / 30) * square));
  s = angle *
      (one - (1.0 / 6) * square * (one - (1.0 / 20) * square * (one - (1.0 / 42) * square)));
  for (; halvings > 0; --halvings) {
    const Lanes twice = 2.0 * s;
    const Lanes sine = twice * c;
    c = one - twice * s;
    s = sine;
  }
}

/// Moves the bodies as advance() in rigid_motion.h does in the plane, but turns cosine and sine by
/// the increment of the angle; returns how many bodies it has entered to be listed anew.
int advance(const PlanarAdvanceArguments& arguments) {
  int entries = 0;
  for (int first = arguments.bodies.first; first < arguments.bodies.end; first += body_lanes) {
    // Bodies beyond the last repeat it.
    const int left = arguments.bodies.end - first, members = left < body_lanes ? left : body_lanes;
    Lanes motion[body_lanes], ahead[body_lanes], pose[body_lanes];
    for (int k = 0; k < body_lanes; ++k) {
      motion[k] =
          k < members ? advance_velocity(arguments, first + k, ahead[k]) : motion[members - 1];
      if (k >= members) ahead[k] = ahead[members - 1];
      pose[k] = load_lanes(&arguments.kinematics[first + (k < members ? k : members - 1)].x);
    }
    transpose_lanes(motion);
    transpose_lanes(ahead);
    transpose_lanes(pose);
    const Lanes x = pose[0] + arguments.dt * motion[0], y = pose[1] + arguments.dt * motion[1];
    Lanes c, s;
    cosine_and_sine(arguments.dt * motion[2], c, s);
    const Lanes cosine = pose[2] * c - pose[3] * s, sine = pose[3] * c + pose[2] * s;
    // One Newton step for 1/sqrt: the square of the norm is 1 to a few rounding errors.
    const Lanes scale = all_lanes(1.5) - 0.5 * (cosine * cosine + sine * sine);
    pose[0] = x;
    pose[1] = y;
    pose[2] = cosine * scale;
    pose[3] = sine * scale;

    const PlanarReferenceLanes& at = arguments.references[first / body_lanes];
    const double made = arguments.steps_since, more = arguments.steps_ahead;
    const Lanes step_x = load_lanes(at.step_x), step_y = load_lanes(at.step_y);
    const Lanes rx = x - (load_lanes(at.x) + made * step_x),
                ry = y - (load_lanes(at.y) + made * step_y);
    const Lanes tc = pose[2] - load_lanes(at.cosine), ts = pose[3] - load_lanes(at.sine);
    const Lanes reach = load_lanes(at.reach), strain_step = load_lanes(at.strain_step);
    const Lanes strain = load_lanes(at.strain) + made * strain_step;
    const Lanes moved = motion_bound(rx, ry, reach, tc, ts) + strain;
    store_lanes(arguments.moved + first, moved);
    // A turn's chord is no longer than its arc. Lanes beyond the last body get some path too many.
    const Lanes path =
        motion_bound(arguments.dt * motion[0] - step_x, arguments.dt * motion[1] - step_y, reach,
                     arguments.dt * motion[2], all_lanes(0.0));
    double* const travelled = arguments.travelled + first;
    store_lanes(travelled, load_lanes(travelled) + (path + strain_step));
    const Lanes will_move =
        motion_bound(rx + ahead[0] - more * step_x, ry + ahead[1] - more * step_y, reach,
                     tc - ahead[2] * pose[3], ts + ahead[2] * pose[2]) +
        (strain + more * strain_step);
    const Lanes skin = load_lanes(at.skin);
    const int far = lane_bits(lane_less(skin, moved) | lane_less(skin, will_move));
    transpose_lanes(pose);
    for (int k = 0; k < members; ++k) {
      store_lanes(&arguments.kinematics[first + k].x, pose[k]);
      if (far & 1 << k) arguments.to_list[entries++] = first + k;
    }
  }
  return entries;
}

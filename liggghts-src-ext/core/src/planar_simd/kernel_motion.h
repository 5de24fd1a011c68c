// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of bodies, as many at a time as Lanes have numbers; included after kernel.h.
//
// What lies body by body, four numbers each (x, y, about z, and something else), comes in four
// bundles of bundle_bodies neighbours; what is computed alike for all of them, in lanes of one
// number of each.

#include "motion_bound.h"

constexpr int lane_bodies = 4 * bundle_bodies;  // bodies that are moved at a time
static_assert(body_lanes % lane_bodies == 0, "registers do not reach over the end of references");

/// The bodies of a bundle; beyond the last one there is, that again.
struct BodyBundle {
  int body[bundle_bodies];
  BodyBundle(int first, int last) {
    for (int v = 0; v < bundle_bodies; ++v) body[v] = first + v < last ? first + v : last;
  }
};

/// Numbers of the bodies of a bundle. `whole`: they are all there, and none of them is young.
template <bool whole>
inline Lanes load_bundle(const PlanarVector* of, const BodyBundle& bundle) {
  if (whole) return load_lanes(of[bundle.body[0]].d);
  const double* places[bundle_bodies];
  for (int v = 0; v < bundle_bodies; ++v) places[v] = of[bundle.body[v]].d;
  return load_each(places);
}
template <bool whole>
inline void store_bundle(PlanarVector* of, const BodyBundle& bundle, Lanes x) {
  if (whole) {
    store_lanes(of[bundle.body[0]].d, x);
    return;
  }
  double* places[bundle_bodies];
  for (int v = 0; v < bundle_bodies; ++v) places[v] = of[bundle.body[v]].d;
  store_each(places, x);
}

/// Counts an evaluation of the forces on the bodies of a bundle, and sets the weights of these in
/// the multistep formula, newest first.
inline void set_weights(const PlanarAdvanceArguments& arguments, const BodyBundle& bundle,
                        const double* (&weights)[bundle_bodies]) {
  for (int v = 0; v < bundle_bodies; ++v) {
    signed char& evaluations = arguments.evaluations[bundle.body[v]];
    if (evaluations <= arguments.order && (v == 0 || bundle.body[v] != bundle.body[v - 1]))
      ++evaluations;
    weights[v] = arguments.force_weights[evaluations];
  }
}

/// One multistep step of the velocities of a bundle of bodies; returns their displacements over dt.
/// `ahead`: becomes about the displacement in the steps that are looked ahead.
template <bool whole>
inline Lanes advance_velocity(const PlanarAdvanceArguments& arguments, const BodyBundle& bundle,
                              Lanes& ahead) {
  const int order = arguments.order;
  const double* of_young[bundle_bodies];
  if (!whole) set_weights(arguments, bundle, of_young);
  const double* const of_force = arguments.force_weights[order + 1];
  const auto force_weight = [&](int k) {
    return whole ? all_lanes(of_force[k]) : each_number(of_young, k);
  };
  double* velocity[bundle_bodies];
  for (int k = 0; k < bundle_bodies; ++k)
    velocity[k] = arguments.kinematics[bundle.body[k]].velocity;
  const Lanes v = load_each(velocity), forces = load_bundle<whole>(arguments.loads, bundle),
              inertia = load_bundle<whole>(arguments.inertia, bundle);
  Lanes a = forces * inertia;
  if (arguments.inverse_square_scaling > 0.0) {
    const Lanes one = all_lanes(1.0);
    const Lanes factor = arguments.inverse_square_scaling * fourth_of_each(forces);
    a = (1.0 / lane_choice(lane_less(one, factor), factor, one)) * a;
  }
  store_bundle<whole>(arguments.loads, bundle,
                      fourth_of_each(inertia) * of_every_body(arguments.gravity.d));
  Lanes dx = arguments.velocity_weights[0] * v, dv = force_weight(0) * a;
  for (int k = 0; k < order - 1; ++k) {
    dx +=
        arguments.velocity_weights[k + 1] * load_bundle<whole>(arguments.past_velocity[k], bundle);
    dv += force_weight(k + 1) * load_bundle<whole>(arguments.past_acceleration[k], bundle);
  }
  // The oldest rates make room for those of this step.
  if (order > 1) {
    store_bundle<whole>(arguments.past_velocity[order - 2], bundle, v);
    store_bundle<whole>(arguments.past_acceleration[order - 2], bundle, a);
  }
  alignas(32) static const double but_the_radius[4] = {1.0, 1.0, 1.0, 0.0};
  const Lanes change = arguments.dt * (dv * of_every_body(but_the_radius)), after = v + change;
  store_each(velocity, after);
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

/// Moves `members` bodies from `first` on, as many as lanes have numbers if they are `whole`, as
/// advance() in rigid_motion.h does in the plane, but turns cosine and sine by the increment of the
/// angle; returns a bit for each body that is to be listed anew.
template <bool whole>
inline int advance_bodies(const PlanarAdvanceArguments& arguments, int first, int members) {
  Lanes motion[4], ahead[4], pose[4];
  for (int k = 0; k < 4; ++k) {
    if (!whole && k * bundle_bodies >= members) {  // the one before again
      motion[k] = motion[k - 1];
      ahead[k] = ahead[k - 1];
      pose[k] = pose[k - 1];
      continue;
    }
    const BodyBundle bundle(first + k * bundle_bodies, first + members - 1);
    motion[k] = advance_velocity<whole>(arguments, bundle, ahead[k]);
    const double* places[bundle_bodies];
    for (int v = 0; v < bundle_bodies; ++v) places[v] = &arguments.kinematics[bundle.body[v]].x;
    pose[k] = load_each(places);
  }
  bundles_to_numbers(motion);
  bundles_to_numbers(ahead);
  bundles_to_numbers(pose);
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
  const int lane = first % body_lanes;
  const double made = arguments.steps_since, more = arguments.steps_ahead;
  const Lanes step_x = load_lanes(at.step_x + lane), step_y = load_lanes(at.step_y + lane);
  const Lanes rx = x - (load_lanes(at.x + lane) + made * step_x),
              ry = y - (load_lanes(at.y + lane) + made * step_y);
  const Lanes tc = pose[2] - load_lanes(at.cosine + lane),
              ts = pose[3] - load_lanes(at.sine + lane);
  const Lanes reach = load_lanes(at.reach + lane), strain_step = load_lanes(at.strain_step + lane);
  const Lanes strain = load_lanes(at.strain + lane) + made * strain_step;
  const Lanes moved = motion_bound(rx, ry, reach, tc, ts) + strain;
  store_lanes(arguments.moved + first, moved);
  // A turn's chord is no longer than its arc. Lanes beyond the last body get some path too many.
  const Lanes path =
      motion_bound(arguments.dt * motion[0] - step_x, arguments.dt * motion[1] - step_y, reach,
                   arguments.dt * motion[2], all_lanes(0.0));
  double* const travelled = arguments.travelled + first;
  store_lanes(travelled, load_lanes(travelled) + (path + strain_step));
  const Lanes will_move = motion_bound(rx + ahead[0] - more * step_x, ry + ahead[1] - more * step_y,
                                       reach, tc - ahead[2] * pose[3], ts + ahead[2] * pose[2]) +
                          (strain + more * strain_step);
  const Lanes skin = load_lanes(at.skin + lane);
  store_poses(pose, arguments.kinematics + first, members);
  return lane_bits(lane_less(skin, moved) | lane_less(skin, will_move)) & ((1 << members) - 1);
}

/// Advances all bodies; returns how many it has entered to be listed anew.
int advance(const PlanarAdvanceArguments& arguments) {
  int entries = 0;
  for (int first = arguments.bodies.first; first < arguments.bodies.end; first += lane_bodies) {
    const int left = arguments.bodies.end - first,
              members = left < lane_bodies ? left : lane_bodies;
    int far = members == lane_bodies && !arguments.any_young
                  ? advance_bodies<true>(arguments, first, lane_bodies)
                  : advance_bodies<false>(arguments, first, members);
    for (int body = first; far != 0; ++body, far >>= 1)
      if (far & 1) arguments.to_list[entries++] = body;
  }
  return entries;
}

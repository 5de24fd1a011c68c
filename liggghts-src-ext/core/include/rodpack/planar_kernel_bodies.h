// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts with walls, and the motion of bodies, in lanes of four; included after planar_kernel.h.

static_assert(lane_blocks == 1, "written for one block, and for one body, in a register");

/// Evaluates lasting contacts with a wall, at the `distance` of the spheres' centres from it along
/// its axis; returns the lanes that need the general way.
inline int evaluate_lasting_wall(PlanarBlockHead& head, BlockValues& history, const Arms& arms,
                                 int axis, Lanes distance, int lasting,
                                 const PlanarForces& forces) {
  const PlanarFrame& i = forces.frames[head.i];
  const Lanes zero = all_lanes(0.0), radius = all_lanes(i.radius);
  const Lanes side = lane_choice(lane_less(distance, zero), all_lanes(-1.0), all_lanes(1.0));
  const Lanes nx = axis == 0 ? side : zero, ny = axis == 0 ? zero : side;
  const Lanes overlap = radius - distance * side;
  const Lanes lever = radius - 0.5 * overlap;
  const Lanes px = arms.x - lever * nx, py = arms.y - lever * ny;
  const Lanes ux = i.velocity[0] - i.velocity[2] * py, uy = i.velocity[1] + i.velocity[2] * px;
  PlanarBlockHead* const heads[1] = {&head};
  int sliding = head.sliding;
  const LaneForces force = lasting_forces(heads, history, overlap, ux * nx + uy * ny,
                                          uy * nx - ux * ny, lasting, sliding, forces);
  head.sliding = static_cast<std::uint8_t>(sliding);
  const Lanes fx = force.normal * nx - force.tangential * ny;
  const Lanes fy = force.normal * ny + force.tangential * nx;
  alignas(64) PlanarVector on_wall;
  double *const load_i[1] = {forces.loads[head.i].d}, *const load_j[1] = {on_wall.d};
  add_loads(fx, fy, px * fy - py * fx, zero, load_i, load_j);
  return force.general;
}

int evaluate_walls(const PlanarForces& forces) {
  int entries = 0;
  for (int place = 0; place < forces.count; ++place) {
    PlanarBlockHead& head = forces.heads[place];
    const PlanarFrame& i = forces.frames[head.i];
    const PlanarWall& wall = forces.walls[-1 - head.j];
    double* const block[1] = {reinterpret_cast<double*>(&forces.blocks[place])};
    const double* const frame[1] = {reinterpret_cast<const double*>(&i)};
    double* const history[1] = {forces.histories + static_cast<long>(place) * forces.stride};
    const Arms arms = arms_of(block, block_xi, block_yi, frame);
    const Lanes distance = (wall.axis == 0 ? i.x + arms.x : i.y + arms.y) - all_lanes(wall.position);
    const Lanes side =
        lane_choice(lane_less(distance, all_lanes(0.0)), all_lanes(-1.0), all_lanes(1.0));
    const int used = (1 << head.used) - 1;
    const int touching = ~lane_bits(lane_less(all_lanes(i.radius), distance * side)) & used;
    const int here = touching | head.alive;
    if (here == 0) continue;
    int lasting = touching & head.mature;
    if (forces.jumped && forces.jumped[head.i]) lasting = 0;
    int general = here & ~lasting;
    if (lasting)
      general |= evaluate_lasting_wall(head, history, arms, wall.axis, distance, lasting, forces);
    if (general != 0) forces.general[entries++] = {place, general};
  }
  return entries;
}

/// rigid_motion.h's planar step for all bodies, one register each; the rotation by the increment of
/// the angle is made on cosine and sine.
int advance(const PlanarMotions& motions) {
  int entries = 0;
  const int order = motions.order;
  const double dt = motions.dt;
  for (int b = 0; b < motions.count; ++b) {
    PlanarFrame& frame = motions.frames[b];
    if (motions.evaluations[b] <= order) ++motions.evaluations[b];
    const double* const of_force = motions.force_weights[motions.evaluations[b]];
    double* const load = motions.loads[b].d;
    const Lanes v = load_lanes(frame.velocity);
    const Lanes a = load_lanes(load) * load_lanes(motions.inverse_inertia[b].d);
    store_lanes(load, load_lanes(motions.weights[b].d));
    Lanes dx = motions.velocity_weights[0] * v, dv = of_force[0] * a;
    for (int k = 0; k < order - 1; ++k) {
      dx += motions.velocity_weights[k + 1] * load_lanes(motions.past_velocity[k][b].d);
      dv += of_force[k + 1] * load_lanes(motions.past_acceleration[k][b].d);
    }
    // The oldest rates make room for those of this step. What stands beside the velocity has no
    // acceleration.
    if (order > 1) {
      store_lanes(motions.past_velocity[order - 2][b].d, v);
      store_lanes(motions.past_acceleration[order - 2][b].d, a);
    }
    store_lanes(frame.velocity, v + dt * dv);
    frame.x += dt * dx[0];
    frame.y += dt * dx[1];
    const double angle = dt * dx[2], square = angle * angle;
    double c, s;
    if (square < 1e-3) {  // the first terms left out are below 1e-19
      c = 1.0 - square * (1.0 / 2) *
                    (1.0 - square * (1.0 / 12) *
                               (1.0 - square * (1.0 / 30) *
                                          (1.0 - square * (1.0 / 56) * (1.0 - square * (1.0 / 90)))));
      s = angle *
          (1.0 - square * (1.0 / 6) *
                     (1.0 - square * (1.0 / 20) *
                                (1.0 - square * (1.0 / 42) *
                                           (1.0 - square * (1.0 / 72) * (1.0 - square * (1.0 / 110))))));
    } else {
      c = __builtin_cos(angle);
      s = __builtin_sin(angle);
    }
    const double cosine = frame.cosine * c - frame.sine * s;
    const double sine = frame.sine * c + frame.cosine * s;
    // One Newton step for 1/sqrt: the square of the norm is 1 to a few rounding errors.
    const double scale = 1.5 - 0.5 * (cosine * cosine + sine * sine);
    frame.cosine = cosine * scale;
    frame.sine = sine * scale;

    const PlanarListed& at = motions.listed[b];
    const double rx = frame.x - at.x, ry = frame.y - at.y;
    const double tc = frame.cosine - at.cosine, ts = frame.sine - at.sine;
    // |a| + |b| <= sqrt(2 (a^2 + b^2))
    const double moved = 2.0 * (rx * rx + ry * ry + at.reach * at.reach * (tc * tc + ts * ts));
    motions.moved[b] = __builtin_sqrt(moved);
    if (moved > at.skin * at.skin) motions.to_list[entries++] = b;
  }
  return entries;
}

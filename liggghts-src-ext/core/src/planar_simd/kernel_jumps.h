// SPDX-License-Identifier: GPL-2.0-or-later
// Lasting contacts of bodies that had an event in the step before: what they could not know of its
// jumps, and what their dashpots have missed (normal_history.h and tangential_history.h, along
// normal and tangent). Included by kernel.h.

/// The motion of the centres of both bodies of the contacts in a register, and where the spheres
/// are from there.
struct LaneBodies {
  Vector2<Lanes> relative_velocity;  // of the centres
  Vector2<Lanes> arm_i, arm_j;
  Lanes spin_i, spin_j;
  Lanes inverse_distance;  // of the spheres; 0 at a wall, whose normal does not turn
};

/// The changes of the motion of one side's surface at the contacts.
struct SideJump {
  Vector2<Lanes> acceleration, velocity, displacement;
};
/// They follow from the jumps of the bodies, one for each block. `x`, `y`: of the spheres in the
/// frames of the bodies; `length`: of the levers from there, for j with a minus sign.
inline SideJump side_jump(BlockConstants& of, LaneValues x, LaneValues y, Lanes length,
                          Vector2<Lanes> normal) {
  Lanes ax, ay, aw, vx, vy, vw, dx, dy, dw, cosine, sine, none;
  each_four(of, 0, ax, ay, aw, vx);
  each_four(of, 4, vy, vw, dx, dy);
  each_four(of, 8, dw, cosine, sine, none);
  const Vector2<Lanes> offset = {load_lanes(x), load_lanes(y)}, a = {ax, ay}, v = {vx, vy},
                       d = {dx, dy};
  const Vector2<Lanes> lever = lever_in_plane(turned(cosine, sine, offset), length, normal);
  return {velocity_at(a, aw, lever), velocity_at(v, vw, lever), velocity_at(d, dw, lever)};
}

/// Whether a body of blocks of walls had an event in the step before.
inline bool have_jumped_at_wall(const LaneHeads& heads, const PlanarForceArguments& forces) {
  if (!forces.jumped) return false;
  int jumped = 0;
  for (int b = 0; b < lane_blocks; ++b) jumped |= forces.jumped[heads.body_i(b)];
  return jumped != 0;
}

/// What the jumps of their bodies did to the contacts in a register, along normal and tangent.
struct LaneJumps {
  static constexpr bool any = true;
  JumpAlong<Lanes> normal, tangential;
  int lanes;  // of the blocks whose bodies have jumped; the others' jumps are 0

  static LaneJumps of(const LaneHeads& heads, LaneValues values, const LaneMotion& motion,
                      const PlanarForceArguments& forces) {
    static const PlanarJump none = PlanarJump();
    const double *of_i[lane_blocks], *of_j[lane_blocks];
    LaneJumps jumps;
    jumps.lanes = 0;
    for (int b = 0; b < lane_blocks; ++b) {
      const int i = heads.body_i(b), j = heads.body_j(b);
      const bool i_has = forces.jumped[i] != 0, j_has = j >= 0 && forces.jumped[j] != 0;
      of_i[b] = reinterpret_cast<const double*>(i_has ? &forces.jumps[i] : &none);
      of_j[b] = reinterpret_cast<const double*>(j_has ? &forces.jumps[j] : &none);
      if (i_has || j_has) jumps.lanes |= all_of_block << b * planar_lanes;
    }
    const SideJump i =
        side_jump(of_i, values + planar_xi, values + planar_yi, motion.length_i, motion.normal);
    const SideJump j =
        side_jump(of_j, values + planar_xj, values + planar_yj, -motion.length_j, motion.normal);
    const auto between = [](Vector2<Lanes> a, Vector2<Lanes> b) {
      return Vector2<Lanes>{a.x - b.x, a.y - b.y};
    };
    const Vector2<Lanes> a = between(i.acceleration, j.acceleration),
                         v = between(i.velocity, j.velocity),
                         d = between(i.displacement, j.displacement);
    jumps.normal = {dot(a, motion.normal), dot(v, motion.normal), dot(d, motion.normal)};
    jumps.tangential = {cross_z(motion.normal, a), cross_z(motion.normal, v),
                        cross_z(motion.normal, d)};
    return jumps;
  }
};

/// Stands for the jumps of contacts whose bodies had none.
struct NoJumps {
  static constexpr bool any = false;
  static NoJumps of(const LaneHeads&, LaneValues, const LaneMotion&, const PlanarForceArguments&) {
    return {};
  }
};

/// Puts the jumps into what the contacts remember, `velocity` newest first. The viscoelastic force
/// of the last evaluation stays in `contact`, as it tells which branch the contact was on; `before`
/// becomes what it would have been, had the dashpot known. Returns the lanes with jumps that only
/// the general path knows: those without a dashpot, and, under the cap of the whole normal force,
/// slides, which learn of the jump through that force, and friction that begins anew.
template <class Load>
inline LaneMask follow_jumps(const LaneJumps& jumps, LaneValues values,
                             const PlanarForceArguments& forces,
                             LastingContact<LaneContacts>& contact, Lanes& before,
                             Lanes (&velocity)[max_multistep_order]) {
  const Lanes zero = all_lanes(0.0);
  for (int k = forces.order; k < forces.slots; ++k)
    velocity[k] = load_lanes(values + forces.velocity[k]);
  for (int k = 0; k < forces.slots; ++k)
    velocity[k] = velocity_after(jumps.tangential, k * forces.dt, velocity[k]);
  contact.spring_before = spring_after(jumps.tangential, contact.slid, contact.spring_before);
  before = viscoelastic_before(contact.viscoelastic_before, contact.normal_damping,
                               jumps.normal.velocity);
  LaneMask unfit = ~lane_less(zero, contact.tangential_damping);
  if (Load::damped) unfit = unfit | contact.slid | ~lane_less(zero, before);
  return unfit & lanes_of_bits(jumps.lanes);
}
template <class Load>
inline LaneMask follow_jumps(const NoJumps&, LaneValues, const PlanarForceArguments&,
                             LastingContact<LaneContacts>&, Lanes&,
                             Lanes (&)[max_multistep_order]) {
  return lanes_of_bits(0);
}

/// The same moment of the change of a force along normal and tangent, in space.
inline ChangeMoments<Vector2<Lanes>> moments_in_space(const ChangeMoments<Lanes>& normal,
                                                      const ChangeMoments<Lanes>& tangential,
                                                      Vector2<Lanes> axis) {
  return {in_space(axis, normal.now, tangential.now), in_space(axis, normal.rate, tangential.rate),
          in_space(axis, normal.impulse, tangential.impulse),
          in_space(axis, normal.impulse_integral, tangential.impulse_integral)};
}

/// One side of the contacts in a register, `sign` 1: i, -1: j. The lever and the arm lead from the
/// centre of the body to the contact and to the centre of the sphere, from where the contact is
/// `length` away.
struct LaneSide {
  double sign;
  Vector2<Lanes> lever, arm;
  Lanes length, spin;
};

/// The torque about the centre of the body on a side of the change of a force on i; `turn`: rate of
/// the normal.
inline ChangeMoments<Lanes> torque_about(const LaneSide& side,
                                         const ChangeMoments<Vector2<Lanes>>& force,
                                         const LaneMotion& motion, Vector2<Lanes> turn) {
  const Lanes zero = all_lanes(0.0);
  const Vector2<Lanes> still = {zero, zero}, arm_rate = velocity_at(still, side.spin, side.arm);
  const auto rate = [&](Lanes of_arm, Lanes normal, Lanes of_normal) {
    return lever_rate_component(of_arm, side.sign, side.length, motion.separation_velocity, normal,
                                of_normal);
  };
  const Vector2<Lanes> lever_rate = {rate(arm_rate.x, motion.normal.x, turn.x),
                                     rate(arm_rate.y, motion.normal.y, turn.y)};
  return torque_moments<Lanes>(
      force, [&](const Vector2<Lanes>& moment) { return cross_z(side.lever, moment); },
      [&](const Vector2<Lanes>& moment) { return cross_z(lever_rate, moment); });
}

/// Adds up over the bodies by how much the dashpots of contacts that act have missed the jumps:
/// those of the normal where the contact pushes, those of the tangent where it sticks.
inline void report_jumps(const LaneHeads& heads, const LaneMotion& motion, const LaneBodies& bodies,
                         LaneValues values, const LaneForces& force, const LaneJumps& jumps,
                         const PlanarForceArguments& forces) {
  const int feel = force.acts & jumps.lanes & (force.pushes | ~force.slides);
  if (feel == 0) return;
  const double* gammas[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) gammas[b] = (values + planar_gammas).block(b);
  const Lanes zero = all_lanes(0.0);
  Lanes along_normal, along_tangent;
  each_two(gammas, 0, along_normal, along_tangent);
  along_normal = lane_choice(lanes_of_bits(feel & force.pushes), along_normal, zero);
  along_tangent = lane_choice(lanes_of_bits(feel & ~force.slides), along_tangent, zero);
  const auto moments = [&](Lanes damping, const JumpAlong<Lanes>& jump) {
    return dashpot_moments(damping, jump.acceleration, jump.velocity, jump.displacement, forces.dt);
  };
  const ChangeMoments<Vector2<Lanes>> on_i = moments_in_space(
      moments(along_normal, jumps.normal), moments(along_tangent, jumps.tangential), motion.normal);
  const Vector2<Lanes> centres =
      velocity_at(velocity_at(bodies.relative_velocity, bodies.spin_i, bodies.arm_i),
                  -bodies.spin_j, bodies.arm_j);
  const auto turning = [&](Lanes relative, Lanes normal) {
    return turning_rate_component(relative, motion.separation_velocity, normal,
                                  bodies.inverse_distance);
  };
  const Vector2<Lanes> turn = {turning(centres.x, motion.normal.x),
                               turning(centres.y, motion.normal.y)};
  const LaneSide side_i = {1.0, motion.lever_i, bodies.arm_i, motion.length_i, bodies.spin_i},
                 side_j = {-1.0, motion.lever_j, bodies.arm_j, motion.length_j, bodies.spin_j};
  const ChangeMoments<Lanes> about_i = torque_about(side_i, on_i, motion, turn),
                             about_j = torque_about(side_j, on_i, motion, turn);
  PlanarChangeSums on_walls = PlanarChangeSums(), *of_i[lane_blocks], *of_j[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    const int i = heads.body_i(b), j = heads.body_j(b);
    of_i[b] = &forces.changes[i];
    of_j[b] = j < 0 ? &on_walls : &forces.changes[j];
    if ((feel >> b * planar_lanes & all_of_block) == 0) continue;
    forces.changed[i] |= planar_changed;
    if (j >= 0) forces.changed[j] |= planar_changed;
  }
  const auto add = [&](PlanarVector PlanarChangeSums::*moment, Vector2<Lanes> sum, Lanes of_i_side,
                       Lanes of_j_side) {
    double *to_i[lane_blocks], *to_j[lane_blocks];
    for (int b = 0; b < lane_blocks; ++b) {
      to_i[b] = (of_i[b]->*moment).d;
      to_j[b] = (of_j[b]->*moment).d;
    }
    add_loads(sum.x, sum.y, of_i_side, of_j_side, to_i, to_j);
  };
  add(&PlanarChangeSums::now, on_i.now, about_i.now, about_j.now);
  add(&PlanarChangeSums::rate, on_i.rate, about_i.rate, about_j.rate);
  add(&PlanarChangeSums::impulse, on_i.impulse, about_i.impulse, about_j.impulse);
  add(&PlanarChangeSums::impulse_integral, on_i.impulse_integral, about_i.impulse_integral,
      about_j.impulse_integral);
}
inline void report_jumps(const LaneHeads&, const LaneMotion&, const LaneBodies&, LaneValues,
                         const LaneForces&, const NoJumps&, const PlanarForceArguments&) {}

// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts with walls; included after kernel.h.

/// Evaluates lasting contacts with walls of the blocks from `first` on; returns the lanes that need
/// the general path.
template <class Load, class Jumps>
inline int evaluate_wall_blocks(LanePlaces places, const PlanarForceArguments& forces) {
  const LaneHeads heads(forces, places);
  const LaneValues values = values_of(forces, places);
  const double *body[lane_blocks], *wall[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    body[b] = kinematics_at(forces, heads.i(b));
    wall[b] = reinterpret_cast<const double*>(&forces.walls[-1 - heads.j(b)]);
  }
  const LaneBody i = bodies_of(body, values + planar_xi, values + planar_yi);
  Lanes along_x, along_y, position, free_side;
  each_four(wall, 0, along_x, along_y, position, free_side);
  const Lanes distance = (i.x + i.arm.x) * along_x + (i.y + i.arm.y) * along_y - position;
  const Lanes zero = all_lanes(0.0);
  const Lanes own_side = lane_choice(lane_less(distance, zero), all_lanes(-1.0), all_lanes(1.0));
  const Lanes side = lane_choice(lane_less(zero, free_side * free_side), free_side, own_side);
  const int touching =
      ~lane_bits(lane_less(i.radius, distance * side)) & heads.bits(&PlanarGroupHeads::used);
  const int here = touching | heads.bits(&PlanarGroupHeads::alive);
  if (here == 0) return 0;
  const int lasting = touching & heads.bits(&PlanarGroupHeads::full_history);
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
  int sliding = heads.bits(&PlanarGroupHeads::sliding);
  const Jumps jumps = Jumps::of(heads, values, motion, forces);
  const LaneForces force =
      lasting_forces<Load>(places, values, motion, lasting, sliding, jumps, forces);
  heads.set_sliding(sliding);
  alignas(64) PlanarVector on_walls = PlanarVector();
  double *load[lane_blocks], *load_of_wall[lane_blocks];
  for (int b = 0; b < lane_blocks; ++b) {
    load[b] = load_at(forces, heads.i(b));
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
      const LanePlaces places(&first);
      const int general = have_jumped_at_wall(LaneHeads(forces, places), forces)
                              ? evaluate_wall_blocks<Load, LaneJumps>(places, forces)
                              : evaluate_wall_blocks<Load, NoJumps>(places, forces);
      if (general != 0) enter_general(places, general, forces, entries);
    }
  return entries;
}

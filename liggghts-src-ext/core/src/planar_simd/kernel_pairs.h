// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over the contacts between bodies; included after kernel.h, once it stands in a namespace
// `several_registers` too.

/// The heads of a run of blocks, as PlanarGroupHeads has them.
struct BlockHeads {
  const std::uint32_t* i;
  const std::int32_t* j;
  const float* gap;
  int alive;  // bits
  BlockHeads(const PlanarForceArguments& forces, int first) {
    const PlanarGroupHeads& group = forces.heads[first / planar_group];
    const int in_group = run_blocks == planar_group ? 0 : first % planar_group;
    i = group.i + in_group;
    j = group.j + in_group;
    gap = group.gap + in_group;
    alive = group.alive >> in_group * planar_lanes & all_of_run;
  }
};

/// Whether some body of the blocks has a flag: 0 or 1.
inline int any_of_flags(const std::uint8_t* flags, const BlockHeads& heads) {
  int any = 0;
  for (int b = 0; b < run_blocks; ++b)
    any |= flags[heads.i[b] / planar_stride] |
           flags[static_cast<std::uint32_t>(heads.j[b]) / planar_stride];
  return any != 0;
}

/// How many runs of blocks have to be evaluated: those whose bodies had no event in the step
/// before, and the others.
struct AwakeBlocks {
  int plain = 0, jumped = 0;

  /// Enters a run that is awake in the list of its kind: without branches, as there is no telling
  /// which. `any_jumped`: there are bodies that had an event.
  template <bool any_jumped>
  void enter(int first, const PlanarForceArguments& forces) {
    const int has_jumped = any_jumped ? any_of_flags(forces.jumped, BlockHeads(forces, first)) : 0;
    forces.awake[plain] = first;
    plain += 1 - has_jumped;
    if (!any_jumped) return;
    forces.awake_jumped[jumped] = first;
    jumped += has_jumped;
  }
};

/// All blocks that touched when they were sorted, and those of the others that may touch now.
template <bool any_jumped>
inline AwakeBlocks find_awake(const PlanarForceArguments& forces) {
  AwakeBlocks found;
  for (int first = forces.touching.first; first < forces.touching.end; first += run_blocks)
    found.enter<any_jumped>(first, forces);
  // Of the others most sleep: only those that do not are asked who jumped.
  int* const others = forces.awake + found.plain;
  int count = 0;
  for (int first = forces.others.first; first < forces.others.end; first += run_blocks) {
    const BlockHeads heads(forces, first);
    others[count] = first;
    count += (heads.alive != 0) | any_has_met(forces.travelled, heads.i, heads.j, heads.gap);
  }
  for (int k = 0; k < count; ++k) found.enter<any_jumped>(others[k], forces);
  return found;
}

/// Evaluates the contacts of the awake blocks; returns the number of entries for the general path.
/// `whole_load`: the kind of cap (contact_formulas.h).
template <bool whole_load>
int evaluate_pairs(const PlanarForceArguments& forces) {
  typedef typename Cap<whole_load>::Load Load;
  typedef typename several_registers::Cap<whole_load>::Load LoadOfSeveral;
  const AwakeBlocks awake = forces.jumped ? find_awake<true>(forces) : find_awake<false>(forces);
  int entries = 0;
  // Several registers at a time, with holes beyond the last; those with jumps one by one, as they
  // are few and need many registers each.
  const int several = several_registers::lane_runs;
  for (int k = 0; k < several - 1; ++k) forces.awake[awake.plain + k] = forces.spare;
  for (int k = 0; k < awake.plain; k += several) {
    const several_registers::LanePlaces places(forces.awake + k);
    const int general =
        several_registers::evaluate_blocks<LoadOfSeveral, several_registers::NoJumps>(places,
                                                                                      forces);
    several_registers::enter_general(places, general, forces, entries);
  }
  for (int k = 0; k < awake.jumped; ++k) {
    const LanePlaces places(forces.awake_jumped + k);
    enter_general(places, evaluate_jumped_blocks<Load>(places, forces), forces, entries);
  }
  return entries;
}

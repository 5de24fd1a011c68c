// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BLOCKS_H
#define RODPACK_PLANAR_BLOCKS_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "../planar_simd/aligned_vector.h"
#include "../planar_simd/block_layout.h"
#include "lane_state.h"
#include "parts.h"

namespace rodpack {

class PlanarDependencies;
struct ContactWeight;
struct PlanarForceArguments;
struct PlanarSphere;

/// What the SIMD loops never read of a block: which spheres it pairs, and what a contact remembers
/// of its first steps.
struct PlanarBlockColdData {
  double touch_rate[planar_lanes], since[planar_lanes];
  std::uint16_t sphere_i[planar_lanes], sphere_j[planar_lanes];
  std::int8_t known[planar_lanes];
  bool just_touched[planar_lanes];
};

/// The numbers of a contact beside those that every one has: its normal force one evaluation before
/// the last; what its normal dashpot felt in the last one; its weights of mass scaling.
struct PlanarExtraRows {
  bool earlier = false, felt_velocity = false, weights = false;
};

/// Blocks in groups, and an index of the blocks of each body. Places that no block has are holes,
/// which the SIMD loops may take like blocks: nothing is alive in them, their gap is infinite, they
/// name a body or wall that is there, and their spheres do not coincide, so that the distance of
/// these has an inverse.
///
/// sort() puts the blocks into the order in which their bodies move, part by part, so that forces
/// follow the motion while both are in the cache. A new block takes the place of one that has just
/// been removed, unless that lies in a part before its own, or comes behind all sorted ones.
class PlanarBlockPool {
 public:
  /// @param slots  tangential velocities that a contact remembers
  /// @param hole_j  second body of the holes: 0 or, if the blocks are of walls, -1
  PlanarBlockPool(int bodies, int slots, int hole_j, PlanarExtraRows extra = PlanarExtraRows());

  void resize(int bodies) { of_body_.resize(bodies); }
  /// The number of places, holes too.
  int size() const { return planar_group * (static_cast<int>(heads_.size()) - 1); }
  /// The first place of a group behind all others that is never filled: what the SIMD loops take
  /// with a last group, as they take several at a time.
  int spare() const { return size(); }
  /// The number of blocks.
  int filled() const { return filled_; }
  /// The number of lanes whose spheres are in contact.
  std::size_t contacts() const;
  /// Places of the blocks of a body, in no particular order.
  const std::vector<int>& of_body(int body) const { return of_body_[body]; }

  /// Adds a block to part `part` of the bodies or a later one; returns its place. Its numbers are
  /// 0, or those of a block that was removed.
  int add(int part, const PlanarBlockHead& head, int law, const PlanarBlockColdData& cold);
  /// Makes the place of a block a hole.
  void remove(int place);
  void remove_all_of(int body);
  /// Sets the smallest gap between the spheres of a block at the reference positions (m). The SIMD
  /// loops leave it, and that of a new block, until settle().
  void set_gap(int place, double gap) {
    heads_[place / planar_group].gap[place % planar_group] = rounded_down(gap);
    set_fresh(place);
  }
  /// All bodies are at the same step: what was listed in the pass is like all other blocks now.
  void settle();
  static float rounded_down(double gap) {
    return std::nextafter(static_cast<float>(gap), -std::numeric_limits<float>::infinity());
  }
  /// The place and lane of the candidate pair of these spheres; place -1: there is none.
  std::pair<int, int> find(int i, int sphere_i, int j, int sphere_j) const;

  /// Sorts the blocks by part: first those with contacts, then the others.
  void sort(const PlanarParts& parts);
  /// The blocks of a part that had contacts when they were sorted, in whole groups; of the last
  /// part: all that are left.
  PlanarRange touching(int part) const;
  /// The other blocks of a part, in whole groups; of the last part: new ones too.
  PlanarRange others(int part) const;
  /// The part with which a place is evaluated.
  int part_of(int place) const;

  /// Offset of the velocities k steps back among a block's numbers; `aged`: as it will be when
  /// they have aged by one more step.
  int velocity(int k, bool aged = false) const {
    int row = front_ + k - (aged ? 1 : 0);
    if (row < 0)
      row += slots_;
    else if (row >= slots_)
      row -= slots_;
    return planar_velocities + row * planar_row;
  }
  /// Offset of the normal force one evaluation before the last among a block's numbers.
  int earlier() const { return planar_velocities + slots_ * planar_row; }
  /// Offset of what the normal dashpot felt.
  int felt_velocity() const { return earlier() + (extra_.earlier ? planar_row : 0); }
  /// Offset of the weights of the contacts for body i.
  int weight_i() const { return felt_velocity() + (extra_.felt_velocity ? planar_row : 0); }
  /// The same for body j.
  int weight_j() const { return weight_i() + planar_row; }
  /// Makes the velocities so many steps older.
  void age(int steps) { front_ = newest_ = ring_index(-steps); }
  /// Until they age, velocities are counted from so many steps after the last one: a part of
  /// the bodies may be some steps ahead of others.
  void look_ahead(int steps) { front_ = ring_index(-steps); }
  /// Sets what the SIMD loop needs to evaluate the blocks of a part.
  void set_arguments(int part, PlanarForceArguments& forces);
  /// Tangential velocities that a contact remembers.
  int slots() const { return slots_; }
  PlanarBlockHead head(int place) const { return head_in(heads_, place); }
  /// Index of the constants of the two types of a block.
  int law(int place) const { return laws_[place]; }
  const PlanarBlockColdData& cold(int place) const { return cold_[place]; }
  /// Asks for what the SIMD loops have not read of a block, so that it is in the cache soon.
  void prefetch(int place) const {
    __builtin_prefetch(&cold_[place]);
    __builtin_prefetch(&laws_[place]);
  }
  /// The numbers of a block, from that of the first lane of the first row.
  const double* values(int place) const { return all_values_.data() + first_value(place); }
  /// The same numbers, for bringing the contact of a lane to the present step.
  double* mutable_values(int place) { return all_values_.data() + first_value(place); }
  /// Sets where the spheres that a block pairs lie in the frames of their bodies, among all spheres
  /// of body i and of body j, and the dashpots of their contacts.
  void set_spheres(int place, const PlanarSphere* of_i, const PlanarSphere* of_j,
                   const double (&gammas)[2]);
  /// Sets the weights of the contacts of a block, whose spheres are set, for both of its bodies.
  void set_weights(int place, const ContactWeight& of_i, const ContactWeight& of_j);

  /// Copies the state of the contact of a lane.
  void save(int place, int lane, PlanarLaneState& state) const;
  /// Sets the state of the contact of a lane; the spheres and bodies of the lane stay. `aged`:
  /// the velocities are those of the step after the next time they age.
  void restore(int place, int lane, const PlanarLaneState& state, bool aged = false);
  void clear(int place, int lane) { restore(place, lane, PlanarLaneState()); }

 private:
  std::size_t first_value(int place) const {
    const std::size_t group = place / planar_group;
    return group * rows() * planar_row + place % planar_group * planar_lanes;
  }
  int rows() const {
    return planar_velocities / planar_row + slots_ + extra_.earlier + extra_.felt_velocity +
           2 * extra_.weights;
  }
  int ring_index(int k) const { return ((newest_ + k) % slots_ + slots_) % slots_; }

  static PlanarBlockHead head_in(const AlignedVector<PlanarGroupHeads>& heads, int place) {
    const PlanarGroupHeads& group = heads[place / planar_group];
    const int k = place % planar_group;
    const auto bits = [k](std::uint8_t of_group) {
      return static_cast<std::uint8_t>(of_group >> k * planar_lanes & all_of_block);
    };
    PlanarBlockHead head;
    head.i = static_cast<std::int32_t>(group.i[k] / planar_stride);
    head.j = group.j[k] < 0 ? group.j[k] : group.j[k] / planar_stride;
    head.gap = group.gap[k];
    head.used = bits(group.used);
    head.alive = bits(group.alive);
    head.full_history = bits(group.full_history);
    head.sliding = bits(group.sliding);
    return head;
  }
  void set_head(int place, const PlanarBlockHead& head);
  void set_fresh(int place);
  int take_hole(int part);
  void resize_blocks(int filled, int blocks);
  void empty(int place);
  void make_hole(int place);
  void forget(int body, int place);
  void reorder(const std::vector<int>& order);
  void find_ends(const PlanarParts& parts, int first, int end, std::vector<int>& ends) const;

  const int slots_;
  const PlanarExtraRows extra_;
  AlignedVector<PlanarGroupHeads> heads_;
  AlignedVector<double> all_values_;
  std::vector<int> laws_;
  std::vector<PlanarBlockColdData> cold_;
  PlanarBlockHead hole_ = PlanarBlockHead();
  std::vector<std::vector<int>> of_body_;
  struct EarlyHole {
    int place, part;
  };
  std::vector<EarlyHole> early_holes_;  // among the sorted blocks, in the order of parts
  std::vector<int> holes_;              // behind them
  std::vector<int> fresh_groups_;       // those with blocks listed in this pass
  int newest_ = 0;                      // row of the ring buffer of velocities
  int front_ = 0;                       // the row from which they are counted
  int filled_ = 0;
  int sorted_ = 0;                                      // places of sorted blocks, whole groups
  std::vector<int> ends_of_touching_, ends_of_others_;  // of each part; the last one: its own

  // Memory that sort() works in, kept since new memory costs more than the sorting.
  using SortedBlock = std::pair<std::uint32_t, int>;  // its earlier body, or its wall; its place
  struct SortingWorkspace {
    std::vector<SortedBlock> blocks;
    std::vector<int> ends, order;
    AlignedVector<PlanarGroupHeads> heads;
    AlignedVector<double> values;
    std::vector<int> laws;
    std::vector<PlanarBlockColdData> cold;
  };
  SortingWorkspace work_;
};

/// All blocks of a scene: between two bodies, and between a body and a wall.
class PlanarBlocks {
 public:
  PlanarBlocks(int bodies, int slots, PlanarExtraRows extra = PlanarExtraRows())
      : pairs_(bodies, slots, 0, extra), at_walls_(bodies, slots, -1, extra) {}

  const PlanarBlockPool& pairs() const { return pairs_; }
  const PlanarBlockPool& at_walls() const { return at_walls_; }
  /// The same, for the evaluation of the contacts, which changes them.
  PlanarBlockPool& pairs() { return pairs_; }
  PlanarBlockPool& at_walls() { return at_walls_; }
  /// The pool of the blocks whose second body is j.
  PlanarBlockPool& of(int j) { return j < 0 ? at_walls_ : pairs_; }

  int slots() const { return pairs_.slots(); }
  /// The number of blocks.
  int filled() const { return pairs_.filled() + at_walls_.filled(); }
  /// Makes room for so many bodies.
  void resize(int bodies);
  /// Removes a block whose second body is j, and appends the contacts in it to `contacts`.
  void take_out(int j, int place, std::vector<PlanarLaneState>& contacts);
  void remove_all_of(int body);
  /// Puts a contact into the lane of its spheres; false: they are no candidates.
  bool restore(const PlanarLaneState& contact);
  /// Sorts all blocks, and enters what each part has to wait for.
  void sort(const PlanarParts& parts, PlanarDependencies& dependencies);
  void age(int steps);
  void look_ahead(int steps);
  void settle();

 private:
  PlanarBlockPool pairs_, at_walls_;
};

}  // namespace rodpack

#endif

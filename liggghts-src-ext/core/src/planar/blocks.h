// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BLOCKS_H
#define RODPACK_PLANAR_BLOCKS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "aligned_vector.h"
#include "rodpack/motion/multistep.h"

namespace rodpack {

/// From `first` up to `end`.
struct PlanarRange {
  int first, end;
};

constexpr int planar_lanes = 2;
constexpr int planar_group = 4;  // blocks whose values lie side by side, as many as a kernel takes
constexpr int planar_row = planar_group * planar_lanes;

inline int whole_groups(int blocks) {
  return (blocks + planar_group - 1) / planar_group * planar_group;
}

/// Up to two sphere pairs of two bodies that may touch before one of the two is listed anew; the
/// second may be a wall. What tells whether anything happens in a block:
struct alignas(16) PlanarBlockHead {
  std::int32_t i, j;  // bodies; j = -1 - wall
  float gap;          // spheres are farther from each other where the bodies were listed, m
  // Bit per lane. mature: its history is full. Together they are `flags` of the inner loops.
  std::uint8_t used, alive, mature, sliding;
};

/// Places of what is known about a block in its values, mostly one for each lane: rows, which the
/// blocks of a group share.
enum PlanarBlockValue {
  // centres of the spheres in the frames of their bodies, m; unused lanes repeat the first
  planar_xi = 0,
  planar_yi = planar_row,
  planar_xj = 2 * planar_row,
  planar_yj = 3 * planar_row,
  planar_gammas = 4 * planar_row,  // dashpots along the normal and the tangent, kg/s
  // what a contact remembers: spring (m), force before the cut at 0 (N), and `slots` tangential
  // velocities (m/s), a ring that turns by one in each step
  planar_spring = 5 * planar_row,
  planar_uncut = 6 * planar_row,
  planar_velocities = 7 * planar_row
};

/// Bodies that move one part after the other, in the order of their numbers; the last part: those
/// of other ranks.
struct PlanarParts {
  int owned, size;  // bodies of this rank, and of a part

  int count() const { return (owned + size - 1) / size + 1; }
  int last() const { return count() - 1; }
  /// Bodies of a part but the last.
  PlanarRange bodies(int part) const { return {part * size, std::min(owned, (part + 1) * size)}; }
  int of(int body) const { return body < owned ? body / size : last(); }
  /// That in which both bodies of a block have moved.
  int of(const PlanarBlockHead& head) const { return of(std::max(head.i, head.j)); }
};

/// Constants of the contacts of two types. friction: mu k_n, N/m.
struct PlanarLawConstants {
  double kn, kt, inverse_kt, friction;
};

/// What the short way never reads: which spheres they are, and the first steps of a contact.
struct PlanarBlockBirth {
  double touch_rate[planar_lanes], since[planar_lanes];
  std::uint16_t sphere_i[planar_lanes], sphere_j[planar_lanes];
  std::int8_t count[planar_lanes];
  bool fresh[planar_lanes];
};

/// Blocks in groups, and the list of them for each body. Places that no block has are holes:
/// nothing is alive in them, their gap is endless, they name a body or wall that is there, and the
/// spheres that they name do not coincide, so that their distance has an inverse.
///
/// Blocks lie in the order in which their bodies move, part of the bodies by part, so that forces
/// follow the motion while both are near the processor. New blocks take the places of those that
/// have just been removed, if these are not too early, or come behind all that order.
class PlanarBlockPool {
 public:
  /// hole_j: of the holes, 0 or, if the blocks are of walls, -1.
  PlanarBlockPool(int bodies, int slots, int hole_j) : slots(slots), of_body_(bodies) {
    hole_.j = hole_j;
    hole_.gap = std::numeric_limits<float>::infinity();
  }

  void resize(int bodies) { of_body_.resize(bodies); }
  int size() const { return static_cast<int>(heads.size()); }  // with holes
  int filled() const { return filled_; }
  const std::vector<int>& of_body(int body) const { return of_body_[body]; }

  /// For part `part` of the bodies, or a later one. The values of a new block are 0, or those of a
  /// removed one.
  int add(int part, const PlanarBlockHead& head, int law, const PlanarBlockBirth& birth) {
    const int place = take_hole(part);
    ++filled_;
    heads[place] = head;
    laws[place] = law;
    births[place] = birth;
    of_body_[head.i].push_back(place);
    if (head.j >= 0) of_body_[head.j].push_back(place);
    return place;
  }

  void remove_all_of(int body) {
    for (const int place : of_body_[body]) {
      const PlanarBlockHead& head = heads[place];
      const int other = head.i == body ? head.j : head.i;
      if (other >= 0) forget(other, place);
      make_hole(place);
      --filled_;
    }
    of_body_[body].clear();
  }

  /// Puts the blocks in the given order: order[k] is the present place of the k-th, or -1 for a
  /// hole. The first `touching` of them, whole groups, may go on to touch; they, and the others,
  /// are in the order of their parts.
  void reorder(const std::vector<int>& order, int touching, const PlanarParts& parts);
  /// The groups of each part; of the last one: all that is left.
  PlanarRange touching(int part) const;
  PlanarRange others(int part) const;
  int part_of(int place) const;

  /// Place of the velocities k steps back in the values; `turned`: as after the next turn.
  int velocity(int k, bool turned = false) const {
    return planar_velocities + ring_place(k - ahead_ - (turned ? 1 : 0)) * planar_row;
  }
  void turn(int steps) {
    newest_ = ring_place(-steps);
    ahead_ = 0;
  }
  /// What follows is done for blocks that are so many steps ahead of the last turn.
  void look_ahead(int steps) { ahead_ = steps; }
  int rows() const { return planar_velocities / planar_row + slots; }
  /// Of the first lane of the first row.
  double* values(int place) { return all_values.data() + values_place(place); }
  const double* values(int place) const { return all_values.data() + values_place(place); }

  const int slots;
  AlignedVector<PlanarBlockHead> heads;
  AlignedVector<double> all_values;
  std::vector<int> laws;  // places of the other constants in PlanarForces::laws
  std::vector<PlanarBlockBirth> births;

 private:
  std::size_t values_place(int place) const {
    const std::size_t group = place / planar_group;
    return group * rows() * planar_row + place % planar_group * planar_lanes;
  }

  int ring_place(int k) const { return ((newest_ + k) % slots + slots) % slots; }

  int take_hole(int part);

  /// Room for `blocks` of them in whole groups; places from `filled` on become holes.
  void resize_blocks(int filled, int blocks) {
    const int places = whole_groups(blocks);
    heads.resize(places);
    all_values.resize(static_cast<std::size_t>(places) * rows() * planar_lanes);
    laws.resize(places);
    births.resize(places);
    for (int place = size() - 1; place >= filled; --place) make_hole(place);
  }

  void make_hole(int place) {
    heads[place] = hole_;
    double* const of_place = values(place);
    std::fill_n(of_place + planar_xi, planar_lanes, 1.0);
    for (int row : {planar_yi, planar_xj, planar_yj})
      std::fill_n(of_place + row, planar_lanes, 0.0);
    if (place < ordered_)
      early_holes_.push_back({place, part_of(place)});
    else
      holes_.push_back(place);
  }

  void forget(int body, int place) {
    std::vector<int>& list = of_body_[body];
    for (int& entry : list) {
      if (entry != place) continue;
      entry = list.back();
      list.pop_back();
      return;
    }
  }

  PlanarBlockHead hole_ = PlanarBlockHead();
  std::vector<std::vector<int>> of_body_;
  struct EarlyHole {
    int place, part;
  };
  std::vector<EarlyHole> early_holes_;  // in the order of parts
  std::vector<int> holes_;              // behind it
  int newest_ = 0, ahead_ = 0, filled_ = 0;
  int ordered_ = 0;                                     // blocks in that order, whole groups
  std::vector<int> ends_of_touching_, ends_of_others_;  // of each part; the last one: its own
  // Room for reorder(), kept: memory that the system gives anew costs more than the sorting.
  AlignedVector<PlanarBlockHead> spare_heads_;
  AlignedVector<double> spare_values_;
  std::vector<int> spare_laws_;
  std::vector<PlanarBlockBirth> spare_births_;
};

}  // namespace rodpack

#endif

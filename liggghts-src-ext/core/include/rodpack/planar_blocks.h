// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BLOCKS_H
#define RODPACK_PLANAR_BLOCKS_H

#include <cstdint>
#include <vector>

#include "aligned_vector.h"
#include "multistep.h"

namespace rodpack {

constexpr int planar_lanes = 4;

/// Up to four sphere pairs of two bodies that may touch before one of the two is listed anew; the
/// second may be a wall. Data that every step reads.
struct alignas(64) PlanarBlock {
  double xi[planar_lanes], yi[planar_lanes];  // sphere of i in the frame of the body, m
  double xj[planar_lanes], yj[planar_lanes];  // of j
  double reach[planar_lanes];                 // sum of the radii; 0: empty lane
  double radius_i, radius_j;
  // of the contact; friction: mu k_n, N/m; inverse_kt: 1 / kt
  double kn, kt, inverse_kt, gamma_n, gamma_t, friction;
  std::int32_t i, j;  // bodies; j = -1 - wall
  std::uint16_t sphere_i[planar_lanes], sphere_j[planar_lanes];
  std::uint8_t used, alive, mature, sliding;  // bit per lane; mature: its history is full
};

static_assert(sizeof(PlanarBlock) == 256, "four cache lines");

/// What the contacts of a block remember: read where one of them touches.
struct alignas(64) PlanarBlockHistory {
  double spring[planar_lanes];
  double velocity[max_multistep_order][planar_lanes];
  double uncut[planar_lanes];
};

/// The rest, needed in the first steps of a contact only.
struct PlanarBlockBirth {
  double touch_rate[planar_lanes], since[planar_lanes];
  std::int8_t count[planar_lanes];
  bool fresh[planar_lanes];
};

/// Blocks in one array without holes, and the list of them for each body.
class PlanarBlockPool {
 public:
  explicit PlanarBlockPool(int bodies) : of_body_(bodies) {}

  void resize(int bodies) { of_body_.resize(bodies); }
  int size() const { return static_cast<int>(blocks.size()); }
  const std::vector<int>& of_body(int body) const { return of_body_[body]; }

  int add(const PlanarBlock& block) {
    const int place = size();
    blocks.push_back(block);
    histories.push_back(PlanarBlockHistory());
    births.push_back(PlanarBlockBirth());
    of_body_[block.i].push_back(place);
    if (block.j >= 0) of_body_[block.j].push_back(place);
    return place;
  }

  /// The last block takes its place.
  void remove(int place) {
    forget(blocks[place].i, place);
    if (blocks[place].j >= 0) forget(blocks[place].j, place);
    const int last = size() - 1;
    if (place != last) {
      blocks[place] = blocks[last];
      histories[place] = histories[last];
      births[place] = births[last];
      rename(blocks[place].i, last, place);
      if (blocks[place].j >= 0) rename(blocks[place].j, last, place);
    }
    blocks.pop_back();
    histories.pop_back();
    births.pop_back();
  }

  /// Puts the blocks in the given order: order[k] is the present place of the k-th.
  void reorder(const std::vector<int>& order);

  AlignedVector<PlanarBlock> blocks;
  AlignedVector<PlanarBlockHistory> histories;
  std::vector<PlanarBlockBirth> births;

 private:
  void forget(int body, int place) {
    std::vector<int>& list = of_body_[body];
    for (int& entry : list) {
      if (entry != place) continue;
      entry = list.back();
      list.pop_back();
      return;
    }
  }
  void rename(int body, int from, int to) {
    for (int& entry : of_body_[body])
      if (entry == from) entry = to;
  }

  std::vector<std::vector<int>> of_body_;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BLOCKS_H
#define RODPACK_PLANAR_BLOCKS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "aligned_vector.h"
#include "multistep.h"

namespace rodpack {

constexpr int planar_lanes = 4;

/// Up to four sphere pairs of two bodies that may touch before one of the two is listed anew; the
/// second may be a wall. What tells whether anything happens in a block:
struct PlanarBlockHead {
  std::int32_t i, j;  // bodies; j = -1 - wall
  double gap;         // the least between spheres where the bodies were listed, m
  double gamma[2];    // dashpots along the normal and the tangent, kg/s
  std::int32_t law;                           // place of the other constants in PlanarForces::laws
  std::uint8_t used, alive, mature, sliding;  // used: number of lanes, from the first; the others
                                              // a bit per lane; mature: its history is full
};

/// Centres of the spheres in the frames of their bodies (m); unused lanes repeat the first.
struct alignas(64) PlanarBlock {
  double xi[planar_lanes], yi[planar_lanes];
  double xj[planar_lanes], yj[planar_lanes];
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

/// Blocks in one array without holes, and the list of them for each body. What the contacts of a
/// block remember lies in `histories`: spring, uncut force and `slots` tangential velocities, each
/// for all lanes. The velocities are a ring that turns by one in each step.
class PlanarBlockPool {
 public:
  PlanarBlockPool(int bodies, int slots) : slots(slots), of_body_(bodies) {}

  int size() const { return static_cast<int>(heads.size()); }
  const std::vector<int>& of_body(int body) const { return of_body_[body]; }

  int add(const PlanarBlockHead& head, const PlanarBlock& block, const PlanarBlockBirth& birth) {
    const int place = size();
    heads.push_back(head);
    blocks.push_back(block);
    histories.resize(histories.size() + stride());
    births.push_back(birth);
    of_body_[head.i].push_back(place);
    if (head.j >= 0) of_body_[head.j].push_back(place);
    return place;
  }

  /// The last block takes its place.
  void remove(int place) {
    forget(heads[place].i, place);
    if (heads[place].j >= 0) forget(heads[place].j, place);
    const int last = size() - 1;
    if (place != last) {
      heads[place] = heads[last];
      blocks[place] = blocks[last];
      std::copy_n(history(last), stride(), history(place));
      births[place] = births[last];
      rename(heads[place].i, last, place);
      if (heads[place].j >= 0) rename(heads[place].j, last, place);
    }
    heads.pop_back();
    blocks.pop_back();
    histories.resize(histories.size() - stride());
    births.pop_back();
  }

  /// Puts the blocks in the given order: order[k] is the present place of the k-th.
  void reorder(const std::vector<int>& order);

  static constexpr int spring = 0, uncut = planar_lanes;  // places in the history of a block
  /// Place of the velocities k steps back; `turned`: as after the next turn.
  int velocity(int k, bool turned = false) const {
    return (2 + (newest_ + (turned ? slots - 1 : 0) + k) % slots) * planar_lanes;
  }
  void turn() { newest_ = (newest_ + slots - 1) % slots; }
  int stride() const { return (2 + slots) * planar_lanes; }
  double* history(int place) {
    return histories.data() + static_cast<std::size_t>(place) * stride();
  }
  const double* history(int place) const {
    return histories.data() + static_cast<std::size_t>(place) * stride();
  }

  const int slots;
  AlignedVector<PlanarBlockHead> heads;
  AlignedVector<PlanarBlock> blocks;
  AlignedVector<double> histories;
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
  int newest_ = 0;
};

}  // namespace rodpack

#endif

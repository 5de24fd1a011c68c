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
  // Bit per lane. mature: its history is full. Together they are `flags` of the inner loops.
  std::uint8_t used, alive, mature, sliding;
};

/// Places of what is known about the lanes of a block in its values, each for all lanes.
enum PlanarBlockValue {
  // centres of the spheres in the frames of their bodies, m; unused lanes repeat the first
  planar_xi = 0,
  planar_yi = planar_lanes,
  planar_xj = 2 * planar_lanes,
  planar_yj = 3 * planar_lanes,
  // what a contact remembers: spring (m), force before the cut at 0 (N), and `slots` tangential
  // velocities (m/s), a ring that turns by one in each step
  planar_spring = 4 * planar_lanes,
  planar_uncut = 5 * planar_lanes,
  planar_velocities = 6 * planar_lanes
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

/// Blocks in arrays without holes, and the list of them for each body.
class PlanarBlockPool {
 public:
  PlanarBlockPool(int bodies, int slots) : slots(slots), of_body_(bodies) {}

  int size() const { return static_cast<int>(heads.size()); }
  const std::vector<int>& of_body(int body) const { return of_body_[body]; }

  /// The values of the new block are 0.
  int add(const PlanarBlockHead& head, const PlanarBlockBirth& birth) {
    const int place = size();
    heads.push_back(head);
    all_values.resize(all_values.size() + stride());
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
      std::copy_n(values(last), stride(), values(place));
      births[place] = births[last];
      rename(heads[place].i, last, place);
      if (heads[place].j >= 0) rename(heads[place].j, last, place);
    }
    heads.pop_back();
    all_values.resize(all_values.size() - stride());
    births.pop_back();
  }

  /// Puts the blocks in the given order: order[k] is the present place of the k-th.
  void reorder(const std::vector<int>& order);

  /// Place of the velocities k steps back in the values; `turned`: as after the next turn.
  int velocity(int k, bool turned = false) const {
    return planar_velocities + (newest_ + (turned ? slots - 1 : 0) + k) % slots * planar_lanes;
  }
  void turn() { newest_ = (newest_ + slots - 1) % slots; }
  int stride() const { return planar_velocities + slots * planar_lanes; }
  double* values(int place) {
    return all_values.data() + static_cast<std::size_t>(place) * stride();
  }
  const double* values(int place) const {
    return all_values.data() + static_cast<std::size_t>(place) * stride();
  }

  const int slots;
  AlignedVector<PlanarBlockHead> heads;
  AlignedVector<double> all_values;
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

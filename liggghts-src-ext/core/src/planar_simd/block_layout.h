// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_BLOCK_LAYOUT_H
#define RODPACK_PLANAR_BLOCK_LAYOUT_H

#include <cstdint>

namespace rodpack {

// How contacts lie in memory for the SIMD loops. A block holds up to two candidate pairs of spheres
// of the same two bodies, one in each of its SIMD lanes. Blocks form groups of four, whose numbers
// lie side by side: eight doubles of a kind, one cache line, make a row.

constexpr int planar_lanes = 2;  // SIMD lanes of a block
constexpr int planar_group = 4;  // blocks of a group, as many as the widest registers take
constexpr int planar_row = planar_group * planar_lanes;
constexpr int all_of_block = (1 << planar_lanes) - 1;  // bits of its lanes

inline int whole_groups(int blocks) {
  return (blocks + planar_group - 1) / planar_group * planar_group;
}

/// The part of a block that tells whether anything happens in it. The second body may be a wall.
struct PlanarBlockHead {
  std::int32_t i, j;  // bodies; j = -1 - wall
  // The smallest gap between the spheres of its pairs, and what the two bodies had travelled when
  // it was that; first that at their reference positions, where each of them was listed last, m.
  // They cannot touch before both together have travelled so far.
  float gap;
  // One bit for each lane. used: the lane holds a candidate pair; alive: its spheres were in
  // contact in the last step; full_history: the contact has lasted for so many steps that its
  // history is full; sliding: it slid in the last step.
  std::uint8_t used, alive, full_history, sliding;
};

constexpr int planar_stride_bits = 5, planar_stride = 1 << planar_stride_bits;  // bytes of a vector

/// The heads of the blocks of a group, as the SIMD loops take them: the bodies as distances in
/// bytes among the vectors of all bodies, the second one of a wall as it is; the bits of all lanes
/// side by side.
struct alignas(64) PlanarGroupHeads {
  std::uint32_t i[planar_group];
  std::int32_t j[planar_group];
  float gap[planar_group];
  std::uint8_t used, alive, full_history, sliding;
  // A bit for each block that was listed in this pass: its bodies may be some steps apart.
  std::uint8_t fresh;
};

/// Offsets of a block's numbers from the first of them, which has one for each lane in most rows.
enum PlanarBlockValue {
  // Centres of the spheres in the frames of their bodies, m; unused lanes repeat the first.
  planar_xi = 0,
  planar_yi = planar_row,
  planar_xj = 2 * planar_row,
  planar_yj = 3 * planar_row,
  planar_gammas = 4 * planar_row,  // dashpots along the normal and the tangent, kg/s
  // The contact history: tangential spring (m), normal force before its cut-off at 0 (N), and the
  // tangential velocities of the last steps (m/s), a ring buffer that ages by one in each step.
  planar_spring = 5 * planar_row,
  planar_viscoelastic = 6 * planar_row,
  planar_velocities = 7 * planar_row
  // Behind the velocities, under the cap of the whole normal force alone: the normal force before
  // its cut-off one evaluation before the last, N. Behind that, with a relaxation time of dashpots
  // alone: what the normal one felt, m/s; NaN where it has felt nothing yet, which the SIMD loops
  // do not look at. Last, with mass scaling alone: the weights of the contact for body i and for
  // body j (mass_scaling.h).
};

/// Constants of the contacts of two types. friction: of the cap (friction_cap.h), mu k_n (N/m) or
/// mu.
struct PlanarLawConstants {
  double kn, kt, inverse_kt, friction;
};

}  // namespace rodpack

#endif

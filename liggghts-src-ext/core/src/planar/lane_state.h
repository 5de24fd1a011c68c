// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_LANE_STATE_H
#define RODPACK_PLANAR_LANE_STATE_H

#include <cstdint>

#include "rodpack/contact/planar_history.h"

namespace rodpack {

/// State of the contact of a lane, apart from where it lies: bodies and spheres as in
/// PlanarContactState, its history, and whether that is full.
struct PlanarLaneState {
  int i, j;
  std::uint16_t sphere_i, sphere_j;
  bool full_history;
  PlanarHistory history;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_CANDIDATES_H
#define RODPACK_PLANAR_CANDIDATES_H

#include <vector>

#include "../planar_simd/arguments.h"
#include "../planar/box.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

/// Two spheres that may touch before one of their bodies is listed again.
struct PlanarCandidate {
  double gap;  // between them at the reference positions of their bodies, m
  int sphere_i, sphere_j;
};

/// A body as the search for candidates sees it: its spheres and its reference position.
struct PlanarChain {
  const PlanarSphere* spheres;
  int count;
  double radius;  // of the spheres, m
  const PlanarBox& box;
  PlanarReference at;
};

/// Whether spheres of bodies i and j may be candidates, as far as their boxes tell.
bool are_close(const PlanarChain& i, const PlanarChain& j);
/// Appends the sphere pairs of bodies i and j whose gap is less than both skins together.
void find_candidates(const PlanarChain& i, const PlanarChain& j,
                     std::vector<PlanarCandidate>& candidates);
/// Appends the spheres whose gap to the wall is less than the skin of their body; sphere_j is 0.
void find_candidates(const PlanarChain& i, const PlanarWall& wall,
                     std::vector<PlanarCandidate>& candidates);
/// Sorts by gap, then by spheres, so that pairs that touch share blocks.
void sort_candidates(std::vector<PlanarCandidate>& candidates);

}  // namespace rodpack

#endif

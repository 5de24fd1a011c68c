// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_NEIGHBOURHOOD_H
#define RODPACK_ANALYSIS_SPACE_NEIGHBOURHOOD_H

#include <functional>
#include <utility>
#include <vector>

#include "analysis/space/ball_in_box.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// What of a packing in space its pair correlations look at: centres in the region, neighbours in
/// the window around it.
struct Neighbourhood {
  Box region, window;
  double region_volume = 0;  // of one period where the region is endless
  std::vector<Vector3> place;
  std::vector<std::size_t> particle;         // its place in the packing
  std::vector<bool> is_centre, is_original;  // not original: a periodic image
  std::vector<std::size_t> centres;          // entries of the arrays above, each particle once
};

/// The smallest extent of the bed between walls and up to the surface, m; infinite if it has
/// neither.
double least_extent(const SpatialPacking& packing);

/// Finds the neighbourhood: the region `margin` away from walls and surface, the window `strip`, m.
/// In a cylinder both are the upright square prisms within it. A periodic axis has no margin; boxes
/// are endless along it, and images count that a centre can see within `reach`, m.
/// @throws TooFewParticles when fewer than 2 centres are left, DataError when `reach` exceeds half
///   of a period.
Neighbourhood neighbourhood(const SpatialPacking& packing, double margin, double strip,
                            double reach);

/// Calls `visit` for every centre and each neighbour of it nearer than `reach`, m: their entries,
/// and from the centre to the neighbour, m.
void for_neighbours(
    const Neighbourhood& points, double reach,
    const std::function<void(std::size_t centre, std::size_t neighbour, const Vector3&)>& visit);

}  // namespace rodpack

#endif

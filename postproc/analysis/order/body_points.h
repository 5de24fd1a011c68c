// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_ORDER_BODY_POINTS_H
#define RODPACK_ANALYSIS_ORDER_BODY_POINTS_H

#include <array>
#include <functional>
#include <vector>

#include "reading/dump.h"
#include "reading/packing.h"
#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {

/// Points of one particle, n x 2, m.
using PointList = std::vector<std::array<double, 2>>;

/// Returns points of every particle of a frame of the bodies' dump, seen from its centre of mass in
/// the frame of the packing. `of_shape`: gives them in the body frame of such a chain.
/// @throws DataError naming the dump when a column is missing or a particle has no valid shape.
std::vector<PointList> body_points(const Frame& bodies, const Packing& packing,
                                   const std::function<PointList(const ChainShape&)>& of_shape);

}  // namespace rodpack

#endif

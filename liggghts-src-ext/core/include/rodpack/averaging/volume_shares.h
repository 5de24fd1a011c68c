// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_AVERAGING_VOLUME_SHARES_H
#define RODPACK_AVERAGING_VOLUME_SHARES_H

#include <vector>

#include "../geometry/chain_geometry.h"

namespace rodpack {

/// Each sphere's share of the particle's volume, in the order of sphere_centres(); they add up
/// to 1. A point that lies in k spheres belongs to each of them by 1/k (LIGGGHTS's volume weight of
/// a clump, which it samples). Exact for a straight chain; a curved one has the shares of the
/// straight chain with the same distance between neighbours.
/// @throws std::invalid_argument for an invalid shape.
std::vector<double> volume_shares(const ChainShape& shape);

}  // namespace rodpack

#endif

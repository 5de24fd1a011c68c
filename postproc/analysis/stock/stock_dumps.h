// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_STOCK_STOCK_DUMPS_H
#define RODPACK_ANALYSIS_STOCK_STOCK_DUMPS_H

#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// Returns a frame of bodies as `dump multisphere/body` has them, without mass and angular
/// velocity: `frame` itself where it is one; of LIGGGHTS's own `dump custom` (columns id type x y z
/// radius, and id_multisphere or mol) the straight chains that its spheres of one body are. A
/// body's id is that of the column, its type the spheres' atom type; a sphere in no body (0 or -1)
/// is a particle of its own, its id the atom's plus the largest body's.
/// @throws DataError that names the line to add to the deck for a dump of something else, and
/// naming
///   the body where its spheres differ in radius, lie on no straight line at even distances, or are
///   some of the body's alone.
Frame as_bodies(const Frame& frame);

/// The body of each sphere of such a stock dump, one per row, by the ids of as_bodies().
std::vector<double> bodies_of_spheres(const Frame& spheres);

/// Refuses what is no dump of contacts: LIGGGHTS's `dump local` names its columns after the deck's
/// compute, not after what they hold. @throws DataError with the line to add to the deck.
void require_contact_dump(const Frame& frame);

}  // namespace rodpack

#endif

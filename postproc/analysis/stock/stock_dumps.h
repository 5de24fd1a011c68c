// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_STOCK_STOCK_DUMPS_H
#define RODPACK_ANALYSIS_STOCK_STOCK_DUMPS_H

#include <string>
#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// Whether it is a dump of spheres that as_bodies() makes bodies of.
bool is_stock_dump(const Frame& frame);

/// Returns a frame of bodies as `dump multisphere/body` has them: `frame` itself where it is one;
/// of LIGGGHTS's own `dump custom` (columns id type x y z radius, and id_multisphere or mol) the
/// straight chains that its spheres of one body are. A body's id is that of the column, its type
/// the spheres' atom type; a sphere in no body (0 or -1) is a particle of its own, its id the
/// atom's plus the largest body's. Mass, velocity and angular velocity are among the columns where
/// `mass`, `vx vy vz` and `omegax omegay omegaz` are among those of the dump: each sphere carries
/// the mass of the whole body there.
/// @throws DataError that names the line to add to the deck for a dump of something else, and
/// naming
///   the body where its spheres differ in radius or mass, lie on no straight line at even
///   distances, or are some of the body's alone.
Frame as_bodies(const Frame& frame);

/// Why these bodies have no fields: a stock dump need not tell mass and velocity. Empty where they
/// do.
std::string why_no_motion(const Frame& bodies);
/// @throws DataError with that reason.
void require_motion(const Frame& bodies);

/// The body of each sphere of such a stock dump, one per row, by the ids of as_bodies().
std::vector<double> bodies_of_spheres(const Frame& spheres);

/// Why it is no dump of contacts, with the line to add to the deck; empty where it is one:
/// LIGGGHTS's `dump local` names its columns after the deck's compute, not after what they hold.
std::string why_no_contact_dump(const Frame& frame);
/// @throws DataError with that reason.
void require_contact_dump(const Frame& frame);

}  // namespace rodpack

#endif

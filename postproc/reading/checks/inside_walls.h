// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_INSIDE_WALLS_H
#define RODPACK_READING_CHECKS_INSIDE_WALLS_H

#include <string>
#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// Refuses walls that do not hold the particles of a frame, such as those of another run or unit.
/// `beyond`: how far each centre of mass lies beyond them, m, negative inside; `source`: where the
/// walls come from. Single particles may have been thrown out, and soft walls let centres in.
/// @throws DataError naming file and line of the first one, when more than one particle in a
/// hundred
///   lies further than `particle_diameter` (m) beyond them.
void require_inside_walls(const Frame& bodies, const std::vector<double>& beyond,
                          double particle_diameter, const std::string& source);

}  // namespace rodpack

#endif

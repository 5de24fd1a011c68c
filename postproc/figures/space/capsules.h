// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_CAPSULES_H
#define RODPACK_FIGURES_SPACE_CAPSULES_H

#include <string>

#include "reading/dump.h"

namespace rodpack {

/// Writes the bodies of a dump (columns `nspheres x y z qw qx qy qz half_length radius curvature`)
/// as closed surfaces of four- and three-sided cells: what a ball sweeps that moves along the
/// centreline, straight or an arc; a compressed VTK PolyData file (.vtp), lengths in m. The corners
/// lie on the true surface. Cells have the arrays of their body, as write_vtp() names them.
/// @throws DataError when a column is missing, there is no such chain, or the file cannot be
/// written.
void write_capsules(const Frame& bodies, const std::string& file);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_BODY_VOLUMES_H
#define RODPACK_ANALYSIS_SPACE_BODY_VOLUMES_H

#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// Volume of each body, m^3: of the union of the spheres of the chain that the columns `nspheres
/// half_length radius curvature` describe, as compute stress/goldhirsch takes it; of a body of a
/// stock template that is the chain which encloses it.
/// @throws DataError naming file and line when there is no such chain.
std::vector<double> body_volumes(const Frame& bodies);

}  // namespace rodpack

#endif

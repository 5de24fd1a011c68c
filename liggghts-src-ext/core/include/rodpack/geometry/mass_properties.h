// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_MASS_PROPERTIES_H
#define RODPACK_GEOMETRY_MASS_PROPERTIES_H

#include <array>

#include "chain_geometry.h"

namespace rodpack {

struct MassProperties {
  double mass;                    // kg
  std::array<double, 3> inertia;  // about the centre of mass along body x, y, z (principal), kg m^2
};

/// Mass and principal moments of inertia of a chain of material density `density` (kg/m^3).
///
/// MassRule::reference: the mass is density times the union volume of the *straight smooth* chain
/// of the same AR; the inertia is that of this mass spread evenly over the 1 + ceil(AR-1) spheres
/// of the coarse chain, bent like the particle (2/5 m r^2 each, parallel axes). Coarse and smooth
/// particles thus differ in shape only, as in the paper.
/// MassRule::own: the union of the chain's own spheres, filled uniformly.
///
/// With `follow_drawn_size` false the nominal diameter is used in place of the drawn one, so that
/// all particles of one kind share one mass and inertia. l_axial is nominal in either case.
/// @throws std::invalid_argument for an invalid shape or a density that is not positive.
MassProperties mass_properties(const ChainShape& shape, double density, MassRule rule,
                               bool follow_drawn_size);

}  // namespace rodpack

#endif

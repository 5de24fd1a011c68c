// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ROD_PROPERTIES_H
#define RODPACK_ROD_PROPERTIES_H

#include "container.h"

namespace LAMMPS_NS {

class Multisphere;

/// What a rigid body remembers of the chain it was made from, one value per body of this rank.
/// All 0 for bodies of other templates.
struct RodProperties {
  ScalarContainer<double>* half_length;  // l_axial / 2, m: along the centreline, cap included
  ScalarContainer<double>* radius;       // of the primary spheres, m
  ScalarContainer<double>* curvature;    // theta, rad; 0 for a straight chain
  ScalarContainer<double>* area;         // covered area, m^2
};

/// The element properties rod_half_length, rod_radius, rod_curvature and rod_area of the bodies,
/// added if they do not exist yet. To be called on all ranks alike, as the order of the properties
/// is the order in which bodies are sent from rank to rank.
///
/// They are not written to restart files: `fix multisphere` reads its bodies in its constructor,
/// before any other style can add a property to it. The template works them out again from its own
/// parameters and the radius of the spheres.
RodProperties rod_properties(Multisphere& bodies);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_BODY_CHAINS_H
#define RODPACK_BODY_CHAINS_H

#include <vector>
#include "lammps.h"

namespace LAMMPS_NS {

/// The chain of spheres that a body consists of.
struct BodyChain {
  double half_length;  // l_axial / 2, m
  double radius;       // of the primary spheres, m
  double curvature;    // theta, rad
  double area;         // covered, m^2
};

/// Returns the chain of each body of this rank; for a body of another template than ours the
/// straight chain that encloses its spheres.
std::vector<BodyChain> body_chains(LAMMPS* lmp, const class ParticleIdentity& particles);

/// Volume of the union of a chain's evenly spaced spheres, of which there are `spheres`, m^3.
double volume(const BodyChain& chain, int spheres);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TIMESTEP_RUN_NETWORK_H
#define RODPACK_TIMESTEP_RUN_NETWORK_H

#include <string>
#include <vector>

#include "rodpack/contact/contact_network.h"

namespace rodpack {

/// The bed at the end of a run, as what limits its time step: planar bodies on linear springs and
/// dashpots, none of which slides.
struct RunNetwork {
  double stiffness = 0;      // k_n of a particle, N/m; two in contact have half of it
  double damping_ratio = 0;  // along the normal
  double timestep = 0;       // of the run, s
  double mass_scaling = 0;   // of the run, 0: none; not in the inertia of the bodies below
  double lightest = 0;       // mass of the lightest particle, kg
  std::vector<NetworkBody> bodies;
  std::vector<NetworkContact> contacts;
};

/// Reads parameters.json and the last frames of the bodies' and contacts' dumps of a run folder.
/// Moments of inertia are those of the nominal shape, in proportion to the mass.
/// @throws DataError when one of them is missing or cannot be used, bodies or contacts are not
///   planar, or a contact names a particle that is not among the bodies.
RunNetwork read_network(const std::string& run);

}  // namespace rodpack

#endif

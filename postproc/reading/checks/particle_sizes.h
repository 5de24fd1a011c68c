// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_PARTICLE_SIZES_H
#define RODPACK_READING_CHECKS_PARTICLE_SIZES_H

#include "reading/packing.h"

namespace rodpack {

struct ParticleSizes {
  double diameter;      // d_p, m
  double aspect_ratio;  // AR = l_axial / d_p
};

/// Finds d_p and AR of a frame of bodies (columns `half_length radius`, at least one row): the
/// options, else parameters.json, else the mean 2 radius and the longest particle.
/// @throws DataError when a length is not positive, d_p is not that of the spheres by a factor of
///   10, or AR is out of range.
ParticleSizes particle_sizes(const Frame& bodies, const PackingOptions& options,
                             const std::optional<RunParameters>& parameters);

}  // namespace rodpack

#endif

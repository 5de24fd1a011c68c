// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_MIXTURE_COMPOSITION_H
#define RODPACK_ANALYSIS_MIXTURE_COMPOSITION_H

#include <optional>
#include <string>
#include <vector>

#include "analysis/mixture/species.h"
#include "reading/packing.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// What one kind has of the bed, and how its particles lie.
struct SpeciesMeasures {
  double number_share = 0;      // of the particles below the surface
  double solid_share = 0;       // of what all of them cover there, area or volume: its part of phi
  std::size_t oriented = 0;     // particles in the order parameter
  std::optional<double> order;  // S2; none with fewer than two particles to take it of
  std::optional<double> order_error;  // standard error
  std::optional<double> director;     // degrees: in a plane gamma, in space from the vertical
};

/// Measures every kind in a plane: S2 as OrientationSample, walls and their margin as those of the
/// whole packing.
std::vector<SpeciesMeasures> measure_species(const Packing& packing, const Mixture& mixture);
/// The same in space: S2 is the largest value of the order tensor, as SpatialOrientationSample.
/// `bodies`: the frame of the packing.
std::vector<SpeciesMeasures> measure_species(const SpatialPacking& packing, const Frame& bodies,
                                             const Mixture& mixture);

/// Mean number of different particles of kind b that one of kind a touches, [a][b]; a row's sum is
/// the coordination number of kind a. `bodies`: all particles of the contacts' timestep.
/// @throws DataError when a column or a particle is missing.
std::vector<std::vector<double>> coordination_by_species(const Frame& contacts, const Frame& bodies,
                                                         const Mixture& mixture);

/// Writes a CSV table, a row per kind: species, type, particles, diameter_m, aspect_ratio,
/// curvature_deg, number_share, solid_share, nematic_order_S2, its standard error, director_deg
/// and, if there is a `coordination`, touching_B for every kind B. What is not known is empty, as
/// are the shares and S2 without `measures`.
void write_mixture_table(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                         const std::vector<std::vector<double>>& coordination,
                         const std::string& file);

}  // namespace rodpack

#endif

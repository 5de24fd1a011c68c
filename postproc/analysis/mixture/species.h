// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_MIXTURE_SPECIES_H
#define RODPACK_ANALYSIS_MIXTURE_SPECIES_H

#include <string>
#include <vector>

#include "reading/dump.h"

namespace rodpack {

/// One kind of particles of a mixture; shapes are means over them.
struct Species {
  std::string name;         // "rods-type1", "spheres-type2-d0.004", "curved-type1-AR5-theta60"
  long type = 0;            // of the template; atom type of a plain sphere
  std::size_t number = 0;   // of particles
  double diameter = 0;      // of the primary spheres, m
  double aspect_ratio = 1;  // half length over radius
  double curvature = 0;     // theta, rad
};

/// The particles of a frame of the bodies' dump by kind.
struct Mixture {
  std::vector<Species> species;
  std::vector<std::size_t> of;  // per row: its place among the species

  bool is_one() const { return species.size() < 2; }
  /// Rows of a species, in their order.
  std::vector<std::size_t> rows_of(std::size_t which) const;
};

/// Tells the kinds apart: single spheres from chains, then by the column `type`, which is that of
/// the deck's template or atoms; within a type by shape, wherever diameters or aspect ratios leave
/// a gap of a factor 1.15 or curvatures one of 5 degrees. So the spread of sizes of one template is
/// one kind, and templates that share a type are not.
/// @throws DataError when a column is missing.
Mixture find_mixture(const Frame& bodies);

}  // namespace rodpack

#endif

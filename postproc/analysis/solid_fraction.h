// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SOLID_FRACTION_H
#define RODPACK_ANALYSIS_SOLID_FRACTION_H

#include <optional>
#include <string>
#include <vector>

#include "reading/packing.h"

namespace rodpack {

/// Coarse-grained solid fraction in the central vertical slice (postproc/README.md, Definitions),
/// averaged over the slice's width 2 AR d_p in closed form, with w = 3 AR d_p. Where x is periodic
/// the slice is the whole period; where y is, there is neither floor nor surface, and means are
/// over the whole height.
struct SolidFraction {
  double scale = 0;                     // w, m
  double lowest = 0;                    // y from which the means start: 3 w above the floor, m
  double surface = 0;                   // y of the bed's surface, m
  std::vector<double> height;           // above the floor, m
  std::vector<double> phi;              // one per height
  std::optional<double> up_to_surface;  // mean; none when the bed is lower than 3 w
  std::optional<double> up_to_3_scales_below;  // mean up to 3 w below the surface
  // The same, and from the floor on, of the solid fraction divided by the kernel's share between
  // the walls and below the surface, which does not sink towards floor and surface.
  std::optional<double> normalised_up_to_surface;
  std::optional<double> normalised_from_floor_to_surface;
  double covered_below_surface = 0;  // covered area over bed area, edges included
  bool side_distance_kept = false;   // the slice is 3 w, to a relative 1e-5, away from the side
                                     // walls, or there are none
};

/// Measures it for one frame.
SolidFraction solid_fraction(const Packing& packing);

/// Writes a CSV table with the columns height_over_dp, solid_fraction. `particle_diameter`: d_p, m.
void write_solid_fraction_table(const SolidFraction& field, double particle_diameter,
                                const std::string& file);
}  // namespace rodpack

#endif

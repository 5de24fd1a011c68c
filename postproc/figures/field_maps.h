// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_FIELD_MAPS_H
#define RODPACK_FIGURES_FIELD_MAPS_H

#include <string>

#include "analysis/fields.h"

namespace rodpack {

/// The bed of a map: its surface is drawn, and what lies within the kernel's reach of a wall or the
/// surface is hatched, unless the densities are normalised by the kernel's share there.
struct MappedBed {
  const Packing& packing;  // gives d_p and the origin
  double scale, reach;     // of the kernel, m
  Normalisation normalisation;
};
MappedBed mapped_bed(const FieldSample& sample, const Packing& packing);

/// Draws a map of the pressure (sigma_1 + sigma_2) / 2 of the contact stress with crosses along the
/// principal directions, arms as long as the principal values: `stem`.png and `stem`.svg. `fields`:
/// those of `averages`. @throws DataError when that fails.
void plot_pressure_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                       const MappedBed& bed, const std::string& stem);

/// Draws a map of the solid fraction, likewise.
void plot_solid_fraction_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                             const MappedBed& bed, const std::string& stem);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_FIELD_MAPS_H
#define RODPACK_FIGURES_FIELD_MAPS_H

#include <string>

#include "analysis/fields.h"

namespace rodpack {

/// Returns gnuplot's command for a palette of the colours of our own drawings.
std::string palette_command();

/// Draws a map of the pressure (sigma_1 + sigma_2) / 2 of the contact stress with crosses along the
/// principal directions, arms as long as the principal values: `stem`.png and `stem`.svg. `fields`:
/// those of `averages`; `packing` gives d_p and the origin. @throws DataError when that fails.
void plot_pressure_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                       const Packing& packing, const std::string& stem);

/// Draws a map of the solid fraction, likewise.
void plot_solid_fraction_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                             const Packing& packing, const std::string& stem);

}  // namespace rodpack

#endif

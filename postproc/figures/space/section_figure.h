// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_SECTION_FIGURE_H
#define RODPACK_FIGURES_SPACE_SECTION_FIGURE_H

#include <string>

#include "analysis/space/fields/spatial_fields.h"

namespace rodpack {

/// Draws maps of a section of the fields of `sample`: of the pressure, a third of the trace of the
/// contact stress, with crosses along the principal directions of its part in the section; of the
/// solid fraction. The surface is drawn, what lies within the kernel's reach of a wall or the
/// surface is hatched, as on the maps of a plane, and what is outside a cylinder is white.
/// `stem`.png and `stem`.svg. @throws DataError as draw_figure().
void plot_section_pressure(const Section& section, const SpatialFieldSample& sample,
                           const std::string& stem);
void plot_section_solid_fraction(const Section& section, const SpatialFieldSample& sample,
                                 const std::string& stem);

}  // namespace rodpack

#endif

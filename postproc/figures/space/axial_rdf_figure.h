// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_AXIAL_RDF_FIGURE_H
#define RODPACK_FIGURES_SPACE_AXIAL_RDF_FIGURE_H

#include <string>

#include "analysis/space/axial_rdf.h"

namespace rodpack {

/// Draws a map of g along and across the particle's axis, `stem`.png and .svg; colours end at the
/// value that 99 % of the bins do not exceed. @throws DataError as draw_figure().
void plot_axial_rdf(const AxialRdf& rdf, const std::string& stem);

}  // namespace rodpack

#endif

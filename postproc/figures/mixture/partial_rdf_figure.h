// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_MIXTURE_PARTIAL_RDF_FIGURE_H
#define RODPACK_FIGURES_MIXTURE_PARTIAL_RDF_FIGURE_H

#include <string>

#include "analysis/mixture/partial_rdf.h"

namespace rodpack {

/// Pairs of kinds that a figure can tell apart.
constexpr std::size_t most_partial_curves = 6;

/// Draws the partial G_ab(r), at most most_partial_curves of them, and the total into `stem`.png
/// and .svg. @throws DataError as draw_figure().
void plot_partial_rdf(const PartialRdf& rdf, const Mixture& mixture, const std::string& stem);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_RDF_FIGURE_H
#define RODPACK_FIGURES_RDF_FIGURE_H

#include <string>
#include <vector>

#include "analysis/rdf.h"

namespace rodpack {

/// Returns G(r) for a curve: not a number where no ring of the bin is in sight of a centre.
std::vector<double> drawn_g(const Rdf& rdf);

/// Draws G(r) with a band of its standard error: `stem`.png and `stem`.svg. @throws DataError when
/// that fails.
void plot_rdf(const Rdf& rdf, const std::string& stem);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_RDF_FIGURE_H
#define RODPACK_FIGURES_RDF_FIGURE_H

#include <string>

#include "analysis/rdf.h"

namespace rodpack {

/// Draws G(r) with a band of its standard error: `stem`.png and `stem`.svg. @throws DataError when
/// that fails.
void plot_rdf(const Rdf& rdf, const std::string& stem);

}  // namespace rodpack

#endif

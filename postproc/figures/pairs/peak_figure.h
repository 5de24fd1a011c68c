// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_PAIRS_PEAK_FIGURE_H
#define RODPACK_FIGURES_PAIRS_PEAK_FIGURE_H

#include <string>

#include "analysis/pairs/peak_configurations.h"
#include "analysis/rdf.h"

namespace rodpack {

/// Draws G(r) with the peak marked, and below it the commonest eight configurations of its pairs,
/// both particles in their nominal shape, with name and share: `stem`.png and `stem`.svg.
/// @throws DataError when that fails.
void plot_peak(const Rdf& rdf, const PeakExplanation& explanation, const std::string& stem);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_ENERGIES_FIGURE_H
#define RODPACK_FIGURES_ENERGIES_FIGURE_H

#include <string>

#include "analysis/energies.h"

namespace rodpack {

/// Draws kinetic and elastic energy over time on a logarithmic axis: `stem`.png and `stem`.svg.
/// `source`: the file that the energies come from, for the message.
/// @throws DataError when no energy is positive, which is all such an axis shows, or drawing fails.
void plot_energies(const EnergyHistory& energies, const std::string& source,
                   const std::string& stem);

}  // namespace rodpack

#endif

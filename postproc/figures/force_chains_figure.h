// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_FORCE_CHAINS_FIGURE_H
#define RODPACK_FIGURES_FORCE_CHAINS_FIGURE_H

#include <string>

#include "reading/dump.h"
#include "reading/packing.h"

namespace rodpack {

/// Picture of the force chains of a frame of the contacts' dump: a line per touching pair, width
/// and shade proportional to its force up to what 99 % of the pairs do not exceed, the strong ones
/// on top; with walls, colour bar and scale bar: `stem`.svg and `stem`.png. The scale bar counts in
/// d_p too if the options or parameters.json say what that is. @throws DataError as force_lines(),
/// and when drawing fails.
void draw_force_chains(const Frame& contacts, const PackingOptions& options,
                       const std::string& stem);

}  // namespace rodpack

#endif

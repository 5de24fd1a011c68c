// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_EDGES_SHADING_H
#define RODPACK_FIGURES_EDGES_SHADING_H

#include <string>
#include <vector>

#include "rodpack/geometry/disc_in_rectangle.h"

namespace rodpack {

// How figures show where averages are not those of the bed alone, and where its surface is; for
// the rooms that draw fields: this one and study.

/// What the key says of it, as gnuplot writes it. `reach`: of the kernel, in w; `surface_alone`:
/// the walls are divided out.
std::string shade_title(double reach, bool surface_alone);

/// Returns the datablock `$name` of these rectangles, in units of the axes, for hatched().
std::string hatch_block(const std::string& name, const std::vector<Rectangle>& parts);
/// Returns what gnuplot plots to hatch them on top of a map.
std::string hatched(const std::string& name);

/// Returns gnuplot's command for a grey strip behind a curve, over the whole of the other axis;
/// `axis`: that of `from` and `to`, 'x' or 'y'. Nothing when to <= from.
std::string grey_strip(char axis, double from, double to);
/// Returns a plot's part that explains the strips in the key, as shade_title().
std::string grey_key(double reach, bool surface_alone);

/// Colour and width of the line at the bed's surface.
std::string surface_look();

}  // namespace rodpack

#endif

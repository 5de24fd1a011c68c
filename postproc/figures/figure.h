// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_FIGURE_H
#define RODPACK_FIGURES_FIGURE_H

#include <string>
#include <vector>

namespace rodpack {

/// Colour-blind-safe line colours (Okabe and Ito), as gnuplot and SVG write them.
namespace colour {

constexpr const char* blue = "#0072B2";
constexpr const char* vermilion = "#D55E00";
constexpr const char* grey = "#7F7F7F";
}  // namespace colour

/// Writes a gnuplot datablock `$name << EOD ... EOD` of the given columns (equal length). A row
/// with a number that is none is an empty line, across which gnuplot draws no line.
std::string datablock(const std::string& name, const std::vector<std::vector<double>>& columns);

/// Draws `commands` with gnuplot into `stem`.png (1600 pixels wide) and `stem`.svg, both with
/// `aspect` = width / height; `columns` times as wide with letters and lines of the same size, for
/// figures of several panels. No display is needed. Text: a space beside a change of font is
/// written as a no-break one (U+00A0), since SVG readers drop a plain one there.
/// @throws DataError when gnuplot is missing or fails, or a file cannot be written.
void draw_figure(const std::string& stem, double aspect, const std::string& commands,
                 double columns = 1);

}  // namespace rodpack

#endif

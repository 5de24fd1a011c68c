// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_SPACE_DIRECTION_FIGURE_H
#define RODPACK_FIGURES_SPACE_DIRECTION_FIGURE_H

#include <string>

#include "analysis/space/direction_histogram.h"
#include "analysis/space/fabric.h"

namespace rodpack {

/// Draws `stem`.png and .svg, density over that of isotropic directions. `what`: whose direction it
/// is ("rod"), `vertical`: the axis that the polar angle is measured from, 0 to 2.
/// @throws DataError as draw_figure().
void plot_polar_angle(const DirectionHistogram& histogram, const std::string& what,
                      std::size_t vertical, const std::string& stem);
/// The same of the azimuth.
void plot_azimuth(const DirectionHistogram& histogram, const std::string& what,
                  std::size_t vertical, const std::string& stem);

/// The polar angle of contact normals, with their mean normal force.
void plot_fabric(const Fabric& fabric, const std::string& stem);

}  // namespace rodpack

#endif

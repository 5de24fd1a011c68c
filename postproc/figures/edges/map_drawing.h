// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_FIGURES_EDGES_MAP_DRAWING_H
#define RODPACK_FIGURES_EDGES_MAP_DRAWING_H

#include <array>
#include <string>
#include <vector>

#include "rodpack/geometry/disc_in_rectangle.h"

namespace rodpack {

/// A map of values at the places of a plane grid; for the room that draws fields, in a plane and in
/// space.
struct FieldMap {
  std::vector<double> x, y, value;  // x fastest; lengths in d_p
  std::array<double, 2> spacing{};  // along x and y, d_p
  std::string x_label, y_label, value_label;
  std::string blocks, edges, over;  // gnuplot's data, and what it plots of them on top of the map

  /// The map with the half of a spacing around its outer places.
  Rectangle area() const;
  /// Adds the hatching of these parts, and says in the key why.
  void hatch(const std::vector<Rectangle>& parts, const std::string& reason);
  /// Adds a level line at the height of the bed's surface, if the map shows that.
  void mark_surface(double height);
};

/// Draws it true to scale with a colour bar from 0 on: `stem`.png and `stem`.svg.
/// @throws DataError as draw_figure().
void draw_map(const FieldMap& map, const std::string& stem);

/// Returns gnuplot's command for a palette of the colours of our own drawings.
std::string palette_command();

/// In-plane components of a stress at the places of a map, N/m or N/m^2.
struct PlaneStress {
  std::vector<double> xx, xy, yx, yy;
  std::vector<bool> shown;  // empty: all
};
/// Adds crosses along the principal directions, some 20 along the longer side, with arms as long as
/// the principal values; `columns`: places along x.
void add_crosses(const PlaneStress& stress, std::size_t columns, FieldMap& map);

}  // namespace rodpack

#endif

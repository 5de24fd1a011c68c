// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_UPRIGHT_CONTAINER_H
#define RODPACK_GEOMETRY_UPRIGHT_CONTAINER_H

#include <array>
#include <cstddef>

namespace rodpack {

/// An upright box in space, or a cylinder in place of its side walls; lengths in m, infinite where
/// there is no wall.
struct UprightContainer {
  std::array<double, 3> low{}, high{};
  std::size_t vertical = 2;  // the axis that it stands along, 0 to 2
  bool round = false;        // the side wall is a cylinder; `low` and `high` of the other two axes
                             // are of no meaning then
  std::array<double, 2> middle{};  // its axis along the axes horizontal(0) and horizontal(1)
  double radius = 0;

  /// The two horizontal axes, in the order x, y, z, x after the vertical one.
  std::size_t horizontal(std::size_t which) const { return (vertical + 1 + which) % 3; }
  /// Whether a place lies in it, or beyond its walls by at most `slack`, m.
  bool contains(const std::array<double, 3>& place, double slack = 0) const;
};

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_CHECKS_BODY_AXES_H
#define RODPACK_READING_CHECKS_BODY_AXES_H

#include <array>

#include "reading/dump.h"

namespace rodpack {

/// Place or direction in space, x to z.
using Vector3 = std::array<double, 3>;

/// Where the bodies of a dump point, from its columns `qw qx qy qz` (body to space).
class BodyAxes {
 public:
  /// `bodies` outlives this. @throws DataError as Frame::column().
  explicit BodyAxes(const Frame& bodies);
  /// Direction in space of a body's own axis x (0), its chord, y (1), towards which it may bend, or
  /// z (2): a unit vector. @throws DataError naming file and line when the quaternion of the row is
  /// none of unit length, to the digits that a dump may print.
  Vector3 axis(std::size_t row, std::size_t which) const;

 private:
  const Frame& bodies_;
  std::array<const std::vector<double>*, 4> quaternion_;
};

/// "<file>:<line>: " of a row, for messages.
std::string at_row(const Frame& frame, std::size_t row);

}  // namespace rodpack

#endif

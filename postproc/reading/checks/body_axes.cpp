// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/body_axes.h"

#include <cmath>

#include "reading/number_text.h"
#include "rodpack/motion/rigid_motion.h"

namespace rodpack {

std::string at_row(const Frame& frame, std::size_t row) {
  return frame.file + ":" + std::to_string(frame.header_line + 1 + static_cast<long>(row)) + ": ";
}

BodyAxes::BodyAxes(const Frame& bodies)
    : bodies_(bodies),
      quaternion_{&bodies.column("qw"), &bodies.column("qx"), &bodies.column("qy"),
                  &bodies.column("qz")} {}

Vector3 BodyAxes::axis(std::size_t row, std::size_t which) const {
  double q[4];
  double square = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    q[c] = (*quaternion_[c])[row];
    square += q[c] * q[c];
  }
  if (!(std::abs(square - 1) < 1e-2))  // a dump may print few digits
    throw DataError(at_row(bodies_, row) +
                    "columns 'qw qx qy qz': expected a unit quaternion, found one of length " +
                    number_text(std::sqrt(square), 6));
  normalise(q);
  double own[3] = {0, 0, 0}, direction[3];
  own[which] = 1;
  rotate(q, own, false, direction);
  return {direction[0], direction[1], direction[2]};
}

}  // namespace rodpack

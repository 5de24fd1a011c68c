// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_COARSE_GRAINING_H
#define RODPACK_COARSE_GRAINING_H

#include <cmath>

namespace rodpack {

/// Gaussian kernel of the spatial averaging ("coarse graining" as Goldhirsch uses the word; not the
/// parcel scaling of LIGGGHTS), physics.md section 5: exp(-|r|^2 / 2 w^2) / (2 pi w^2) is the
/// product of this factor for x and for y. `scale`: w, m; result 1/m.
inline double gaussian(double distance, double scale) {
  const double t = distance / scale;
  return std::exp(-0.5 * t * t) / (scale * 2.5066282746310002);
}

/// Integral of gaussian() over distances from `from` to `to`; no unit.
inline double gaussian_integral(double from, double to, double scale) {
  const double root = scale * 1.4142135623730951;
  return 0.5 * (std::erf(to / root) - std::erf(from / root));
}

}  // namespace rodpack

#endif

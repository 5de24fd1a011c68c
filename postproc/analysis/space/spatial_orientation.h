// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_SPATIAL_ORIENTATION_H
#define RODPACK_ANALYSIS_SPACE_SPATIAL_ORIENTATION_H

#include <optional>
#include <vector>

#include "analysis/space/direction_histogram.h"
#include "analysis/space/order_tensor.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// How the long axes (chords) of the particles of a packing in space lie.
struct SpatialOrientation {
  std::size_t vertical = 2;  // axis that the polar angle is measured from, 0 to 2
  OrderTensor order;
  OrderAbout about_vertical{};  // 1 upright, 0 isotropic, -1/2 flat
  DirectionHistogram polar, azimuth;
  std::size_t near_walls = 0;  // left out: closer than AR d_p to a side wall or the floor
  std::size_t spheres = 0;     // left out: no axis
};

/// Collects particles over one or several frames.
class SpatialOrientationSample {
 public:
  /// Adds the particles of a frame. @throws DataError when its vertical is another than before.
  void add(const SpatialPacking& packing);
  /// Returns the distributions over so many `bins` each; without a number, 18 of the polar angle
  /// and 36 of the azimuth. @throws TooFewParticles when fewer than 2 particles are left to count.
  SpatialOrientation result(std::optional<int> bins = {}) const;

 private:
  std::vector<Vector3> axes_;
  std::optional<std::size_t> vertical_;
  std::size_t near_walls_ = 0, spheres_ = 0;
};

}  // namespace rodpack

#endif

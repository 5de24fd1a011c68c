// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_PAIRS_SPATIAL_CONFIGURATION_H
#define RODPACK_ANALYSIS_SPACE_PAIRS_SPATIAL_CONFIGURATION_H

#include <string>
#include <vector>

#include "reading/checks/body_axes.h"
#include "rodpack/geometry/chain_geometry.h"

namespace rodpack {

/// How two alike straight particles lie to each other in space: the neighbour in a frame whose
/// origin is the centre particle's centre of mass and whose x axis is that particle's. Turns about
/// x are of no matter. Lengths in d_p.
struct SpatialConfiguration {
  Vector3 place{};  // of the neighbour's centre of mass
  Vector3 axis{};   // of the neighbour, a unit vector; either way round is the same

  /// Of the neighbour's centre, d_p.
  double along() const { return place[0]; }
  double across() const;
  double distance() const;
  /// Between the two axes, 0 to pi/2, rad.
  double turn() const;
  /// Between the neighbour's axis and the line of the centres, 0 to pi/2, rad.
  double axis_to_line() const;
};

/// Returns the configuration with the neighbour's centre in the x-y plane, at y >= 0. `to`: from
/// centre to neighbour, d_p; axes: unit vectors.
SpatialConfiguration spatial_configuration(const Vector3& to, const Vector3& axis_of_centre,
                                           const Vector3& axis_of_neighbour);

/// Returns everything that `pair` is equal to, itself first, each as spatial_configuration() has
/// it: seen from either particle, with either of either's ends ahead, and in a mirror: sixteen.
/// Entry k comes from the same operation for every pair.
std::vector<SpatialConfiguration> equal_configurations(const SpatialConfiguration& pair);

/// Returns `pair` turned about x to where the points of the neighbour's axis are nearest to those
/// in `reference`, in rms: the turn is that of the phase of a Hermitian product. `arm`: the rms
/// distance of the points of an axis from its middle, AR / sqrt 12, d_p.
SpatialConfiguration turned_towards(const SpatialConfiguration& reference,
                                    const SpatialConfiguration& pair, double arm);

/// Returns the rms distance of the points of the neighbour's axis in two configurations, at the
/// turn about x where it is least, d_p.
double distance_between(const SpatialConfiguration& a, const SpatialConfiguration& b, double arm);

/// Picks of equal_configurations() the one that is reported: along >= 0, the axis forward, and out
/// of the plane of the centres towards z >= 0; seen from the particle that the other lies more
/// beside than ahead of (smaller `along`).
SpatialConfiguration reported_configuration(const SpatialConfiguration& pair);

/// Returns the name of a reported configuration in plain words, by the rules of postproc/README.md
/// (Definitions).
std::string configuration_name(const SpatialConfiguration& pair, const ChainShape& shape);

}  // namespace rodpack

#endif

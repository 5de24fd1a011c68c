// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SURFACE_ROUGHNESS_H
#define RODPACK_ANALYSIS_SURFACE_ROUGHNESS_H

namespace rodpack {

/// How a chain of primary spheres of diameter d, (1 - f) d apart, differs from the capsule (the
/// exact spherocylinder) it stands for. f in [0, 1): overlap of neighbours; lengths in d. Ends of
/// the chain aside; against a plane wall chain and capsule are the same. A `partner` is the end of
/// another rod, or a parallel rod of the same spacing. All throw std::invalid_argument for another
/// f.

/// Depth of the grooves between the spheres below the capsule's side: between two spheres, half a
/// spacing from either centre, the surface is sqrt(r^2 - (s/2)^2) from the axis, so that it is
/// (1 - sqrt(1 - (1 - f)^2)) / 2 of d deep.
double groove_depth(double overlap);

/// How much closer to the axis of the chain than to a capsule's a partner comes in a groove, where
/// it touches two spheres half a spacing to either side: 1 - sqrt(1 - ((1 - f)/2)^2) of d. A
/// partner that slides along goes up and down by this.
double sliding_amplitude(double overlap);

/// Steepest slope of that way up and down, tan(asin((1 - f)/2)): a frictionless partner in a groove
/// resists sliding like one on a capsule with this friction coefficient.
double groove_friction(double overlap);

/// Force across the axis that a chain exerts on a partner sphere whose centre is d (1 - depth) from
/// it, over that of a capsule, k depth d, with the spring k in every contact of two spheres.
/// `offset`: of the partner from a sphere of the chain along the axis, in spacings. depth in (0,
/// 1).
double chain_force_ratio(double overlap, double depth, double offset);

/// The values that chain_force_ratio() takes over all offsets; `mean` is their average.
struct ForceRatioRange {
  double least, mean, largest;
};
/// Returns the range of that ratio at one depth in (0, 1).
ForceRatioRange chain_force_range(double overlap, double depth);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_GEOMETRY_CHAIN_GEOMETRY_H
#define RODPACK_GEOMETRY_CHAIN_GEOMETRY_H

#include <array>
#include <vector>

namespace rodpack {

/// A straight or curved spherocylinder: equal primary spheres, evenly spaced on a line or a
/// circular arc in the body x-y plane (Lu et al., Granular Matter 18:34, 2016). Lengths in m.
struct ChainShape {
  double aspect_ratio;         // AR = l_axial / d_p, at least 1 (1: a single sphere)
  double nominal_diameter;     // d_p; with AR it fixes l_axial, whatever diameter was drawn
  double overlap = 0.5;        // f in [0,1): neighbours are (1-f) d_p apart; 0 coarse, 0.5 smooth
  double curvature_angle = 0;  // theta in [0, pi], rad: arc length of the centreline / its radius
  double diameter;             // primary diameter d drawn for this particle
};

/// How a particle's mass is distributed, and with it where its centre of mass lies.
enum class MassRule {
  reference,  // both surfaces of one AR share the mass distribution of the coarse chain (the paper)
  own         // uniform density in the union of the particle's own spheres
};

/// Checks the shape. @throws std::invalid_argument naming the value that is out of range.
/// A drawn diameter of l_axial or more is refused too, unless the chain is a single sphere.
void validate(const ChainShape& shape);

/// Axial length l_axial = AR d_p, m: along the centreline, caps included; independent of the draw.
inline double axial_length(const ChainShape& shape) {
  return shape.aspect_ratio * shape.nominal_diameter;
}

/// Number of primary spheres, 1 + ceil((AR-1)/(1-f)), so that neighbours overlap by f or more.
int sphere_count(const ChainShape& shape);

/// `count` points evenly spaced on the centreline from end centre to end centre (l_axial - d along
/// it), count x 2, m, in order of increasing x. Origin: the middle of the centreline; x parallel to
/// the chord between the ends; the arc bulges to +y, so that y <= 0. One point: the middle.
std::vector<std::array<double, 2>> centreline_points(const ChainShape& shape, int count);

/// Centres of the primary spheres, n x 2, body frame, m, in order of increasing x. The body x axis
/// is parallel to the chord between the end centres and the arc bulges to +y. End centres are
/// l_axial - d apart along the centreline, the others evenly between. The origin is the centre of
/// mass under `rule`: for `reference` that of 1 + ceil(AR-1) equal spheres evenly spaced on this
/// centreline, for `own` that of the union solid. The two differ for curved chains only.
std::vector<std::array<double, 2>> sphere_centres(const ChainShape& shape,
                                                  MassRule rule = MassRule::reference);

/// Area of the union of the discs, the particle's silhouette in the x-y plane, m^2; closed form.
double covered_area(const ChainShape& shape);

/// Moments of the union of the spheres as a solid; relative error below 1e-12.
struct UnionMoments {
  double volume;      // m^3
  double centroid_y;  // above the middle of the centreline, m; the centroid's x and z are 0
  double xx, yy, zz;  // integrals of x^2, y^2, z^2 about the centroid, m^5
};
UnionMoments union_moments(const ChainShape& shape);

/// Volume of the union of the spheres, m^3; relative error below 1e-12.
inline double union_volume(const ChainShape& shape) { return union_moments(shape).volume; }

/// Radius of the smallest sphere about the centre of mass that contains the particle, m.
double bounding_radius(const ChainShape& shape, MassRule rule = MassRule::reference);

}  // namespace rodpack

#endif

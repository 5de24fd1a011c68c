// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_FIELDS_SECTION_H
#define RODPACK_ANALYSIS_SPACE_FIELDS_SECTION_H

#include <array>
#include <string>
#include <vector>

#include "reading/space/spatial_packing.h"
#include "rodpack/averaging/coarse_graining.h"

namespace rodpack {

/// A plane on which one coordinate is constant.
struct Slice {
  std::size_t axis;  // of that coordinate, 0 to 2
  double at;         // m
  /// "y_0.018", for names of files.
  std::string name() const;
};

/// Fields on a surface through a packing in space, at places along two coordinates u and v: a
/// slice, or all azimuths of a cylinder at once, where u is the radius. All vectors hold one entry
/// per place, u fastest.
struct Section {
  std::array<std::size_t, 2> count{};      // places along u and v
  std::array<double, 2> spacing{};         // m
  std::vector<double> u, v;                // from section_origin(), m
  std::vector<Vector3> place;              // in space, m; of rings that at azimuth 0
  std::array<std::string, 2> name;         // of u and v: x, y, z or r
  std::array<std::size_t, 2> component{};  // of u and v among those of the fields
  std::string where;                       // "y" of a slice y = constant; empty: rings
  double at = 0;                           // of that coordinate, from section_origin(), m
  std::vector<Field> fields;
};

/// Returns where the coordinates of sections count from, m: the corner of the box with the lower
/// coordinates, the floor; the axis of a cylinder.
Vector3 section_origin(const SpatialWalls& walls);

/// Returns a section of the fields of `averages`, which are those of a grid of one plane.
Section slice_section(const Slice& slice, const SpatialWalls& walls, const CoarseGraining& averages,
                      const std::vector<Field>& fields);

/// Places on rings about the axis of a cylinder, at even steps of radius, from the axis to the
/// wall, and height, and on each at n even steps of the azimuth, of about `arc` or less. What a
/// Gaussian of standard deviation w about a place at the radius b sums to on a ring of radius a
/// errs by exp(-n^2 w^2 / 2 a b) of it.
class Rings {
 public:
  /// `spacing`: of radii and heights, roughly, m; `top`: of the heights, along the vertical, m.
  Rings(const SpatialWalls& walls, double top, double spacing, double arc);
  const std::vector<Vector>& places() const { return places_; }
  /// Means over each ring of fields at these places; vectors and tensors have the components r, t
  /// (around the axis, from the first horizontal axis to the second) and v (up). The velocity is
  /// momentum over mass density of the ring, and what is counted per particle its mean over them.
  Section means(const std::vector<Field>& fields) const;

 private:
  SpatialWalls walls_;
  std::array<std::size_t, 2> count_{};
  std::array<double, 2> spacing_{};
  std::vector<Vector> places_;
  std::vector<double> azimuth_;    // of each place
  std::vector<std::size_t> ring_;  // of each place, radius fastest
};

/// Writes a CSV table of a section: r_over_dp, z_over_dp (as u and v are called), then every
/// component of every field. `particle_diameter`: d_p, m.
void write_section_table(const Section& section, double particle_diameter, const std::string& file);

}  // namespace rodpack

#endif

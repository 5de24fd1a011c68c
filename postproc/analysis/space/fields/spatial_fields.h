// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_FIELDS_SPATIAL_FIELDS_H
#define RODPACK_ANALYSIS_SPACE_FIELDS_SPATIAL_FIELDS_H

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fields.h"
#include "analysis/space/fields/section.h"
#include "reading/space/spatial_packing.h"
#include "rodpack/averaging/kernel_share.h"

namespace rodpack {

/// Returns the scale w of the averaging in space, m: that of the options, else AR d_p / 2.
double averaging_scale(const SpatialPacking& packing, const FieldOptions& options);

/// Returns the slices that are drawn where nobody asks for others: an upright one through the
/// middle of the container, and a level one at half the height of the bed.
std::vector<Slice> middle_slices(const SpatialPacking& packing);

/// Returns how far a place is from the walls and the surface of the bed beyond which the averages
/// count empty space, m; infinite where there are none. Negative outside.
double distance_to_edges(const SpatialPacking& packing, const Vector3& place,
                         Normalisation normalisation);

/// Fields in space (CoarseGraining of three dimensions) over one or several frames: on a grid
/// between the walls, from the floor to w above the surface (to the surface where that bounds what
/// is normalised), on slices, and in a cylinder as means over rings. Walls and surface are those of
/// the first frame. `options`: scale, spacing (none: w/2 of the grid and the rings, w/4 of slices),
/// kernel, line, tolerance, couple stress and normalisation, which needs the Gaussian; no window.
class SpatialFieldSample {
 public:
  /// Without `slices`, middle_slices().
  explicit SpatialFieldSample(FieldOptions options, std::vector<Slice> slices = {});
  /// Adds a frame; without contacts (null) there is no stress.
  /// @throws DataError as averaged_frame(), for a grid of too many places, or when a slice lies
  ///   outside the container; TooFewParticles when there is no bed.
  void add(const SpatialPacking& packing, const Frame& bodies, const Frame* contacts);

  /// That of the first frame. @throws TooFewParticles when no frame was added, like all below.
  const SpatialPacking& packing() const;
  const CoarseGraining& averages() const;
  std::vector<Field> fields() const;
  /// The fields in the slices, in the order of slices().
  std::vector<Section> sections() const;
  const std::vector<Slice>& slices() const { return slices_; }
  /// Whether they are none of middle_slices().
  bool slices_are_given() const { return slices_given_; }
  /// Means over rings about the axis; none but in a cylinder.
  std::optional<Section> rings() const;
  Normalisation normalisation() const { return options_.normalisation; }

 private:
  void start(const SpatialPacking& packing);
  std::vector<Field> fields_of(const CoarseGraining& averages) const;

  FieldOptions options_;
  std::vector<Slice> slices_;
  bool slices_given_;
  std::optional<SpatialPacking> packing_;
  UprightContainer container_{};
  std::unique_ptr<CoarseGraining> grid_, on_rings_;
  std::vector<CoarseGraining> on_slices_;
  std::optional<Rings> rings_;
  int frames_ = 0;
};

/// Mean over the places of the grid that no wall and no surface disturbs.
struct InteriorMean {
  double mean;
  double deviation;  // standard deviation over the places
  std::size_t places;
};
/// Of the solid fraction; none where there are no such places.
std::optional<InteriorMean> interior_solid_fraction(const SpatialFieldSample& sample);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_SPATIAL_RDF_H
#define RODPACK_ANALYSIS_SPACE_SPATIAL_RDF_H

#include <functional>

#include "analysis/pairs/rdf_sums.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// G(r) = N(r + dr) / (4 pi r^2 dr rho) in space, collected over one or several frames: as
/// RdfSample in the plane, with shells in place of rings, rho the number per volume and 4 pi r^2 dr
/// the volume of the shell's part inside the window. In a cylinder, region and window are the
/// upright square prisms within it. Where no axis has walls, all particles are centres and the
/// margin is 0.
class SpatialRdfSample {
 public:
  explicit SpatialRdfSample(const RdfOptions& options);
  /// Adds the particles of a frame. @throws as neighbourhood().
  void add(const SpatialPacking& packing);
  Rdf result() const { return sums_.result(); }

 private:
  RdfOptions options_;
  RdfSums sums_;
};

/// A pair that SpatialRdfSample counts.
struct SpatialRdfPair {
  std::size_t centre, neighbour;  // places in the packing
  Vector3 to;                     // from the centre to the neighbour (the image seen), m
  bool both_centres;              // it is counted a second time, from the other end
};
/// Calls `visit` for every pair that SpatialRdfSample counts in the bins `first` to `last`, both
/// included, centre by centre. @throws as neighbourhood().
void for_spatial_rdf_pairs(const SpatialPacking& packing, const RdfOptions& options,
                           std::size_t first, std::size_t last,
                           const std::function<void(const SpatialRdfPair&)>& visit);

/// Half of the packing's shortest period, in d_p; infinite without one.
double half_period(const SpatialPacking& packing);

/// Calls `visitor` with every centre and every pair that SpatialRdfSample counts. Returns the
/// volume in which the centres lie, m^3. @throws as neighbourhood().
double visit_spatial_rdf(const SpatialPacking& packing, const RdfOptions& options,
                         const RdfVisitor& visitor);

}  // namespace rodpack

#endif

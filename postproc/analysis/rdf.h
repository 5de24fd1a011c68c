// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_RDF_H
#define RODPACK_ANALYSIS_RDF_H

#include <functional>

#include "analysis/pairs/rdf_sums.h"
#include "reading/packing.h"

namespace rodpack {

/// G(r) = N(r + dr) / (2 pi r dr rho), collected over one or several frames.
///
/// Centres lie further than (10 + AR) d_p from side walls, floor and surface; rho is their number
/// per area. In a bed too small for that the margin shrinks to a third of the bed's smaller extent,
/// and `margin_reduced` says so. Neighbours count wherever they are, up to AR d_p (or the margin,
/// if smaller) from walls and surface, where the layering along the walls begins; 2 pi r dr is the
/// part of the ring inside that window, so that G tends to 1 for every r. With r <= 10 d_p and the
/// full margin every ring is complete. A periodic direction has no margin, and none of them is left
/// where both are.
///
/// The standard error holds for independent particles, an upper bound at large r for dense
/// packings, whose density fluctuates less: the number of distinct pairs, and the scatter of rho,
/// which is common to all bins.
class RdfSample {
 public:
  explicit RdfSample(const RdfOptions& options);
  /// Adds the particles of a frame. @throws TooFewParticles when fewer than 2 centres are left,
  /// DataError when r exceeds half of a period.
  void add(const Packing& packing);
  Rdf result() const { return sums_.result(); }

 private:
  RdfOptions options_;
  RdfSums sums_;
};

/// A pair of particles that RdfSample counts.
struct RdfPair {
  std::size_t centre, neighbour;  // places in the packing
  double dx, dy;                  // from the centre to the neighbour (the image seen), m
  bool both_centres;              // it is counted a second time, from the other end
};
/// Calls `visit` for every pair that RdfSample counts in the bins `first` to `last`, both included,
/// centre by centre in the packing's order.
/// @throws TooFewParticles, DataError as RdfSample::add().
void for_rdf_pairs(const Packing& packing, const RdfOptions& options, std::size_t first,
                   std::size_t last, const std::function<void(const RdfPair&)>& visit);

/// Half of the packing's shortest period, in d_p; infinite without one.
double half_period(const Packing& packing);

/// Calls `visitor` with every centre and every pair that RdfSample counts. Returns the area in
/// which the centres lie, m^2. @throws TooFewParticles, DataError as RdfSample::add().
double visit_rdf(const Packing& packing, const RdfOptions& options, const RdfVisitor& visitor);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_SPACE_AXIAL_RDF_H
#define RODPACK_ANALYSIS_SPACE_AXIAL_RDF_H

#include <optional>
#include <string>
#include <vector>

#include "reading/space/spatial_packing.h"

namespace rodpack {

struct AxialRdfOptions {
  double bin_width = 0.25;      // along and across, in d_p
  double largest_distance = 8;  // in d_p
};

/// Pair correlation g along and across the axis of the centre particle. Vectors hold one entry per
/// bin; there are those that lie within the largest distance wholly.
struct AxialRdf {
  double bin_width = 0;                // in d_p
  std::vector<double> along, across;   // middle of the bin, in d_p
  std::vector<double> g;               // 1: as in an ideal gas of the same density
  std::vector<double> standard_error;  // of the number of distinct pairs alone
  std::vector<double> pairs;           // (centre, neighbour) pairs in the bin
  std::size_t centres = 0;             // elongated particles in the analysis region, all frames
  double margin = 0;                   // of the centres from walls and surface, in d_p
};

/// g(along, across) = pairs / (centres rho V), collected over one or several frames. The
/// neighbour's centre of mass lies |s u| along the centre's axis u (its chord) and |s - (s u) u|
/// across; V is the volume of the bin's two rings about the axis, 2 pi (across_2^2 - across_1^2)
/// (along_2 - along_1). Centres are elongated, and lie so far from walls and surface that
/// neighbours up to the largest distance are further than AR d_p from them: no ring is cut.
/// Neighbours are all particles, rho is the number per volume of those in the region of the
/// centres.
class AxialRdfSample {
 public:
  explicit AxialRdfSample(const AxialRdfOptions& options);
  /// Adds the particles of a frame. @throws as neighbourhood(), TooFewParticles when no elongated
  /// centre is left.
  void add(const SpatialPacking& packing);
  AxialRdf result() const;

 private:
  std::optional<std::size_t> bin_at(double along, double across) const;  // in bins

  AxialRdfOptions options_;
  std::size_t bins_;  // in either direction
  std::vector<double> pairs_, variance_, expected_;
  std::size_t centres_ = 0;
  double margin_ = 0;
};

/// Writes a CSV table with the columns along_over_dp, across_over_dp, g, standard_error, pairs.
void write_axial_rdf_table(const AxialRdf& rdf, const std::string& file);

}  // namespace rodpack

#endif

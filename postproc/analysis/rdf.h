// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_RDF_H
#define RODPACK_ANALYSIS_RDF_H

#include <functional>
#include <string>
#include <vector>

#include "reading/packing.h"

namespace rodpack {

struct RdfOptions {
  double bin_width = 0.1;        // delta r, in d_p
  double largest_distance = 10;  // in d_p
  double margin = -1;            // of the centres from walls and surface, in d_p; < 0: automatic
};

/// Radial distribution function of the centres of mass. Vectors hold one entry per bin.
struct Rdf {
  std::vector<double> r;               // middle of the bin, in d_p
  std::vector<double> g;               // 1: as in an ideal gas of the same density
  std::vector<double> standard_error;  // of g, see RdfSample
  std::vector<double> pairs;           // (centre, neighbour) pairs in the bin
  std::vector<double> expected;        // those of an ideal gas; 0: no ring of the bin is in sight
  std::size_t centres = 0;             // particles in the analysis region, all frames
  double density = 0;                  // mean number per area in the analysis region, 1/m^2
  double margin = 0;                   // used, in d_p (the smallest over the frames)
  bool margin_reduced = false;         // the bed was too small for (10 + AR) d_p
  double tail_g = 0;                   // mean of g over the last quarter of r
  double tail_standard_error = 0;
};

/// G(r) = N(r + dr) / (2 pi r dr rho), collected over one or several frames.
///
/// Centres lie further than (10 + AR) d_p from side walls, floor and surface; rho is their number
/// per area. In a bed too small for that the margin shrinks to a third of the bed's smaller extent,
/// and `margin_reduced` says so. Neighbours count wherever they are, up to AR d_p (or the margin,
/// if smaller) from walls and surface, where the layering along the walls begins; 2 pi r dr is the
/// part of the ring inside that window, so that G tends to 1 for every r. With r <= 10 d_p and the
/// full margin every ring is complete.
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
  Rdf result() const;

 private:
  RdfOptions options_;
  std::vector<double> pairs_;
  std::vector<double> variance_;  // of pairs_: a pair of two centres is one event that counts twice
  std::vector<double> density_variance_;  // of pairs_, from the scatter of rho
  std::vector<double> expected_;          // pairs of an ideal gas: rho times area of the rings
  std::size_t centres_ = 0;
  double region_area_ = 0;
  double margin_ = -1;
  bool margin_reduced_ = false;
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

/// Writes a CSV table with the columns r_over_dp, g, standard_error, pairs.
void write_rdf_table(const Rdf& rdf, const std::string& file);
}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_PAIRS_RDF_SUMS_H
#define RODPACK_ANALYSIS_PAIRS_RDF_SUMS_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

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
  std::vector<double> standard_error;  // of g, see RdfSample, SpatialRdfSample
  std::vector<double> pairs;           // (centre, neighbour) pairs in the bin
  std::vector<double> expected;        // those of an ideal gas; 0: no ring of the bin is in sight
  std::size_t centres = 0;             // particles in the analysis region, all frames
  double density = 0;  // mean number in the analysis region, per area, 1/m^2; in space 1/m^3
  double margin = 0;   // used, in d_p (the smallest over the frames)
  bool margin_reduced = false;  // the bed was too small for (10 + AR) d_p
  double tail_g = 0;            // mean of g over the last quarter of r
  double tail_standard_error = 0;
};

/// Number of bins up to the largest distance.
std::size_t bins_of(const RdfOptions& options);

/// The same options with a largest distance of at most `half_period`, in d_p, in whole bins.
RdfOptions up_to(RdfOptions options, double half_period);

/// What one frame adds to G(r), in the plane or in space; lengths in m. One entry per bin.
struct RdfFrame {
  explicit RdfFrame(std::size_t bins);
  /// Adds a pair; `twice`: both are centres.
  void add_pair(std::size_t bin, bool twice);
  /// Adds the rings of a centre.
  void add_rings(const std::vector<double>& of_centre);

  std::vector<double> pairs;     // (centre, neighbour)
  std::vector<double> variance;  // of pairs: a pair of two centres is one event that counts twice
  std::vector<double> rings;     // of all centres, inside the window: their area, in space volume
  std::vector<double> spread;    // relative variance of G from the scatter of rho
  std::size_t centres = 0;
  double region = 0;  // where the centres lie: its area, in space its volume
  double margin = 0;  // in d_p
  bool margin_reduced = false;
};

/// Who wants to count the pairs of G(r) by kinds of particles; particles are named by their place
/// in the packing.
struct RdfVisitor {
  /// A centre and its rings inside the window, one per bin: areas, m^2, in space volumes, m^3.
  std::function<void(std::size_t particle, const std::vector<double>& rings)> centre;
  /// A pair; `twice`: both are centres, and it is counted a second time from the other end.
  std::function<void(std::size_t centre, std::size_t neighbour, std::size_t bin, bool twice)> pair;
};

/// Adds a particle's share to RdfFrame::spread. rho comes from the region, the neighbours also from
/// around it. A particle at x changes G by the fraction h(x) / rings - [x is a centre] / centres,
/// where h(x) is the ring around x inside the region; independent particles add up in quadrature.
/// `frame`: with its rings, centres and spread; `inside`: h(x).
void add_to_spread(const std::vector<double>& inside, bool is_centre, RdfFrame& frame);

/// Sums over frames.
class RdfSums {
 public:
  explicit RdfSums(const RdfOptions& options);
  void add(const RdfFrame& frame);
  Rdf result() const;

 private:
  double bin_width_;  // d_p
  std::vector<double> pairs_, variance_;
  std::vector<double> density_variance_;  // of pairs_, from the scatter of rho
  std::vector<double> expected_;          // pairs of an ideal gas: rho times the rings
  std::size_t centres_ = 0;
  double region_ = 0;
  double margin_ = -1;
  bool margin_reduced_ = false;
};

/// Writes a CSV table with the columns r_over_dp, g, standard_error, pairs.
void write_rdf_table(const Rdf& rdf, const std::string& file);

}  // namespace rodpack

#endif

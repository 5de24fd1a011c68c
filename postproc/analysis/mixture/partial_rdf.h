// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ANALYSIS_MIXTURE_PARTIAL_RDF_H
#define RODPACK_ANALYSIS_MIXTURE_PARTIAL_RDF_H

#include <string>
#include <vector>

#include "analysis/mixture/species.h"
#include "analysis/pairs/rdf_sums.h"
#include "reading/packing.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// G_ab(r) of two kinds a <= b, either of which may be the centre. One entry per bin.
struct PartialPair {
  std::size_t a = 0, b = 0;
  std::vector<double> g;  // 1: as in an ideal gas of the same densities
  std::vector<double>
      standard_error;            // of the number of distinct pairs, without the scatter of rho
  std::vector<double> pairs;     // (centre, neighbour), both ways
  std::vector<double> expected;  // those of an ideal gas
};

/// Partial radial distribution functions of a mixture: a pair's number over the one that an ideal
/// gas of the same mean densities has in the same rings,
///
///   G_ab = (N_ab + N_ba) / (rho_b R_a + rho_a R_b),
///
/// R_a the rings of all centres of kind a inside the window, so that the total of RdfSample is
/// G = sum over a <= b of w_ab G_ab with w_ab = expected_ab / expected, in a homogeneous bed
/// x_a x_b (2 - delta_ab) with the number shares x.
struct PartialRdf {
  std::vector<double> r;           // middle of the bin, in d_p
  std::vector<double> total;       // G of all particles together
  std::vector<double> expected;    // pairs of an ideal gas, all kinds together
  std::vector<PartialPair> pairs;  // in the order of a, then b
};

/// Measures them in a plane. @throws TooFewParticles, DataError as RdfSample::add().
PartialRdf partial_rdf(const Packing& packing, const Mixture& mixture, const RdfOptions& options);
/// The same in space. @throws as SpatialRdfSample::add().
PartialRdf partial_rdf(const SpatialPacking& packing, const Mixture& mixture,
                       const RdfOptions& options);

/// Writes a CSV table with the columns r_over_dp, g, and for each pair g_A_B, standard_error_A_B,
/// pairs_A_B and weight_A_B, the w_ab above.
void write_partial_rdf_table(const PartialRdf& rdf, const Mixture& mixture,
                             const std::string& file);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/mixture/partial_rdf.h"

#include <algorithm>
#include <cmath>

#include "analysis/rdf.h"
#include "analysis/space/spatial_rdf.h"
#include "reading/csv_file.h"

namespace rodpack {
namespace {

using Bins = std::vector<double>;

// What one frame counts, by kinds.
struct PartialSums {
  PartialSums(std::size_t kinds, std::size_t bins)
      : rings(kinds, Bins(bins, 0)),
        centres(kinds, 0),
        pairs(kinds * kinds, Bins(bins, 0)),
        variance(kinds * kinds, Bins(bins, 0)) {}

  std::vector<Bins> rings;            // of the centres of a kind
  std::vector<double> centres;        // their number
  std::vector<Bins> pairs, variance;  // of [smaller kind x kinds + larger kind]
};

RdfVisitor visitor_of(PartialSums& sums, const Mixture& mixture) {
  RdfVisitor visitor;
  visitor.centre = [&](std::size_t particle, const Bins& rings) {
    const auto kind = mixture.of[particle];
    sums.centres[kind] += 1;
    for (std::size_t k = 0; k < rings.size(); ++k) sums.rings[kind][k] += rings[k];
  };
  visitor.pair = [&](std::size_t centre, std::size_t neighbour, std::size_t bin, bool twice) {
    const auto [a, b] = std::minmax(mixture.of[centre], mixture.of[neighbour]);
    const auto at = a * mixture.species.size() + b;
    sums.pairs[at][bin] += 1;
    sums.variance[at][bin] += twice ? 2 : 1;
  };
  return visitor;
}

PartialRdf result_of(const PartialSums& sums, double region, const RdfOptions& options) {
  const auto kinds = sums.centres.size(), bins = sums.rings[0].size();
  PartialRdf rdf;
  for (std::size_t k = 0; k < bins; ++k)
    rdf.r.push_back((static_cast<double>(k) + 0.5) * options.bin_width);
  rdf.total.assign(bins, 0);
  rdf.expected.assign(bins, 0);
  for (std::size_t a = 0; a < kinds; ++a)
    for (std::size_t b = a; b < kinds; ++b) {
      PartialPair pair;
      pair.a = a;
      pair.b = b;
      pair.pairs = sums.pairs[a * kinds + b];
      for (std::size_t k = 0; k < bins; ++k) {
        double expected = sums.rings[a][k] * sums.centres[b] / region;
        if (a != b) expected += sums.rings[b][k] * sums.centres[a] / region;
        pair.expected.push_back(expected);
        pair.g.push_back(expected > 0 ? pair.pairs[k] / expected : 0);
        pair.standard_error.push_back(
            expected > 0 ? std::sqrt(sums.variance[a * kinds + b][k]) / expected : 0);
        rdf.total[k] += pair.pairs[k];
        rdf.expected[k] += expected;
      }
      rdf.pairs.push_back(std::move(pair));
    }
  for (std::size_t k = 0; k < bins; ++k)
    rdf.total[k] = rdf.expected[k] > 0 ? rdf.total[k] / rdf.expected[k] : 0;
  return rdf;
}

}  // namespace

PartialRdf partial_rdf(const Packing& packing, const Mixture& mixture, const RdfOptions& options) {
  PartialSums sums(mixture.species.size(), bins_of(options));
  const double region = visit_rdf(packing, options, visitor_of(sums, mixture));
  return result_of(sums, region, options);
}

PartialRdf partial_rdf(const SpatialPacking& packing, const Mixture& mixture,
                       const RdfOptions& options) {
  PartialSums sums(mixture.species.size(), bins_of(options));
  const double region = visit_spatial_rdf(packing, options, visitor_of(sums, mixture));
  return result_of(sums, region, options);
}

void write_partial_rdf_table(const PartialRdf& rdf, const Mixture& mixture,
                             const std::string& file) {
  std::vector<std::pair<std::string, std::vector<double>>> columns{{"r_over_dp", rdf.r},
                                                                   {"g", rdf.total}};
  for (const auto& pair : rdf.pairs) {
    const auto name = "_" + mixture.species[pair.a].name + "_" + mixture.species[pair.b].name;
    auto weight = pair.expected;
    for (std::size_t k = 0; k < weight.size(); ++k)
      weight[k] = rdf.expected[k] > 0 ? weight[k] / rdf.expected[k] : 0;
    columns.emplace_back("g" + name, pair.g);
    columns.emplace_back("standard_error" + name, pair.standard_error);
    columns.emplace_back("pairs" + name, pair.pairs);
    columns.emplace_back("weight" + name, weight);
  }
  write_csv(file, columns);
}

}  // namespace rodpack

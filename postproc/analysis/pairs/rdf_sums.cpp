// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/rdf_sums.h"

#include <algorithm>
#include <cmath>

#include "reading/csv_file.h"

namespace rodpack {

std::size_t bins_of(const RdfOptions& options) {
  return static_cast<std::size_t>(std::ceil(options.largest_distance / options.bin_width - 1e-9));
}

RdfOptions up_to(RdfOptions options, double half_period) {
  if (options.largest_distance <= half_period * (1 + 1e-9)) return options;
  options.largest_distance =
      options.bin_width * std::floor(half_period / options.bin_width * (1 + 1e-9));
  return options;
}

RdfFrame::RdfFrame(std::size_t bins)
    : pairs(bins, 0), variance(bins, 0), rings(bins, 0), spread(bins, 0) {}

void RdfFrame::add_pair(std::size_t bin, bool twice) {
  pairs[bin] += 1;
  variance[bin] += twice ? 2 : 1;
}

void RdfFrame::add_rings(const std::vector<double>& of_centre) {
  for (std::size_t k = 0; k < rings.size(); ++k) rings[k] += of_centre[k];
}

void add_to_spread(const std::vector<double>& inside, bool is_centre, RdfFrame& frame) {
  for (std::size_t k = 0; k < inside.size(); ++k) {
    const double weight = (frame.rings[k] > 0 ? inside[k] / frame.rings[k] : 0) -
                          (is_centre ? 1 / static_cast<double>(frame.centres) : 0);
    frame.spread[k] += weight * weight;
  }
}

RdfSums::RdfSums(const RdfOptions& options) : bin_width_(options.bin_width) {
  for (auto* sums : {&pairs_, &variance_, &density_variance_, &expected_})
    sums->assign(bins_of(options), 0);
}

void RdfSums::add(const RdfFrame& frame) {
  const double density = static_cast<double>(frame.centres) / frame.region;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    pairs_[k] += frame.pairs[k];
    variance_[k] += frame.variance[k];
    expected_[k] += density * frame.rings[k];
    density_variance_[k] += frame.pairs[k] * frame.pairs[k] * frame.spread[k];
  }
  centres_ += frame.centres;
  region_ += frame.region;
  margin_reduced_ = margin_reduced_ || frame.margin_reduced;
  margin_ = margin_ < 0 ? frame.margin : std::min(margin_, frame.margin);
}

Rdf RdfSums::result() const {
  Rdf rdf;
  rdf.centres = centres_;
  rdf.density = static_cast<double>(centres_) / region_;
  rdf.margin = margin_;
  rdf.margin_reduced = margin_reduced_;
  rdf.pairs = pairs_;
  rdf.expected = expected_;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    rdf.r.push_back((static_cast<double>(k) + 0.5) * bin_width_);
    const bool seen = expected_[k] > 0;
    rdf.g.push_back(seen ? pairs_[k] / expected_[k] : 0);
    rdf.standard_error.push_back(
        seen ? std::sqrt(variance_[k] + density_variance_[k]) / expected_[k] : 0);
  }
  // The deviation of the density is common to all bins, so its standard errors add up.
  double pairs = 0, variance = 0, density_error = 0, expected = 0;
  for (std::size_t k = pairs_.size() - (pairs_.size() + 3) / 4; k < pairs_.size(); ++k) {
    pairs += pairs_[k];
    variance += variance_[k];
    density_error += std::sqrt(density_variance_[k]);
    expected += expected_[k];
  }
  rdf.tail_g = expected > 0 ? pairs / expected : 0;
  rdf.tail_standard_error =
      expected > 0 ? std::sqrt(variance + density_error * density_error) / expected : 0;
  return rdf;
}

void write_rdf_table(const Rdf& rdf, const std::string& file) {
  write_csv(file, {{"r_over_dp", rdf.r},
                   {"g", rdf.g},
                   {"standard_error", rdf.standard_error},
                   {"pairs", rdf.pairs}});
}

}  // namespace rodpack

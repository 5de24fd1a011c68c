// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/peak_shares.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {

void count_members(const std::vector<PeakPair>& pairs, const std::vector<std::size_t>& members,
                   const std::vector<double>& off, PeakConfiguration& configuration) {
  auto& result = configuration;
  double squares = 0;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto& pair = pairs[members[k]];
    squares += pair.weight * off[k] * off[k];
    result.near_share += off[k] <= 2 * peak_bandwidth ? pair.weight : 0;
    result.pairs += pair.weight;
    result.touching_share += pair.touching ? pair.weight : 0;
    result.common_neighbours += pair.weight * pair.common;
  }
  result.spread = std::sqrt(squares / result.pairs);
  result.near_share /= result.pairs;
  result.touching_share /= result.pairs;
  result.common_neighbours /= result.pairs;
}

void share_out(const std::vector<PeakPair>& pairs, const PeakClusters& clusters,
               const std::function<PeakConfiguration(const std::vector<std::size_t>& members,
                                                     std::size_t summit)>& describe,
               double least_share, PeakExplanation& explanation) {
  if (pairs.empty()) throw DataError("the peak holds no pair of particles");
  double squared = 0;  // weights, for the error of shares
  for (const auto& pair : pairs) {
    explanation.pairs += pair.weight;
    explanation.touching_share += pair.touching ? pair.weight : 0;
    squared += pair.weight * pair.weight;
  }
  explanation.touching_share /= explanation.pairs;
  double others = explanation.pairs;
  for (const auto& [summit, members] : clusters) {
    double weight = 0;
    for (const auto m : members) weight += pairs[m].weight;
    const double share = weight / explanation.pairs;
    if (share < least_share) continue;
    auto configuration = describe(members, summit);
    configuration.share = share;
    configuration.share_error = std::sqrt(share * (1 - share) * squared) / explanation.pairs;
    explanation.configurations.push_back(configuration);
    others -= weight;
  }
  explanation.other_share = others / explanation.pairs;
  std::stable_sort(explanation.configurations.begin(), explanation.configurations.end(),
                   [](const auto& a, const auto& b) { return a.share > b.share; });
}

namespace {

// Of the neighbour's axis to the line of the centres.
std::string axis_to_centres(const PeakConfiguration& configuration) {
  const auto& [pair, axis] = std::tie(configuration.pair, configuration.axis);
  const double along_line =
      std::abs(axis[0] * pair.along + axis[1] * pair.across) / std::hypot(pair.along, pair.across);
  return number_text(std::acos(std::min(1.0, along_line)) / degree);
}

}  // namespace

void write_peak_table(const PeakExplanation& explanation, const std::string& file) {
  std::vector<std::string> names{
      "configuration",        "along_over_dp",  "across_over_dp", "angle_deg",
      "distance_over_dp",     "spread_over_dp", "near_share",     "share",
      "share_standard_error", "pairs",          "touching_share", "common_neighbours"};
  constexpr std::ptrdiff_t behind_angle = 4;
  const auto with_line = [&](std::vector<std::string> row, const std::string& field) {
    if (explanation.in_space) row.insert(row.begin() + behind_angle, field);
    return csv_line(row) + '\n';
  };
  std::string text = with_line(names, "axis_to_centres_deg");
  const bool round = explanation.kind == ParticleKind::sphere;
  for (const auto& each : explanation.configurations)
    text += with_line(
        {each.name, number_text(each.pair.along), number_text(each.pair.across),
         round ? "nan" : number_text(each.pair.angle / degree), number_text(each.distance),
         number_text(each.spread), number_text(each.near_share), number_text(each.share),
         number_text(each.share_error), number_text(each.pairs), number_text(each.touching_share),
         number_text(each.common_neighbours)},
        round ? "nan" : axis_to_centres(each));
  text += with_line(
      {"other", "nan", "nan", "nan", "nan", "nan", "nan", number_text(explanation.other_share),
       "nan", number_text(explanation.other_share * explanation.pairs), "nan", "nan"},
      "nan");
  write_text(file, text);
}

}  // namespace rodpack

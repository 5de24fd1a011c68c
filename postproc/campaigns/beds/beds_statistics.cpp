// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "campaigns/beds/beds.h"
#include "campaigns/launch/step_timing.h"

namespace rodpack {

SeedMean seed_mean(const std::vector<double>& values) {
  SeedMean mean;
  mean.seeds = static_cast<int>(values.size());
  if (values.empty()) return mean;
  for (const double value : values) mean.value += value / mean.seeds;
  if (mean.seeds < 2) return mean;
  double squares = 0;
  for (const double value : values) squares += std::pow(value - mean.value, 2);
  mean.error = std::sqrt(squares / (mean.seeds - 1) / mean.seeds);
  return mean;
}

double in_standard_errors(const SeedMean& difference) {
  return difference.value == 0 ? 0 : std::fabs(difference.value) / difference.error;
}

SeedMean resting_mean(const std::vector<BedRow>& rows, const BedModel& model, int rods,
                      const std::function<double(const BedRow&)>& value) {
  std::vector<double> values;
  for (const auto& row : rows)
    if (row.model == model && row.at_rest(rods)) values.push_back(value(row));
  return seed_mean(values);
}

SeedMean paired_difference(const std::vector<BedRow>& rows, const BedModel& model,
                           const BedModel& reference, int rods,
                           const std::function<double(const BedRow&)>& value) {
  std::map<int, double> expected;
  for (const auto& row : rows)
    if (row.model == reference && row.at_rest(rods)) expected[row.seed] = value(row);
  std::vector<double> differences;
  for (const auto& row : rows) {
    const auto pair = expected.find(row.seed);
    if (row.model == model && row.at_rest(rods) && pair != expected.end())
      differences.push_back(value(row) - pair->second);
  }
  return seed_mean(differences);
}

double bed_cost(const std::vector<BedRow>& rows, const BedModel& model) {
  std::vector<double> costs;
  for (const auto& row : rows)
    if (row.model == model) costs.push_back(row.seconds_per_step / model.step);
  return costs.empty() ? 0 : median(costs);
}

const std::vector<BedQuantity>& bed_quantities() {
  static const std::vector<BedQuantity> all = {
      {"φ", "", [](const BedRow& row) { return row.solid_fraction; }},
      {"S₂", "", [](const BedRow& row) { return row.order; }},
      {"E_p", "µJ", [](const BedRow& row) { return 1e6 * row.elastic; }},
      {"neighbours", "", [](const BedRow& row) { return row.neighbours; }}};
  return all;
}

std::vector<BedSummary> summarise_beds(const std::vector<BedRow>& rows,
                                       const BedComparison& comparison, int rods) {
  std::vector<BedSummary> summaries;
  for (const auto& model : comparison.models) {
    BedSummary summary;
    summary.model = model;
    for (const auto& row : rows) {
      if (!(row.model == model)) continue;
      ++summary.runs;
      summary.at_rest += row.at_rest(rods) ? 1 : 0;
    }
    if (summary.runs == 0) continue;
    for (const auto& quantity : bed_quantities())
      summary.means.push_back(resting_mean(rows, model, rods, quantity.value));
    summaries.push_back(summary);
  }
  for (auto& summary : summaries)
    for (const auto& quantity : bed_quantities()) {
      const auto difference =
          paired_difference(rows, summary.model, summaries.back().model, rods, quantity.value);
      summary.differences.push_back(difference);
      const double apart = difference.seeds < 2 ? 0 : in_standard_errors(difference);
      if (apart <= summary.worst) continue;
      summary.worst = apart;
      summary.worst_of = quantity.name;
    }
  return summaries;
}

std::optional<double> largest_step_within(const std::vector<BedSummary>& given, double bound) {
  auto steps = given;
  std::sort(steps.begin(), steps.end(),
            [](const BedSummary& a, const BedSummary& b) { return a.model.step < b.model.step; });
  if (steps.empty() || !steps.front().all_at_rest() || steps.front().runs < 2) return std::nullopt;
  double largest = steps.front().model.step;
  for (const auto& step : steps) {
    if (!step.all_at_rest() || step.runs < 2 || !(step.worst < bound)) break;
    largest = step.model.step;
  }
  return largest;
}

}  // namespace rodpack

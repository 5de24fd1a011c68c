// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/statistics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <random>

#include "reading/angles.h"

namespace rodpack {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<double> known_values(const ValuesOfRuns& values) {
  std::vector<double> known;
  for (const auto& value : values)
    if (value && std::isfinite(*value)) known.push_back(*value);
  return known;
}

double mean_of(const std::vector<double>& values) {
  // The sum of equal values divided by their number may miss them by a rounding error.
  const double first = values.front();
  double sum = 0;
  for (const double value : values) sum += value - first;
  return first + sum / static_cast<double>(values.size());
}

double square_sum_about(double mean, const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

std::optional<double> standard_error(double mean, const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  if (values.size() < 2) return std::nullopt;
  return std::sqrt(square_sum_about(mean, values) / (n - 1) / n);
}

double folded(double angle, double low, double period) {
  const double rest = (angle - low) - period * std::floor((angle - low) / period);
  return low + (rest < period ? rest : 0);
}

bool all_runs_have(const EnsembleCurve& curve, std::size_t bin) {
  return std::all_of(curve.of_runs.begin(), curve.of_runs.end(),
                     [bin](const std::vector<double>& run) { return std::isfinite(run[bin]); });
}

// Calls `visit` with every sequence of n out of n runs; there are n^n.
void for_all_resamples(std::size_t n,
                       const std::function<void(const std::vector<std::size_t>&)>& visit) {
  std::vector<std::size_t> sample(n, 0);
  for (;;) {
    visit(sample);
    std::size_t digit = 0;
    while (digit < n && ++sample[digit] == n) sample[digit++] = 0;
    if (digit == n) return;
  }
}

void for_random_resamples(std::size_t n,
                          const std::function<void(const std::vector<std::size_t>&)>& visit) {
  // The remainder, since the distributions of the standard library differ between its makers.
  std::mt19937_64 random(1);
  std::vector<std::size_t> sample(n);
  for (int k = 0; k < bootstrap_resamples; ++k) {
    for (auto& run : sample) run = random() % n;
    visit(sample);
  }
}

}  // namespace

EnsembleMean mean_over_runs(const ValuesOfRuns& values) {
  const auto known = known_values(values);
  if (known.empty()) return {none, std::nullopt, 0};
  const double mean = mean_of(known);
  return {mean, standard_error(mean, known), static_cast<int>(known.size())};
}

EnsembleMean mean_axis_over_runs(const ValuesOfRuns& degrees) {
  auto known = known_values(degrees);
  if (known.empty()) return {none, std::nullopt, 0};
  std::complex<double> sum = 0;
  for (const double angle : known) sum += std::polar(1.0, 2 * angle * degree);
  const double direction = std::arg(sum) / 2 / degree;
  for (double& angle : known) angle = folded(angle - direction, -90, 180);
  return {folded(direction, 0, 180), standard_error(0, known), static_cast<int>(known.size())};
}

EnsembleMean bootstrap_over_runs(std::size_t runs, const FunctionOfRuns& quantity) {
  std::vector<std::size_t> all(runs);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto value = runs > 0 ? quantity(all) : std::nullopt;
  if (!value || !std::isfinite(*value)) return {none, std::nullopt, 0};
  EnsembleMean result{*value, std::nullopt, static_cast<int>(runs)};
  if (runs < 2) return result;
  ValuesOfRuns resampled;
  const auto visit = [&](const std::vector<std::size_t>& sample) {
    resampled.push_back(quantity(sample));
  };
  if (runs <= 4)
    for_all_resamples(runs, visit);
  else
    for_random_resamples(runs, visit);
  const auto known = known_values(resampled);
  if (static_cast<double>(known.size()) < 0.9 * static_cast<double>(resampled.size()))
    return result;
  const auto n = static_cast<double>(runs);
  const double variance =
      square_sum_about(mean_of(known), known) / static_cast<double>(known.size());
  result.sem = std::sqrt(variance * n / (n - 1));
  return result;
}

EnsembleMean sum_over_ranges(const EnsembleCurve& curve, const std::vector<RangeTerm>& terms) {
  ValuesOfRuns sums(curve.of_runs.size(), 0.0);
  for (const auto& term : terms) {
    std::vector<std::size_t> bins;
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      if (curve.x[k] >= term.from && curve.x[k] <= term.to && all_runs_have(curve, k))
        bins.push_back(k);
    if (bins.empty()) return {none, std::nullopt, 0};
    for (std::size_t run = 0; run < sums.size(); ++run) {
      double mean = 0;
      for (const std::size_t k : bins)
        mean += curve.of_runs[run][k] / static_cast<double>(bins.size());
      *sums[run] += term.weight * mean;
    }
  }
  return mean_over_runs(sums);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/mixture/species.h"

#include <algorithm>
#include <functional>
#include <map>

#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

using Rows = std::vector<std::size_t>;

struct Kind {
  std::string name;
  Rows rows;
};

double mean_over(const Rows& rows, const std::vector<double>& values) {
  double sum = 0;
  for (const auto row : rows) sum += values[row];
  return sum / static_cast<double>(rows.size());
}

// Divides each kind where its sorted values leave a gap; `label`: of a mean value, for the names of
// what was divided.
std::vector<Kind> divided(const std::vector<Kind>& kinds, const std::vector<double>& values,
                          const std::function<bool(double low, double high)>& is_gap,
                          const std::function<std::string(double mean)>& label) {
  std::vector<Kind> result;
  for (const auto& kind : kinds) {
    auto sorted = kind.rows;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<Rows> parts(1);
    for (const auto row : sorted) {
      if (!parts.back().empty() && is_gap(values[parts.back().back()], values[row]))
        parts.emplace_back();
      parts.back().push_back(row);
    }
    for (auto& part : parts) {
      const auto name = kind.name + (parts.size() > 1 ? label(mean_over(part, values)) : "");
      std::sort(part.begin(), part.end());
      result.push_back({name, std::move(part)});
    }
  }
  return result;
}

}  // namespace

std::vector<std::size_t> Mixture::rows_of(std::size_t which) const {
  Rows rows;
  for (std::size_t row = 0; row < of.size(); ++row)
    if (of[row] == which) rows.push_back(row);
  return rows;
}

Mixture find_mixture(const Frame& bodies) {
  const auto& type = bodies.column("type");
  const auto& spheres = bodies.column("nspheres");
  const auto& half_length = bodies.column("half_length");
  const auto& radius = bodies.column("radius");
  const auto& curvature = bodies.column("curvature");
  std::vector<double> diameter, ratio;
  std::map<std::pair<int, double>, Rows> by_type;
  for (std::size_t row = 0; row < bodies.rows; ++row) {
    diameter.push_back(2 * radius[row]);
    ratio.push_back(half_length[row] / radius[row]);
    const int kind = spheres[row] < 2 ? 2 : curvature[row] > 0 ? 1 : 0;
    by_type[{kind, type[row]}].push_back(row);
  }
  std::vector<Kind> kinds;
  for (const auto& [key, rows] : by_type)
    kinds.push_back({std::string(key.first == 0   ? "rods"
                                 : key.first == 1 ? "curved"
                                                  : "spheres") +
                         "-type" + number_text(key.second),
                     rows});
  const auto factor = [](double low, double high) { return high > 1.15 * low; };
  kinds = divided(kinds, diameter, factor, [](double mean) { return "-d" + number_text(mean, 3); });
  kinds = divided(kinds, ratio, factor, [](double mean) { return "-AR" + number_text(mean, 3); });
  kinds = divided(
      kinds, curvature, [](double low, double high) { return high - low > 5 * degree; },
      [](double mean) { return "-theta" + number_text(mean / degree, 3); });

  Mixture mixture;
  mixture.of.resize(bodies.rows);
  for (const auto& [name, rows] : kinds) {
    for (const auto row : rows) mixture.of[row] = mixture.species.size();
    mixture.species.push_back({name, static_cast<long>(type[rows.front()]), rows.size(),
                               mean_over(rows, diameter), mean_over(rows, ratio),
                               mean_over(rows, curvature)});
  }
  return mixture;
}

}  // namespace rodpack

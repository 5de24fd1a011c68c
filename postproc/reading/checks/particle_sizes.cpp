// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/checks/particle_sizes.h"

#include <algorithm>
#include <numeric>

#include "reading/checks/number_range.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// Another unit of length shows as a factor of 100 or 1000.
void require_diameter_of_spheres(double given, double mean, const std::string& where) {
  if (given > 10 * mean || given < mean / 10)
    throw DataError(where + ": particle diameter d_p: expected about the spheres' mean, " +
                    number_text(mean, 4) + " m, found " + number_text(given, 4) + " m");
}

}  // namespace

ParticleSizes particle_sizes(const Frame& bodies, const PackingOptions& options,
                             const std::optional<RunParameters>& parameters) {
  const auto where = bodies.file + ":" + std::to_string(bodies.header_line);
  const auto& radius = bodies.column("radius");
  const auto& half_length = bodies.column("half_length");
  const auto from_parameters = [&](const char* key) -> std::optional<double> {
    if (parameters && parameters->values.contains(key)) return parameters->number(key);
    return std::nullopt;
  };
  const auto first_of = [](std::optional<double> a, std::optional<double> b, double c) {
    return a ? *a : b.value_or(c);
  };
  const double mean_diameter =
      2 * std::accumulate(radius.begin(), radius.end(), 0.0) / static_cast<double>(bodies.rows);
  const double diameter = require_positive(
      first_of(options.particle_diameter, from_parameters("particle_diameter_m"), mean_diameter),
      where + ": particle diameter");
  require_diameter_of_spheres(diameter, mean_diameter, where);
  const double longest = 2 * *std::max_element(half_length.begin(), half_length.end());
  const double ratio = require_positive(
      first_of(options.aspect_ratio, from_parameters("aspect_ratio"), longest / diameter),
      where + ": aspect ratio");
  // A plain sphere with a drawn size may be a little shorter than d_p.
  constexpr NumberRange ratios{0.5, 1000};
  if (!ratios.contains(ratio))
    throw DataError(where + ": aspect ratio AR: expected " + ratios.text() + ", found " +
                    number_text(ratio, 4));
  return {diameter, ratio};
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/axial_rdf.h"

#include <algorithm>
#include <cmath>

#include "analysis/space/neighbourhood.h"
#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "rodpack/geometry/vector3.h"

namespace rodpack {
namespace {

// Where a neighbour lies along and across an axis.
std::pair<double, double> along_and_across(const Vector3& to, const Vector3& axis) {
  const double along = dot(to.data(), axis.data());
  double normal[3];
  cross(to.data(), axis.data(), normal);
  return {std::abs(along), std::hypot(normal[0], normal[1], normal[2])};
}

}  // namespace

AxialRdfSample::AxialRdfSample(const AxialRdfOptions& options)
    : options_(options),
      bins_(static_cast<std::size_t>(
          std::floor(options.largest_distance / options.bin_width + 1e-9))) {
  for (auto* sums : {&pairs_, &variance_, &expected_}) sums->assign(bins_ * bins_, 0);
}

std::optional<std::size_t> AxialRdfSample::bin_at(double along, double across) const {
  const double i = std::floor(along), j = std::floor(across);
  const double limit = options_.largest_distance / options_.bin_width;
  if (std::hypot(i + 1, j + 1) > limit * (1 + 1e-12)) return std::nullopt;
  return static_cast<std::size_t>(j) * bins_ + static_cast<std::size_t>(i);
}

void AxialRdfSample::add(const SpatialPacking& packing) {
  const double bin = options_.bin_width * packing.particle_diameter;
  const double reach = options_.largest_distance * packing.particle_diameter;
  const bool bounded = std::isfinite(least_extent(packing));
  const double margin = bounded ? packing.axial_length() + reach : 0;
  const auto points = neighbourhood(packing, margin, bounded ? packing.axial_length() : 0, reach);
  const auto bin_of_pair = [&](const Vector3& to, std::size_t particle) {
    const auto [along, across] = along_and_across(to, packing.axis[particle]);
    return bin_at(along / bin, across / bin);
  };
  for_neighbours(points, reach, [&](std::size_t i, std::size_t j, const Vector3& to) {
    const auto centre = points.particle[i], neighbour = points.particle[j];
    if (!packing.elongated[centre]) return;
    const auto at = bin_of_pair(to, centre);
    if (!at) return;
    // A pair that the neighbour sees in the same bin is one event that counts twice.
    const bool twice =
        points.is_centre[j] && packing.elongated[neighbour] && bin_of_pair(to, neighbour) == at;
    pairs_[*at] += 1;
    variance_[*at] += twice ? 2 : 1;
  });
  const auto axes = static_cast<std::size_t>(
      std::count_if(points.centres.begin(), points.centres.end(),
                    [&](std::size_t i) { return packing.elongated[points.particle[i]]; }));
  if (axes == 0)
    throw TooFewParticles(
        "pair correlation along and across: no elongated particle lies further "
        "than " +
        number_text(margin / packing.particle_diameter, 4) + " d_p from walls and surface");
  const double density = static_cast<double>(points.centres.size()) / points.region_volume;
  for (std::size_t j = 0; j < bins_; ++j) {
    const double ring = 2 * pi * static_cast<double>(2 * j + 1) * bin * bin * bin;
    for (std::size_t i = 0; i < bins_; ++i)
      expected_[j * bins_ + i] += static_cast<double>(axes) * density * ring;
  }
  centres_ += axes;
  margin_ = std::max(margin_, margin / packing.particle_diameter);
}

AxialRdf AxialRdfSample::result() const {
  AxialRdf rdf;
  rdf.bin_width = options_.bin_width;
  rdf.centres = centres_;
  rdf.margin = margin_;
  for (std::size_t j = 0; j < bins_; ++j)
    for (std::size_t i = 0; i < bins_; ++i) {
      const double along = static_cast<double>(i) + 0.5, across = static_cast<double>(j) + 0.5;
      const auto at = bin_at(along, across);
      if (!at) continue;
      rdf.along.push_back(along * options_.bin_width);
      rdf.across.push_back(across * options_.bin_width);
      rdf.pairs.push_back(pairs_[*at]);
      const bool seen = expected_[*at] > 0;
      rdf.g.push_back(seen ? pairs_[*at] / expected_[*at] : 0);
      rdf.standard_error.push_back(seen ? std::sqrt(variance_[*at]) / expected_[*at] : 0);
    }
  return rdf;
}

void write_axial_rdf_table(const AxialRdf& rdf, const std::string& file) {
  write_csv(file, {{"along_over_dp", rdf.along},
                   {"across_over_dp", rdf.across},
                   {"g", rdf.g},
                   {"standard_error", rdf.standard_error},
                   {"pairs", rdf.pairs}});
}

}  // namespace rodpack

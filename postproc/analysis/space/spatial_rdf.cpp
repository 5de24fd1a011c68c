// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/spatial_rdf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/space/neighbourhood.h"

namespace rodpack {
namespace {

// Volumes of the parts inside `box` of the shells around `centre`, one per bin.
std::vector<double> shell_volumes(const Box& box, const Vector3& centre, double bin,
                                  std::size_t bins) {
  std::vector<double> volumes(bins);
  double inner = 0;
  for (std::size_t k = 0; k < bins; ++k) {
    const double outer = ball_volume_inside(box, centre, static_cast<double>(k + 1) * bin);
    volumes[k] = outer - inner;
    inner = outer;
  }
  return volumes;
}

// Of the region from walls and surface, m, and whether it had to shrink.
std::pair<double, bool> margin_in_space(const SpatialPacking& packing, const RdfOptions& options) {
  const double extent = least_extent(packing);
  if (std::isinf(extent)) return {0, false};
  if (options.margin >= 0) return {options.margin * packing.particle_diameter, false};
  const double margin = (10 + packing.aspect_ratio) * packing.particle_diameter;
  return {std::min(margin, extent / 3), margin > extent / 3};
}

}  // namespace

SpatialRdfSample::SpatialRdfSample(const RdfOptions& options) : options_(options), sums_(options) {}

void SpatialRdfSample::add(const SpatialPacking& packing) {
  const double bin = options_.bin_width * packing.particle_diameter;
  const auto bins = bins_of(options_);
  const double reach = bin * static_cast<double>(bins);
  const auto [margin, reduced] = margin_in_space(packing, options_);
  const auto points =
      neighbourhood(packing, margin, std::min(packing.axial_length(), margin), reach);
  RdfFrame frame(bins);
  frame.centres = points.centres.size();
  frame.region = points.region_volume;
  frame.margin = margin / packing.particle_diameter;
  frame.margin_reduced = reduced;
  for_neighbours(points, reach, [&](std::size_t, std::size_t j, const Vector3& to) {
    const auto k = static_cast<std::size_t>(std::hypot(to[0], to[1], to[2]) / bin);
    if (k < bins) frame.add_pair(k, points.is_centre[j]);
  });
  for (const auto i : points.centres)
    frame.add_rings(shell_volumes(points.window, points.place[i], bin, bins));
  for (std::size_t i = 0; i < points.place.size(); ++i)
    if (points.is_original[i])
      add_to_spread(shell_volumes(points.region, points.place[i], bin, bins), points.is_centre[i],
                    frame);
  sums_.add(frame);
}

void for_spatial_rdf_pairs(const SpatialPacking& packing, const RdfOptions& options,
                           std::size_t first, std::size_t last,
                           const std::function<void(const SpatialRdfPair&)>& visit) {
  const double bin = options.bin_width * packing.particle_diameter;
  const double reach = bin * static_cast<double>(bins_of(options));
  const double margin = margin_in_space(packing, options).first;
  const auto points =
      neighbourhood(packing, margin, std::min(packing.axial_length(), margin), reach);
  for_neighbours(points, reach, [&](std::size_t i, std::size_t j, const Vector3& to) {
    const auto k = static_cast<std::size_t>(std::hypot(to[0], to[1], to[2]) / bin);
    if (k >= first && k <= last)
      visit({points.particle[i], points.particle[j], to, points.is_centre[j]});
  });
}

double half_period(const SpatialPacking& packing) {
  double half = std::numeric_limits<double>::infinity();
  const auto& walls = packing.walls;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (walls.periodic[axis]) half = std::min(half, (walls.high[axis] - walls.low[axis]) / 2);
  return half / packing.particle_diameter;
}

double visit_spatial_rdf(const SpatialPacking& packing, const RdfOptions& options,
                         const RdfVisitor& visitor) {
  const double bin = options.bin_width * packing.particle_diameter;
  const auto bins = bins_of(options);
  const double reach = bin * static_cast<double>(bins);
  const double margin = margin_in_space(packing, options).first;
  const auto points =
      neighbourhood(packing, margin, std::min(packing.axial_length(), margin), reach);
  for (const auto i : points.centres)
    visitor.centre(points.particle[i], shell_volumes(points.window, points.place[i], bin, bins));
  for_neighbours(points, reach, [&](std::size_t i, std::size_t j, const Vector3& to) {
    const auto k = static_cast<std::size_t>(std::hypot(to[0], to[1], to[2]) / bin);
    if (k < bins) visitor.pair(points.particle[i], points.particle[j], k, points.is_centre[j]);
  });
  return points.region_volume;
}

}  // namespace rodpack

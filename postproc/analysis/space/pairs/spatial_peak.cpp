// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/pairs/spatial_peak.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/pairs/density_clusters.h"
#include "analysis/space/pairs/touching_rods.h"
#include "analysis/space/spatial_rdf.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// More pairs than this are sorted by their nearest one of so many, evenly chosen: each is compared
// with each, which in the plane a search tree spares.
constexpr std::size_t most_sorted = 2500;
constexpr Vector3 x_axis{1, 0, 0};

std::string name_of_spheres(double distance, int common, const ChainShape& shape) {
  if (common == 3 && std::abs(distance - std::sqrt(8.0 / 3)) <= same_place / 2)
    return "across two tetrahedra";
  return configuration_name({distance, 0, 0}, ParticleKind::sphere, shape, common);
}

}  // namespace

void SpatialPeakSample::check_shape(const Frame& bodies, const SpatialPacking& packing) {
  const auto &spheres = bodies.column("nspheres"), &curvature = bodies.column("curvature");
  for (std::size_t row = 0; row < bodies.rows; ++row) {
    const int count = static_cast<int>(spheres[row]);
    if (count > 1 && curvature[row] > 0)
      throw DataError(
          at_row(bodies, row) + "column 'curvature': expected straight particles, found " +
          number_text(curvature[row], 4) + ": how curved ones lie in space takes two numbers more");
    if (!shape_) {
      spheres_ = count;
      shape_ = shape_of_body(count, packing.aspect_ratio, 1, 1, 0);
      arm_ = count > 1 ? packing.aspect_ratio / std::sqrt(12.0) : 0;
    }
    // Where no parameters.json says it, AR comes from the drawn sizes and scatters a little.
    if (count == spheres_ && (count < 2 || std::abs(packing.aspect_ratio - shape_->aspect_ratio) <=
                                               0.01 * shape_->aspect_ratio))
      continue;
    throw DataError(at_row(bodies, row) + "a particle of " + std::to_string(count) +
                    " spheres in a bed of AR = " + number_text(packing.aspect_ratio, 6) +
                    "; expected those of the first one, " + std::to_string(spheres_) +
                    " spheres, AR = " + number_text(shape_->aspect_ratio, 6) +
                    ": only alike particles have configurations in common");
  }
}

void SpatialPeakSample::add(const Frame& bodies, const SpatialPacking& packing) {
  check_shape(bodies, packing);
  const TouchingRods rods(bodies, packing);
  const double d = packing.particle_diameter;
  for_spatial_rdf_pairs(
      packing, options_, peak_.first, peak_.last, [&](const SpatialRdfPair& pair) {
        const auto i = pair.centre, j = pair.neighbour;
        if (pair.both_centres && j < i) return;  // seen from the other end already
        const Vector3 to{pair.to[0] / d, pair.to[1] / d, pair.to[2] / d};
        if (arm_ > 0)
          equal_.push_back(
              equal_configurations(spatial_configuration(to, packing.axis[i], packing.axis[j])));
        else
          equal_.push_back({{{std::hypot(to[0], to[1], to[2]), 0, 0}, {}}});
        pairs_.push_back({pair.both_centres ? 2.0 : 1.0, rods.touch(i, j, pair.to),
                          rods.common_neighbours(i, j)});
      });
}

// To the nearest of them; nothing is turned that is too far off already.
double SpatialPeakSample::least_distance(std::size_t pair,
                                         const std::vector<SpatialConfiguration>& others) const {
  const auto& own = equal_[pair].front();
  double least = std::numeric_limits<double>::infinity();
  for (const auto& each : others)
    if (std::abs(each.along() - own.along()) < least &&
        std::abs(each.across() - own.across()) < least)
      least = std::min(least, distance_between(own, each, arm_));
  return least;
}

// Symmetric, since a pair seen from its other end is moved by more or less there.
bool SpatialPeakSample::are_near(std::size_t a, std::size_t b) const {
  if (arm_ == 0 && pairs_[a].common != pairs_[b].common) return false;
  return least_distance(a, equal_[b]) < peak_bandwidth ||
         least_distance(b, equal_[a]) < peak_bandwidth;
}

PeakClusters SpatialPeakSample::clusters() const {
  const std::size_t step = (pairs_.size() + most_sorted - 1) / most_sorted;
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < pairs_.size(); i += step) sample.push_back(i);
  std::vector<std::vector<std::size_t>> near(sample.size());
  for (std::size_t a = 0; a < sample.size(); ++a)
    for (std::size_t b = a + 1; b < sample.size(); ++b) {
      if (!are_near(sample[a], sample[b])) continue;
      near[a].push_back(b);
      near[b].push_back(a);
    }
  std::vector<double> density;
  for (const auto& each : near) density.push_back(1 + static_cast<double>(each.size()));
  const auto summits = density_clusters(
      density,
      [&](std::size_t k, const Visit& visit) {
        std::for_each(near[k].begin(), near[k].end(), visit);
      },
      peak_pass_depth);
  PeakClusters clusters;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    std::size_t nearest = i / step;
    if (i % step != 0) {
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < sample.size(); ++k) {
        if (arm_ == 0 && pairs_[i].common != pairs_[sample[k]].common) continue;
        const double distance = least_distance(i, equal_[sample[k]]);
        if (distance < least) nearest = k;
        least = std::min(least, distance);
      }
    }
    clusters[sample[summits[nearest]]].push_back(i);
  }
  return clusters;
}

PeakConfiguration SpatialPeakSample::describe(const std::vector<std::size_t>& members,
                                              std::size_t summit) const {
  const auto& top = equal_[summit].front();
  // The operations that leave the densest pair where it is, as in PeakSample.
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < equal_[summit].size(); ++k)
    if (k == 0 || distance_between(top, equal_[summit][k], arm_) < peak_bandwidth) own.push_back(k);
  PeakConfiguration result;
  SpatialConfiguration mean;
  std::vector<SpatialConfiguration> aligned;
  const auto nearer = [&](const SpatialConfiguration& a, const SpatialConfiguration& b) {
    return distance_between(top, a, arm_) < distance_between(top, b, arm_);
  };
  double weight = 0;
  for (const auto m : members) {
    aligned.push_back(*std::min_element(equal_[m].begin(), equal_[m].end(), nearer));
    if (distance_between(top, aligned.back(), arm_) > peak_bandwidth) continue;
    const auto equal = arm_ > 0 ? equal_configurations(aligned.back())
                                : std::vector<SpatialConfiguration>{aligned.back()};
    for (const auto k : own) {
      const auto turned = turned_towards(top, equal[k], arm_);
      for (std::size_t c = 0; c < 3; ++c) {
        mean.place[c] += pairs_[m].weight * turned.place[c];
        mean.axis[c] += pairs_[m].weight * turned.axis[c];
      }
      weight += pairs_[m].weight;
    }
  }
  for (auto& each : mean.place) each /= weight;
  const double size = std::hypot(mean.axis[0], mean.axis[1], mean.axis[2]);
  if (arm_ > 0)
    for (auto& each : mean.axis) each /= size;
  std::vector<double> off;
  for (const auto& each : aligned) off.push_back(distance_between(mean, each, arm_));
  count_members(pairs_, members, off, result);
  result.distance = mean.distance();
  if (arm_ > 0) {
    mean = reported_configuration(spatial_configuration(mean.place, x_axis, mean.axis));
    result.name = configuration_name(mean, *shape_);
  } else {
    result.name = name_of_spheres(mean.distance(), pairs_[summit].common, *shape_);
  }
  result.pair = {mean.along(), mean.across(), arm_ > 0 ? mean.turn() : 0};
  result.axis = mean.axis;
  return result;
}

PeakExplanation SpatialPeakSample::result(double least_share) const {
  PeakExplanation explanation;
  explanation.peak = peak_;
  explanation.in_space = true;
  explanation.kind = arm_ > 0 ? ParticleKind::straight : ParticleKind::sphere;
  if (shape_) explanation.shape = *shape_;
  share_out(
      pairs_, pairs_.empty() ? PeakClusters() : clusters(),
      [&](const std::vector<std::size_t>& members, std::size_t summit) {
        return describe(members, summit);
      },
      least_share, explanation);
  return explanation;
}

}  // namespace rodpack

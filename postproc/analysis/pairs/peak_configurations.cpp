// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pairs/peak_configurations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>

#include "analysis/pairs/density_clusters.h"
#include "analysis/pairs/touching_chains.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double bandwidth = peak_bandwidth;
// More pairs than this are sorted by their nearest one of so many, evenly chosen: the neighbours of
// all would take long, and say no more.
constexpr std::size_t most_sorted = 5000;

using Coordinates = std::array<double, 3>;

// Points whose distance is the rms distance of the points of the neighbour's centreline in two
// configurations, in d_p: turning by a moves them by (AR / sqrt 12) a. For spheres the third
// coordinate keeps those with another number of common neighbours apart.
struct Space {
  ParticleKind kind;
  double arm;

  Coordinates point(const PairConfiguration& pair, int common) const {
    if (kind == ParticleKind::sphere) return {{pair.along, 0, static_cast<double>(common)}};
    return {{pair.along, pair.across, arm * angle_from(0, pair.angle, kind)}};
  }
  double distance(const PairConfiguration& a, const PairConfiguration& b) const {
    return std::sqrt(std::pow(a.along - b.along, 2) + std::pow(a.across - b.across, 2) +
                     std::pow(arm * angle_from(a.angle, b.angle, kind), 2));
  }
  // Of everything that `pair` is equal to the one nearest to `reference`, its angle counted from
  // there without a jump.
  PairConfiguration nearest(const PairConfiguration& pair,
                            const PairConfiguration& reference) const {
    const auto all = equal_configurations(pair, kind);
    auto best = *std::min_element(all.begin(), all.end(), [&](const auto& a, const auto& b) {
      return distance(a, reference) < distance(b, reference);
    });
    best.angle = reference.angle + angle_from(reference.angle, best.angle, kind);
    return best;
  }
};

// The pairs with all their equals, so that the folds of symmetry have no edges.
struct Cloud {
  std::vector<Coordinates> points;
  std::vector<std::size_t> pair;  // of the sample

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
  void add(const Space& space, const PairConfiguration& configuration, int common,
           std::size_t index) {
    for (const auto& each : equal_configurations(configuration, space.kind)) {
      const auto at = space.point(each, common);
      points.push_back(at);
      pair.push_back(index);
      // Where angles close, seen from the other end of their range.
      const double turn = space.arm * (space.kind == ParticleKind::curved ? 2 * pi : pi);
      if (space.kind == ParticleKind::sphere || std::abs(at[2]) < turn / 2 - bandwidth) continue;
      points.push_back({{at[0], at[1], at[2] - std::copysign(turn, at[2])}});
      pair.push_back(index);
    }
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 3, std::size_t>;

Space space_of(ParticleKind kind, double aspect_ratio) {
  return {kind, kind == ParticleKind::sphere ? 0 : aspect_ratio / std::sqrt(12.0)};
}

}  // namespace

void PeakSample::check_shape(const Frame& bodies, const Packing& packing) {
  const auto& spheres = bodies.column("nspheres");
  // Where no parameters.json says it, AR comes from the drawn sizes and scatters a little.
  const auto differs = [](double a, double b) { return std::abs(a - b) > 0.01 * std::abs(a); };
  for (std::size_t i = 0; i < packing.size(); ++i) {
    const int count = static_cast<int>(spheres[i]);
    const double curvature = packing.curvature[i];
    if (!shape_) {
      spheres_ = count;
      kind_ = count < 2       ? ParticleKind::sphere
              : curvature > 0 ? ParticleKind::curved
                              : ParticleKind::straight;
      shape_ = shape_of_body(count, packing.aspect_ratio, 1, 1, curvature);
    }
    if (count != spheres_ || differs(packing.curvature[i], shape_->curvature_angle) ||
        (count > 1 && differs(packing.aspect_ratio, shape_->aspect_ratio)))
      throw DataError(bodies.file + ": particles of " + std::to_string(count) +
                      " spheres, AR = " + number_text(packing.aspect_ratio, 6) + ", arc angle " +
                      number_text(curvature / degree, 6) +
                      " degrees; expected those of the first one, " + std::to_string(spheres_) +
                      " spheres, AR = " + number_text(shape_->aspect_ratio, 6) + ", arc angle " +
                      number_text(shape_->curvature_angle / degree, 6) +
                      " degrees: only alike particles have configurations in common");
  }
}

void PeakSample::add(const Frame& bodies, const Packing& packing) {
  check_shape(bodies, packing);
  const TouchingChains chains(bodies, packing);
  const double d = packing.particle_diameter;
  for_rdf_pairs(packing, options_, peak_.first, peak_.last, [&](const RdfPair& pair) {
    const auto i = pair.centre, j = pair.neighbour;
    if (pair.both_centres && j < i) return;  // seen from the other end already
    configurations_.push_back(
        pair_configuration(pair.dx / d, pair.dy / d, packing.angle[i], packing.angle[j]));
    pairs_.push_back({pair.both_centres ? 2.0 : 1.0, chains.touch(i, j, pair.dx, pair.dy),
                      chains.common_neighbours(i, j)});
  });
}

PeakConfiguration PeakSample::describe(const std::vector<std::size_t>& members,
                                       std::size_t summit) const {
  const auto space = space_of(kind_, shape_->aspect_ratio);
  const auto& top = configurations_[summit];
  // The operations that leave the densest pair where it is: what is nearly its own mirror image is
  // reported as exactly that, since noise alone decides on which side of the mirror a pair lies.
  const auto of_top = equal_configurations(top, kind_);
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < of_top.size(); ++k)
    if (k == 0 || space.distance(of_top[k], of_top[0]) < bandwidth) own.push_back(k);

  PeakConfiguration result;
  PairConfiguration mean{0, 0, 0};
  double weight = 0;
  std::vector<PairConfiguration> aligned;
  for (const auto m : members) {
    aligned.push_back(space.nearest(configurations_[m], of_top[0]));
    if (space.distance(aligned.back(), of_top[0]) > bandwidth) continue;
    const auto equal = equal_configurations(aligned.back(), kind_);
    for (const auto k : own) {
      const double part = pairs_[m].weight;
      mean.along += part * equal[k].along;
      mean.across += part * equal[k].across;
      mean.angle += part * angle_from(of_top[0].angle, equal[k].angle, kind_);
      weight += part;
    }
  }
  mean = {mean.along / weight, mean.across / weight, of_top[0].angle + mean.angle / weight};

  std::vector<double> off;
  for (const auto& each : aligned) off.push_back(space.distance(each, mean));
  count_members(pairs_, members, off, result);
  result.distance = std::hypot(mean.along, mean.across);
  result.pair = reported_configuration(mean, kind_);
  result.name = configuration_name(result.pair, kind_, *shape_, pairs_[summit].common);
  return result;
}

PeakClusters PeakSample::clusters() const {
  const auto space = space_of(kind_, shape_->aspect_ratio);
  const auto place_of = [&](std::size_t pair) {
    return space.point(equal_configurations(configurations_[pair], kind_).front(),
                       pairs_[pair].common);
  };
  const std::size_t step = (pairs_.size() + most_sorted - 1) / most_sorted;
  Cloud cloud;
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < pairs_.size(); i += step) {
    cloud.add(space, configurations_[i], pairs_[i].common, sample.size());
    sample.push_back(i);
  }
  const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  const nanoflann::SearchParams any_order(32, 0.F, false);
  std::vector<std::pair<std::size_t, double>> found;
  const auto neighbours = [&](std::size_t k, const Visit& visit) {
    tree.radiusSearch(place_of(sample[k]).data(), bandwidth * bandwidth, found, any_order);
    for (const auto& each : found)
      if (cloud.pair[each.first] != k) visit(cloud.pair[each.first]);
  };
  std::vector<double> density(sample.size());
  for (std::size_t k = 0; k < sample.size(); ++k) {
    density[k] = 1;
    neighbours(k, [&](std::size_t) { density[k] += 1; });
  }
  const auto summits = density_clusters(density, neighbours, peak_pass_depth);

  PeakClusters clusters;
  for (std::size_t i = 0; i < pairs_.size(); ++i) {
    std::size_t nearest = i / step;
    if (i % step != 0) {
      double squared_distance = 0;
      tree.knnSearch(place_of(i).data(), 1, &nearest, &squared_distance);
      nearest = cloud.pair[nearest];
    }
    clusters[sample[summits[nearest]]].push_back(i);
  }
  return clusters;
}

PeakExplanation PeakSample::result(double least_share) const {
  PeakExplanation explanation;
  explanation.peak = peak_;
  explanation.kind = kind_;
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

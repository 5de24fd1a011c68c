// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/neighbourhood.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

// The view of the points that nanoflann asks for.
struct PlacesInSpace {
  const std::vector<Vector3>& place;
  std::size_t kdtree_get_point_count() const { return place.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return place[i][axis]; }
  template <class Bounds>
  bool kdtree_get_bbox(Bounds&) const {
    return false;
  }
};

// The bed without a strip along its walls and its surface; one period along a periodic axis.
Box inset_box(const SpatialPacking& packing, double strip) {
  const auto& walls = packing.walls;
  Box box{walls.low, walls.high};
  if (walls.round) {
    const double half = (walls.radius - strip) / std::sqrt(2.0);
    for (const std::size_t which : {0U, 1U}) {
      box.low[walls.horizontal(which)] = walls.middle[which] - half;
      box.high[walls.horizontal(which)] = walls.middle[which] + half;
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (walls.periodic[axis]) continue;
    if (axis == walls.vertical) box.high[axis] = packing.surface;
    if (walls.round && axis != walls.vertical) continue;
    box.low[axis] += strip;
    box.high[axis] -= strip;
  }
  return box;
}

Box without_ends(Box box, const SpatialWalls& walls) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (walls.periodic[axis]) {
      box.low[axis] = -endless;
      box.high[axis] = endless;
    }
  return box;
}

// Adds the images of a particle that lie within `reach` of the box of one period, itself first.
void add_images(const SpatialWalls& walls, const Vector3& place, std::size_t particle,
                bool is_centre, double reach, Neighbourhood& points) {
  std::vector<Vector3> images{place};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!walls.periodic[axis]) continue;
    const double period = walls.high[axis] - walls.low[axis];
    for (std::size_t k = images.size(); k-- > 0;)
      for (const double step : {period, -period}) {
        auto image = images[k];
        image[axis] += step;
        if (image[axis] > walls.low[axis] - reach && image[axis] < walls.high[axis] + reach)
          images.push_back(image);
      }
  }
  for (std::size_t k = 0; k < images.size(); ++k) {
    points.place.push_back(images[k]);
    points.particle.push_back(particle);
    points.is_centre.push_back(is_centre);
    points.is_original.push_back(k == 0);
  }
}

void require_short_reach(const SpatialPacking& packing, double reach) {
  const auto& walls = packing.walls;
  const double d = packing.particle_diameter;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double half = (walls.high[axis] - walls.low[axis]) / 2;
    // A box of exactly 20 d_p has room for 10 d_p, rounded as it may be.
    if (walls.periodic[axis] && reach > half * (1 + 1e-9))
      throw DataError("the largest distance, " + number_text(reach / d, 4) +
                      " d_p, exceeds half of the period in " + std::string(1, "xyz"[axis]) + ", " +
                      number_text(half / d, 4) + " d_p");
  }
}

}  // namespace

double least_extent(const SpatialPacking& packing) {
  const auto& walls = packing.walls;
  double extent = walls.round ? 2 * walls.radius : endless;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (walls.periodic[axis] || (walls.round && axis != walls.vertical)) continue;
    const double high = axis == walls.vertical ? packing.surface : walls.high[axis];
    extent = std::min(extent, high - walls.low[axis]);
  }
  return extent;
}

Neighbourhood neighbourhood(const SpatialPacking& packing, double margin, double strip,
                            double reach) {
  require_short_reach(packing, reach);
  const auto& walls = packing.walls;
  Neighbourhood points;
  const Box region = inset_box(packing, margin);
  points.region_volume = region.volume();
  points.region = without_ends(region, walls);
  points.window = without_ends(inset_box(packing, strip), walls);
  for (std::size_t i = 0; i < packing.size(); ++i)
    if (points.window.contains(packing.centre[i]))
      add_images(walls, packing.centre[i], i, points.region.contains(packing.centre[i]), reach,
                 points);
  for (std::size_t i = 0; i < points.place.size(); ++i)
    if (points.is_centre[i] && points.is_original[i]) points.centres.push_back(i);
  bool empty = points.centres.size() < 2;
  for (std::size_t axis = 0; axis < 3; ++axis)
    empty = empty || !(region.high[axis] > region.low[axis]);
  if (empty)
    throw TooFewParticles("RDF: fewer than 2 particles lie further than " +
                          number_text(margin / packing.particle_diameter, 4) +
                          " d_p from the walls and from the surface of the bed, whose smallest "
                          "extent is " +
                          number_text(least_extent(packing) / packing.particle_diameter, 4) +
                          " d_p");
  return points;
}

void for_neighbours(
    const Neighbourhood& points, double reach,
    const std::function<void(std::size_t centre, std::size_t neighbour, const Vector3&)>& visit) {
  const PlacesInSpace places{points.place};
  using Tree =
      nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, PlacesInSpace>,
                                          PlacesInSpace, 3, std::size_t>;
  const Tree tree(3, places, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  const nanoflann::SearchParams any_order(32, 0.F, false);
  std::vector<std::pair<std::size_t, double>> found;
  for (const auto i : points.centres) {
    const auto& at = points.place[i];
    tree.radiusSearch(at.data(), reach * reach, found, any_order);
    for (const auto& [j, squared] : found) {
      if (j == i) continue;
      const auto& there = points.place[j];
      visit(i, j, {there[0] - at[0], there[1] - at[1], there[2] - at[2]});
    }
  }
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/rdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nanoflann.hpp>

#include "reading/number_text.h"
#include "rodpack/geometry/disc_in_rectangle.h"

namespace rodpack {
namespace {

// The view of the points that nanoflann asks for.
struct Points {
  std::vector<double> x, y;
  std::vector<std::size_t> particle;         // place in the packing
  std::vector<bool> is_centre, is_original;  // not original: a periodic image
  std::size_t kdtree_get_point_count() const { return x.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return axis == 0 ? x[i] : y[i]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  /// Places of the centres, each once.
  std::vector<std::size_t> centres() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (is_centre[i] && is_original[i]) result.push_back(i);
    return result;
  }
};

// The bed without a strip along its walls and its surface. A periodic direction has no strip.
Rectangle inset_bed(const Packing& packing, double strip) {
  const auto& walls = packing.walls;
  const double side = walls.sides ? strip : 0, end = walls.bottom ? strip : 0;
  return {walls.left + side, walls.right - side, walls.floor + end, packing.surface - end};
}

// Adds the images of each place by a period along x (0) or y (1) that a centre between `low` and
// `high` can see within `reach`.
void add_images(std::vector<std::array<double, 2>>& places, std::size_t axis, double low,
                double high, double reach) {
  for (std::size_t k = places.size(); k-- > 0;)
    for (const double shift : {high - low, low - high}) {
      auto image = places[k];
      image[axis] += shift;
      if (image[axis] > low - reach && image[axis] < high + reach) places.push_back(image);
    }
}

// Particles inside the window, where neighbours count; those inside the region are centres. Along
// a periodic direction with the images that a centre can see within `reach`.
Points points_inside(const Packing& packing, const Rectangle& window, const Rectangle& region,
                     double reach) {
  const auto& walls = packing.walls;
  Points points;
  for (std::size_t i = 0; i < packing.size(); ++i) {
    if (!window.contains(packing.x[i], packing.y[i])) continue;
    std::vector<std::array<double, 2>> places{{packing.x[i], packing.y[i]}};
    if (!walls.sides) add_images(places, 0, walls.left, walls.right, reach);
    if (!walls.bottom) add_images(places, 1, walls.floor, walls.ceiling, reach);
    const bool is_centre = region.contains(packing.x[i], packing.y[i]);
    for (std::size_t k = 0; k < places.size(); ++k) {
      points.x.push_back(places[k][0]);
      points.y.push_back(places[k][1]);
      points.particle.push_back(i);
      points.is_centre.push_back(is_centre);
      points.is_original.push_back(k == 0);
    }
  }
  return points;
}

// Areas of the parts inside `box` of the rings around (x, y), one per bin.
std::vector<double> ring_areas(const Rectangle& box, double x, double y, double bin,
                               std::size_t bins) {
  std::vector<double> areas(bins);
  double inner = 0;
  for (std::size_t k = 0; k < bins; ++k) {
    const double outer = disc_area_inside(box, x, y, static_cast<double>(k + 1) * bin);
    areas[k] = outer - inner;
    inner = outer;
  }
  return areas;
}

// Calls visit(i, j, bin) for the points i, a centre, and j, its neighbour, of every pair.
template <class Visit>
void for_pairs(const Points& points, const std::vector<std::size_t>& centres, double bin,
               std::size_t bins, Visit visit) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                   Points, 2, std::size_t>;
  const Tree tree(2, points, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  const nanoflann::SearchParams any_order(32, 0.F, false);
  const double reach = bin * static_cast<double>(bins);
  std::vector<std::pair<std::size_t, double>> found;
  for (const auto i : centres) {
    const double at[2] = {points.x[i], points.y[i]};
    tree.radiusSearch(at, reach * reach, found, any_order);
    for (const auto& [j, squared] : found) {
      const auto k = static_cast<std::size_t>(std::sqrt(squared) / bin);
      if (j != i && k < bins) visit(i, j, k);
    }
  }
}

// What of a packing G(r) looks at.
struct FieldOfView {
  double margin;             // of the region from walls and surface, m
  bool reduced;              // it had to shrink
  double area;               // where the centres lie, of one period, m^2
  Rectangle region, window;  // endless along a periodic direction
  Points points;
  std::vector<std::size_t> centres;
};

// Far enough beyond a period's ends that no ring is cut there.
Rectangle without_ends(Rectangle rectangle, const Walls& walls, double reach) {
  if (!walls.sides) {
    rectangle.left -= 2 * reach;
    rectangle.right += 2 * reach;
  }
  if (!walls.bottom) {
    rectangle.bottom -= 2 * reach;
    rectangle.top += 2 * reach;
  }
  return rectangle;
}

std::pair<double, bool> margin_of(const Packing& packing, const RdfOptions& options) {
  const auto& walls = packing.walls;
  if (!walls.sides && !walls.bottom) return {0, false};
  if (options.margin >= 0) return {options.margin * packing.particle_diameter, false};
  const double margin = (10 + packing.aspect_ratio) * packing.particle_diameter;
  double extent = std::numeric_limits<double>::infinity();
  if (walls.bottom) extent = packing.surface - walls.floor;
  if (walls.sides) extent = std::min(extent, walls.width());
  return {std::min(margin, extent / 3), margin > extent / 3};
}

FieldOfView field_of_view(const Packing& packing, const RdfOptions& options) {
  const double d = packing.particle_diameter;
  const auto& walls = packing.walls;
  const double reach = options.bin_width * d * static_cast<double>(bins_of(options));
  const auto require_short = [&](double half, const char* axis) {
    // A period of exactly 20 d_p has room for 10 d_p, rounded as it may be.
    if (reach > half * (1 + 1e-9))
      throw DataError("the largest distance, " + number_text(reach / d, 4) +
                      " d_p, exceeds half of the period in " + axis + ", " +
                      number_text(half / d, 4) + " d_p");
  };
  if (!walls.sides) require_short(walls.width() / 2, "x");
  if (!walls.bottom) require_short((walls.ceiling - walls.floor) / 2, "y");

  const auto [margin, reduced] = margin_of(packing, options);
  const Rectangle one_period = inset_bed(packing, margin);
  const Rectangle region = without_ends(one_period, walls, reach);
  const Rectangle window =
      without_ends(inset_bed(packing, std::min(packing.axial_length(), margin)), walls, reach);
  Points points = points_inside(packing, window, region, reach);
  auto centres = points.centres();
  if (centres.size() < 2 || one_period.right <= one_period.left ||
      one_period.top <= one_period.bottom)
    throw TooFewParticles("RDF: fewer than 2 particles lie further than " +
                          number_text(margin / d, 4) +
                          " d_p from the walls and from the surface of the bed, which is " +
                          number_text(walls.width() / d, 4) + " d_p wide and " +
                          number_text((packing.surface - walls.floor) / d, 4) + " d_p high");
  return {margin, reduced,           one_period.area(), region,
          window, std::move(points), std::move(centres)};
}

}  // namespace

RdfSample::RdfSample(const RdfOptions& options) : options_(options), sums_(options) {}

void RdfSample::add(const Packing& packing) {
  const double bin = options_.bin_width * packing.particle_diameter;
  const auto bins = bins_of(options_);
  const auto [margin, reduced, area, region, window, points, centres] =
      field_of_view(packing, options_);
  RdfFrame frame(bins);
  frame.centres = centres.size();
  frame.region = area;
  frame.margin = margin / packing.particle_diameter;
  frame.margin_reduced = reduced;
  const auto& is_centre = points.is_centre;
  for_pairs(points, centres, bin, bins,
            [&](std::size_t, std::size_t j, std::size_t k) { frame.add_pair(k, is_centre[j]); });
  for (const auto i : centres)
    frame.add_rings(ring_areas(window, points.x[i], points.y[i], bin, bins));
  for (std::size_t i = 0; i < points.x.size(); ++i)
    if (points.is_original[i])
      add_to_spread(ring_areas(region, points.x[i], points.y[i], bin, bins), points.is_centre[i],
                    frame);
  sums_.add(frame);
}

void for_rdf_pairs(const Packing& packing, const RdfOptions& options, std::size_t first,
                   std::size_t last, const std::function<void(const RdfPair&)>& visit) {
  const auto view = field_of_view(packing, options);
  const auto& points = view.points;
  for_pairs(points, view.centres, options.bin_width * packing.particle_diameter, bins_of(options),
            [&](std::size_t i, std::size_t j, std::size_t bin) {
              if (bin < first || bin > last) return;
              visit({points.particle[i], points.particle[j], points.x[j] - points.x[i],
                     points.y[j] - points.y[i], points.is_centre[j]});
            });
}

double half_period(const Packing& packing) {
  double half = std::numeric_limits<double>::infinity();
  const auto& walls = packing.walls;
  if (!walls.sides) half = std::min(half, walls.width() / 2);
  if (!walls.bottom) half = std::min(half, (walls.ceiling - walls.floor) / 2);
  return half / packing.particle_diameter;
}

double visit_rdf(const Packing& packing, const RdfOptions& options, const RdfVisitor& visitor) {
  const double bin = options.bin_width * packing.particle_diameter;
  const auto bins = bins_of(options);
  const auto view = field_of_view(packing, options);
  const auto& points = view.points;
  for (const auto i : view.centres)
    visitor.centre(points.particle[i],
                   ring_areas(view.window, points.x[i], points.y[i], bin, bins));
  for_pairs(points, view.centres, bin, bins, [&](std::size_t i, std::size_t j, std::size_t k) {
    visitor.pair(points.particle[i], points.particle[j], k, points.is_centre[j]);
  });
  return view.area;
}

}  // namespace rodpack

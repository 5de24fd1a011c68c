// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/rdf.h"

#include <algorithm>
#include <cmath>
#include <nanoflann.hpp>

#include "rodpack/figure.h"
#include "rodpack/text.h"

namespace rodpack {
namespace {
constexpr double pi = 3.14159265358979323846;

// The view of the points that nanoflann asks for.
struct Points {
  std::vector<double> x, y;
  std::vector<bool> is_centre;
  std::size_t kdtree_get_point_count() const { return x.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return axis == 0 ? x[i] : y[i]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

struct Rectangle {
  double left, right, bottom, top;
  bool contains(double x, double y) const {
    return x >= left && x <= right && y >= bottom && y <= top;
  }
  double area() const { return (right - left) * (top - bottom); }
};

// The bed without a strip along its walls and its surface. A periodic direction has no strip.
Rectangle inset_bed(const Packing& packing, double strip) {
  const auto& walls = packing.walls;
  const double side = walls.sides ? strip : 0;
  return {walls.left + side, walls.right - side, walls.floor + (walls.bottom ? strip : 0),
          packing.surface - strip};
}

}  // namespace

double quarter_disc_area(double r, double a, double b) {
  if (a <= 0 || b <= 0) return 0;
  if (a * a + b * b <= r * r) return a * b;
  a = std::min(a, r);
  b = std::min(b, r);
  // Flat part b up to where the circle comes below it, then the integral of sqrt(r^2 - x^2).
  const double start = std::sqrt(std::max(0.0, r * r - b * b));
  const auto primitive = [r](double x) {
    return 0.5 * (x * std::sqrt(std::max(0.0, r * r - x * x)) + r * r * std::asin(std::min(1.0, x / r)));
  };
  return b * start + primitive(a) - primitive(start);
}

RdfSample::RdfSample(const RdfOptions& options) : options_(options) {
  const auto bins = static_cast<std::size_t>(
      std::ceil(options.largest_distance / options.bin_width - 1e-9));
  pairs_.assign(bins, 0);
  variance_.assign(bins, 0);
  expected_.assign(bins, 0);
}

void RdfSample::add(const Packing& packing) {
  const double d = packing.particle_diameter;
  const auto& walls = packing.walls;
  const double bin = options_.bin_width * d;
  const double reach = bin * static_cast<double>(pairs_.size());
  if (!walls.sides && reach > walls.width() / 2)
    throw DataError("the largest distance, " + number_text(reach / d, 4) +
                    " d_p, exceeds half of the period in x, " +
                    number_text(walls.width() / 2 / d, 4) + " d_p");

  double margin = options_.margin * d;
  if (options_.margin < 0) {
    margin = (10 + packing.aspect_ratio) * d;
    double extent = packing.surface - walls.floor;
    if (walls.sides) extent = std::min(extent, walls.width());
    if (margin > extent / 3) {
      margin = extent / 3;
      margin_reduced_ = true;
    }
  }
  const Rectangle region = inset_bed(packing, margin);
  Rectangle window = inset_bed(packing, std::min(packing.axial_length(), margin));

  std::vector<std::size_t> centres;
  Points points;
  for (std::size_t i = 0; i < packing.size(); ++i) {
    if (!window.contains(packing.x[i], packing.y[i])) continue;
    const bool is_centre = region.contains(packing.x[i], packing.y[i]);
    if (is_centre) centres.push_back(points.x.size());
    const auto add_point = [&](double x) {
      points.x.push_back(x);
      points.y.push_back(packing.y[i]);
      points.is_centre.push_back(is_centre);
    };
    add_point(packing.x[i]);
    if (!walls.sides) {  // periodic images that a centre can see
      if (packing.x[i] < walls.left + reach) add_point(packing.x[i] + walls.width());
      if (packing.x[i] > walls.right - reach) add_point(packing.x[i] - walls.width());
    }
  }
  if (centres.size() < 2 || region.right <= region.left || region.top <= region.bottom)
    throw TooFewParticles("RDF: fewer than 2 particles lie further than " + number_text(margin / d, 4) +
                    " d_p from the walls and from the surface of the bed, which is " +
                    number_text(walls.width() / d, 4) + " d_p wide and " +
                    number_text((packing.surface - walls.floor) / d, 4) + " d_p high");
  if (!walls.sides) {
    window.left -= reach;
    window.right += reach;
  }

  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                   Points, 2, std::size_t>;
  const Tree tree(2, points, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  const double density = static_cast<double>(centres.size()) / region.area();
  const nanoflann::SearchParams any_order(32, 0.F, false);
  std::vector<std::pair<std::size_t, double>> found;
  for (const auto i : centres) {
    const double at[2] = {points.x[i], points.y[i]};
    tree.radiusSearch(at, reach * reach, found, any_order);
    for (const auto& [j, squared] : found) {
      const auto k = static_cast<std::size_t>(std::sqrt(squared) / bin);
      if (j == i || k >= pairs_.size()) continue;
      pairs_[k] += 1;
      variance_[k] += points.is_centre[j] ? 2 : 1;
    }
    double inner = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const double r = static_cast<double>(k + 1) * bin;
      double outer = 0;
      for (const double a : {at[0] - window.left, window.right - at[0]})
        for (const double b : {at[1] - window.bottom, window.top - at[1]})
          outer += quarter_disc_area(r, a, b);
      expected_[k] += density * (outer - inner);
      inner = outer;
    }
  }
  centres_ += centres.size();
  region_area_ += region.area();
  margin_ = margin_ < 0 ? margin / d : std::min(margin_, margin / d);
}

Rdf RdfSample::result() const {
  Rdf rdf;
  rdf.centres = centres_;
  rdf.density = static_cast<double>(centres_) / region_area_;
  rdf.margin = margin_;
  rdf.margin_reduced = margin_reduced_;
  rdf.pairs = pairs_;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    rdf.r.push_back((static_cast<double>(k) + 0.5) * options_.bin_width);
    const bool seen = expected_[k] > 0;
    rdf.g.push_back(seen ? pairs_[k] / expected_[k] : 0);
    rdf.standard_error.push_back(seen ? std::sqrt(variance_[k]) / expected_[k] : 0);
  }
  double pairs = 0, variance = 0, expected = 0;
  for (std::size_t k = pairs_.size() - (pairs_.size() + 3) / 4; k < pairs_.size(); ++k) {
    pairs += pairs_[k];
    variance += variance_[k];
    expected += expected_[k];
  }
  rdf.tail_g = expected > 0 ? pairs / expected : 0;
  rdf.tail_standard_error = expected > 0 ? std::sqrt(variance) / expected : 0;
  return rdf;
}

void write_rdf_table(const Rdf& rdf, const std::string& file) {
  write_csv(file, {{"r_over_dp", rdf.r},
                   {"g", rdf.g},
                   {"standard_error", rdf.standard_error},
                   {"pairs", rdf.pairs}});
}

void plot_rdf(const Rdf& rdf, const std::string& stem) {
  const std::string style = std::string(" linecolor '") + colour::blue + "'";
  draw_figure(stem, 1.4,
              datablock("g", {rdf.r, rdf.g, rdf.standard_error}) +
                  "set xlabel 'distance {/:Italic r} / {/:Italic d}_p'\n"
                  "set ylabel 'radial distribution function {/:Italic G}({/:Italic r})'\n"
                  "set yrange [0:*]\nset xrange [0:" +
                  number_text(rdf.r.back() + rdf.r.front()) +
                  "]\n"
                  "plot 1 with lines dashtype 2 linewidth 1 linecolor '" + colour::grey + "', " +
                  "$g using 1:($2-$3):($2+$3) with filledcurves fillstyle transparent solid 0.25" +
                  style + " title '± standard error', $g using 1:2 with lines linewidth 1.3" +
                  style + " title '{/:Italic G}({/:Italic r})'\n");
}

}  // namespace rodpack

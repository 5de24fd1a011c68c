// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "analysis/edges/undisturbed.h"
#include "ensemble/ensemble_field.h"
#include "figures/edges/shading.h"
#include "figures/edges/map_drawing.h"
#include "figures/figure.h"
#include "reading/number_text.h"
#include "study/case_panels.h"

namespace rodpack {
namespace {

struct CaseMap {
  std::string title;
  std::vector<double> x, y, value;  // x, y in d_p
  double width = 0, height = 0;     // of the map, d_p
  std::vector<Rectangle> disturbed;
  std::optional<double> surface;  // d_p
};

std::optional<CaseMap> read_map(const EnsembleCase& each, const std::string& out) {
  const auto file = std::filesystem::path(out) / (each.name + "_fields.csv");
  const auto diameter = each.parameters.find("particle_diameter_m");
  if (!std::filesystem::exists(file) || diameter == each.parameters.end()) return std::nullopt;
  const auto field = read_ensemble_field(file.string());
  const double d = diameter->get<double>();
  CaseMap map;
  for (std::size_t row = 0; row < field.y.size(); ++row)
    for (std::size_t column = 0; column < field.x.size(); ++column) {
      const auto& value = field.solid_fraction[row * field.x.size() + column];
      if (value.n == 0 || !std::isfinite(value.mean)) continue;
      map.x.push_back(field.x[column] / d);
      map.y.push_back(field.y[row] / d);
      map.value.push_back(value.mean);
    }
  if (map.x.empty()) return std::nullopt;
  map.width = field.x.back() / d;
  map.height = field.y.back() / d;
  double omega = 0;
  if (const auto bed = mean_bed(each, omega)) {
    map.disturbed = parts_outside(undisturbed_part(*bed, 3 * omega), {0, map.width, 0, map.height});
    if (bed->surface < map.height) map.surface = bed->surface;
  }
  return map;
}

// Straight cases, both surfaces of an aspect ratio beside each other.
std::vector<CaseMap> straight_maps(const Ensemble& ensemble, const std::string& out) {
  std::vector<CaseMap> maps;
  for (const double aspect_ratio : aspect_ratios(ensemble, false))
    for (const bool coarse : {true, false}) {
      const auto* each = straight_case(ensemble, surface_of(coarse), aspect_ratio);
      auto map = each ? read_map(*each, out) : std::nullopt;
      if (!map) continue;
      map->title = "AR = " + number_text(aspect_ratio, 4) + "\\n" + (coarse ? "coarse" : "smooth");
      maps.push_back(*map);
    }
  return maps;
}

// The maps side by side, all at one scale.
struct MapLayout {
  double left = 6.6, right = 10, bottom = 4.6, top = 3.8, gap = 2.2;  // letters
  double per_diameter = 1;                                            // letters per d_p
  double width = 0, height = 0;

  explicit MapLayout(const std::vector<CaseMap>& maps) {
    double widths = 0, tallest = 0;
    for (const auto& map : maps) {
      widths += map.width;
      tallest = std::max(tallest, map.height);
    }
    // The narrowest map takes its title; the sheet is not taller than a page is.
    double narrowest = maps.front().width;
    for (const auto& map : maps) narrowest = std::min(narrowest, map.width);
    per_diameter = std::min(std::max(90 / widths, 4.5 / narrowest), 70 / tallest);
    width = left + widths * per_diameter + gap * static_cast<double>(maps.size() - 1) + right;
    height = bottom + tallest * per_diameter + top;
  }
  std::string across(double length) const { return number_text(length / width, 6); }
  std::string up(double length) const { return number_text(length / height, 6); }
};

std::string map_plot(const CaseMap& map, std::size_t place, double x0, const MapLayout& layout) {
  const double x1 = x0 + map.width * layout.per_diameter;
  const double y1 = layout.bottom + map.height * layout.per_diameter;
  const double tic = round_step(map.width);
  std::string edges;
  if (!map.disturbed.empty()) edges += ", " + hatched("disturbed" + std::to_string(place));
  if (map.surface) edges += ", " + number_text(*map.surface) + " with lines " + surface_look();
  return "set lmargin at screen " + layout.across(x0) + "\nset rmargin at screen " +
         layout.across(x1) + "\nset bmargin at screen " + layout.up(layout.bottom) +
         "\nset tmargin at screen " + layout.up(y1) + "\nset xrange [0:" + number_text(map.width) +
         "]\nset yrange [0:" + number_text(map.height) + "]\nset xtics 0," + number_text(tic) +
         "\nset format y '" + (place == 0 ? "%g" : "") + "'\nset label 1 \"" + map.title +
         "\" at screen " + layout.across(0.5 * (x0 + x1)) + "," + layout.up(y1 + 2.6) +
         " center\nplot $map" + std::to_string(place) + " using 1:2:3 with image" + edges +
         "\nunset colorbox\nunset label\n";
}

}  // namespace

StudyFigure draw_solid_fraction_maps(const Ensemble& ensemble, const std::string& out) {
  StudyFigure figure{
      "fig2_solid_fraction_maps", "Fig. 2",
      "Maps of the coarse-grained solid fraction, mean over the repetitions, straight "
      "particles, all at one scale. Hatched: within 3ω of a wall or the surface (line: its mean), "
      "where the kernel averages over the empty space beyond.",
      ""};
  const auto maps = straight_maps(ensemble, out);
  if (maps.empty()) {
    figure.not_drawn = "no straight case has a map (CASE_fields.csv)";
    return figure;
  }
  const MapLayout layout(maps);
  std::string blocks, plots;
  double x0 = layout.left, largest = 0, tallest = 0;
  for (std::size_t place = 0; place < maps.size(); ++place) {
    const auto& map = maps[place];
    blocks += datablock("map" + std::to_string(place), {map.x, map.y, map.value});
    if (!map.disturbed.empty())
      blocks += hatch_block("disturbed" + std::to_string(place), map.disturbed);
    plots += map_plot(map, place, x0, layout);
    x0 += map.width * layout.per_diameter + layout.gap;
    largest = std::max(largest, *std::max_element(map.value.begin(), map.value.end()));
    tallest = std::max(tallest, map.height);
  }
  const double bar = std::min(tallest * layout.per_diameter, 20.0);
  draw_figure(
      out + "/" + figure.name, layout.width / layout.height,
      blocks + palette_command() + "set multiplot\nset tics out nomirror\nset cbrange [0.5:" +
          number_text(0.05 * std::ceil(20 * largest), 3) +
          "]\nset label 4 'solid fraction {/:Italic φ}' at screen " +
          layout.across(layout.width - 1.2) + "," + layout.up(layout.bottom + 0.5 * bar) +
          " center rotate by 90\nset colorbox user origin screen " +
          layout.across(layout.width - layout.right + 1.2) + ", screen " +
          layout.up(layout.bottom) + " size screen " + layout.across(1.2) + ", screen " +
          layout.up(bar) + "\nset label 2 '{/:Italic x} / {/:Italic d}_p' at screen " +
          layout.across(0.5 * (layout.left + layout.width - layout.right)) + "," + layout.up(0.9) +
          " center\nset label 3 '{/:Italic y} / {/:Italic d}_p' at screen " + layout.across(1.2) +
          "," + layout.up(layout.bottom + 0.5 * tallest * layout.per_diameter) +
          " center rotate by 90\n" + plots + "unset multiplot\n",
      layout.width * em);
  return figure;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/space/section_figure.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "analysis/edges/undisturbed.h"
#include "figures/edges/map_drawing.h"
#include "figures/edges/shading.h"
#include "figures/figure.h"
#include "reading/angles.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

std::string coordinate(const std::string& name) { return "{/:Italic " + name + "}"; }

// The places of a map for which `holds`, as rectangles of a row each.
std::vector<Rectangle> places_with(const FieldMap& map, std::size_t columns,
                                   const std::function<bool(std::size_t)>& holds) {
  std::vector<Rectangle> parts;
  const double half_x = map.spacing[0] / 2, half_y = map.spacing[1] / 2;
  for (std::size_t i = 0; i < map.x.size(); ++i) {
    if (!holds(i)) continue;
    const bool goes_on = i % columns > 0 && holds(i - 1);
    if (goes_on)
      parts.back().right = map.x[i] + half_x;
    else
      parts.push_back({map.x[i] - half_x, map.x[i] + half_x, map.y[i] - half_y, map.y[i] + half_y});
  }
  return parts;
}

// White over what is outside a cylinder, and its wall on a level slice.
void show_wall(const Section& section, const SpatialPacking& packing,
               const std::function<bool(std::size_t)>& outside, FieldMap& map) {
  auto beyond = places_with(map, section.count[0], outside);
  if (beyond.empty()) return;
  for (auto& part : beyond) {  // so that no seam shows between two rows
    part.bottom -= 0.05 * map.spacing[1];
    part.top += 0.05 * map.spacing[1];
  }
  map.blocks += hatch_block("outside", beyond);
  map.edges +=
      ", $outside using 1:2:3:4:5:6 with boxxyerror fillstyle solid noborder linecolor '#FFFFFF'";
  std::vector<double> x, y;
  const double radius = packing.walls.radius / packing.particle_diameter;
  for (int k = 0; k <= 180; ++k) {
    x.push_back(radius * std::cos(2 * k * degree));
    y.push_back(radius * std::sin(2 * k * degree));
  }
  map.blocks += datablock("wall", {x, y});
  map.edges += ", $wall using 1:2 with lines linewidth 1.4 linecolor '#202020'";
}

FieldMap map_of(const Section& section, const SpatialFieldSample& sample) {
  const auto& packing = sample.packing();
  const auto& kernel = sample.averages().kernel();
  const double d = packing.particle_diameter, reach = kernel_reach(kernel);
  FieldMap map;
  for (std::size_t i = 0; i < section.place.size(); ++i) {
    map.x.push_back(section.u[i] / d);
    map.y.push_back(section.v[i] / d);
  }
  map.spacing = {section.spacing[0] / d, section.spacing[1] / d};
  map.x_label = coordinate(section.name[0]) + " / {/:Italic d}_p";
  map.y_label = coordinate(section.name[1]) + " / {/:Italic d}_p";
  if (!section.where.empty())
    map.x_label += ",  at " + coordinate(section.where) + " = " + number_text(section.at / d, 3) +
                   " {/:Italic d}_p";
  const auto away = [&](std::size_t i, Normalisation normalisation) {
    return distance_to_edges(packing, section.place[i], normalisation);
  };
  const double disturbed = reach * (1 - 1e-5);  // lengths that differ by rounding are equal
  map.hatch(places_with(map, section.count[0],
                        [&](std::size_t i) { return away(i, sample.normalisation()) < disturbed; }),
            shade_title(reach / kernel.scale(), sample.normalisation() == Normalisation::walls));
  if (packing.walls.round && section.where == std::string(1, "xyz"[packing.walls.vertical]))
    show_wall(
        section, packing,
        [&](std::size_t i) {
          return packing.walls.distance_to_sides(section.place[i]) < -0.5 * section.spacing[0];
        },
        map);
  if (section.name[1] == std::string(1, "xyz"[packing.walls.vertical]))
    map.mark_surface((packing.surface - packing.walls.low[packing.walls.vertical]) / d);
  return map;
}

}  // namespace

void plot_section_solid_fraction(const Section& section, const SpatialFieldSample& sample,
                                 const std::string& stem) {
  auto map = map_of(section, sample);
  map.value = field_named(section.fields, "solid_fraction").values[0];
  map.value_label = "solid fraction {/:Italic φ}";
  draw_map(map, stem);
}

void plot_section_pressure(const Section& section, const SpatialFieldSample& sample,
                           const std::string& stem) {
  const auto& stress = field_named(section.fields, "contact_stress").values;
  auto map = map_of(section, sample);
  double largest = 0;
  for (std::size_t i = 0; i < section.place.size(); ++i) {
    map.value.push_back((stress[0][i] + stress[4][i] + stress[8][i]) / 3);
    largest = std::max(largest, map.value.back());
  }
  const auto unit = scaled_unit(largest, "Pa");
  for (double& value : map.value) value *= unit.factor;
  map.value_label = "pressure {/:Italic P} (" + unit.name + ")";
  const auto [u, v] = section.component;
  PlaneStress plane{stress[3 * u + u], stress[3 * u + v], stress[3 * v + u], stress[3 * v + v], {}};
  for (const auto& place : section.place)
    plane.shown.push_back(sample.packing().walls.distance_to_sides(place) >= 0);
  add_crosses(plane, section.count[0], map);
  draw_map(map, stem);
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/field_maps.h"

#include <algorithm>

#include "analysis/edges/undisturbed.h"
#include "figures/edges/map_drawing.h"
#include "figures/edges/shading.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

// A map of `values` over the grid, lengths in d_p, with what shows where the bed ends and where the
// kernel reaches beyond it.
FieldMap map_of(const Grid& grid, const std::vector<double>& values, const std::string& label,
                const MappedBed& bed) {
  const auto& walls = bed.packing.walls;
  const double d = bed.packing.particle_diameter;
  FieldMap map;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const Vector place = grid.place(i);
    map.x.push_back((place[0] - walls.left) / d);
    map.y.push_back((place[1] - walls.floor) / d);
  }
  map.value = values;
  map.spacing = {grid.spacing[0] / d, grid.spacing[1] / d};
  map.x_label = "{/:Italic x} / {/:Italic d}_p";
  map.y_label = "{/:Italic y} / {/:Italic d}_p";
  map.value_label = label;
  const auto part = undisturbed_part(bed.packing, bed.reach, bed.normalisation);
  map.hatch(parts_outside({(part.left - walls.left) / d, (part.right - walls.left) / d,
                           (part.bottom - walls.floor) / d, (part.top - walls.floor) / d},
                          map.area()),
            shade_title(bed.reach / bed.scale, bed.normalisation == Normalisation::walls));
  map.mark_surface((bed.packing.surface - walls.floor) / d);
  return map;
}

}  // namespace

MappedBed mapped_bed(const FieldSample& sample, const Packing& packing) {
  const auto& kernel = sample.averages().kernel();
  return {packing, kernel.scale(), kernel_reach(kernel), sample.normalisation()};
}

void plot_solid_fraction_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                             const MappedBed& bed, const std::string& stem) {
  draw_map(map_of(*averages.grid(), field_named(fields, "solid_fraction").values[0],
                  "solid fraction {/:Italic φ}", bed),
           stem);
}

void plot_pressure_map(const CoarseGraining& averages, const std::vector<Field>& fields,
                       const MappedBed& bed, const std::string& stem) {
  const Grid& grid = *averages.grid();
  const auto& stress = field_named(fields, "contact_stress").values;
  std::vector<double> pressure(grid.size());
  double largest = 0;
  for (std::size_t i = 0; i < grid.size(); ++i) {
    pressure[i] = 0.5 * (stress[0][i] + stress[3][i]);
    largest = std::max(
        largest, principal_stress(stress[0][i], stress[1][i], stress[2][i], stress[3][i]).larger);
  }
  const auto unit = scaled_unit(largest, "N/m");
  for (double& value : pressure) value *= unit.factor;
  auto map = map_of(grid, pressure, "pressure {/:Italic P}_0 (" + unit.name + ")", bed);
  add_crosses({stress[0], stress[1], stress[2], stress[3], {}},
              static_cast<std::size_t>(grid.count[0]), map);
  draw_map(map, stem);
}

}  // namespace rodpack

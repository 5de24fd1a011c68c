// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/mixture/composition.h"

#include <map>
#include <set>

#include "analysis/orientation.h"
#include "analysis/space/body_volumes.h"
#include "analysis/space/spatial_orientation.h"
#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "reading/text_file.h"

namespace rodpack {
namespace {

template <class Value>
std::vector<Value> at_rows(const std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  std::vector<Value> result;
  for (const auto row : rows) result.push_back(values[row]);
  return result;
}

// The packing with these particles alone; walls, surface and sizes stay those of all.
Packing part_of(const Packing& packing, const std::vector<std::size_t>& rows) {
  Packing part = packing;
  for (auto values :
       {&Packing::x, &Packing::y, &Packing::angle, &Packing::curvature, &Packing::area})
    part.*values = at_rows(packing.*values, rows);
  part.elongated = at_rows(packing.elongated, rows);
  return part;
}

SpatialPacking part_of(const SpatialPacking& packing, const std::vector<std::size_t>& rows) {
  SpatialPacking part = packing;
  part.centre = at_rows(packing.centre, rows);
  part.axis = at_rows(packing.axis, rows);
  part.elongated = at_rows(packing.elongated, rows);
  return part;
}

// Shares of what lies below the surface. `content`: area or volume of each particle.
std::vector<SpeciesMeasures> shares(const Mixture& mixture, const std::vector<double>& height,
                                    double surface, const std::vector<double>& content) {
  std::vector<SpeciesMeasures> measures(mixture.species.size());
  double number = 0, all = 0;
  for (std::size_t i = 0; i < height.size(); ++i) {
    if (!(height[i] < surface)) continue;
    measures[mixture.of[i]].number_share += 1;
    measures[mixture.of[i]].solid_share += content[i];
    number += 1;
    all += content[i];
  }
  for (auto& each : measures) {
    each.number_share = number > 0 ? each.number_share / number : 0;
    each.solid_share = all > 0 ? each.solid_share / all : 0;
  }
  return measures;
}

}  // namespace

std::vector<SpeciesMeasures> measure_species(const Packing& packing, const Mixture& mixture) {
  auto measures = shares(mixture, packing.y, packing.surface, packing.area);
  for (std::size_t kind = 0; kind < measures.size(); ++kind) try {
      OrientationSample sample;
      sample.add(part_of(packing, mixture.rows_of(kind)));
      const auto result = sample.distribution();
      measures[kind].oriented = result.particles;
      if (result.particles < 2) continue;
      measures[kind].order = result.nematic.order;
      measures[kind].order_error = result.nematic.standard_error;
      measures[kind].director = result.nematic.director;
    } catch (const TooFewParticles&) {
      continue;  // spheres, or all of them are close to walls
    }
  return measures;
}

std::vector<SpeciesMeasures> measure_species(const SpatialPacking& packing, const Frame& bodies,
                                             const Mixture& mixture) {
  std::vector<double> height;
  for (const auto& centre : packing.centre) height.push_back(centre[packing.walls.vertical]);
  auto measures = shares(mixture, height, packing.surface, body_volumes(bodies));
  for (std::size_t kind = 0; kind < measures.size(); ++kind) try {
      SpatialOrientationSample sample;
      sample.add(part_of(packing, mixture.rows_of(kind)));
      const auto result = sample.result();
      measures[kind].oriented = result.order.number;
      measures[kind].order = result.order.value[0];
      measures[kind].order_error = result.order.standard_error[0];
      measures[kind].director = direction_angles(result.order.direction[0], result.vertical).polar;
    } catch (const TooFewParticles&) {
      continue;
    }
  return measures;
}

std::vector<std::vector<double>> coordination_by_species(const Frame& contacts, const Frame& bodies,
                                                         const Mixture& mixture) {
  const auto& id = bodies.column("id");
  std::map<double, std::size_t> kind_of;
  for (std::size_t row = 0; row < bodies.rows; ++row) kind_of[id[row]] = mixture.of[row];
  const auto& body_i = contacts.column("body_i");
  const auto& body_j = contacts.column("body_j");
  const auto& wall = contacts.column("wall");
  const auto kind = [&](double body) {
    const auto found = kind_of.find(body);
    if (found == kind_of.end())
      throw DataError(bodies.file + ": no particle " + number_text(body) +
                      ", which has a contact in " + contacts.file);
    return found->second;
  };
  std::set<std::pair<double, double>> touching;
  for (std::size_t row = 0; row < contacts.rows; ++row)
    if (wall[row] == 0) touching.insert(std::minmax(body_i[row], body_j[row]));
  const auto kinds = mixture.species.size();
  std::vector<std::vector<double>> number(kinds, std::vector<double>(kinds, 0));
  for (const auto& [i, j] : touching) {
    number[kind(i)][kind(j)] += 1;
    number[kind(j)][kind(i)] += 1;
  }
  for (std::size_t a = 0; a < kinds; ++a)
    for (auto& each : number[a]) each /= static_cast<double>(mixture.species[a].number);
  return number;
}

void write_mixture_table(const Mixture& mixture, const std::vector<SpeciesMeasures>& measures,
                         const std::vector<std::vector<double>>& coordination,
                         const std::string& file) {
  std::vector<std::string> head{
      "species",       "type",         "particles",   "diameter_m",       "aspect_ratio",
      "curvature_deg", "number_share", "solid_share", "nematic_order_S2", "nematic_order_S2_error",
      "director_deg"};
  if (!coordination.empty())
    for (const auto& each : mixture.species) head.push_back("touching_" + each.name);
  std::string text = csv_line(head) + "\n";
  for (std::size_t kind = 0; kind < mixture.species.size(); ++kind) {
    const auto& species = mixture.species[kind];
    std::vector<std::string> row{species.name,
                                 std::to_string(species.type),
                                 std::to_string(species.number),
                                 number_text(species.diameter),
                                 number_text(species.aspect_ratio),
                                 number_text(species.curvature / degree)};
    if (measures.empty()) {
      row.resize(row.size() + 5);
    } else {
      const auto& measure = measures[kind];
      for (const auto& each :
           {std::optional(measure.number_share), std::optional(measure.solid_share), measure.order,
            measure.order_error, measure.director})
        row.push_back(csv_number(each));
    }
    if (!coordination.empty())
      for (const double each : coordination[kind]) row.push_back(number_text(each));
    text += csv_line(row) + "\n";
  }
  write_text(file, text);
}

}  // namespace rodpack

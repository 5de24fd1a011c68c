// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/fields/section.h"

#include <algorithm>
#include <cmath>

#include "reading/angles.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"

namespace rodpack {
namespace {

std::string section_axis(std::size_t axis) { return std::string(1, "xyz"[axis]); }

// Weight of a place in the mean of a field over a ring: what is per mass, or per particle, counts
// with these.
const std::vector<double>* weights_of(const std::string& field, const std::vector<Field>& fields) {
  const bool per_mass = field == "velocity";
  const bool per_particle = field == "coordination_number" || field == "contacts_per_particle";
  if (!per_mass && !per_particle) return nullptr;
  const std::string weight = per_mass ? "mass_density" : "number_density";
  for (const auto& each : fields)
    if (each.name == weight) return each.values.data();
  return nullptr;
}

using Basis = std::array<Vector3, 3>;  // r, t, v

// A field at one place, in that basis.
std::vector<double> turned(const Field& field, std::size_t place, const Basis& basis) {
  const auto value = [&](std::size_t c) { return field.values[c][place]; };
  const std::size_t components = field.values.size();
  if (components == 1) return {value(0)};
  std::vector<double> result(components, 0);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t i = 0; i < 3; ++i) {
      if (components == 3) {
        result[a] += basis[a][i] * value(i);
        continue;
      }
      for (std::size_t b = 0; b < 3; ++b)
        for (std::size_t j = 0; j < 3; ++j)
          result[3 * a + b] += basis[a][i] * value(3 * i + j) * basis[b][j];
    }
  return result;
}

Field without_values(const Field& field, std::size_t places) {
  Field result{field.name, field.unit, field.components, {}};
  if (field.components.size() == 3) result.components = {"r", "t", "v"};
  if (field.components.size() == 9)
    result.components = {"rr", "rt", "rv", "tr", "tt", "tv", "vr", "vt", "vv"};
  result.values.assign(field.values.size(), std::vector<double>(places, 0));
  return result;
}

}  // namespace

std::string Slice::name() const { return section_axis(axis) + "_" + number_text(at); }

Vector3 section_origin(const SpatialWalls& walls) {
  Vector3 origin = walls.low;
  if (walls.round)
    for (const std::size_t which : {0U, 1U}) origin[walls.horizontal(which)] = walls.middle[which];
  return origin;
}

Section slice_section(const Slice& slice, const SpatialWalls& walls, const CoarseGraining& averages,
                      const std::vector<Field>& fields) {
  const auto up = walls.vertical;
  const bool level = slice.axis == up;
  const std::size_t v = level ? walls.horizontal(1) : up;
  const std::size_t u = 3 - slice.axis - v;
  const Grid& grid = *averages.grid();
  const std::array<std::size_t, 3> step{
      1, static_cast<std::size_t>(grid.count[0]),
      static_cast<std::size_t>(grid.count[0]) * static_cast<std::size_t>(grid.count[1])};
  const auto origin = section_origin(walls);
  Section section;
  section.count = {static_cast<std::size_t>(grid.count[u]),
                   static_cast<std::size_t>(grid.count[v])};
  section.spacing = {grid.spacing[u], grid.spacing[v]};
  section.name = {section_axis(u), section_axis(v)};
  section.component = {u, v};
  section.where = section_axis(slice.axis);
  section.at = slice.at - origin[slice.axis];
  std::vector<std::size_t> index;
  for (std::size_t j = 0; j < section.count[1]; ++j)
    for (std::size_t i = 0; i < section.count[0]; ++i) {
      index.push_back(i * step[u] + j * step[v]);
      section.place.push_back(grid.place(index.back()));
      section.u.push_back(section.place.back()[u] - origin[u]);
      section.v.push_back(section.place.back()[v] - origin[v]);
    }
  for (const auto& field : fields) {
    section.fields.push_back(field);
    for (auto& values : section.fields.back().values) {
      const auto on_grid = values;
      for (std::size_t k = 0; k < index.size(); ++k) values[k] = on_grid[index[k]];
    }
  }
  return section;
}

Rings::Rings(const SpatialWalls& walls, double top, double spacing, double arc) : walls_(walls) {
  const auto up = walls.vertical, first = walls.horizontal(0), second = walls.horizontal(1);
  const double height = top - walls.low[up];
  const auto pieces = [&](double length) {
    return static_cast<std::size_t>(std::max(1.0, std::round(length / spacing)));
  };
  count_ = {pieces(walls.radius) + 1, pieces(height) + 1};
  spacing_ = {walls.radius / static_cast<double>(count_[0] - 1),
              height / static_cast<double>(count_[1] - 1)};
  for (std::size_t j = 0; j < count_[1]; ++j)
    for (std::size_t i = 0; i < count_[0]; ++i) {
      const double radius = static_cast<double>(i) * spacing_[0];
      const double around = std::max(16.0, std::ceil(2 * pi * radius / arc));
      for (double k = 0; k < around; ++k) {
        const double azimuth = 2 * pi * k / around;
        Vector place{};
        place[up] = walls.low[up] + static_cast<double>(j) * spacing_[1];
        place[first] = walls.middle[0] + radius * std::cos(azimuth);
        place[second] = walls.middle[1] + radius * std::sin(azimuth);
        places_.push_back(place);
        azimuth_.push_back(azimuth);
        ring_.push_back(i + j * count_[0]);
      }
    }
}

Section Rings::means(const std::vector<Field>& fields) const {
  const auto up = walls_.vertical, first = walls_.horizontal(0), second = walls_.horizontal(1);
  Section section;
  section.count = count_;
  section.spacing = spacing_;
  section.name = {"r", section_axis(up)};
  section.component = {0, 2};
  const std::size_t rings = count_[0] * count_[1];
  for (std::size_t ring = 0; ring < rings; ++ring) {
    section.u.push_back(static_cast<double>(ring % count_[0]) * spacing_[0]);
    section.v.push_back(static_cast<double>(ring / count_[0]) * spacing_[1]);
    Vector3 place{};
    place[up] = walls_.low[up] + section.v.back();
    place[first] = walls_.middle[0] + section.u.back();
    place[second] = walls_.middle[1];
    section.place.push_back(place);
  }
  for (const auto& field : fields) {
    auto mean = without_values(field, rings);
    const auto* weights = weights_of(field.name, fields);
    std::vector<double> total(rings, 0);
    for (std::size_t p = 0; p < places_.size(); ++p) {
      Basis basis{};
      basis[0][first] = basis[1][second] = std::cos(azimuth_[p]);
      basis[0][second] = std::sin(azimuth_[p]);
      basis[1][first] = -std::sin(azimuth_[p]);
      basis[2][up] = 1;
      const double weight = weights ? (*weights)[p] : 1;
      total[ring_[p]] += weight;
      const auto values = turned(field, p, basis);
      for (std::size_t c = 0; c < values.size(); ++c)
        mean.values[c][ring_[p]] += weight * values[c];
    }
    for (auto& values : mean.values)
      for (std::size_t ring = 0; ring < rings; ++ring)
        if (total[ring] > 0) values[ring] /= total[ring];
    section.fields.push_back(mean);
  }
  return section;
}

void write_section_table(const Section& section, double particle_diameter,
                         const std::string& file) {
  std::vector<std::pair<std::string, std::vector<double>>> columns;
  for (const auto* coordinate : {&section.u, &section.v}) {
    columns.push_back({section.name[columns.size()] + "_over_dp", *coordinate});
    for (double& value : columns.back().second) value /= particle_diameter;
  }
  for (const auto& field : section.fields)
    for (std::size_t c = 0; c < field.values.size(); ++c)
      columns.push_back({field.column(c), field.values[c]});
  write_csv(file, columns);
}

}  // namespace rodpack

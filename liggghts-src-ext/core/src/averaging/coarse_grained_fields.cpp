// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "rodpack/averaging/coarse_graining.h"

namespace rodpack {

namespace {

const char axes[] = "xyz";

std::vector<std::string> vector_components(int dimension) {
  std::vector<std::string> names;
  for (int a = 0; a < dimension; ++a) names.push_back({axes[a]});
  return names;
}

std::vector<std::string> tensor_components(int first, int dimension) {
  std::vector<std::string> names;
  for (int a = first; a < (first == 2 ? 3 : dimension); ++a)
    for (int b = 0; b < dimension; ++b) names.push_back({axes[a], axes[b]});
  return names;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

Vector Grid::place(std::size_t index) const {
  const auto nx = static_cast<std::size_t>(count[0]), ny = static_cast<std::size_t>(count[1]);
  return {{origin[0] + static_cast<double>(index % nx) * spacing[0],
           origin[1] + static_cast<double>(index / nx % ny) * spacing[1],
           origin[2] + static_cast<double>(index / nx / ny) * spacing[2]}};
}

Grid filling_grid(int dimension, const Vector& low, const Vector& high, double spacing) {
  if (!(spacing > 0))
    throw std::invalid_argument("grid spacing is " + number_text(spacing) +
                                " m, expected a length > 0");
  Grid grid;
  double places = 1;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
    const double length = high[d] - low[d];
    if (!(length > 0))
      throw std::invalid_argument(std::string("grid is empty: ") + axes[d] + " from " +
                                  number_text(low[d]) + " to " + number_text(high[d]) + " m");
    const double steps = std::max(1.0, std::round(length / spacing));
    places *= steps + 1;
    if (places > 1e8)
      throw std::invalid_argument("grid spacing is " + number_text(spacing) +
                                  " m: more than 1e8 places");
    grid.origin[d] = low[d];
    grid.count[d] = static_cast<int>(steps) + 1;
    grid.spacing[d] = length / steps;
  }
  return grid;
}

std::string Field::column(std::size_t component) const {
  std::string text = name;
  for (const std::string& part : {components.at(component), unit})
    if (!part.empty()) text += "_" + part;
  return text;
}

std::vector<Field> CoarseGraining::fields(double frames) const {
  const bool planar = dimension_ == 2;
  const auto D = static_cast<std::size_t>(dimension_);
  const std::size_t products = 5 + D;  // m v_a v_b, upper triangle
  const auto sum = [&](std::size_t k) {
    std::vector<double> plane(sums_.begin() + static_cast<std::ptrdiff_t>(k * places_),
                              sums_.begin() + static_cast<std::ptrdiff_t>((k + 1) * places_));
    for (double& value : plane) value /= frames;
    return plane;
  };
  const auto sums_from = [&](std::size_t first, std::size_t count) {
    std::vector<std::vector<double>> planes;
    for (std::size_t k = 0; k < count; ++k) planes.push_back(sum(first + k));
    return planes;
  };
  const auto ratio = [&](const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> plane(places_, 0.0);
    for (std::size_t i = 0; i < places_; ++i)
      if (below[i] > 0) plane[i] = above[i] / below[i];
    return plane;
  };

  const auto scalar = std::vector<std::string>{""};
  const auto vector = vector_components(dimension_);
  const auto tensor = tensor_components(0, dimension_);
  std::vector<Field> fields;
  fields.push_back({"number_density", planar ? "1_m2" : "1_m3", scalar, {sum(0)}});
  const auto mass_density = sum(1);
  fields.push_back({"mass_density", planar ? "kg_m2" : "kg_m3", scalar, {mass_density}});
  fields.push_back({"solid_fraction", "", scalar, {sum(2)}});
  const auto momentum = sums_from(5, D);
  fields.push_back({"momentum_density", planar ? "kg_m_s" : "kg_m2_s", vector, momentum});
  std::vector<std::vector<double>> velocity;
  for (const auto& component : momentum) velocity.push_back(ratio(component, mass_density));
  fields.push_back({"velocity", "m_s", vector, velocity});

  const char* const stress_unit = planar ? "N_m" : "N_m2";
  fields.push_back({"contact_stress", stress_unit, tensor, sums_from(particle_sums_, D * D)});
  std::vector<std::vector<double>> kinetic(D * D);
  std::size_t product = products;
  for (std::size_t a = 0; a < D; ++a)
    for (std::size_t b = a; b < D; ++b) {
      auto plane = sum(product++);
      for (std::size_t i = 0; i < places_; ++i) plane[i] -= momentum[a][i] * velocity[b][i];
      kinetic[a * D + b] = kinetic[b * D + a] = plane;
    }
  fields.push_back({"kinetic_stress", stress_unit, tensor, kinetic});
  fields.push_back({"boundary_force_density", planar ? "N_m2" : "N_m3", vector,
                    sums_from(particle_sums_ + line_sums_, D)});
  fields.push_back({"coordination_number", "", scalar, {ratio(sum(3), sum(0))}});
  fields.push_back({"contacts_per_particle", "", scalar, {ratio(sum(4), sum(0))}});
  if (options_.couple_stress)
    fields.push_back({"couple_stress", planar ? "N" : "N_m",
                      tensor_components(planar ? 2 : 0, dimension_),
                      sums_from(particle_sums_ + D * D, line_sums_ - D * D)});
  return fields;
}

std::string csv_text(const CoarseGraining& averages, const std::vector<Field>& fields) {
  const auto D = static_cast<std::size_t>(averages.kernel().dimension());
  std::string text;
  for (std::size_t d = 0; d < D; ++d) text += (d ? "," : "") + std::string(1, axes[d]) + "_m";
  for (const Field& field : fields)
    for (std::size_t c = 0; c < field.components.size(); ++c) text += "," + field.column(c);
  char number[32];
  for (std::size_t i = 0; i < averages.places(); ++i) {
    const Vector place = averages.place(i);
    for (std::size_t d = 0; d < D; ++d) {
      std::snprintf(number, sizeof number, d ? ",%.15g" : "\n%.15g", place[d]);
      text += number;
    }
    for (const Field& field : fields)
      for (const auto& values : field.values) {
        std::snprintf(number, sizeof number, ",%.15g", values[i]);
        text += number;
      }
  }
  return text + "\n";
}

}  // namespace rodpack

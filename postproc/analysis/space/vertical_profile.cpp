// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/space/vertical_profile.h"

#include <cmath>
#include <limits>

#include "analysis/space/body_volumes.h"
#include "analysis/space/fields/spatial_fields.h"
#include "analysis/stock/stock_dumps.h"
#include "reading/angles.h"
#include "reading/checks/contacts_of_bodies.h"
#include "reading/csv_file.h"
#include "reading/number_text.h"
#include "rodpack/averaging/averaging_kernel.h"

namespace rodpack {
namespace {

double cross_section(const SpatialWalls& walls) {
  if (walls.round) return pi * walls.radius * walls.radius;
  const auto first = walls.horizontal(0), second = walls.horizontal(1);
  return (walls.high[first] - walls.low[first]) * (walls.high[second] - walls.low[second]);
}

// All but the depths, for what is done to every one of them.
std::array<std::vector<double>*, 7> columns_of(VerticalProfile& profile) {
  return {&profile.solid_fraction, &profile.density,  &profile.vertical,  &profile.horizontal[0],
          &profile.horizontal[1],  &profile.pressure, &profile.wall_force};
}

}  // namespace

void VerticalProfileSample::start(const SpatialPacking& packing) {
  walls_ = packing.walls;
  surface_ = packing.surface;
  if (walls_.periodic[walls_.vertical])
    throw DataError("profile: expected a floor, found a periodic vertical");
  const double height = surface_ - walls_.low[walls_.vertical];
  if (!(height > 0)) throw TooFewParticles("profile: there is no bed above the floor");
  sums_.axis = walls_.vertical;
  sums_.particle_diameter = packing.particle_diameter;
  sums_.scale = averaging_scale(packing, options_);
  sums_.depth_of_floor = height;
  sums_.cross_section = cross_section(walls_);
  const double pieces = std::ceil(height / options_.spacing.value_or(sums_.scale / 4) - 1e-9);
  constexpr double most = 1e5;
  if (!(pieces < most))
    throw DataError("spacing: expected at most " + number_text(most) +
                    " places from floor to surface, found " + number_text(pieces));
  const auto count = static_cast<std::size_t>(std::max(pieces, 1.0));
  for (std::size_t k = 0; k <= count; ++k)
    sums_.depth.push_back(height * static_cast<double>(k) / static_cast<double>(count));
  for (auto* column : columns_of(sums_)) column->assign(count + 1, 0);
}

void VerticalProfileSample::add(const SpatialPacking& packing, const Frame& bodies,
                                const Frame* contacts) {
  require_motion(bodies);
  const auto volumes = body_volumes(bodies);
  const auto& mass = bodies.column("mass");
  std::vector<Interaction> interactions;
  if (contacts) {
    require_contacts_of_bodies(*contacts, bodies);
    interactions = sum_pairs(read_contacts(*contacts)).interactions;
  }
  if (frames_ == 0) start(packing);
  ++frames_;
  const auto up = walls_.vertical, first = walls_.horizontal(0), second = walls_.horizontal(1);
  const double w = sums_.scale, area = sums_.cross_section;
  for (std::size_t k = 0; k < sums_.depth.size(); ++k) {
    const double z = surface_ - sums_.depth[k];
    for (std::size_t i = 0; i < packing.size(); ++i) {
      const double weight = gaussian(z - packing.centre[i][up], w) / area;
      sums_.solid_fraction[k] += volumes[i] * weight;
      sums_.density[k] += mass[i] * weight;
    }
    for (const auto& each : interactions) {
      const double from = z - each.from[up], rise = each.branch[up];
      const double weight = gaussian_along(from, rise, w) / area;
      sums_.vertical[k] -= each.force[up] * rise * weight;
      sums_.horizontal[0][k] -= each.force[first] * each.branch[first] * weight;
      sums_.horizontal[1][k] -= each.force[second] * each.branch[second] * weight;
      if (each.wall) sums_.wall_force[k] += each.force[up] * gaussian(from - rise, w) / area;
    }
  }
}

VerticalProfile VerticalProfileSample::result() const {
  if (frames_ == 0) throw TooFewParticles("profile: no frame to average");
  VerticalProfile profile = sums_;
  constexpr double endless = std::numeric_limits<double>::infinity();
  const double floor = walls_.low[walls_.vertical];
  const double top =
      options_.normalisation == Normalisation::walls_and_surface ? surface_ : endless;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    const double z = surface_ - profile.depth[k];
    const double share = options_.normalisation == Normalisation::none
                             ? 1
                             : gaussian_integral(z - top, z - floor, profile.scale);
    for (auto* column : columns_of(profile)) (*column)[k] /= frames_ * share;
    profile.pressure[k] =
        (profile.vertical[k] + profile.horizontal[0][k] + profile.horizontal[1][k]) / 3;
  }
  return profile;
}

std::optional<double> mean_solid_fraction(const VerticalProfile& profile) {
  const double edge = 3 * profile.scale * (1 - 1e-9);
  double sum = 0;
  int places = 0;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    if (profile.depth[k] < edge || profile.depth_of_floor - profile.depth[k] < edge) continue;
    sum += profile.solid_fraction[k];
    ++places;
  }
  if (places < 2) return std::nullopt;
  return sum / places;
}

JanssenFit fit_janssen(const VerticalProfile& profile) {
  PressureProfile plane;
  plane.particle_diameter = profile.particle_diameter;
  plane.scale = profile.scale;
  plane.depth_of_floor = profile.depth_of_floor;
  plane.depth = profile.depth;
  plane.pressure = profile.vertical;
  return fit_janssen(plane);
}

void write_vertical_profile_table(const VerticalProfile& profile, const std::string& file) {
  std::vector<double> depth;
  for (const double each : profile.depth) depth.push_back(each / profile.particle_diameter);
  write_csv(file, {{"h_over_dp", depth},
                   {"solid_fraction", profile.solid_fraction},
                   {"density_kg_m3", profile.density},
                   {"stress_vertical_N_m2", profile.vertical},
                   {"stress_horizontal_1_N_m2", profile.horizontal[0]},
                   {"stress_horizontal_2_N_m2", profile.horizontal[1]},
                   {"pressure_N_m2", profile.pressure},
                   {"wall_force_N_m3", profile.wall_force}});
}

void write_layer_table(const VerticalProfile& profile, const std::string& file) {
  std::vector<double> height, solid_fraction, density;
  for (std::size_t k = profile.depth.size(); k-- > 0;) {
    height.push_back((profile.depth_of_floor - profile.depth[k]) / profile.particle_diameter);
    solid_fraction.push_back(profile.solid_fraction[k]);
    density.push_back(profile.density[k]);
  }
  write_csv(
      file,
      {{"height_over_dp", height}, {"solid_fraction", solid_fraction}, {"density_kg_m3", density}});
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pressure_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/edges/undisturbed.h"
#include "reading/csv_file.h"
#include "rodpack/averaging/kernel_share.h"

namespace rodpack {
namespace {
constexpr int slice_columns = 8;  // midpoints across a slice of 2 AR d_p, far closer than w

// The columns of a packing's slice: their number and the width of one, m. A periodic bed has no
// middle: its slice is the whole period.
std::pair<int, double> columns_of_slice(const Packing& packing, double scale) {
  const double width = 2 * packing.axial_length();
  if (packing.walls.sides) return {slice_columns, width / slice_columns};
  const double period = packing.walls.width();
  const double most = std::min(width / slice_columns, scale / 4);
  const int count = static_cast<int>(std::ceil(period / most - 1e-9));
  return {count, period / count};
}
}  // namespace

void ProfileSample::add(const Packing& packing, const Frame& bodies, const Frame& contacts) {
  if (!averages_) {
    packing_ = packing;
    const auto& walls = packing.walls;
    const double height = packing.surface - walls.floor;
    if (!walls.bottom) throw TooFewParticles("profile: expected a floor, found y periodic");
    if (!(height > 0)) throw TooFewParticles("profile: there is no bed above the floor");
    const double scale = averaging_scale(packing, options_);
    const auto [columns, column] = columns_of_slice(packing, scale);
    const double width = columns * column;
    const double left = (walls.left + walls.right - width + column) / 2;
    Grid grid =
        filling_grid(2, {{left, walls.floor, 0}}, {{left + width - column, packing.surface, 0}},
                     options_.spacing.value_or(scale / 4));
    grid.count[0] = columns;
    grid.spacing[0] = column;
    averages_ =
        std::make_unique<CoarseGraining>(averaging_kernel(packing, options_), checked_grid(grid),
                                         averaging_options(packing, options_));
  }
  add_frame(*averages_, bodies, &contacts);
  ++frames_;
}

PressureProfile ProfileSample::result() const {
  if (!averages_) throw TooFewParticles("profile: no frame to average");
  auto fields = averages_->fields(frames_);
  if (options_.normalisation != Normalisation::none)
    normalise_by_share(*averages_, counted_space(packing_, options_.normalisation), fields);
  const Grid& grid = *averages_->grid();
  const auto rows = static_cast<std::size_t>(grid.count[1]);
  const auto columns = static_cast<std::size_t>(grid.count[0]);
  // From the top down, the mean over the slice.
  const auto mean = [&](const std::vector<double>& values) {
    std::vector<double> result;
    for (std::size_t row = rows; row-- > 0;) {
      double sum = 0;
      for (std::size_t i = 0; i < columns; ++i) sum += values[row * columns + i];
      result.push_back(sum / static_cast<double>(columns));
    }
    return result;
  };
  PressureProfile profile;
  profile.particle_diameter = packing_.particle_diameter;
  profile.scale = averages_->kernel().scale();
  profile.depth_of_floor = packing_.surface - packing_.walls.floor;
  profile.reach = kernel_reach(averages_->kernel());
  profile.inclination = packing_.inclination;
  profile.walls_divided_out = options_.normalisation == Normalisation::walls;
  const auto heights = undisturbed_heights(packing_, profile.reach, options_.normalisation);
  profile.undisturbed = {packing_.surface - heights[1], packing_.surface - heights[0]};
  for (std::size_t row = rows; row-- > 0;)
    profile.depth.push_back(packing_.surface - grid.place(row * columns)[1]);
  const auto& stress = field_named(fields, "contact_stress").values;
  profile.xx = mean(stress[0]);
  profile.xy = mean(stress[1]);
  profile.yx = mean(stress[2]);
  profile.yy = mean(stress[3]);
  profile.solid_fraction = mean(field_named(fields, "solid_fraction").values[0]);
  for (std::size_t k = 0; k < rows; ++k) {
    profile.principal.push_back(
        principal_stress(profile.xx[k], profile.xy[k], profile.yx[k], profile.yy[k]));
    profile.pressure.push_back(0.5 * (profile.xx[k] + profile.yy[k]));
  }
  return profile;
}

void write_profile_table(const PressureProfile& profile, const std::string& file) {
  std::vector<double> depth, larger, smaller, direction, anisotropies;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    const auto& principal = profile.principal[k];
    depth.push_back(profile.depth[k] / profile.particle_diameter);
    larger.push_back(principal.larger);
    smaller.push_back(principal.smaller);
    direction.push_back(principal.direction);
    anisotropies.push_back(anisotropy(principal));
  }
  write_csv(file, {{"h_over_dp", depth},
                   {"pressure_N_m", profile.pressure},
                   {"stress_xx_N_m", profile.xx},
                   {"stress_xy_N_m", profile.xy},
                   {"stress_yx_N_m", profile.yx},
                   {"stress_yy_N_m", profile.yy},
                   {"sigma_1_N_m", larger},
                   {"sigma_2_N_m", smaller},
                   {"sigma_1_direction_deg", direction},
                   {"anisotropy", anisotropies},
                   {"solid_fraction", profile.solid_fraction}});
}

PressureProfile mean_profile(const std::vector<double>& depth_over_dp,
                             const std::vector<std::optional<double>>& pressure,
                             double particle_diameter, double omega) {
  PressureProfile profile;
  profile.particle_diameter = particle_diameter;
  profile.scale = omega;
  profile.depth_of_floor = depth_over_dp.back() * particle_diameter;
  for (std::size_t k = 0; k < depth_over_dp.size(); ++k) {
    if (!pressure[k] || !std::isfinite(*pressure[k])) continue;
    profile.depth.push_back(depth_over_dp[k] * particle_diameter);
    profile.pressure.push_back(*pressure[k]);
  }
  return profile;
}

}  // namespace rodpack

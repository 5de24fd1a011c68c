// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/pressure_profile.h"

#include <algorithm>
#include <cmath>

#include "figures/figure.h"
#include "reading/text.h"

namespace rodpack {
namespace {
constexpr int slice_columns = 8;  // midpoints across the slice, far closer than w
}

void ProfileSample::add(const Packing& packing, const Frame& bodies, const Frame& contacts) {
  if (!averages_) {
    packing_ = packing;
    const auto& walls = packing.walls;
    const double height = packing.surface - walls.floor;
    if (!(height > 0)) throw TooFewParticles("profile: there is no bed above the floor");
    const double width = 2 * packing.axial_length();
    const double column = width / slice_columns;
    const double left = (walls.left + walls.right - width + column) / 2;
    Grid grid =
        filling_grid(2, {{left, walls.floor, 0}}, {{left + width - column, packing.surface, 0}},
                     options_.spacing.value_or(averaging_scale(packing, options_) / 4));
    grid.count[0] = slice_columns;
    grid.spacing[0] = column;
    averages_ = std::make_unique<CoarseGraining>(averaging_kernel(packing, options_), grid,
                                                 averaging_options(packing, options_));
  }
  add_frame(*averages_, bodies, &contacts);
  ++frames_;
}

PressureProfile ProfileSample::result() const {
  if (!averages_) throw TooFewParticles("profile: no frame to average");
  const auto fields = averages_->fields(frames_);
  const Grid& grid = *averages_->grid();
  const auto rows = static_cast<std::size_t>(grid.count[1]);
  // From the top down, the mean over the slice.
  const auto mean = [&](const std::vector<double>& values) {
    std::vector<double> result;
    for (std::size_t row = rows; row-- > 0;) {
      double sum = 0;
      for (std::size_t i = 0; i < slice_columns; ++i) sum += values[row * slice_columns + i];
      result.push_back(sum / slice_columns);
    }
    return result;
  };
  PressureProfile profile;
  profile.particle_diameter = packing_.particle_diameter;
  profile.scale = averages_->kernel().scale();
  profile.depth_of_floor = packing_.surface - packing_.walls.floor;
  for (std::size_t row = rows; row-- > 0;)
    profile.depth.push_back(packing_.surface - grid.place(row * slice_columns)[1]);
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
  std::vector<double> depth, larger, smaller, direction, anisotropy;
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    const auto& principal = profile.principal[k];
    depth.push_back(profile.depth[k] / profile.particle_diameter);
    larger.push_back(principal.larger);
    smaller.push_back(principal.smaller);
    direction.push_back(principal.direction);
    const double sum = principal.larger + principal.smaller;
    anisotropy.push_back(sum > 0 ? (principal.larger - principal.smaller) / sum : 0);
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
                   {"anisotropy", anisotropy},
                   {"solid_fraction", profile.solid_fraction}});
}

void plot_profile(const PressureProfile& profile, const JanssenFit* fit, const std::string& stem) {
  const double d = profile.particle_diameter;
  std::vector<double> depth, pressure, vertical, horizontal;
  const double top = *std::max_element(profile.yy.begin(), profile.yy.end());
  const auto unit = scaled_unit(top, "N/m");
  for (std::size_t k = 0; k < profile.depth.size(); ++k) {
    depth.push_back(profile.depth[k] / d);
    pressure.push_back(profile.pressure[k] * unit.factor);
    vertical.push_back(profile.yy[k] * unit.factor);
    horizontal.push_back(profile.xx[k] * unit.factor);
  }
  std::string law;
  if (fit)
    law = ", [" + number_text(fit->from / d) + ":" + number_text(fit->to / d) + "] " +
          number_text(fit->pressure * unit.factor) + "*(1-exp(-x/" + number_text(fit->depth / d) +
          ")) with lines dashtype 2 linewidth 1.4 linecolor '#000000' title '" +
          (fit->saturates ? "Janssen" : "Janssen (not saturating)") + "'";
  draw_figure(stem, 1.4,
              datablock("p", {depth, pressure, vertical, horizontal}) +
                  "set xlabel 'depth {/:Italic h} / {/:Italic d}_p'\n"
                  "set ylabel 'stress (" +
                  unit.name +
                  ")'\n"
                  "set key top left Left reverse\nset autoscale xfix\nset yrange [0:*]\n"
                  "set samples 300\n"
                  "plot $p using 1:2 with lines linewidth 1.8 linecolor '" +
                  colour::blue +
                  "' title '{/:Italic P}_0', $p using 1:3 with lines linewidth 1.2 linecolor '" +
                  colour::vermilion +
                  "' title '{/:Italic σ}_{yy}', $p using 1:4 with lines linewidth 1.2 linecolor '" +
                  colour::grey + "' title '{/:Italic σ}_{xx}'" + law + "\n");
}

std::string describe(const JanssenFit& fit, double particle_diameter) {
  if (!fit.saturates)
    return "the pressure does not saturate within the bed: h_c = " +
           number_text(fit.depth / particle_diameter, 3) + " d_p is beyond the fitted depth of " +
           number_text(fit.to / particle_diameter, 3) + " d_p";
  return "Janssen: P_j = " + number_text(fit.pressure, 4) + " +- " +
         number_text(fit.pressure_error, 2) +
         " N/m, h_c = " + number_text(fit.depth / particle_diameter, 4) + " +- " +
         number_text(fit.depth_error / particle_diameter, 2) + " d_p, rms residual " +
         number_text(fit.rms_residual, 2) + " N/m";
}

}  // namespace rodpack

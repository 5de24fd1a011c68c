// SPDX-License-Identifier: GPL-2.0-or-later
#include "analysis/incline/chute_profile.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/fields.h"
#include "analysis/line_fit.h"
#include "reading/angles.h"
#include "reading/checks/contacts_of_bodies.h"
#include "reading/checks/planar.h"
#include "reading/csv_file.h"
#include "rodpack/averaging/averaging_kernel.h"

namespace rodpack {
namespace {

constexpr int per_scale = 4;  // heights per w

// Of the Gaussian, what lies above `y` when its centre is at `centre`.
double share_above(double y, double centre, double scale) {
  return 0.5 * std::erfc((y - centre) / (std::sqrt(2.0) * scale));
}

// Indices of the heights where the kernel reaches neither base nor surface.
std::vector<std::size_t> inner_heights(const ChuteProfile& profile) {
  const double reach = 3 * profile.scale * (1 - 1e-9);
  std::vector<std::size_t> inner;
  for (std::size_t k = 0; k < profile.height.size(); ++k)
    if (profile.height[k] >= reach && profile.surface - profile.height[k] >= reach)
      inner.push_back(k);
  return inner;
}

}  // namespace

ChuteSample::ChuteSample(const Slope& slope, std::optional<double> scale)
    : slope_(slope), scale_(scale) {}

void ChuteSample::start(const Packing& packing) {
  sums_.slope = slope_;
  sums_.particle_diameter = packing.particle_diameter;
  sums_.scale =
      scale_.value_or(packing.particle_diameter * std::max(1.0, packing.aspect_ratio / 2));
  width_ = packing.walls.width();
  const double top = std::max(packing.surface, packing.walls.floor) + 5 * sums_.scale;
  const double low = packing.walls.floor;
  const double spacing = sums_.scale / per_scale;
  for (double y = low; y <= top; y = low + static_cast<double>(sums_.height.size()) * spacing)
    sums_.height.push_back(y);
  for (auto* column : {&sums_.solid_fraction, &sums_.density, &sums_.xx, &sums_.xy, &sums_.yx,
                       &sums_.yy, &sums_.load_onto, &sums_.load_down, &momentum_[0], &momentum_[1],
                       &density_slope_, &momentum_slope_, &flux_xx_, &flux_xy_, &flux_yy_})
    column->assign(sums_.height.size(), 0);
}

void ChuteSample::add_bodies(const Frame& bodies) {
  const auto &y = bodies.column("y"), &mass = bodies.column("mass"), &area = bodies.column("area");
  const auto &vx = bodies.column("vx"), &vy = bodies.column("vy");
  const double w = sums_.scale;
  const double onto = slope_.gravity * std::cos(slope_.angle);
  const double down = slope_.gravity * std::sin(slope_.angle);
  for (std::size_t k = 0; k < sums_.height.size(); ++k)
    for (std::size_t i = 0; i < bodies.rows; ++i) {
      const double off = sums_.height[k] - y[i];
      const double weight = gaussian(off, w) / width_, m = mass[i] * weight;
      const double slope = -off / (w * w) * m;
      sums_.solid_fraction[k] += area[i] * weight;
      sums_.density[k] += m;
      density_slope_[k] += slope;
      momentum_[0][k] += m * vx[i];
      momentum_[1][k] += m * vy[i];
      momentum_slope_[k] += slope * vx[i];
      flux_xx_[k] += m * vx[i] * vx[i];
      flux_xy_[k] += m * vx[i] * vy[i];
      flux_yy_[k] += m * vy[i] * vy[i];
      const double above = mass[i] * share_above(sums_.height[k], y[i], w) / width_;
      sums_.load_onto[k] += onto * above;
      sums_.load_down[k] += down * above;
    }
  sums_.particle_mass +=
      std::accumulate(mass.begin(), mass.end(), 0.0) / static_cast<double>(bodies.rows);
}

void ChuteSample::add_contacts(const Frame& contacts) {
  require_planar_contacts(contacts);
  for (const auto& each : sum_pairs(read_contacts(contacts)).interactions) {
    const auto &f = each.force, &b = each.branch;
    for (std::size_t k = 0; k < sums_.height.size(); ++k) {
      const double from = sums_.height[k] - each.from[1];
      const double weight = gaussian_along(from, b[1], sums_.scale) / width_;
      sums_.xx[k] -= f[0] * b[0] * weight;
      sums_.xy[k] -= f[0] * b[1] * weight;
      sums_.yx[k] -= f[1] * b[0] * weight;
      sums_.yy[k] -= f[1] * b[1] * weight;
      if (!each.wall) continue;
      const double above = share_above(sums_.height[k], each.from[1] + b[1], sums_.scale) / width_;
      sums_.load_onto[k] -= f[1] * above;
      sums_.load_down[k] += f[0] * above;
    }
  }
}

void ChuteSample::add(const Packing& packing, const Frame& bodies, const Frame& contacts) {
  require_contacts_of_bodies(contacts, bodies);
  if (frames_ == 0) start(packing);
  ++frames_;
  sums_.surface += packing.surface - packing.walls.floor;
  add_bodies(bodies);
  add_contacts(contacts);
}

ChuteProfile ChuteSample::result() const {
  if (frames_ == 0) throw TooFewParticles("incline: no frame to average");
  ChuteProfile profile = sums_;
  profile.surface /= frames_;
  profile.particle_mass /= frames_;
  const double low = profile.height.front();
  const std::size_t count = profile.height.size();
  for (auto* column :
       {&profile.velocity, &profile.shear_rate, &profile.kinetic_xy, &profile.kinetic_yy})
    column->assign(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    profile.height[k] -= low;
    for (auto* column : {&profile.solid_fraction, &profile.density, &profile.xx, &profile.xy,
                         &profile.yx, &profile.yy, &profile.load_onto, &profile.load_down})
      (*column)[k] /= frames_;
    const double rho = sums_.density[k];  // of all frames together, as the momenta
    if (!(rho > 0)) continue;
    const double u = momentum_[0][k] / rho, v = momentum_[1][k] / rho;
    profile.velocity[k] = u;
    profile.shear_rate[k] = (momentum_slope_[k] - u * density_slope_[k]) / rho;
    profile.kinetic_xy[k] = (flux_xy_[k] - rho * u * v) / frames_;
    profile.kinetic_yy[k] = (flux_yy_[k] - rho * v * v) / frames_;
    profile.xx[k] += (flux_xx_[k] - rho * u * u) / frames_;
    profile.xy[k] += profile.kinetic_xy[k];
    profile.yx[k] += profile.kinetic_xy[k];
    profile.yy[k] += profile.kinetic_yy[k];
  }
  return profile;
}

std::optional<ShearLaw> fit_shear(const ChuteProfile& profile) {
  std::vector<double> x, y;
  for (const std::size_t k : inner_heights(profile)) {
    if (!(profile.shear_rate[k] > 0)) continue;
    x.push_back(std::log(profile.surface - profile.height[k]));
    y.push_back(std::log(profile.shear_rate[k]));
  }
  if (x.size() < 5) return std::nullopt;
  const LineFit line = fit_line(x, y);
  const double variance = line.residual / (static_cast<double>(x.size()) - 2);
  const double correlated = 2 * std::sqrt(pi) * per_scale;
  return ShearLaw{line.b, std::sqrt(variance / line.sxx * correlated)};
}

std::optional<ChuteBulk> bulk_of(const ChuteProfile& profile) {
  const auto inner = inner_heights(profile);
  if (inner.empty()) return std::nullopt;
  ChuteBulk bulk;
  for (const std::size_t k : inner) {
    const double pressure = 0.5 * (profile.xx[k] + profile.yy[k]);
    if (!(pressure > 0 && profile.yy[k] > 0)) return std::nullopt;
    bulk.friction -= profile.xy[k] / profile.yy[k];
    bulk.inertial_number += profile.shear_rate[k] * std::sqrt(profile.particle_mass / pressure);
    bulk.solid_fraction += profile.solid_fraction[k];
  }
  for (double* each : {&bulk.friction, &bulk.inertial_number, &bulk.solid_fraction})
    *each /= static_cast<double>(inner.size());
  return bulk;
}

Imbalance imbalance_of(const ChuteProfile& profile) {
  Imbalance most;
  double load = 0;
  for (std::size_t k = 0; k < profile.height.size(); ++k) {
    most.onto = std::max(most.onto, std::abs(profile.yy[k] - profile.load_onto[k]));
    most.down = std::max(most.down, std::abs(profile.xy[k] + profile.load_down[k]));
    load = std::max(load, profile.load_onto[k]);
  }
  if (load > 0) return {most.onto / load, most.down / load};
  return most;
}

void write_chute_table(const ChuteProfile& profile, const std::string& file) {
  std::vector<double> height;
  for (const double each : profile.height) height.push_back(each / profile.particle_diameter);
  write_csv(file, {{"height_over_dp", height},
                   {"solid_fraction", profile.solid_fraction},
                   {"density_kg_m2", profile.density},
                   {"velocity_m_s", profile.velocity},
                   {"shear_rate_per_s", profile.shear_rate},
                   {"stress_xx_N_m", profile.xx},
                   {"stress_xy_N_m", profile.xy},
                   {"stress_yx_N_m", profile.yx},
                   {"stress_yy_N_m", profile.yy},
                   {"kinetic_stress_xy_N_m", profile.kinetic_xy},
                   {"kinetic_stress_yy_N_m", profile.kinetic_yy},
                   {"load_onto_N_m", profile.load_onto},
                   {"load_down_N_m", profile.load_down}});
}

}  // namespace rodpack

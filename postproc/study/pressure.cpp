// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/pressure.h"

#include <cmath>

#include "study/study_case.h"

namespace rodpack {
namespace {

std::optional<double> parameter(const EnsembleCase& each, const char* name) {
  const auto found = each.parameters.find(name);
  if (found == each.parameters.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

}  // namespace

std::optional<PressureProfile> mean_profile(const EnsembleCase& each) {
  const auto* curve = curve_of(&each, "profile.pressure_N_m");
  const auto diameter = parameter(each, "particle_diameter_m");
  const auto aspect_ratio = parameter(each, "aspect_ratio");
  if (!curve || !diameter || !aspect_ratio) return std::nullopt;
  PressureProfile profile;
  profile.particle_diameter = *diameter;
  profile.scale = 3 * *aspect_ratio * *diameter;
  for (std::size_t k = 0; k < curve->x.size(); ++k) {
    if (curve->y[k].n == 0 || !std::isfinite(curve->y[k].mean)) continue;
    profile.depth.push_back(curve->x[k] * *diameter);
    profile.pressure.push_back(curve->y[k].mean);
    profile.depth_of_floor = std::max(profile.depth_of_floor, profile.depth.back());
  }
  return profile;
}

std::optional<JanssenFit> janssen_of(const EnsembleCase& each, std::string& why) {
  const auto profile = mean_profile(each);
  if (!profile) {
    why = each.name + ": no pressure profile";
    return std::nullopt;
  }
  try {
    return fit_janssen(*profile);
  } catch (const TooFewParticles& reason) {
    why = each.name + ": " + reason.what();
    return std::nullopt;
  }
}

}  // namespace rodpack

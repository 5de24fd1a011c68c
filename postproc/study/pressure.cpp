// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/pressure.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::optional<double> usable_depth(const EnsembleCase* each) {
  const auto profile = each ? mean_profile(*each) : std::nullopt;
  if (!profile) return std::nullopt;
  const double end = (profile->depth_of_floor - 3 * profile->scale) / profile->particle_diameter;
  if (!(end > 0)) return std::nullopt;
  return end;
}

EnsembleMean mean_pressure(const EnsembleCase& each, double from, double to) {
  const auto& curve = *curve_of(&each, "profile.pressure_N_m");
  int runs = 0;
  for (const auto& value : curve.y) runs = std::max(runs, value.n);
  EnsembleMean mean;
  double sem = 0;
  bool errors = true;
  int count = 0;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    const auto& value = curve.y[k];
    if (curve.x[k] < from || curve.x[k] > to || value.n < runs) continue;
    mean.mean += value.mean;
    errors = errors && value.sem;
    sem += value.sem.value_or(0);
    ++count;
  }
  if (count == 0) return {};
  mean.mean /= count;
  mean.n = runs;
  if (errors) mean.sem = sem / count;
  return mean;
}

PressureOverTheta pressure_over_theta(const Ensemble& ensemble, double aspect_ratio) {
  PressureOverTheta result;
  std::vector<const EnsembleCase*> cases;
  result.to = std::numeric_limits<double>::infinity();
  for (const double theta : angles_from_straight(ensemble, aspect_ratio)) {
    const auto* each = curved_case(ensemble, aspect_ratio, theta);
    const auto depth = usable_depth(each);
    if (!depth) continue;
    cases.push_back(each);
    result.theta.push_back(theta);
    result.to = std::min(result.to, *depth);
  }
  result.from = result.to / 2;
  for (const auto* each : cases)
    result.pressure.push_back(mean_pressure(*each, result.from, result.to));
  return result;
}

}  // namespace rodpack

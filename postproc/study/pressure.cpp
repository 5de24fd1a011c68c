// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/pressure.h"

#include <algorithm>
#include <limits>

#include "study/study_case.h"

namespace rodpack {
namespace {

std::optional<PressureProfile> profile_of(const EnsembleCase& each) {
  const auto* curve = curve_of(&each, "profile.pressure_N_m");
  const auto diameter = each.parameters.find("particle_diameter_m");
  const auto omega = each.numbers.find("omega_m");
  if (!curve || curve->x.empty() || diameter == each.parameters.end() ||
      omega == each.numbers.end())
    return std::nullopt;
  std::vector<std::optional<double>> pressure;
  for (const auto& value : curve->y)
    pressure.push_back(value.n > 0 ? std::optional<double>(value.mean) : std::nullopt);
  return mean_profile(curve->x, pressure, diameter->get<double>(), omega->second.mean);
}

}  // namespace

std::optional<JanssenFit> janssen_of(const EnsembleCase& each, std::string& why) {
  const auto profile = profile_of(each);
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
  const auto profile = each ? profile_of(*each) : std::nullopt;
  if (!profile) return std::nullopt;
  const double end = (profile->depth_of_floor - 3 * profile->scale) / profile->particle_diameter;
  if (!(end > 0)) return std::nullopt;
  return end;
}

EnsembleMean sum_of_pressures(const EnsembleCase& each, const std::vector<RangeTerm>& terms) {
  return sum_over_ranges(*curve_of(&each, "profile.pressure_N_m"), terms);
}

EnsembleMean mean_pressure(const EnsembleCase& each, double from, double to) {
  return sum_of_pressures(each, {{1, from, to}});
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

// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/study_case.h"

#include <cmath>
#include <regex>
#include <set>

namespace rodpack {
namespace {

const std::string number = "([0-9]+(?:\\.[0-9]+)?)";

// Straight and curved cases of the paper, without those of the sensitivity to a parameter.
template <class Accept, class Value>
std::vector<double> values_of(const Ensemble& ensemble, Accept accept, Value value) {
  std::set<double> values;
  for (const auto& each : ensemble.cases) {
    const auto meaning = study_case(each.name);
    if (meaning && meaning->variation.empty() && accept(*meaning)) values.insert(value(*meaning));
  }
  return {values.begin(), values.end()};
}

const EnsembleCase* find_case(const Ensemble& ensemble, Surface surface, double aspect_ratio,
                              double theta) {
  for (const auto& each : ensemble.cases) {
    const auto meaning = study_case(each.name);
    if (meaning && meaning->variation.empty() && meaning->surface == surface &&
        meaning->aspect_ratio == aspect_ratio && meaning->theta == theta)
      return &each;
  }
  return nullptr;
}

}  // namespace

std::optional<StudyCase> study_case(const std::string& name) {
  static const std::regex spheres("spheres(?:-(.+))?");
  static const std::regex straight("(coarse|smooth)-AR" + number + "(?:-(.+))?");
  static const std::regex curved("curved-AR" + number + "-theta" + number + "(?:-(.+))?");
  std::smatch found;
  if (std::regex_match(name, found, spheres)) return StudyCase{Surface::sphere, 1, 0, found[1]};
  if (std::regex_match(name, found, straight))
    return StudyCase{found[1] == "coarse" ? Surface::coarse : Surface::smooth, std::stod(found[2]),
                     0, found[3]};
  if (std::regex_match(name, found, curved))
    return StudyCase{Surface::smooth, std::stod(found[1]), std::stod(found[2]), found[3]};
  return std::nullopt;
}

std::vector<double> aspect_ratios(const Ensemble& ensemble, bool curved) {
  return values_of(
      ensemble,
      [&](const StudyCase& each) {
        return each.surface != Surface::sphere && curved == (each.theta > 0);
      },
      [](const StudyCase& each) { return each.aspect_ratio; });
}

std::vector<double> opening_angles(const Ensemble& ensemble, double aspect_ratio) {
  return values_of(
      ensemble,
      [&](const StudyCase& each) { return each.theta > 0 && each.aspect_ratio == aspect_ratio; },
      [](const StudyCase& each) { return each.theta; });
}

std::vector<double> angles_from_straight(const Ensemble& ensemble, double aspect_ratio) {
  auto angles = opening_angles(ensemble, aspect_ratio);
  angles.insert(angles.begin(), 0);
  return angles;
}

const EnsembleCase* straight_case(const Ensemble& ensemble, Surface surface, double aspect_ratio) {
  return find_case(ensemble, surface, aspect_ratio, 0);
}

const EnsembleCase* curved_case(const Ensemble& ensemble, double aspect_ratio, double theta) {
  return find_case(ensemble, Surface::smooth, aspect_ratio, theta);
}

const EnsembleMean* number_of(const EnsembleCase* each, const std::string& name) {
  if (!each) return nullptr;
  const auto found = each->numbers.find(name);
  if (found == each->numbers.end() || found->second.n == 0 || !std::isfinite(found->second.mean))
    return nullptr;
  return &found->second;
}

const EnsembleCurve* curve_of(const EnsembleCase* each, const std::string& name) {
  if (!each) return nullptr;
  const auto found = each->curves.find(name);
  return found == each->curves.end() || found->second.x.empty() ? nullptr : &found->second;
}

}  // namespace rodpack

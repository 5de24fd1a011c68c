// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_POSTPROC_STUDY_SYNTHETIC_STUDY_H
#define RODPACK_TESTS_POSTPROC_STUDY_SYNTHETIC_STUDY_H

#include <cmath>
#include <functional>
#include <string>

#include "study/study_case.h"

namespace rodpack {

/// Cases whose numbers and curves are formulas, five repetitions each.
class SyntheticStudy {
 public:
  Ensemble ensemble;

  void number(const std::string& name, const std::string& key, double mean, double sem) {
    one(name).numbers[key] = {mean, sem, 5};
  }

  /// Distribution of gamma in bins of 5 degrees, in units of the isotropic one, of an angle in rad;
  /// standard errors of 3 %. S2 goes with it, +- 0.01.
  void orientation(const std::string& name, const std::function<double(double)>& shape) {
    const bool curved = study_case(name)->theta > 0;
    const double range = curved ? 360 : 180;
    auto& curve = one(name).curves["orientation.probability_density_per_deg"];
    curve = {};
    for (int bin = 0; 5 * bin < range; ++bin) {
      const double g = 5 * bin;
      curve.x.push_back(g);
      const double value = shape(g * std::acos(-1.0) / 180) / range;
      curve.y.push_back({value, 0.03 / range, 5});
    }
    number(name, "nematic_order_S2_pooled", 0.3, 0.01);
  }

  /// G(r): 1 with a peak of Gaussian shape, standard errors 0.03.
  void peak(const std::string& name, double place, double height) {
    auto& curve = one(name).curves["rdf.g"];
    curve = {};
    for (int k = 0; k < 100; ++k) {
      const double r = 0.05 + 0.1 * k;
      curve.x.push_back(r);
      curve.y.push_back({1 + (height - 1) * std::exp(-std::pow((r - place) / 0.15, 2)), 0.03, 5});
    }
  }

  /// P_0(h) down to a floor at 150 d_p, standard errors 0.1 N/m. The runs depart from the law by
  /// -2, -1, 0, 1, 2 times 0.1 sqrt(2) N/m, each over 10 d_p in another way.
  void pressure(const std::string& name, const std::function<double(double)>& law) {
    auto& study_case = one(name);
    auto& curve = study_case.curves["profile.pressure_N_m"];
    curve = {};
    curve.of_runs.resize(5);
    for (int h = 0; h <= 150; ++h) {
      curve.x.push_back(h);
      curve.y.push_back({law(h), 0.1, 5});
      for (int run = 0; run < 5; ++run)
        curve.of_runs[static_cast<std::size_t>(run)].push_back(
            law(h) + 0.1 * std::sqrt(2.0) * ((run + h / 10) % 5 - 2));
    }
    const double omega = 3 * study_case.parameters["aspect_ratio"].get<double>() * 0.003;
    study_case.numbers["omega_m"] = {omega, 0, 5};
  }

 private:
  EnsembleCase& one(const std::string& name) {
    for (auto& each : ensemble.cases)
      if (each.name == name) return each;
    EnsembleCase each;
    each.name = name;
    each.parameters["aspect_ratio"] = study_case(name)->aspect_ratio;
    each.parameters["particle_diameter_m"] = 0.003;
    ensemble.cases.push_back(each);
    return ensemble.cases.back();
  }
};

inline std::string curved_name_of(int aspect_ratio, int theta) {
  return "curved-AR" + std::to_string(aspect_ratio) + "-theta" + std::to_string(theta);
}

/// A study in which the paper's claims hold (`sign` = 1), or the opposite of them (-1).
inline SyntheticStudy study_of_claims(double sign) {
  SyntheticStudy study;
  const double rise[] = {0, 1, 3, 5};
  const int ratios[] = {2, 3, 5, 7};
  for (int k = 0; k < 4; ++k) {
    for (const std::string surface : {"coarse", "smooth"}) {
      const std::string name = std::string(surface).append("-AR").append(std::to_string(ratios[k]));
      const bool coarse = surface == "coarse";
      study.number(name, "solid_fraction", 0.85 - 0.02 * sign * rise[k], 0.001);
      // Harmonics 12 stand for discrete angles; the second one for lying flat.
      const double discrete = coarse == (sign > 0) && k < 2 ? 0.6 : 0.0;
      const double flat = sign * (0.2 + 0.1 * rise[k]);
      study.orientation(
          name, [=](double g) { return 1 + discrete * std::cos(12 * g) + flat * std::cos(2 * g); });
      const bool high = coarse == (sign > 0);
      study.peak(name, high ? 1.75 : 1.95, high ? 2.6 : 2.0);
      const double factor = k < 2 && high ? 1.2 : k == 3 && sign < 0 && coarse ? 1.5 : 1.0;
      study.pressure(name, [=](double h) {
        const double bent = 12 * (1 - std::exp(-h / 30));
        return factor * (k == 3 && sign < 0 ? bent - 0.05 * h : 0.1 * h);
      });
    }
  }
  study.pressure("spheres", [=](double h) {
    return sign > 0 ? 12 * (1 - std::exp(-h / 30)) : 12 * std::pow(h / 150, 2);
  });
  for (const int ratio : {3, 5, 7})
    for (const int theta : {30, 60, 90, 120}) {
      const std::string name = curved_name_of(ratio, theta);
      const double straight = study.ensemble.cases[0].numbers["solid_fraction"].mean;
      study.number(name, "solid_fraction", straight - 0.1 * sign * (1 + theta / 120.0), 0.001);
      const double up = sign > 0 ? 0.3 : 0.0;
      study.orientation(name,
                        [=](double g) { return 1 + up * std::cos(g) + 0.3 * std::cos(2 * g); });
      study.peak(name, 2.05, 1.8);
      study.pressure(name, [=](double h) { return 0.1 * h * (1 + sign * theta / 400.0); });
    }
  return study;
}

}  // namespace rodpack

#endif

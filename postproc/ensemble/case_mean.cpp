// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/case_mean.h"

#include <cmath>
#include <complex>
#include <filesystem>
#include <limits>
#include <set>

#include "analysis/janssen_fit.h"
#include "ensemble/case_curves.h"
#include "ensemble/run_analysis.h"
#include "ensemble/run_cost.h"
#include "ensemble/statistics.h"
#include "reading/angles.h"
#include "reading/dump.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::json;
using NumbersOfRuns = std::map<std::string, ValuesOfRuns>;
using Sample = std::vector<std::size_t>;

// Directions of axes, in degrees.
const std::set<std::string> axes = {"director_deg", "profile.sigma_1_direction_deg"};

EnsembleMean mean_of(const std::string& name, const ValuesOfRuns& values) {
  return axes.count(name) ? mean_axis_over_runs(values) : mean_over_runs(values);
}

// Curves that are kept for each run.
const std::set<std::string> kept_curves = {"rdf.g", "orientation.probability_density_per_deg",
                                           "profile.pressure_N_m"};

// The paper's own names of the two solid fractions, whose keys in summary.json name the heights.
std::string name_of_number(const std::string& key) {
  if (key == "solid_fraction_from_3_omega_above_floor_to_surface") return "solid_fraction";
  if (key == "solid_fraction_from_3_omega_above_floor_to_3_omega_below_surface")
    return "solid_fraction_to_3_omega_below_surface";
  return key;
}

NumbersOfRuns read_numbers(const CaseRuns& one) {
  NumbersOfRuns numbers;
  const std::size_t runs = one.runs.size();
  const auto set = [&](const std::string& name, std::size_t run, double value) {
    auto& values = numbers[name];
    values.resize(runs);
    values[run] = value;
  };
  for (std::size_t run = 0; run < runs; ++run) {
    const Json summary = read_summary(one.runs[run]);
    for (const auto& [key, value] : summary.items())
      if (value.is_number() && key.find("standard_error") == std::string::npos)
        set(name_of_number(key), run, value.get<double>());
    if (const auto cost = cost_of_run((fs::path(one.runs[run].folder) / "log.liggghts").string())) {
      set("wall_time_s", run, cost->wall_time_s);
      set("core_seconds", run, cost->core_seconds);
    }
  }
  return numbers;
}

// < exp(2 i gamma) > over the particles of all runs of the sample, from the runs' own S2.
std::optional<std::complex<double>> pooled_order(const NumbersOfRuns& numbers,
                                                 const Sample& sample) {
  std::complex<double> sum = 0;
  double particles = 0;
  for (const std::size_t run : sample) {
    const auto& n = numbers.at("orientation_particles")[run];
    if (!n) continue;
    sum += *n * std::polar(*numbers.at("nematic_order_S2")[run],
                           2 * *numbers.at("director_deg")[run] * degree);
    particles += *n;
  }
  if (particles == 0) return std::nullopt;
  return sum / particles;
}

void add(EnsembleCase& mean, const std::string& name, const EnsembleMean& value) {
  if (value.n > 0) mean.numbers[name] = value;
}

EnsembleCurve mean_curve(const std::string& name, const CurveOfRuns& curve) {
  EnsembleCurve mean{curve.abscissa, curve.x, {}, {}};
  for (const auto& values : curve.y) mean.y.push_back(mean_of(name, values));
  if (!kept_curves.count(name)) return mean;
  for (std::size_t run = 0; run < curve.y.front().size(); ++run) {
    mean.of_runs.emplace_back();
    for (const auto& values : curve.y)
      mean.of_runs.back().push_back(values[run].value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  return mean;
}

void add_pooled_order(const NumbersOfRuns& numbers, std::size_t runs, EnsembleCase& mean) {
  if (!numbers.count("orientation_particles")) return;
  add(mean, "nematic_order_S2_pooled",
      bootstrap_over_runs(runs, [&](const Sample& sample) -> std::optional<double> {
        const auto order = pooled_order(numbers, sample);
        if (!order) return std::nullopt;
        return std::abs(*order);
      }));
  Sample all(runs);
  for (std::size_t run = 0; run < runs; ++run) all[run] = run;
  const auto order = pooled_order(numbers, all);
  if (!order) return;
  // The direction of each resample from that of all, so that 179 and 1 degrees are close.
  auto turn = bootstrap_over_runs(runs, [&](const Sample& sample) -> std::optional<double> {
    const auto other = pooled_order(numbers, sample);
    if (!other) return std::nullopt;
    return std::arg(*other / *order) / 2 / degree;
  });
  const double direction = std::arg(*order) / 2 / degree;
  turn.mean = direction < 0 ? direction + 180 : direction;
  add(mean, "director_pooled_deg", turn);
}

// Means of the curve over the runs of the sample; none in a bin without a value.
std::vector<std::optional<double>> mean_of_sample(const CurveOfRuns& curve, const Sample& sample) {
  std::vector<std::optional<double>> result;
  for (const auto& values : curve.y) {
    ValuesOfRuns chosen;
    for (const std::size_t run : sample) chosen.push_back(values[run]);
    const auto mean = mean_over_runs(chosen);
    result.push_back(mean.n > 0 ? std::optional<double>(mean.mean) : std::nullopt);
  }
  return result;
}

struct Peak {
  double x, y;
};

// The top of the parabola through the highest point and its neighbours, equally spaced.
std::optional<Peak> highest_peak(const std::vector<double>& x,
                                 const std::vector<std::optional<double>>& y) {
  std::size_t top = 0;
  for (std::size_t k = 0; k < y.size(); ++k)
    if (y[k] && (!y[top] || *y[k] > *y[top])) top = k;
  if (top == 0 || top + 1 >= y.size() || !y[top] || !y[top - 1] || !y[top + 1]) return std::nullopt;
  const double left = *y[top - 1], middle = *y[top], right = *y[top + 1];
  const double curvature = left - 2 * middle + right, slope = (right - left) / 2;
  if (!(curvature < 0)) return Peak{x[top], middle};
  const double shift = -slope / curvature;
  return Peak{x[top] + shift * (x[top + 1] - x[top]), middle + slope * shift / 2};
}

void add_rdf_peak(const CurvesOfRuns& curves, std::size_t runs, EnsembleCase& mean) {
  const auto found = curves.find("rdf.g");
  if (found == curves.end()) return;
  const auto peak = [&](double Peak::*part) {
    return bootstrap_over_runs(runs, [&, part](const Sample& sample) -> std::optional<double> {
      const auto top = highest_peak(found->second.x, mean_of_sample(found->second, sample));
      if (!top) return std::nullopt;
      return (*top).*part;
    });
  };
  add(mean, "rdf_peak_r_over_dp", peak(&Peak::x));
  add(mean, "rdf_peak_g", peak(&Peak::y));
}

void add_janssen_fit(const CurvesOfRuns& curves, const NumbersOfRuns& numbers, double diameter,
                     std::size_t runs, EnsembleCase& mean) {
  const auto found = curves.find("profile.pressure_N_m");
  if (found == curves.end() || !numbers.count("omega_m")) return;
  const CurveOfRuns& pressure = found->second;
  const double omega = mean_over_runs(numbers.at("omega_m")).mean;
  const auto fit = [&](const Sample& sample) -> std::optional<JanssenFit> {
    const auto profile =
        mean_profile(pressure.x, mean_of_sample(pressure, sample), diameter, omega);
    try {
      return fit_janssen(profile);
    } catch (const TooFewParticles&) {
      return std::nullopt;
    }
  };
  Sample all(runs);
  for (std::size_t run = 0; run < runs; ++run) all[run] = run;
  const auto of_all = fit(all);
  if (!of_all) return;
  const auto part = [&](const std::function<double(const JanssenFit&)>& value) {
    return bootstrap_over_runs(runs, [&](const Sample& sample) -> std::optional<double> {
      const auto one = fit(sample);
      if (!one) return std::nullopt;
      return value(*one);
    });
  };
  add(mean, "janssen_depth_over_fitted_depth",
      part([](const JanssenFit& one) { return one.depth / one.to; }));
  if (!of_all->saturates) return;
  add(mean, "janssen_pressure_of_mean_profile_N_m",
      part([](const JanssenFit& one) { return one.pressure; }));
  add(mean, "janssen_depth_of_mean_profile_over_dp",
      part([&](const JanssenFit& one) { return one.depth / diameter; }));
}

}  // namespace

EnsembleCase mean_over_case(const CaseRuns& one) {
  const std::size_t runs = one.runs.size();
  EnsembleCase mean;
  mean.name = one.name;
  mean.parameters = one.parameters;
  for (const auto& run : one.runs) {
    mean.runs.push_back(run.name);
    mean.seeds.push_back(run.seed);
  }
  const NumbersOfRuns numbers = read_numbers(one);
  for (const auto& [name, values] : numbers) add(mean, name, mean_of(name, values));
  const CurvesOfRuns curves = read_curves(one);
  for (const auto& [name, curve] : curves) mean.curves[name] = mean_curve(name, curve);
  add_pooled_order(numbers, runs, mean);
  add_rdf_peak(curves, runs, mean);
  add_janssen_fit(curves, numbers, one.parameters.value("particle_diameter_m", 0.0), runs, mean);
  return mean;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_ENSEMBLE_ENSEMBLE_H
#define RODPACK_ENSEMBLE_ENSEMBLE_H

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rodpack {

/// Mean over the repetitions of a case.
struct EnsembleMean {
  double mean = 0;
  std::optional<double> sem;  // standard error of the mean; none for a single repetition
  int n = 0;                  // repetitions that have a value
};

/// A measured curve, for example G(r): one entry per bin.
struct EnsembleCurve {
  std::string abscissa;  // with its unit, as in the header of the table: r_over_dp
  std::vector<double> x;
  std::vector<EnsembleMean> y;
  // The curve in each run, [run][bin], not a number where it has no value: for quantities derived
  // from several bins, whose noise is common to the bins of a run. Kept for rdf.g,
  // orientation.probability_density_per_deg and profile.pressure_N_m; empty for the others.
  std::vector<std::vector<double>> of_runs{};
};

/// All repetitions of one case: same parameters, other seeds.
struct EnsembleCase {
  std::string name;                   // coarse-AR2, curved-AR5-theta60 ...
  nlohmann::ordered_json parameters;  // parameters.json, less those that differ by run
  std::vector<std::string> runs;      // their folders, by seed
  std::vector<long> seeds;
  std::map<std::string, EnsembleMean> numbers;  // solid_fraction, nematic_order_S2 ...
  std::map<std::string, EnsembleCurve>
      curves;  // by table and column: rdf.g, profile.pressure_N_m ...
};

/// A study, or any run folders.
struct Ensemble {
  std::vector<EnsembleCase> cases;  // spheres, then by surface, aspect ratio, angle
  std::vector<std::string> notes;   // what was left out, and why
};

/// Finds a case by name; null when there is none.
const EnsembleCase* case_named(const Ensemble& ensemble, const std::string& name);

/// Reads ensemble.json and, where it is beside it, cost.json, as write_ensemble() wrote them.
/// @throws DataError when ensemble.json is missing or one is malformed.
Ensemble read_ensemble(const std::string& file);

/// Writes `folder`/ensemble.json, cost.json with the numbers that tell of the clock (wall_time_s,
/// core_seconds), which differ whenever a study is run, numbers.csv (columns case, number, mean,
/// sem, n) and one CSV table per case and measured table. Tables of cases that an ensemble.json
/// there names are removed first.
/// @throws DataError when one cannot be written.
void write_ensemble(const Ensemble& ensemble, const std::string& folder);

}  // namespace rodpack

#endif

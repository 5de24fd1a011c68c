// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_ENSEMBLE_RUN_FOLDERS_H
#define RODPACK_TESTS_ENSEMBLE_RUN_FOLDERS_H

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "../synthetic_packing.h"
#include "ensemble/cases.h"
#include "reading/run_folder.h"
#include "rodpack/version.h"

namespace rodpack::test {

/// A finished run without dumps, with an analysis of made-up numbers and tables.
struct MadeUpRun {
  long seed = 1;
  nlohmann::json parameters = {{"aspect_ratio", 5}, {"particle_diameter_m", 1e-3}};
  nlohmann::json numbers = nlohmann::json::object();  // of summary.json
  std::map<std::string, std::string> tables;          // by name: "rdf", the text of rdf.csv

  nlohmann::json all_parameters(const std::filesystem::path& folder) const {
    auto all = parameters;
    all["seed"] = seed;
    all["out"] = folder.string();
    all["rodpack"] = {{"version", version()}};
    return all;
  }

  /// Writes the folder. Returns it.
  std::string write(const std::filesystem::path& folder) const {
    put(folder / "parameters.json", all_parameters(folder).dump());
    put(folder / "result.json", R"({"step": 2000})");
    auto summary = numbers;
    summary["format"] = analysis_format;
    summary["timestep"] = 2000;
    summary["parameters"] = all_parameters(folder);
    summary["rodpack"] = {{"version", version()}};
    for (const auto& [name, text] : tables) put(folder / "analysis" / (name + ".csv"), text);
    put(folder / "analysis" / "summary.json", summary.dump());
    return folder.string();
  }
};

/// The runs written into `folder`/seed-1, seed-2 ... and found there as one case.
inline CaseRuns case_of(const std::filesystem::path& folder, std::vector<MadeUpRun> runs) {
  for (std::size_t k = 0; k < runs.size(); ++k) {
    runs[k].seed = static_cast<long>(k) + 1;
    runs[k].write(folder / ("seed-" + std::to_string(k + 1)));
  }
  return find_cases({folder.string()}, folder.string(), false).cases.at(0);
}

/// Writes a finished run with dumps, ready for `rodpack analyse`.
inline void write_finished_run(const std::filesystem::path& folder, unsigned seed,
                               double friction = 0.3) {
  SyntheticPacking packing;
  packing.seed = seed;
  packing.fill();
  packing.write_run(folder);
  const MadeUpRun run{static_cast<long>(seed),
                      {{"aspect_ratio", 5},
                       {"particle_diameter_m", 3e-3},
                       {"container_width_m", packing.width},
                       {"timestep_s", 1.1e-5},
                       {"friction", friction}},
                      {},
                      {}};
  put(folder / "parameters.json", run.all_parameters(folder).dump());
  put(folder / "result.json", R"({"step": 2000})");
}

}  // namespace rodpack::test

#endif

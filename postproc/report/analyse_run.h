// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_ANALYSE_RUN_H
#define RODPACK_REPORT_ANALYSE_RUN_H

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/stock/local_contacts.h"
#include "reading/packing.h"
#include "reading/space/spatial_packing.h"

namespace rodpack {

/// What the user states; everything left out is looked up.
struct AnalyseOptions {
  bool all_frames = false;  // export every frame to VTK, not only the last
  PackingOptions packing;
  SpaceOptions space;
  std::optional<double> friction;  // mu
  LocalContactOptions local;
};

/// Runs every analysis on the last frame of a run folder (parameters.json, dumps/bodies.*.dump,
/// dumps/spheres.*.dump, dumps/contacts.*.dump, energies.csv; dumps may end in .gz) and writes
/// tables, figures, VTK files and summary.json into `run_folder`/analysis; of what is there
/// already, only earlier outputs of its own are removed. Returns the summary. A scene in space gets
/// the measures of space (is_in_space()). Without parameters.json, dumps may lie in the folder
/// itself, and those of bodies are enough. A measurement for which the bed is too small, or for
/// which something is missing, is left out, and the summary's "notes" say so.
/// @throws DataError when the folder or the bodies' dumps are missing, with parameters.json those
/// of
///   the spheres, when dumps are of several runs, or when nothing could be measured.
nlohmann::ordered_json analyse_run(const std::string& run_folder, const AnalyseOptions& options);

}  // namespace rodpack

#endif

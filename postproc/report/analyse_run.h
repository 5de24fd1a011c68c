// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_REPORT_ANALYSE_RUN_H
#define RODPACK_REPORT_ANALYSE_RUN_H

#include <nlohmann/json.hpp>
#include <string>

namespace rodpack {

/// Runs every analysis on the last frame of a run folder (parameters.json, dumps/bodies.*.dump,
/// dumps/spheres.*.dump, dumps/contacts.*.dump, energies.csv; dumps may end in .gz) and writes
/// tables, figures, VTK files and summary.json into `run_folder`/analysis; of what is there
/// already, only earlier outputs of its own are removed. Returns the summary. A measurement for
/// which the bed is too small, or whose contacts are missing or lack normals, is left out, and the
/// summary's "notes" say so. `all_frames`: export every frame to VTK, not only the last.
/// @throws DataError when the folder, parameters.json or the bodies' or spheres' dumps are missing.
nlohmann::ordered_json analyse_run(const std::string& run_folder, bool all_frames);

}  // namespace rodpack

#endif

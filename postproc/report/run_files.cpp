// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/run_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "analysis/stock/stock_dumps.h"
#include "reading/number_text.h"
#include "reading/run_folder.h"
#include "reading/scene/run_scene.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

using RowOfId = std::map<double, std::size_t>;

RowOfId rows_by_id(const Frame& frame) {
  RowOfId rows;
  const auto& id = frame.column("id");
  for (std::size_t row = 0; row < frame.rows; ++row) rows.emplace(id[row], row);
  return rows;
}

// Sizes as text dumps hold them, to six digits.
bool same_size(double a, double b) { return std::abs(a - b) <= 2e-5 * std::max(a, b); }

// A particle keeps its number of spheres and its size; another one under its id is another run's.
void require_same_particles(const Frame& earlier, const Frame& last, const RowOfId& rows_of_last) {
  const auto& id = earlier.column("id");
  for (std::size_t row = 0; row < earlier.rows; ++row) {
    const auto found = rows_of_last.find(id[row]);
    if (found == rows_of_last.end()) continue;
    for (const char* name : {"nspheres", "half_length", "radius"}) {
      const double was = earlier.column(name)[row], is = last.column(name)[found->second];
      if (!same_size(was, is))
        throw DataError(earlier.file + ": expected dumps of one run, found particle " +
                        number_text(id[row]) + " with " + name + " " + number_text(was, 5) +
                        " here and " + number_text(is, 5) + " in " + last.file);
    }
  }
}

void require_one_run(const std::string& run, const std::vector<std::string>& files,
                     const Frame& last) {
  const auto dumps = (fs::path(run) / "dumps").string();
  if (!dumps_in(dumps, "bodies").empty() && !dumps_in(run, "bodies").empty())
    throw DataError(run + ": expected the bodies' dumps of one run, found some here and some in " +
                    dumps);
  const auto rows_of_last = rows_by_id(last);
  std::map<long, std::string> file_of;
  for (const auto& file : files) {
    Frame first;
    if (!DumpReader(file).next(first)) continue;
    first = as_bodies(first);
    const auto place = file_of.emplace(first.timestep, file);
    if (!place.second)
      throw DataError(file + ": expected dumps of one run, found timestep " +
                      std::to_string(first.timestep) + " here and in " + place.first->second);
    require_same_particles(first, last, rows_of_last);
  }
}

// Dumps that may be missing: with a note that says what writes them.
void find_spheres(const std::string& run, bool own_parameters, RunFiles& files) {
  const std::string hint = "; dump multisphere/sphere writes them";
  try {
    files.sphere_files = dumps_of_run(run, "spheres");
  } catch (const DataError& reason) {
    files.notes.push_back("spheres: " + std::string(reason.what()) + hint);
    return;
  }
  if (own_parameters) {
    files.spheres = last_frame(files.sphere_files);
    return;
  }
  try {
    files.spheres = frame_at(files.sphere_files, files.bodies.timestep);
  } catch (const NoSuchFrame& reason) {
    files.notes.push_back("spheres: " + std::string(reason.what()) + hint);
    files.sphere_files.clear();
  }
}

}  // namespace

RunFiles find_run_files(const std::string& run, const std::string& given) {
  const fs::path folder(run);
  if (!fs::is_directory(folder)) throw DataError(run + ": no such run folder");
  RunFiles files;
  const auto own = folder / "parameters.json";
  const bool has_own = given.empty() && fs::exists(own);
  // A run's own parameters show their faults before its dumps.
  if (has_own) files.parameters = read_parameters(own.string());
  try {
    files.body_files = dumps_of_run(run, "bodies");
  } catch (const DataError&) {
    if (has_own || !dumps_in(run, "bodies").empty() ||
        !dumps_in((folder / "dumps").string(), "bodies").empty())
      throw;
    throw DataError(run +
                    ": expected dumps of bodies (dump multisphere/body), bodies.*.dump, here or in "
                    "its dumps/, found none");
  }
  if (!has_own) files.parameters = find_parameters(files.body_files.back(), given);
  files.bodies = as_bodies(last_frame(files.body_files));
  if (!has_own) {
    if (files.bodies.rows == 0)
      throw DataError(files.bodies.file + ": the last frame holds no particles");
    require_one_run(run, files.body_files, files.bodies);
  }
  if (!files.parameters && !find_scene(files.bodies))
    files.notes.push_back(
        "times: no dump scene, nor parameters.json with 'timestep_s' (--parameters), so that they "
        "are timesteps");
  find_spheres(run, has_own, files);
  files.own_parameters = has_own;
  return files;
}

}  // namespace rodpack

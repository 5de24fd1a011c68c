// SPDX-License-Identifier: GPL-2.0-or-later
#include "ensemble/run_analysis.h"

#include <filesystem>

#include "reading/data_error.h"
#include "reading/json_file.h"
#include "reading/run_folder.h"
#include "rodpack/version.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::json;

Json read_object(const fs::path& file) { return json_object_if_sound(file.string()); }

// An analysis that was cut short leaves no summary, or half of one.
std::string why_not_current(const FinishedRun& run, const Json& summary) {
  const fs::path folder(run.folder);
  if (!summary.is_object()) return "there is no analysis/summary.json";
  if (summary.value("format", Json()) != analysis_format)
    return std::string("the analysis is not of the format '") + analysis_format + "'";
  const auto rodpack = summary.value("rodpack", Json::object());
  if (!rodpack.is_object() || rodpack.value("version", Json()) != version())
    return std::string("the analysis is not by rodpack ") + version();
  std::error_code error;
  if (fs::last_write_time(folder / "analysis" / "summary.json", error) <
      fs::last_write_time(folder / "result.json", error))
    return "the analysis is older than result.json";
  const Json result = read_object(folder / "result.json");
  if (!result.is_object() || summary.value("timestep", Json()) != result.value("step", Json()))
    return "the analysis is not of the step at which result.json says the run ended";
  if (common_parameters(summary.value("parameters", Json::object())) !=
      common_parameters(run.parameters))
    return "the analysis is of other parameters than parameters.json has";
  return {};
}

Json summary_of(const FinishedRun& run) {
  return read_object(fs::path(run.folder) / "analysis" / "summary.json");
}

}  // namespace

std::string why_not_current(const FinishedRun& run) {
  return why_not_current(run, summary_of(run));
}

Json read_summary(const FinishedRun& run) {
  Json summary = summary_of(run);
  const auto reason = why_not_current(run, summary);
  if (!reason.empty()) throw DataError(run.folder + ": " + reason + ", expected it to be current");
  if (summary.contains("vertical_axis"))
    throw DataError(run.folder +
                    ": is a scene in space, expected runs in a plane: means over repetitions are "
                    "taken of those alone");
  return summary;
}

}  // namespace rodpack

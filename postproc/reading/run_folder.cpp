// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/run_folder.h"

#include <fnmatch.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "reading/checks/number_range.h"
#include "reading/data_error.h"
#include "reading/dump.h"
#include "reading/json_file.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

/// Reads the step at which the run ended, as its result.json says; none while it has not ended.
std::optional<long> last_step(const fs::path& run) {
  const fs::path file = run / "result.json";
  if (!fs::exists(file)) return {};
  const auto result = read_json_object(file.string());
  constexpr NumberRange range{0, 9007199254740992.0, true};
  if (!result.contains("step") || !result["step"].is_number() ||
      !range.contains(result["step"].get<double>()))
    throw DataError(file.string() + ": key 'step': expected " + range.text());
  return result["step"].get<long>();
}

/// Finds `run`/dumps/`kind`.*.dump, plain or .gz, else those in `run` itself. The run's own name is
/// no pattern.
std::vector<std::string> files_of(const fs::path& run, const std::string& kind) {
  for (const auto& folder : {run / "dumps", run})
    if (const auto files = dumps_in(folder.string(), kind); !files.empty())
      return find_dumps(files);
  throw DataError("no file matches '" + (run / "dumps" / (kind + ".*.dump*")).string() + "'");
}

}  // namespace

std::vector<std::string> dumps_in(const std::string& folder, const std::string& kind) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename();
    if (fnmatch((kind + ".*.dump*").c_str(), name.c_str(), 0) == 0 ||
        fnmatch((kind + ".dump*").c_str(), name.c_str(), 0) == 0)
      files.push_back(entry->path().string());
  }
  return files;
}

std::vector<std::string> dumps_of_run(const std::string& run_folder, const std::string& kind) {
  const fs::path run(run_folder);
  auto files = files_of(run, kind);
  if (const auto last = last_step(run)) {
    const auto later = [&](const std::string& file) {
      const auto name = fs::path(file).filename().string();
      return std::strtol(name.c_str() + kind.size() + 1, nullptr, 10) > *last;
    };
    files.erase(std::remove_if(files.begin(), files.end(), later), files.end());
    if (files.empty())
      throw DataError((run / "dumps").string() + ": no dump of " + kind + " up to step " +
                      std::to_string(*last) + ", where result.json says the run ended");
  }
  return files;
}

}  // namespace rodpack

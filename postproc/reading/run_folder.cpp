// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/run_folder.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "reading/data_error.h"
#include "reading/dump.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

/// Reads the step at which the run ended, as its result.json says; none while it has not ended.
std::optional<long> last_step(const fs::path& run) {
  std::ifstream file(run / "result.json");
  if (!file) return {};
  const auto result = nlohmann::json::parse(file, nullptr, false);
  if (!result.is_object() || !result.contains("step") || !result["step"].is_number())
    throw DataError((run / "result.json").string() +
                    ": expected a JSON object with a number 'step'");
  return result["step"].get<long>();
}

}  // namespace

std::vector<std::string> dumps_of_run(const std::string& run_folder, const std::string& kind) {
  const fs::path run(run_folder);
  auto files = find_dumps({(run / "dumps" / (kind + ".*.dump*")).string()});
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

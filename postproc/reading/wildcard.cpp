// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/wildcard.h"

#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

namespace rodpack {

namespace fs = std::filesystem;

namespace {

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

void add_matches(const fs::path& folder, const std::string& pattern, std::vector<fs::path>& found) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end;
       !error && entry != end; entry.increment(error)) {
    const auto name = entry->path().filename().string();
    if (fnmatch(pattern.c_str(), name.c_str(), FNM_PERIOD) == 0) found.push_back(folder / name);
  }
}

}  // namespace

bool is_wildcard(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

std::vector<std::string> files_matching(const std::string& pattern) {
  if (pattern.empty()) return {};
  if (is_there(pattern)) return {pattern};
  std::vector<fs::path> found{fs::path()};
  for (const auto& part : fs::path(pattern)) {
    std::vector<fs::path> next;
    for (const auto& folder : found) {
      const fs::path literal = folder / part;
      if (is_there(literal))
        next.push_back(literal);
      else if (is_wildcard(part.string()))
        add_matches(folder, part.string(), next);
    }
    found = std::move(next);
  }
  std::vector<std::string> names;
  for (const auto& path : found) names.push_back(path.string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace rodpack

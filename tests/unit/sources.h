// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_UNIT_SOURCES_H
#define RODPACK_TESTS_UNIT_SOURCES_H

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace rodpack::test {

const std::filesystem::path repository = RODPACK_REPOSITORY;

/// The C++ files below a folder of the repository, in the order of their names.
inline std::vector<std::filesystem::path> sources_below(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(repository / folder)) {
    const auto suffix = entry.path().extension();
    if (suffix == ".h" || suffix == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What a file includes in quotes, as it is written there.
inline std::vector<std::string> includes_of(const std::filesystem::path& file) {
  const std::string start = "#include \"";
  std::vector<std::string> included;
  for (const std::string& line : lines_of(file))
    if (line.compare(0, start.size(), start) == 0)
      included.push_back(line.substr(start.size(), line.find('"', start.size()) - start.size()));
  return included;
}

}  // namespace rodpack::test

#endif

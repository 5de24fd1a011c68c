// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {
namespace fs = std::filesystem;

// What each room of the post-processor may include besides itself, the core (rodpack/...) and
// libraries: dependencies point one way, so that the analysis knows no picture and no deck, and
// starts no simulation.
const std::map<std::string, std::set<std::string>> may_include = {
    {"reading", {}},
    {"analysis", {"reading"}},
    {"figures", {"reading", "analysis"}},
    {"report", {"reading", "analysis", "figures"}},
    {"campaigns", {"reading", "analysis", "figures"}},
    {"cli", {"reading", "analysis", "figures", "report", "campaigns"}}};

TEST(Rooms, DependenciesOfThePostProcessorPointOneWay) {
  const std::regex include("^#include \"([a-z_]+)/.*");
  int seen = 0;
  for (const auto& [room, others] : may_include)
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(RODPACK_REPOSITORY) / "postproc" / room)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, include) || found[1] == "rodpack") continue;
        ++seen;
        EXPECT_TRUE(found[1] == room || others.count(found[1]))
            << entry.path().string() << ": " << line;
      }
    }
  EXPECT_GT(seen, 100);  // the includes were found at all
}

// A folder has one theme, and can be taken in at a glance.
TEST(Rooms, NoFolderOfThePostProcessorHoldsMoreThanSome25Files) {
  std::map<fs::path, int> files;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(RODPACK_REPOSITORY) / "postproc"))
    if (entry.is_regular_file()) ++files[entry.path().parent_path()];
  for (const auto& [folder, count] : files) EXPECT_LE(count, 26) << folder.string();
}

}  // namespace

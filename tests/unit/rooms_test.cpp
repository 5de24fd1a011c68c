// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

// Dependencies point one way (liggghts-src-ext/doc/background/ARCHITECTURE.md), so that a room can
// be read, tested and replaced without those that use it.
namespace {
namespace fs = std::filesystem;

/// What each room may include besides itself and libraries.
using Rules = std::map<std::string, std::set<std::string>>;
/// The room of an included file, empty for one of no room: by the including file's folder, and the
/// path as it is written.
using RoomOfInclude = std::function<std::string(const fs::path&, const std::string&)>;

const fs::path repository = RODPACK_REPOSITORY;

void expect_one_way(const fs::path& rooms, const Rules& rules, const RoomOfInclude& room_of) {
  const std::regex include("^#include \"([^\"]+)\".*");
  int seen = 0;
  for (const auto& [room, others] : rules) {
    if (!fs::exists(rooms / room)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(rooms / room)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (!std::regex_match(line, found, include)) continue;
        const std::string other = room_of(entry.path().parent_path(), found[1]);
        if (other.empty()) continue;
        ++seen;
        EXPECT_TRUE(other == room || others.count(other)) << entry.path().string() << ": " << line;
      }
    }
  }
  EXPECT_GT(seen, 10) << rooms.string() << ": the includes were not found";
}

/// Every room has rules, and every rule its room.
void expect_all_rooms(const std::set<fs::path>& folders, const Rules& rules) {
  std::set<std::string> rooms;
  for (const fs::path& folder : folders)
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_directory()) rooms.insert(entry.path().filename().string());
  std::set<std::string> ruled;
  for (const auto& rule : rules) ruled.insert(rule.first);
  EXPECT_EQ(rooms, ruled);
}

TEST(Rooms, DependenciesOfTheCorePointOneWay) {
  // The loops for one kind of processor and the ghosts of other ranks are rooms of the engine.
  const std::set<std::string> of_engine = {"planar",  "planar_simd", "planar_ranks",
                                           "contact", "motion",      "geometry"};
  const Rules rules = {{"geometry", {}},
                       {"dumps", {}},
                       {"motion", {"geometry"}},
                       {"contact", {"motion", "geometry"}},
                       {"averaging", {"contact", "geometry"}},
                       {"planar", of_engine},
                       {"planar_ranks", of_engine},
                       {"planar_simd", of_engine}};
  const fs::path core = repository / "liggghts-src-ext" / "core";
  const fs::path headers = core / "include" / "rodpack", sources = core / "src";
  const RoomOfInclude room_of = [&](const fs::path& folder, const std::string& path) {
    if (path.compare(0, 8, "rodpack/") == 0 && path.find('/', 8) != std::string::npos)
      return path.substr(8, path.find('/', 8) - 8);
    const fs::path file = (folder / path).lexically_normal();
    return file.parent_path() == sources ? std::string() : file.parent_path().filename().string();
  };
  expect_all_rooms({headers, sources}, rules);
  expect_one_way(headers, rules, room_of);
  expect_one_way(sources, rules, room_of);
}

TEST(Rooms, DependenciesOfTheStylesPointOneWay) {
  const Rules rules = {{"support", {}},
                       {"deck", {"support", "contact"}},
                       {"particles", {"support"}},
                       {"contact", {"support"}},
                       {"motion", {"support", "contact"}},
                       {"measuring", {"support", "contact"}},
                       {"planar", {"support", "contact", "motion"}}};
  const fs::path styles = repository / "liggghts-src-ext" / "styles";
  // LIGGGHTS puts all headers into one folder: they are included by their names alone.
  std::map<std::string, std::string> rooms;
  for (const auto& entry : fs::recursive_directory_iterator(styles))
    if (entry.is_regular_file())
      rooms[entry.path().filename().string()] = entry.path().parent_path().filename().string();
  expect_all_rooms({styles}, rules);
  expect_one_way(styles, rules, [&](const fs::path&, const std::string& name) {
    const auto found = rooms.find(name);
    return found == rooms.end() ? std::string() : found->second;
  });
}

TEST(Rooms, DependenciesOfThePostProcessorPointOneWay) {
  // The analysis knows no picture and no deck, and starts no simulation.
  const Rules rules = {
      {"reading", {}},
      {"programs", {"reading"}},
      {"analysis", {"reading"}},
      {"figures", {"reading", "programs", "analysis"}},
      {"report", {"reading", "analysis", "figures"}},
      {"campaigns", {"reading", "programs", "analysis", "figures"}},
      {"ensemble", {"reading", "analysis"}},
      // campaigns: launch/, which knows where inputs/ is
      {"study", {"reading", "analysis", "figures", "ensemble", "campaigns"}},
      {"page", {"reading", "analysis", "ensemble", "figures", "report"}},
      {"cli",
       {"reading", "analysis", "figures", "report", "ensemble", "study", "page", "campaigns"}}};
  expect_one_way(repository / "postproc", rules, [&](const fs::path&, const std::string& path) {
    const std::string first = path.substr(0, path.find('/'));
    return rules.count(first) ? first : std::string();
  });
}

// A folder has one theme, and can be taken in at a glance.
TEST(Rooms, NoFolderHoldsMoreThan25Files) {
  std::map<fs::path, int> files;
  for (const char* top : {"liggghts-src-ext/core", "liggghts-src-ext/styles", "postproc", "tests"})
    for (const auto& entry : fs::recursive_directory_iterator(repository / top))
      if (entry.is_regular_file() && entry.path().string().find("/corpus/") == std::string::npos)
        ++files[entry.path().parent_path()];  // a corpus is data, read by the fuzzer
  for (const auto& [folder, count] : files) EXPECT_LE(count, 25) << folder.string();
}

}  // namespace

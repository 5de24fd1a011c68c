// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sources.h"

// Dependencies point one way (liggghts-src-ext/doc/background/ARCHITECTURE.md), so that a room can
// be read, tested and replaced without those that use it.
namespace {
namespace fs = std::filesystem;
using namespace rodpack::test;

const fs::path core = "liggghts-src-ext/core";

/// What each room may include besides itself and libraries.
using Rules = std::map<std::string, std::set<std::string>>;
/// The room of an included file, empty for one of no room: by the including file's folder, and the
/// path as it is written.
using RoomOfInclude = std::function<std::string(const fs::path&, const std::string&)>;

void expect_one_way(const fs::path& rooms, const Rules& rules, const RoomOfInclude& room_of) {
  int seen = 0;
  for (const auto& [room, others] : rules) {
    if (!fs::exists(repository / rooms / room)) continue;
    for (const auto& file : sources_below(rooms / room))
      for (const std::string& path : includes_of(file)) {
        const std::string other = room_of(file.parent_path(), path);
        if (other.empty()) continue;
        ++seen;
        EXPECT_TRUE(other == room || others.count(other)) << file.string() << ": " << path;
      }
  }
  EXPECT_GT(seen, 10) << rooms.string() << ": the includes were not found";
}

/// Every room has rules, and every rule its room.
void expect_all_rooms(const std::set<fs::path>& folders, const Rules& rules) {
  std::set<std::string> rooms;
  for (const fs::path& folder : folders)
    for (const auto& entry : fs::directory_iterator(repository / folder))
      if (entry.is_directory()) rooms.insert(entry.path().filename().string());
  std::set<std::string> ruled;
  for (const auto& rule : rules) ruled.insert(rule.first);
  EXPECT_EQ(rooms, ruled);
}

TEST(Rooms, DependenciesOfTheCorePointOneWay) {
  // Neighbour lists, the loops for one kind of processor and the ghosts of other ranks are rooms of
  // the engine.
  const std::set<std::string> of_engine = {"planar",  "planar_lists", "planar_ranks", "planar_simd",
                                           "contact", "motion",       "geometry"};
  const Rules rules = {{"geometry", {}},
                       {"dumps", {}},
                       {"motion", {"geometry"}},
                       {"contact", {"motion", "geometry"}},
                       {"averaging", {"contact", "geometry"}},
                       {"planar", of_engine},
                       {"planar_lists", of_engine},
                       {"planar_ranks", of_engine},
                       {"planar_simd", of_engine}};
  const fs::path headers = core / "include" / "rodpack", sources = core / "src";
  const RoomOfInclude room_of = [&](const fs::path& folder, const std::string& path) {
    if (path.compare(0, 8, "rodpack/") == 0 && path.find('/', 8) != std::string::npos)
      return path.substr(8, path.find('/', 8) - 8);
    const fs::path file = (folder / path).lexically_normal();
    return file.parent_path() == repository / sources ? std::string()
                                                      : file.parent_path().filename().string();
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
                       {"planar", {"support", "contact", "motion", "particles"}}};
  const fs::path styles = "liggghts-src-ext/styles";
  // LIGGGHTS puts all headers into one folder: they are included by their names alone.
  std::map<std::string, std::string> rooms;
  for (const auto& entry : fs::recursive_directory_iterator(repository / styles))
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
      {"timestep", {"reading", "analysis"}},
      {"figures", {"reading", "programs", "analysis"}},
      {"report", {"reading", "analysis", "figures"}},
      {"campaigns/launch", {"reading", "programs"}},
      {"campaigns", {"reading", "programs", "analysis", "figures", "campaigns/launch"}},
      {"ensemble", {"reading", "analysis"}},
      // launch/ knows where inputs/ is
      {"study", {"reading", "analysis", "figures", "ensemble", "campaigns/launch"}},
      {"page", {"reading", "analysis", "ensemble", "figures", "report"}},
      {"cli",
       {"reading", "analysis", "timestep", "figures", "report", "ensemble", "study", "page",
        "campaigns", "campaigns/launch"}}};
  Rules rooms = rules;
  rooms.erase("campaigns/launch");
  rooms.insert({{"doc", {}}, {"python", {}}});
  expect_all_rooms({"postproc"}, rooms);
  expect_one_way("postproc", rules, [&](const fs::path&, const std::string& path) {
    if (path.compare(0, 17, "campaigns/launch/") == 0) return std::string("campaigns/launch");
    const std::string first = path.substr(0, path.find('/'));
    return rules.count(first) ? first : std::string();
  });
}

/// The headers of the engine that a source of it sees, in the way that the compiler finds them.
std::set<std::string> engine_headers_of(const fs::path& source) {
  std::set<std::string> seen;
  std::vector<fs::path> open = {source};
  while (!open.empty()) {
    const fs::path file = open.back();
    open.pop_back();
    for (const std::string& path : includes_of(file)) {
      const fs::path header = (file.parent_path() / path).lexically_normal();
      if (fs::exists(header) && seen.insert(header.stem().string()).second) open.push_back(header);
    }
  }
  return seen;
}

TEST(Rooms, OnlyTheSceneSeesAllPartsOfTheEngine) {
  const std::set<std::string> parts = {"bodies",          "blocks", "events", "neighbours",
                                       "force_evaluator", "ghosts", "halo",   "pipeline"};
  std::set<std::string> with_all;
  for (const char* room : {"planar", "planar_lists", "planar_ranks", "planar_simd"})
    for (const auto& file : sources_below(core / "src" / room)) {
      const auto seen = engine_headers_of(file);
      if (std::includes(seen.begin(), seen.end(), parts.begin(), parts.end()))
        with_all.insert(file.filename().string());
    }
  EXPECT_EQ(with_all, std::set<std::string>{"scene.cpp"});
}

TEST(Rooms, TheHaloIsCompiledWithoutListsBlocksAndForces) {
  const auto seen = engine_headers_of(repository / core / "src/planar_ranks/halo.cpp");
  EXPECT_TRUE(seen.count("bodies") && seen.count("events"));
  for (const char* part : {"blocks", "neighbours", "candidates", "grid", "force_evaluator"})
    EXPECT_EQ(seen.count(part), 0u) << part;
}

// A public header is for others: they include it, or one that needs it.
TEST(Rooms, EveryPublicHeaderHasAUserOutsideTheCore) {
  const fs::path include = core / "include";
  std::set<fs::path> used;
  std::vector<fs::path> open;
  const auto use = [&](const fs::path& header) {
    if (fs::exists(header) && used.insert(header).second) open.push_back(header);
  };
  for (const char* folder : {"liggghts-src-ext/styles", "liggghts-src-ext/vtk", "postproc"})
    for (const auto& file : sources_below(folder))
      for (const std::string& path : includes_of(file)) use(repository / include / path);
  while (!open.empty()) {
    const fs::path header = open.back();
    open.pop_back();
    for (const std::string& path : includes_of(header))
      use((header.parent_path() / path).lexically_normal());
  }
  EXPECT_GT(used.size(), 20u);
  for (const auto& header : sources_below(include)) EXPECT_EQ(used.count(header), 1u) << header;
}

TEST(Rooms, TheMapInTheReadmeNamesEveryRoom) {
  std::string map;
  for (const std::string& line : lines_of(repository / "README.md")) map += line + '\n';
  int rooms = 0;
  for (const char* top : {"inputs", "liggghts-src-ext", "postproc", "tests"})
    for (const auto& entry : fs::directory_iterator(repository / top)) {
      if (!entry.is_directory()) continue;
      ++rooms;
      const std::string name = entry.path().filename().string();
      EXPECT_NE(map.find("`" + name + "/`"), std::string::npos) << top << '/' << name;
    }
  EXPECT_GT(rooms, 30);
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

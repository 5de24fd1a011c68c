// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "sources.h"

// A reader has to be able to tell words apart and to look them up.
namespace {
using namespace rodpack::test;

/// Names of classes in the code of a line; they begin with a capital letter here.
std::vector<std::string> types_named_in(std::string line) {
  line = line.substr(0, line.find("//"));
  if (line.find("template") != std::string::npos) return {};  // its parameters are no types
  for (char& letter : line)
    if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '_') letter = ' ';
  std::istringstream words(line);
  std::vector<std::string> types;
  std::string before;
  for (std::string word; words >> word; before = word) {
    if (word == "alignas") words >> word >> word;  // and its number
    if ((before == "class" || before == "struct") &&
        std::isupper(static_cast<unsigned char>(word[0])))
      types.push_back(word);
  }
  return types;
}

std::set<std::string> types_below(const std::vector<std::string>& folders) {
  std::set<std::string> types;
  for (const std::string& folder : folders)
    for (const auto& file : sources_below(folder))
      for (const std::string& line : lines_of(file))
        for (const std::string& type : types_named_in(line)) types.insert(type);
  return types;
}

TEST(Words, NoTwoTypesDifferByAnS) {
  const auto types = types_below({"liggghts-src-ext", "postproc"});
  EXPECT_THAT(types, testing::IsSupersetOf({"PlanarScene", "Frame", "NormalHistory"}));
  for (const std::string& type : types) EXPECT_EQ(types.count(type + "s"), 0u) << type;
}

// Each set of SIMD instructions has a header of its own, one of which a source includes.
TEST(Words, NoTwoHeadersDefineATypeOfTheSameName) {
  const std::regex definition(
      R"(^(class|struct|enum class|enum) (alignas\(\d+\) )?([A-Z]\w*)( final)?( :.*| \{.*)$)");
  std::map<std::string, std::string> header_of;
  for (const char* folder : {"liggghts-src-ext", "postproc"})
    for (const auto& file : sources_below(folder)) {
      if (file.extension() != ".h" || file.filename().string().rfind("lanes_", 0) == 0) continue;
      for (const std::string& line : lines_of(file)) {
        std::smatch found;
        if (!std::regex_match(line, found, definition)) continue;
        const auto other = header_of.emplace(found.str(3), file.string());
        EXPECT_TRUE(other.second) << found.str(3) << ": " << other.first->second << ", " << file;
      }
    }
  EXPECT_GT(header_of.size(), 200u);
}

TEST(Words, EveryTypeOfTheEngineStandsInTheGlossary) {
  std::set<std::string> explained;
  for (std::string line : lines_of(repository / "liggghts-src-ext/doc/background/glossary.md")) {
    for (char& letter : line)
      if (!std::isalnum(static_cast<unsigned char>(letter))) letter = ' ';
    std::istringstream words(line);
    for (std::string word; words >> word;) explained.insert(word);
  }
  int seen = 0;
  const std::string core = "liggghts-src-ext/core/";
  for (const std::string& type :
       types_below({core + "include/rodpack/planar", core + "src/planar", core + "src/planar_lists",
                    core + "src/planar_ranks", core + "src/planar_simd"}))
    if (type.compare(0, 6, "Planar") == 0) {
      ++seen;
      EXPECT_EQ(explained.count(type), 1u) << type;
    }
  EXPECT_GT(seen, 30);
}

}  // namespace

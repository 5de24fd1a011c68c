// SPDX-License-Identifier: GPL-2.0-or-later
// Names of files and folders are names: never read by a shell, never taken for a pattern or an
// option where there is a file of that name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_run.h"
#include "reading/dump.h"
#include "programs/run_program.h"
#include "reading/wildcard.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

// Names that a shell, glob, gnuplot or the command line would read in another way.
const std::vector<std::string> odd_names{
    "run[1]",     "a b", "$(touch hit)", "`touch hit`", "x;touch hit",  "it's", "\"q\"", "*",
    "|touch hit", "-o",  "--help",       "\\n",         "%d & > hit #", "~",    "ä€"};

SyntheticPacking packing_of(double side, unsigned seed = 1) {
  SyntheticPacking packing;
  packing.width = packing.height = side;
  packing.seed = seed;
  packing.fill();
  return packing;
}

int rodpack_in(const fs::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), RODPACK_BIN "/rodpack");
  return run_program(words, {"", folder.string(), (folder / "said.txt").string(), {}});
}

std::string said(const fs::path& folder) {
  std::ifstream in(folder / "said.txt");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(FileNames, AWholeRunMayHaveAnyName) {
  const auto packing = packing_of(0.15);
  const std::string all = "a [1]*$(touch hit)`touch hit`;touch hit;'\"|~";
  for (const auto& name : {all, std::string("-o"), std::string("|touch hit")}) {
    const auto folder = fresh_folder();
    packing.write_run(folder / name);
    EXPECT_EQ(rodpack_in(folder, {"analyse", "--", name}), 0) << name << ": " << said(folder);
    EXPECT_TRUE(fs::exists(folder / name / "analysis" / "summary.json")) << name;
    EXPECT_TRUE(fs::exists(folder / name / "analysis" / "packing.png")) << name;
    EXPECT_TRUE(fs::exists(folder / name / "analysis" / "rdf.svg")) << name;
    EXPECT_FALSE(fs::exists(folder / "hit")) << name;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2) << name;
  }
}

TEST(FileNames, DumpsAndPicturesMayHaveAnyName) {
  const auto spheres = packing_of(0.03).spheres_frame(1);
  for (const auto& name : odd_names) {
    const auto folder = fresh_folder();
    put(folder / name, spheres);
    EXPECT_EQ(rodpack_in(folder, {"render", "--output=" + name + "_", "--", name}), 0)
        << name << ": " << said(folder);
    EXPECT_TRUE(fs::exists(folder / (name + "_.png"))) << name << ": " << said(folder);
    EXPECT_FALSE(fs::exists(folder / "hit")) << name;
  }
}

TEST(FileNames, FiguresByGnuplotMayHaveAnyName) {
  const auto folder = fresh_folder();
  put(folder / "bodies", packing_of(0.15).bodies_frame(1));
  for (const std::string name : {"|touch hit;", "`touch hit`", "it's \"q\" %d", "-o"}) {
    EXPECT_EQ(rodpack_in(folder, {"orientation", "--output=" + name, "bodies"}), 0)
        << name << ": " << said(folder);
    EXPECT_TRUE(fs::exists(folder / (name + ".png"))) << name;
    EXPECT_TRUE(fs::exists(folder / (name + "_polar.svg"))) << name;
    EXPECT_FALSE(fs::exists(folder / "hit")) << name;
  }
}

// run[1] as a pattern is run1: another run.
TEST(FileNames, AFolderWithBracketsIsNotTakenForAnother) {
  const auto folder = fresh_folder();
  packing_of(0.15).write_run(folder / "run[1]");
  packing_of(0.3).write_run(folder / "run1");
  ASSERT_EQ(rodpack_in(folder, {"analyse", "run[1]"}), 0) << said(folder);
  EXPECT_TRUE(fs::exists(folder / "run[1]/analysis/summary.json"));
  EXPECT_FALSE(fs::exists(folder / "run1/analysis"));
  EXPECT_THAT(said(folder), HasSubstr("particles: 500\n"));
  ASSERT_EQ(rodpack_in(folder, {"orientation", "run[1]/dumps/bodies.*.dump"}), 0) << said(folder);
  EXPECT_THAT(said(folder), HasSubstr("run[1]/parameters.json"));
  ASSERT_EQ(rodpack_in(folder, {"analyse", "run[2]"}), 1);
  EXPECT_EQ(said(folder), "rodpack: run[2]: no such run folder\n");
}

TEST(Wildcards, ANameThatExistsComesBeforeAPattern) {
  const auto folder = fresh_folder();
  const auto at = [&](const std::string& name) { return (folder / name).string(); };
  for (const std::string name : {"a1", "a2", "a[1]", "d*/x", "d1/x", "d1/.hidden"})
    put(folder / name, "");
  EXPECT_THAT(files_matching(at("a[1]")), ElementsAre(at("a[1]")));
  EXPECT_THAT(files_matching(at("a[12]")), ElementsAre(at("a1"), at("a2")));
  EXPECT_THAT(files_matching(at("a?")), ElementsAre(at("a1"), at("a2")));
  EXPECT_THAT(files_matching(at("d*/*")), ElementsAre(at("d*/x")));
  EXPECT_THAT(files_matching(at("d?/*")), ElementsAre(at("d*/x"), at("d1/x")));
  EXPECT_THAT(files_matching(at("none*")), ElementsAre());
  EXPECT_THAT(files_matching(at("none/*")), ElementsAre());
}

TEST(RunProgram, WordsArriveAsTheyAreAndTheEndIsTold) {
  const auto folder = fresh_folder();
  const auto out = (folder / "out").string();
  const auto content = [&] {
    std::ifstream in(out);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  EXPECT_EQ(run_program({"printf", "%s|", "a b", "$(touch hit)", "'"}, {"", "", out, {}}), 0);
  EXPECT_EQ(content(), "a b|$(touch hit)|'|");
  EXPECT_EQ(run_program({"cat"}, {"input", folder.string(), out, {}}), 0);
  EXPECT_EQ(content(), "input");
  EXPECT_EQ(run_program({"printenv", "RODPACK_TEST"}, {"", "", out, {{"RODPACK_TEST", "a;b"}}}), 0);
  EXPECT_EQ(content(), "a;b\n");
  EXPECT_EQ(run_program({"false"}), 1);
  EXPECT_EQ(run_program({"no-such-program-here"}), 127);
  EXPECT_EQ(run_program({"no-such-program-here"}, {"", folder.string(), "", {}}), 127);
  EXPECT_EQ(run_program({"sh", "-c", "kill -TERM $$"}), 128 + 15);
}

}  // namespace

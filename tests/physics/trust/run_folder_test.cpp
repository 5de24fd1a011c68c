// SPDX-License-Identifier: GPL-2.0-or-later
// A run folder belongs to one run at a time; the command line of a deck means what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;
using testing::Not;

namespace {

namespace fs = std::filesystem;
using Vars = std::map<std::string, std::string>;

const std::string deck = "deposition/in.deposition";

Vars small(const Vars& changes = {}) {
  Vars vars = {{"particles", "12"},
               {"width_in_lengths", "5"},
               {"particles_per_line", "4"},
               {"container_height", "0.12"},
               {"out", "run"},
               {"relaxation_ratio", "1e-4"},
               {"restart_interval", "0.05"},
               {"output_interval", "0.04"}};
  for (const auto& [name, value] : changes) vars[name] = value;
  return vars;
}

/// The program with words of a command line as they stand.
Run with_words(const std::string& words) {
  return run_command("'" RODPACK_BIN "/liggghts' -log none -in '" RODPACK_REPOSITORY "/inputs/" +
                     deck + "' " + words);
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    files[entry.path().filename().string()] = text_of(entry.path());
  return files;
}

}  // namespace

// LIGGGHTS makes the folder of a dump anew: the result would stand there, without the run.
TEST(RunFolder, HasNoResultWhereItWasMovedAway) {
  const std::string open = "run_folder open run dumps\n",
                    write = "run_folder write run/result.json x\n";
  const auto whole = run_liggghts(open + write);
  EXPECT_EQ(whole.exit_code, 0) << whole.output;
  EXPECT_EQ(text_of(whole.folder / "run" / "result.json"), "x\n");
  for (const char* then : {"shell mkdir run\n", "", "shell mkdir run\nrun_folder open other\n"}) {
    const auto moved = run_liggghts(open + "shell mv run away\n" + then + write);
    EXPECT_NE(moved.exit_code, 0);
    EXPECT_THAT(moved.output, HasSubstr("run_folder write run/result.json: this is no longer the "
                                        "folder that was opened, which was moved or removed"));
    EXPECT_FALSE(fs::exists(moved.folder / "run" / "result.json"));
  }
}

TEST(RunFolder, WordsOfTheCommandLineThatMeanNothingAreRefused) {
  const std::pair<const char*, const char*> cases[] = {
      {"-var seed 1 -var seed 2", "'seed' is given twice on the command line, as '1' and '2'"},
      {"-var seed 5 6 7", "'seed': '6' follows its value '5' on the command line"},
      {"-var seed 5 stray -var particles 3", "'seed': 'stray' follows its value '5'"},
      {"-var speed 5", "unknown deck parameter 'speed'"},
      {"-var out 'x;touch y'", "parameter 'out': expected a path without blanks"},
      {"-var out 'run[1] b'", "parameter 'out': expected a path without blanks"},
      {"-var out '$(touch y)'", "parameter 'out': expected a path without blanks"},
      {"-var out '-x'", "parameter 'out': expected a path"}};
  for (const auto& [words, message] : cases) {
    const auto run = with_words(words);
    EXPECT_NE(run.exit_code, 0) << words;
    EXPECT_THAT(run.output, HasSubstr(message)) << words;
    EXPECT_FALSE(fs::exists(run.folder / "y")) << words;
    EXPECT_FALSE(fs::exists(run.folder / "results")) << words;
  }
}

// What a table of arguments does not tell (keyword_sweep_test.cpp): the verb, and folders that are
// not there.
TEST(RunFolder, WhatItCannotDoIsOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"run_folder",
       "run_folder: value of the first word is missing, expected open, resume or write"},
      {"run_folder close run",
       "run_folder: the first word is 'close', expected open, resume or write"},
      {"run_folder resume nosuch in.deck",
       "run_folder resume nosuch: no folder that 'run_folder open' has opened"},
      {"run_folder open in.deck/sub", "run_folder open in.deck/sub: in.deck is no folder"},
      {"run_folder write nosuch/file text",
       "run_folder write nosuch/file: cannot write nosuch/file.part: No such file or directory"}};
  for (const auto& [command, message] : cases) {
    const auto run = run_liggghts(std::string(command) + "\n");
    EXPECT_EQ(run.exit_code, 1) << command;
    EXPECT_THAT(run.output, HasSubstr(std::string("ERROR: ") + message)) << command;
  }
}

TEST(RunFolder, BelongsToOneRunAtATime) {
  const auto run = run_command(
      "mkdir run; flock run/.lock sleep 60 & sleep 0.3; echo 'process 7 on there' > run/.lock;"
      "'" RODPACK_BIN "/liggghts' -log none -in '" RODPACK_REPOSITORY "/inputs/" +
      deck + "' -var out run; status=$?; kill $!; echo \"status $status\"; ls run");
  EXPECT_THAT(run.output, HasSubstr("ERROR: run_folder open run: another run is at work in it: "
                                    "process 7 on there"));
  EXPECT_THAT(run.output, HasSubstr("status 1"));
  EXPECT_THAT(run.output, Not(HasSubstr("parameters.json")));
}

// Resumed in the middle, the run folder is that of a run that was never interrupted: energies and
// dumps to the last bit, no row twice, nothing of the longer past.
TEST(RunFolder, AfterAResumeHoldsEachStepOnceAndTheSameBits) {
  const auto whole = run_liggghts(deck, small());
  ASSERT_EQ(whole.exit_code, 0) << whole.output;
  const fs::path run = whole.folder / "run";
  const auto dumps = files_of(run / "dumps");
  const std::string energies = text_of(run / "energies.csv"), result = text_of(run / "result.json");
  ASSERT_GE(dumps.size(), 12u);

  std::set<long> steps;
  for (const auto& [name, text] : files_of(run / "restart"))
    if (name.rfind("deposition.end", 0) != 0) steps.insert(std::stol(name.substr(11)));
  ASSERT_GE(steps.size(), 3u);
  const std::string middle = std::to_string(*std::next(steps.begin(), 1));
  // A dump of a past that ran on with another interval, and one that was being written.
  std::ofstream(run / "dumps/bodies.99999999.dump") << "ITEM: TIMESTEP\n";
  std::ofstream(run / "dumps/scene.99999999.json") << "{}\n";
  std::ofstream(run / "dumps/bodies.7.dump.part") << "ITEM: TIMESTEP\n";
  const auto resumed = run_liggghts_in(
      whole.folder, deck, small({{"resume", "run/restart/deposition." + middle + ".restart"}}));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_EQ(text_of(run / "energies.csv"), energies);
  EXPECT_EQ(text_of(run / "result.json"), result);
  const auto after = files_of(run / "dumps");
  EXPECT_EQ(after.size(), dumps.size());
  for (const auto& [name, text] : dumps)
    EXPECT_EQ(after.count(name) ? after.at(name) : "", text) << name;
}

TEST(RunFolder, ARestartFileOfAnotherRunIsRefused) {
  const auto one = run_liggghts(deck, small());
  ASSERT_EQ(one.exit_code, 0) << one.output;
  const auto two = run_liggghts_in(one.folder, deck, small({{"seed", "2"}, {"out", "other"}}));
  ASSERT_EQ(two.exit_code, 0) << two.output;
  const std::string energies = text_of(one.folder / "run/energies.csv");
  const auto mixed = run_liggghts_in(one.folder, deck,
                                     small({{"resume", "other/restart/deposition.end.restart"}}));
  EXPECT_NE(mixed.exit_code, 0);
  EXPECT_THAT(mixed.output,
              HasSubstr("ERROR: parameter 'seed': expected as in the restart file, 2, got 1"));
  EXPECT_EQ(text_of(one.folder / "run/energies.csv"), energies);
  EXPECT_TRUE(fs::exists(one.folder / "run/result.json"));
}

// What two ranks began four go on with: to a bed at rest, of the same particles.
TEST(RunFolder, FourRanksGoOnWithWhatTwoBegan) {
  const Vars vars =
      small({{"particles", "60"}, {"particles_per_line", "6"}, {"width_in_lengths", "8"}});
  auto first = vars;
  first["relaxation_limit"] = "0.01";  // stops before the bed is at rest, with a restart file
  const auto two = run_liggghts(deck, first, 2);
  ASSERT_TRUE(fs::exists(two.folder / "run/restart/deposition.end.restart")) << two.output;
  auto second = vars;
  second["resume"] = "run/restart/deposition.end.restart";
  const auto four = run_liggghts_in(two.folder, deck, second, 4);
  EXPECT_EQ(four.exit_code, 0) << four.output;
  EXPECT_TRUE(fs::exists(two.folder / "run/result.json"));
}

// SPDX-License-Identifier: GPL-2.0-or-later
// A restart file is whole and of this run, or refused with one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;
using testing::Not;

namespace {

namespace fs = std::filesystem;

const std::string parameters = R"(parameter seed integer 1 minimum 1
parameter out text here path
)";

std::string written() {
  const auto run = run_liggghts(parameters + Deck().with(R"(
create_atoms 1 single 0.05 0.05 0 units box
create_atoms 1 single 0.06 0.05 0 units box
set group all diameter 0.003 density 2500
fix move all nve/sphere
run 10
write_restart r.restart
)"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return text_of(run.folder / "r.restart");
}

Run read(const std::string& content, const std::string& words = "", const std::string& after = "",
         const std::map<std::string, std::string>& vars = {}) {
  const fs::path folder = fresh_folder();
  std::ofstream(folder / "r.restart", std::ios::binary) << content;
  return run_liggghts_in(
      folder,
      parameters + Deck().restart("r.restart " + words).with(after + "\nprint \"was read\"\n"),
      vars);
}

void expect_refused(const std::string& content, const std::string& what) {
  const auto run = read(content);
  EXPECT_NE(run.exit_code, 0) << what;
  EXPECT_THAT(run.output, HasSubstr("ERROR on proc 0: Restart file r.restart ")) << what;
  EXPECT_THAT(run.output, Not(HasSubstr("was read"))) << what;
}

}  // namespace

TEST(RestartSeal, AWholeFileIsReadAndOneThatIsCutOrFlippedIsRefused) {
  const std::string whole = written();
  ASSERT_GT(whole.size(), 500u);
  EXPECT_THAT(read(whole).output, HasSubstr("was read"));
  std::mt19937 random(1);
  const auto below = [&](std::size_t size) {
    return std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
  };
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{16}, std::size_t{100}, below(whole.size()),
        whole.size() - 62, whole.size() - 61, whole.size() - 1})
    expect_refused(whole.substr(0, size), "cut to " + std::to_string(size));
  for (int k = 0; k < 8; ++k) {
    std::string flipped = whole;
    const std::size_t at = k == 0 ? whole.size() - 30 : k == 1 ? 0 : below(whole.size());
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << below(8)));
    expect_refused(flipped, "flipped at " + std::to_string(at));
  }
  expect_refused(std::string(whole.size(), '\0'), "zeros");
  expect_refused(whole + '\0', "longer");
}

// Files of other LIGGGHTSs have none; whoever knows that says so.
TEST(RestartSeal, AFileWithoutASealIsReadOnRequestAlone) {
  const std::string whole = written();
  const std::string bare = whole.substr(0, whole.find("\"seed\": "));
  expect_refused(bare, "no seal");
  EXPECT_THAT(read(bare).output, HasSubstr("has no seal at its end"));
  EXPECT_THAT(read(bare, "unsealed").output, HasSubstr("was read"));
  std::string flipped = whole;
  flipped[200] = static_cast<char>(flipped[200] ^ 1);
  EXPECT_THAT(read(flipped, "unsealed").output, HasSubstr("is damaged"));
}

TEST(RestartSeal, TheParametersOfTheRunThatWroteItAreCompared) {
  const std::string whole = written();
  const std::string compare = "parameter compare restart except out";
  EXPECT_THAT(read(whole, "", compare).output, HasSubstr("was read"));
  EXPECT_THAT(read(whole, "", compare, {{"out", "there"}}).output, HasSubstr("was read"));
  const auto other = read(whole, "", compare, {{"seed", "2"}});
  EXPECT_NE(other.exit_code, 0);
  EXPECT_THAT(other.output,
              HasSubstr("ERROR: parameter 'seed': expected as in the restart file, 1, got 2"));
}

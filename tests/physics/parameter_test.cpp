// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "liggghts_run.h"
#include "rodpack/version.h"

using namespace rodpack::test;

namespace {

const std::string deck = R"(
parameter preset choice paper quick
if "${preset_is_quick} == 1" then "variable particles index 250"
parameter particles integer 9000 minimum 1
parameter timestep real 1.1e-5 above 0 unit s
parameter overlap real .5 minimum 0 below 1
parameter resume text none
parameter check
parameter write parameters.json
print "particles=${particles} paper=${preset_is_paper} resume=${resume_given}"
)";

void expect_error(const std::map<std::string, std::string>& vars, const std::string& message) {
  const auto run = run_liggghts(deck, vars);
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("ERROR: " + message), std::string::npos) << run.output;
  EXPECT_FALSE(std::filesystem::exists(run.folder / "parameters.json"));
}

}  // namespace

TEST(ParameterCommand, TakesDefaultThenPresetThenCommandLine) {
  EXPECT_NE(run_liggghts(deck).output.find("particles=9000 paper=1 resume=0"), std::string::npos);
  EXPECT_NE(run_liggghts(deck, {{"preset", "quick"}}).output.find("particles=250 paper=0"),
            std::string::npos);
  EXPECT_NE(run_liggghts(deck, {{"preset", "quick"}, {"particles", "7"}, {"resume", "a.restart"}})
                .output.find("particles=7 paper=0 resume=1"),
            std::string::npos);
}

TEST(ParameterCommand, WritesJsonNumbersAndStrings) {
  const auto run = run_liggghts(deck);
  EXPECT_EQ(text_of(run.folder / "parameters.json"),
            "{\n  \"format\": \"rodpack-run 1\",\n  \"rodpack\": {\"version\": \"" +
                std::string(rodpack::version()) + "\", \"commit\": \"" + rodpack::commit() +
                "\"},\n  \"preset\": \"paper\",\n  \"particles\": 9000,\n"
                "  \"timestep_s\": 1.1e-05,\n  \"overlap\": 0.5,\n  \"resume\": \"none\"\n}\n");
}

TEST(ParameterCommand, TellsADeckWhichRodpackItRunsWith) {
  const std::string expected = std::string("{\"version\": \"") + rodpack::version() +
                               "\", \"commit\": \"" + rodpack::commit() + "\"}";
  const auto run = run_liggghts("parameter version\nprint '${rodpack}'\n");
  EXPECT_NE(run.output.find("\n" + expected + "\n"), std::string::npos) << run.output;
}

TEST(Program, NamesTheRodpackInItsBanner) {
  const std::string banner = std::string("LIGGGHTS-PUBLIC 3.8.0 with rodpack ") +
                             rodpack::version() + " (" + rodpack::commit() + ")";
  const auto run = run_liggghts("print begun\n");
  EXPECT_NE(run.output.find(banner), std::string::npos) << run.output;
}

TEST(ParameterCommand, NamesTheWrongValueAndWhatWasExpected) {
  expect_error({{"preset", "fast"}}, "parameter 'preset': value 'fast' is none of: paper quick");
  expect_error({{"particles", "1.5"}}, "parameter 'particles': expected an integer, got '1.5'");
  expect_error({{"particles", "0"}}, "parameter 'particles': expected minimum 1, got 0");
  expect_error({{"overlap", "1"}}, "parameter 'overlap': expected below 1, got 1");
  expect_error({{"timestep", "nan"}}, "parameter 'timestep': expected a number, got 'nan'");
  expect_error({{"timestep", "1e-5s"}}, "parameter 'timestep': expected a number, got '1e-5s'");
}

// The deposition's step under mass scaling, without mass scaling: a name that the user can set.
TEST(ParameterCommand, SaysWhyThereIsNoAutomaticValue) {
  const auto run = run_liggghts("deposition/in.deposition", {{"timestep", "auto"}, {"out", "run"}});
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("ERROR: parameter 'timestep': value 'auto' needs mass_scaling of at "
                            "least 1, got 0"),
            std::string::npos)
      << run.output;
  EXPECT_FALSE(std::filesystem::exists(run.folder / "run"));
}

TEST(ParameterCommand, RefusesAVariableNobodyDeclared) {
  expect_error({{"partciles", "12"}}, "unknown deck parameter 'partciles' on the command line");
}

TEST(ParameterCommand, NeverOverwritesARun) {
  const auto run = run_liggghts("print 'kept' file parameters.json\n" + deck);
  EXPECT_NE(run.exit_code, 0);
  EXPECT_NE(run.output.find("'parameters.json' exists already"), std::string::npos);
  EXPECT_EQ(text_of(run.folder / "parameters.json"), "kept\n");
}

TEST(ParameterCommand, ComparesWithTheParametersOfARun) {
  const auto first = run_liggghts(deck, {{"particles", "12"}});
  std::string again = deck;
  again.replace(again.find("write"), 5, "compare");
  const auto compare = [&](const std::map<std::string, std::string>& vars) {
    return run_liggghts_in(first.folder, again, vars);
  };
  EXPECT_EQ(compare({{"particles", "12"}, {"timestep", "11e-6"}}).exit_code, 0);
  const auto other = compare({});
  EXPECT_NE(other.exit_code, 0);
  EXPECT_NE(
      other.output.find("parameter 'particles': expected as in 'parameters.json', 12, got 9000"),
      std::string::npos)
      << other.output;

  again.replace(again.find("parameters.json"), 15, "parameters.json except particles");
  EXPECT_EQ(compare({}).exit_code, 0);

  // rodpack 0.1 did not write its version.
  std::string old = text_of(first.folder / "parameters.json");
  const auto version = old.find("  \"rodpack\"");
  ASSERT_NE(version, std::string::npos) << old;
  old.erase(version, old.find('\n', version) + 1 - version);
  std::ofstream(first.folder / "parameters.json") << old;
  EXPECT_EQ(compare({}).exit_code, 0);

  std::filesystem::remove(first.folder / "parameters.json");
  EXPECT_NE(compare({}).output.find("cannot read 'parameters.json'"), std::string::npos);
}

// From another folder than the deck's, in one with a blank in its name, also from an included file.
TEST(ParameterCommand, IncludesFilesBesideTheDeckOnOneAndTwoRanks) {
  const auto folder = fresh_folder();
  const auto decks = folder / "my decks";
  std::filesystem::create_directories(decks / "common");
  std::ofstream(decks / "common/inner.in") << "parameter size real 5\nprint 'inner'\n";
  std::ofstream(decks / "common/outer.in")
      << "parameter include common/inner.in\nprint 'outer ${size}'\n";
  std::ofstream(decks / "in.deck") << "parameter include common/outer.in\nparameter check\n"
                                      "print 'deck ${size}'\n";
  const std::string program = std::string("'") + RODPACK_BIN "/liggghts' -log none -in '" +
                              (decks / "in.deck").string() + "' -var size 7";
  for (const std::string start : {"",
                                  "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
                                  "mpirun --oversubscribe -np 2 "}) {
    const auto run = run_command(start + program, folder);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    for (const char* said : {"\ninner\n", "\nouter 7\n", "\ndeck 7\n"})
      EXPECT_NE(run.output.find(said), std::string::npos) << run.output;
  }
}

TEST(ParameterCommand, TellsTheFolderOfTheDeckOrSaysWhyNot) {
  const auto run = run_liggghts("parameter folder\nprint 'in ${deck_folder}.'\n");
  EXPECT_NE(run.output.find("\nin " + run.folder.string() + "/.\n"), std::string::npos)
      << run.output;
  const auto here = run_command("'" RODPACK_BIN "/liggghts' -in in.deck", run.folder);
  EXPECT_NE(here.output.find("\nin ./.\n"), std::string::npos) << here.output;
  const auto piped = run_command("'" RODPACK_BIN "/liggghts' < in.deck", run.folder);
  EXPECT_NE(piped.exit_code, 0);
  EXPECT_NE(piped.output.find("parameter folder: expected the deck on the command line, as -in"),
            std::string::npos)
      << piped.output;
  const auto absent = run_liggghts("parameter include nowhere.in\nprint 'went on'\n");
  EXPECT_NE(absent.exit_code, 0);
  EXPECT_NE(absent.output.find("parameter include nowhere.in: cannot read '"), std::string::npos)
      << absent.output;
  EXPECT_EQ(absent.output.find("\nwent on"), std::string::npos);
}

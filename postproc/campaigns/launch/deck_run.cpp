// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/launch/deck_run.h"

#include <signal.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "reading/data_error.h"
#include "programs/run_program.h"
#include "reading/text_file.h"

namespace rodpack {

namespace fs = std::filesystem;

namespace {

/// Finds the line that says what went wrong: the first that starts with ERROR, else the last one.
std::string error_line(const std::string& output) {
  std::istringstream lines(output);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (line.rfind("ERROR", 0) == 0) return line;
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace

std::string liggghts_beside_this_program() {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "liggghts";
  if (!fs::exists(program))
    throw DataError("no " + program.string() +
                    ": this build holds the post-processor only; name a program with --liggghts");
  return program.string();
}

int run_liggghts(const Liggghts& liggghts, const std::string& deck, const DeckVariables& variables,
                 const std::string& folder) {
  ProgramSurroundings surroundings;
  surroundings.folder = folder;
  surroundings.output = (fs::absolute(folder) / "output.txt").string();
  // Each run has a session folder of its own: in the common one, runs that start and end side by
  // side make and remove it under each other's feet.
  surroundings.variables["OMPI_MCA_orte_tmpdir_base"] = fs::absolute(folder).string();
  std::vector<std::string> words;
  if (liggghts.ranks > 1) {
    surroundings.variables["OMPI_ALLOW_RUN_AS_ROOT"] = "1";
    surroundings.variables["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1";
    surroundings.variables["OMPI_MCA_btl_vader_single_copy_mechanism"] = "none";
    // Several ranks may share a core here, and runs go on side by side: no binding to cores.
    words = {liggghts.mpiexec,
             "--oversubscribe",
             "--bind-to",
             "none",
             "-np",
             std::to_string(liggghts.ranks)};
  } else {
    // A single process needs no daemon of Open MPI's, whose start takes as long as many a deck.
    surroundings.variables["OMPI_MCA_ess_singleton_isolated"] = "1";
  }
  // LIGGGHTS prints an error just before MPI_Abort: without line buffering it would be lost.
  for (const auto& word :
       {std::string("stdbuf"), std::string("-oL"), liggghts.program, std::string("-in"), deck})
    words.push_back(word);
  for (const auto& [name, value] : variables)
    for (const auto& word : {std::string("-var"), name, value}) words.push_back(word);
  return run_program(words, surroundings);
}

std::string run_deck(const Liggghts& liggghts, const std::string& deck,
                     const DeckVariables& variables, const std::string& folder) {
  if (!fs::exists(deck)) throw DataError("no deck " + deck);
  fs::create_directories(folder);
  // The working folder is another; what is no file here is looked for in PATH.
  Liggghts from_there = liggghts;
  if (fs::exists(liggghts.program)) from_there.program = fs::absolute(liggghts.program).string();
  const int exit_code = run_liggghts(from_there, fs::absolute(deck).string(), variables, folder);
  const std::string output = read_text((fs::path(folder) / "output.txt").string());
  if (exit_code == 128 + SIGINT || exit_code == 128 + SIGTERM)
    throw DataError("interrupted while " + deck + " ran in " + folder);
  if (exit_code != 0)
    throw DataError(deck + " in " + folder + ": exit code " + std::to_string(exit_code) + ": " +
                    error_line(output));
  return output;
}

}  // namespace rodpack

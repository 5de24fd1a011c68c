// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_folder.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "comm.h"
#include "input.h"
#include "memory.h"
#include "run_files.h"
#include "stop_run.h"
#include "style_arguments.h"
#include "update.h"

using namespace LAMMPS_NS;

namespace {

std::string path(StyleArguments& arguments, const std::string& name) {
  std::string text = arguments.word(name, a_plain_path);
  if (!is_plain_path(text)) arguments.reject(name, a_plain_path, text);
  return text;
}

}  // namespace

void RunFolder::command(int narg, char** arg) {
  StyleArguments verbs(lmp, "run_folder", narg, arg, 0);
  const std::string verb = verbs.peek();
  verbs.choice("the first word", {"open", "resume", "write"});
  StyleArguments arguments(lmp, "run_folder " + verb, narg, arg, 1);
  const std::string name = path(arguments, verb == "write" ? "FILE" : "FOLDER");
  std::string fault;
  if (verb == "open") {
    std::vector<std::string> parts;
    while (arguments.more()) parts.push_back(path(arguments, "SUBFOLDER"));
    if (comm->me == 0) fault = open(name, parts);
  } else if (verb == "resume") {
    const std::string restart = path(arguments, "RESTART_FILE");
    arguments.require_end();
    const bool missing = comm->me == 0 && !std::ifstream(restart);
    stop_run_by_rank_0(lmp, missing ? "run_folder resume: RESTART_FILE is '" + restart +
                                          "', expected a file that can be read"
                                    : "");
    if (comm->me == 0) fault = resume(name, restart);
  } else {
    const std::string text = arguments.word("TEXT", "a line");
    arguments.require_end();
    // Ranks other than 0 have variables to work out, too, which computes may need.
    const std::string line = substituted(text) + "\n";
    if (comm->me == 0) fault = write_whole(name, line);
  }
  if (!fault.empty()) fault = "run_folder " + verb + " " + name + ": " + fault;
  stop_run_by_rank_0(lmp, fault);
}

std::string RunFolder::open(const std::string& folder,
                            const std::vector<std::string>& parts) const {
  std::string fault = make_folder(folder);
  // The ranks of a run that was killed may take as long to go.
  if (fault.empty()) fault = lock_folder(folder, 5.0);
  for (const std::string& part : parts) {
    std::string whole = folder;
    whole.append("/").append(part);
    if (fault.empty()) fault = make_folder(whole);
  }
  return fault;
}

std::string RunFolder::resume(const std::string& folder, const std::string& restart) const {
  const long long step = update->ntimestep;
  if (!std::ifstream(folder + "/.lock")) return "no folder that 'run_folder open' has opened";
  std::string fault = remove_unfinished(folder);
  for (const char* part : {"/dumps", "/silo", "/collector", "/restart"})
    if (fault.empty()) fault = remove_unfinished(folder + part);
  for (const char* table : {"/energies.csv", "/discharge.csv", "/flow.csv"})
    if (fault.empty()) fault = cut_table(folder + table, step);
  for (const char* part : {"/dumps", "/silo", "/collector"})
    if (fault.empty()) fault = remove_later_dumps(folder + part, step);
  if (fault.empty()) fault = rename_later_restarts(folder + "/restart", step, restart);
  if (!fault.empty()) return fault;
  // There is none until the run has come to its end again.
  const std::string result = folder + "/result.json";
  std::rename(result.c_str(), (result + ".superseded").c_str());
  return "";
}

/// The text with the values of its variables, which quotes have kept from the input so far.
std::string RunFolder::substituted(const std::string& text) const {
  int size = static_cast<int>(text.size()) + 1, work_size = size;
  char* copy = static_cast<char*>(memory->smalloc(size, "run_folder:copy"));
  char* work = static_cast<char*>(memory->smalloc(work_size, "run_folder:work"));
  std::memcpy(copy, text.c_str(), static_cast<std::size_t>(size));
  input->substitute(copy, work, size, work_size, 0);
  std::string result = copy;
  memory->sfree(copy);
  memory->sfree(work);
  return result;
}

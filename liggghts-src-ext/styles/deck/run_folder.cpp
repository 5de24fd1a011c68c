// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_folder.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "comm.h"
#include "input.h"
#include "memory.h"
#include "run_files.h"
#include "stop_run.h"
#include "update.h"

using namespace LAMMPS_NS;

void RunFolder::command(int narg, char** arg) {
  const std::vector<std::string> words(arg, arg + narg);
  const std::string verb = narg > 0 ? words[0] : "";
  // Ranks other than 0 have variables to work out, too, which computes may need.
  std::string text, fault;
  if (verb == "write" && narg == 3) text = substituted(words[2]);
  if (verb == "open" && narg >= 2) {
    if (comm->me == 0) fault = open(words);
  } else if (verb == "resume" && narg == 3) {
    if (comm->me == 0) fault = resume(words[1], words[2]);
  } else if (verb == "write" && narg == 3) {
    if (comm->me == 0) fault = write(words[1], text);
  } else {
    stop_run(lmp,
             "run_folder: expected 'run_folder open FOLDER [SUBFOLDER ...]', 'run_folder resume "
             "FOLDER RESTART_FILE' or 'run_folder write FILE TEXT'");
  }
  if (!fault.empty()) fault = "run_folder " + verb + " " + words[1] + ": " + fault;
  stop_run_by_rank_0(lmp, fault);
}

std::string RunFolder::open(const std::vector<std::string>& words) const {
  std::string fault = make_folder(words[1]);
  // As long as the ranks of a run that was killed may take to go.
  if (fault.empty()) fault = lock_folder(words[1], 5.0);
  for (std::size_t k = 2; k < words.size() && fault.empty(); ++k)
    fault = make_folder(words[1] + "/" + words[k]);
  return fault;
}

std::string RunFolder::resume(const std::string& folder, const std::string& restart) const {
  const long long step = update->ntimestep;
  std::string fault = remove_unfinished(folder);
  for (const char* part : {"/dumps", "/restart"})
    if (fault.empty()) fault = remove_unfinished(folder + part);
  if (fault.empty()) fault = cut_table(folder + "/energies.csv", step);
  if (fault.empty()) fault = remove_later_dumps(folder + "/dumps", step);
  if (fault.empty()) fault = rename_later_restarts(folder + "/restart", step, restart);
  if (!fault.empty()) return fault;
  // There is none until the run has come to its end again.
  const std::string result = folder + "/result.json";
  std::rename(result.c_str(), (result + ".superseded").c_str());
  return "";
}

std::string RunFolder::write(const std::string& file, const std::string& text) const {
  return write_whole(file, text + "\n");
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

// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts_run.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace rodpack::test {

namespace fs = std::filesystem;

namespace {

/// Folders of this test program's runs. A failed test keeps them, to be looked at.
class Folders {
 public:
  Folders() { testing::UnitTest::GetInstance(); }  // constructed first, so still there at our end
  ~Folders() {
    for (const fs::path& folder : folders_) {
      if (testing::UnitTest::GetInstance()->Failed()) {
        std::cout << "kept: " << folder.string() << '\n';
      } else {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
      }
    }
  }
  fs::path create() {
    std::string name = (fs::temp_directory_path() / "rodpack-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    folders_.push_back(name);
    return name;
  }

 private:
  std::vector<fs::path> folders_;
};

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string contents(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Several ranks may share a core here, and tests run side by side: no binding to cores.
std::string mpi_launcher(int ranks) {
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
         "OMPI_MCA_btl_vader_single_copy_mechanism=none " +
         quoted(RODPACK_MPIEXEC) + " --oversubscribe --bind-to none -np " + std::to_string(ranks) +
         " ";
}

}  // namespace

fs::path fresh_folder() {
  static Folders folders;
  return folders.create();
}

Run run_command(const std::string& command, const fs::path& folder) {
  const fs::path output = folder / "output.txt";
  const std::string line =
      "cd " + quoted(folder.string()) + " && { " + command + " ; } > output.txt 2>&1 < /dev/null";
  const int status = std::system(line.c_str());
  const int exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {exit_code, contents(output), folder};
}

Run run_liggghts(const std::string& deck, const std::map<std::string, std::string>& vars,
                 int ranks) {
  return run_liggghts_in(fresh_folder(), deck, vars, ranks);
}

Run run_liggghts_in(const fs::path& folder, const std::string& deck,
                    const std::map<std::string, std::string>& vars, int ranks) {
  fs::path file = fs::path(RODPACK_REPOSITORY) / "inputs" / deck;
  if (deck.find('\n') != std::string::npos) {
    file = folder / "in.deck";
    std::ofstream(file) << deck;
  } else if (!fs::exists(file)) {
    throw std::runtime_error("no deck " + file.string());
  }
  // LIGGGHTS prints an error just before MPI_Abort: without line buffering it would be lost.
  // A single process needs no daemon of Open MPI's, whose start takes as long as many a deck.
  // Each run has a session folder of its own: in the common one, runs that start and end side by
  // side make and remove it under each other's feet.
  std::string command = "OMPI_MCA_orte_tmpdir_base=" + quoted(folder.string()) + " ";
  command += ranks > 1 ? mpi_launcher(ranks) : "OMPI_MCA_ess_singleton_isolated=1 ";
  command += "stdbuf -oL " + quoted(std::string(RODPACK_BIN) + "/liggghts");
  command += " -in " + quoted(file.string());
  for (const auto& [name, value] : vars) command += " -var " + name + " " + quoted(value);
  fs::remove(folder / "log.liggghts");
  Run run = run_command(command, folder);
  run.output += contents(folder / "log.liggghts");
  return run;
}

}  // namespace rodpack::test

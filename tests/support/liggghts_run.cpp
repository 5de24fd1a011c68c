// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts_run.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "campaigns/launch/deck_run.h"
#include "programs/run_program.h"

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

}  // namespace

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

fs::path fresh_folder() {
  static Folders folders;
  return folders.create();
}

Run run_command(const std::string& command, const fs::path& folder) {
  const int exit_code = run_program({"sh", "-c", command},
                                    {"", folder.string(), (folder / "output.txt").string(), {}});
  return {exit_code, text_of(folder / "output.txt"), folder};
}

Run run_rodpack(const std::string& arguments, const fs::path& folder) {
  return run_command("'" RODPACK_BIN "/rodpack' " + arguments, folder);
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
  const Liggghts liggghts = {RODPACK_BIN "/liggghts", RODPACK_MPIEXEC, ranks};
  fs::remove(folder / "log.liggghts");
  const int exit_code = rodpack::run_liggghts(liggghts, file.string(), vars, folder.string());
  Run run = {exit_code, text_of(folder / "output.txt"), folder};
  run.output += text_of(folder / "log.liggghts");
  return run;
}

}  // namespace rodpack::test

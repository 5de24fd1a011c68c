// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_TESTS_LIGGGHTS_RUN_H
#define RODPACK_TESTS_LIGGGHTS_RUN_H

#include <filesystem>
#include <map>
#include <string>

#include "table.h"

namespace rodpack::test {

/// A finished run of a program. Inside a TEST write `const auto run = …`: there, Run is a private
/// function of testing::Test.
struct Run {
  int exit_code;
  std::string output;            // standard output and error, then log.liggghts if there is one
  std::filesystem::path folder;  // working folder; removed at the end unless a test failed
};

/// A fresh empty folder; removed when the test program ends, unless a test failed.
std::filesystem::path fresh_folder();

/// The whole of a file; empty if there is none.
std::string text_of(const std::filesystem::path& file);

/// Runs a shell command in `folder`.
Run run_command(const std::string& command, const std::filesystem::path& folder = fresh_folder());

/// Runs the built post-processor in `folder`; the arguments are words for a shell.
Run run_rodpack(const std::string& arguments, const std::filesystem::path& folder = fresh_folder());

/// Runs the built LIGGGHTS in a fresh folder. `deck` is a path relative to the repository's
/// inputs/, or the deck's text if it contains a newline. `vars` become -var name value.
Run run_liggghts(const std::string& deck, const std::map<std::string, std::string>& vars = {},
                 int ranks = 1);

/// Same, in a folder that exists: for a deck that goes on from an earlier run's restart.
Run run_liggghts_in(const std::filesystem::path& folder, const std::string& deck,
                    const std::map<std::string, std::string>& vars = {}, int ranks = 1);

}  // namespace rodpack::test

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PROGRAMS_RUN_PROGRAM_H
#define RODPACK_PROGRAMS_RUN_PROGRAM_H

#include <map>
#include <string>
#include <vector>

namespace rodpack {

/// What another program gets beside its arguments.
struct ProgramSurroundings {
  std::string input;   // text for its standard input
  std::string folder;  // its working folder; empty: this one
  std::string output;  // file for all it prints, from the root on; empty: as this program
  std::map<std::string, std::string> variables;  // of its environment, added to this program's
};

/// Runs a program, looked for in PATH unless its name has a slash, and waits for its end. No shell
/// sees the words: each argument arrives as it is, blanks, quotes and $(...) too.
/// @return its exit code; 128 + the signal that ended it; 127 when there is no such program.
/// @throws DataError when no process can be started.
int run_program(const std::vector<std::string>& words,
                const ProgramSurroundings& surroundings = {});

}  // namespace rodpack

#endif

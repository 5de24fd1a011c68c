// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CAMPAIGNS_LAUNCH_DECK_RUN_H
#define RODPACK_CAMPAIGNS_LAUNCH_DECK_RUN_H

#include <map>
#include <string>

namespace rodpack {

/// Values of -var, by name.
using DeckVariables = std::map<std::string, std::string>;

/// A program and how to start it.
struct Liggghts {
  std::string program;              // file; that of this build stands beside `rodpack`
  std::string mpiexec = "mpiexec";  // launcher, for more than one rank
  int ranks = 1;
};

/// Finds the `liggghts` that stands beside the running program. @throws DataError when there is
/// none.
std::string liggghts_beside_this_program();

/// Runs `deck` in `folder`, where LIGGGHTS leaves its log.liggghts, Open MPI its session folder,
/// and all that is printed goes into output.txt. No shell sees deck, values or folder. Returns the
/// exit code, or 128 + the signal that ended it.
int run_liggghts(const Liggghts& liggghts, const std::string& deck, const DeckVariables& variables,
                 const std::string& folder);

/// Runs `deck` (a file; the folder it names is not the working one) in `folder`, which is made if
/// missing. Returns what it printed. @throws DataError with LIGGGHTS's own error line when it
/// fails, or that it was interrupted.
std::string run_deck(const Liggghts& liggghts, const std::string& deck,
                     const DeckVariables& variables, const std::string& folder);

}  // namespace rodpack

#endif

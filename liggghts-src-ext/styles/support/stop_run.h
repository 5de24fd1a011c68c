// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STOP_RUN_H
#define RODPACK_STOP_RUN_H

#include <string>

namespace LAMMPS_NS {

class Compute;
class Dump;
class Fix;
class LAMMPS;

/// The style that speaks, as it stands at the front of a message: "Fix STYLE (id ID)", "Compute
/// ...", "Dump ...".
std::string name_of(const Fix& fix);
std::string name_of(const Compute& compute);
std::string name_of(const Dump& dump);

/// Ends the run with the line "ERROR: MESSAGE" on the screen and in the log file. All ranks have to
/// call it, as they do where they all find the same.
[[noreturn]] void stop_run(LAMMPS* lmp, const std::string& message);

/// Ends the run in the name of a style: "ERROR: NAME OF THE STYLE: MESSAGE".
template <class Style>
[[noreturn]] void stop_run(LAMMPS* lmp, const Style& style, const std::string& message) {
  stop_run(lmp, name_of(style) + ": " + message);
}

/// Ends the run with what rank 0 alone has found, unless its `message` is empty; those of other
/// ranks do not matter. All ranks have to call it.
void stop_run_by_rank_0(LAMMPS* lmp, std::string message);

/// Ends the run from one rank, where the others cannot know what it has found: "ERROR on proc RANK:
/// MESSAGE". All output of this rank so far, and the line, arrive wherever they are sent to.
[[noreturn]] void stop_run_from_one_rank(LAMMPS* lmp, const std::string& message);

/// Ends the run from one rank in the name of a style: "ERROR on proc RANK: NAME OF THE STYLE:
/// MESSAGE".
template <class Style>
[[noreturn]] void stop_run_from_one_rank(LAMMPS* lmp, const Style& style,
                                         const std::string& message) {
  stop_run_from_one_rank(lmp, name_of(style) + ": " + message);
}

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_STOP_H
#define RODPACK_PLANAR_STOP_H

#include <string>
#include "stop_run.h"

namespace LAMMPS_NS {

/// The run style of the planar engine, as messages name it.
constexpr const char* planar_run_style = "run_style verlet/planar";

/// Ends the run on all ranks alike, because the engine cannot honour what the deck asks for.
[[noreturn]] inline void refuse(LAMMPS* lmp, const std::string& what) {
  stop_run(lmp, planar_run_style + (": " + what));
}

/// Ends the run from one rank, where the others do not know what it has found.
[[noreturn]] inline void refuse_from_one_rank(LAMMPS* lmp, const std::string& what) {
  stop_run_from_one_rank(lmp, planar_run_style + (": " + what));
}

}  // namespace LAMMPS_NS

#endif

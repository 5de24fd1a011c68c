// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS

CommandStyle(stable_timestep, StableTimestep)

#else

#ifndef LMP_STABLE_TIMESTEP_H
#define LMP_STABLE_TIMESTEP_H

#include <string>
#include "pointers.h"

namespace LAMMPS_NS {

/// Command stable_timestep: the time step that a packing of equal particles allows under mass
/// scaling, as a variable; see doc/stable_timestep.md.
class StableTimestep : protected Pointers {
 public:
  explicit StableTimestep(LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);

 private:
  void report(const std::string& line) const;
};

}  // namespace LAMMPS_NS

#endif
#endif

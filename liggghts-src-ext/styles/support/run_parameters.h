// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_RUN_PARAMETERS_H
#define RODPACK_RUN_PARAMETERS_H

#include <string>

namespace LAMMPS_NS {

/// Parameters of this run as the command parameter has declared them, one "NAME": VALUE a line;
/// what is written at the end of a restart file.
inline std::string& run_parameters() {
  static std::string text;
  return text;
}

/// The same of the run that wrote the restart file which this one has read; empty if there was none
/// or it does not tell. Known to rank 0.
inline std::string& parameters_of_restart() {
  static std::string text;
  return text;
}

}  // namespace LAMMPS_NS

#endif

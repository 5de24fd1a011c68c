// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_DUMP_FILES_H
#define RODPACK_DUMP_FILES_H

#include <string>

namespace LAMMPS_NS {

class Dump;
class LAMMPS;

/// Returns `name` with its * replaced by the step, padded with zeros to `width` digits.
std::string name_at_step(std::string name, long long step, int width);

/// Stops the run, on all ranks, unless a file can be made in the folder of `file`.
void require_folder(LAMMPS* lmp, const Dump& dump, const std::string& file);

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_RESTART_SEAL_H
#define RODPACK_RESTART_SEAL_H

#include <cstdio>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

// The seal of a restart file: what stands behind LIGGGHTS's own content, which its reader never
// reaches. By it a file is known to be whole, and to be of the run that goes on with it.
//
//   content
//   parameters of the run, one "NAME": VALUE a line (command parameter); may be empty
//   rodpack-restart-1 LENGTH CONTENT CRC32\n
//
// The last line has seal_size bytes: the length of the file and that of its content, 16 hexadecimal
// digits each, and the CRC-32 (zlib's) of all before that line, 8 digits.
// inputs/deposition/whole_restart.py reads it too.
namespace rodpack {

constexpr int seal_size = 61;

/// Opens NAME.part to write a restart file into; NULL if that is not possible.
std::FILE* open_restart(const char* name);

/// Seals a file of open_restart(), brings it to the disk and gives it its name. Where that is not
/// possible the run stops, and what stood under that name before still does.
void close_restart(LAMMPS_NS::LAMMPS* lmp, std::FILE* file);

/// Stops the run unless restart files can be made in the folder of `name`.
void require_folder_of_restart(LAMMPS_NS::LAMMPS* lmp, const char* name);

/// What is wrong with the seal of a file, as the end of a sentence that begins with its name; empty
/// if it is whole, and `parameters` are those of its run.
std::string fault_of_restart(const char* name, std::string& parameters);

/// Stops the run unless the file is whole. `unsealed`: it has no seal, as those of other LIGGGHTSs.
void require_whole_restart(LAMMPS_NS::LAMMPS* lmp, const char* name, bool unsealed);

}  // namespace rodpack

#endif

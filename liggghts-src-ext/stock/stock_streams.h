// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STOCK_STREAMS_H
#define RODPACK_STOCK_STREAMS_H

#include <mpi.h>

#include <cstdio>

namespace LAMMPS_NS {
class LAMMPS;
}

// What the mended sources of LIGGGHTS call (mends.cmake) so that all that is said arrives and all
// that cannot be written is noticed.
namespace rodpack {

/// Keeps the name of the log file, so that any rank can add a line at its end. All ranks call it;
/// `log` is NULL where another rank writes, `name` is "none" where nobody does.
void keep_log(std::FILE* log, const char* name);

/// Writes the line of an error of one rank to the log file, whoever has it open.
void error_to_log(LAMMPS_NS::LAMMPS* lmp, const char* file, int line, const char* text);

/// Ends the run once all that is buffered has been written.
void abort_run(LAMMPS_NS::LAMMPS* lmp, MPI_Comm world);

/// Lets a write into a closed pipe, or beyond the limit of file sizes, fail with an error instead
/// of ending the program without a word.
void let_writes_fail();

/// Brings what has been said so far to screen and log file, and stops the run if that is not
/// possible. Called after each command and each line of thermo.
void check_streams(LAMMPS_NS::LAMMPS* lmp);

/// Writes out what is buffered, and stops the run if that or an earlier write has failed. `what`
/// and `which` name the file in the message.
void check_written(LAMMPS_NS::LAMMPS* lmp, std::FILE* file, const char* what,
                   const char* which = "");

/// The same, and closes the file.
void close_written(LAMMPS_NS::LAMMPS* lmp, std::FILE* file, const char* what,
                   const char* which = "");

/// Warns once if there are multispheres: the kinetic energy of thermo is not theirs.
void warn_of_kinetic_energy(LAMMPS_NS::LAMMPS* lmp);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_STOCK_NUMBERS_H
#define RODPACK_STOCK_NUMBERS_H

namespace LAMMPS_NS {
class Error;
class Input;
}  // namespace LAMMPS_NS

// What the mended sources of LIGGGHTS (mends.cmake) read numbers of commands with. Stock code reads
// the beginning of a word ("run 1e6" makes one step) and takes integers modulo 2^32. `file` and
// `line` are those of Error::all; all ranks have to call these functions.
namespace rodpack {

/// Stops the run: "expected EXPECTED, got 'TEXT'", and the command's arguments.
void refuse_number(LAMMPS_NS::Error* error, const LAMMPS_NS::Input* input, const char* file,
                   int line, const char* expected, const char* text);

/// Reads the finite number that the whole word is; false where it is none.
bool is_number(const char* text, double& value);

/// The same of an integer of at most 2147483647 in magnitude.
bool is_integer(const char* text, int& value);

/// A number of steps, up to 9e18; stops the run where the whole word is none.
long long whole_word_steps(LAMMPS_NS::Error* error, const LAMMPS_NS::Input* input, const char* file,
                           int line, const char* text);

}  // namespace rodpack

#endif

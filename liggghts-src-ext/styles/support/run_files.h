// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_RUN_FILES_H
#define RODPACK_RUN_FILES_H

#include <string>

namespace LAMMPS_NS {

/// What is expected of a path in a deck, where it stands without quotes, which would keep variables
/// from their values: nothing that a deck, a shell or the name of a dump reads as something else.
extern const char* const a_plain_path;
bool is_plain_path(const std::string& text);

// Files of a run folder. Each function returns what went wrong, as the end of a message; empty if
// nothing did.

/// Makes a folder and those above it.
std::string make_folder(const std::string& folder);

/// Takes the lock of a folder for as long as this process lives; waits `seconds` for another owner.
std::string lock_folder(const std::string& folder, double seconds);

/// Writes a file aside, brings it to the disk and gives it its name then; not into a folder in the
/// place of one whose lock this process took.
std::string write_whole(const std::string& file, const std::string& text);

/// Takes out of a table, whose first column is the step, the rows of steps after `step` and rows
/// that are not whole. It is no fault if there is no such file.
std::string cut_table(const std::string& file, long long step);

/// Removes what was being written in a folder when a run ended: NAME.part.
std::string remove_unfinished(const std::string& folder);

/// Removes files NAME.STEP.dump (also with .gz) and NAME.STEP.json of steps after `step`.
std::string remove_later_dumps(const std::string& folder, long long step);

/// Renames restart files NAME.STEP.restart of steps after `step`, and NAME.end.restart, to
/// NAME.….superseded; not the file `kept`.
std::string rename_later_restarts(const std::string& folder, long long step,
                                  const std::string& kept);

}  // namespace LAMMPS_NS

#endif

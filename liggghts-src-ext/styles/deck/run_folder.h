// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS

CommandStyle(run_folder, RunFolder)

#else

#ifndef LMP_RUN_FOLDER_H
#define LMP_RUN_FOLDER_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

/// Command run_folder: a folder that belongs to one run at a time and is whole at every moment; see
/// doc/run_folder.md.
class RunFolder : protected Pointers {
 public:
  explicit RunFolder(LAMMPS* lmp) : Pointers(lmp) {}
  void command(int narg, char** arg);

 private:
  // What rank 0 does; each returns what went wrong.
  std::string open(const std::string& folder, const std::vector<std::string>& parts) const;
  std::string resume(const std::string& folder, const std::string& restart) const;
  std::string substituted(const std::string& text) const;
};

}  // namespace LAMMPS_NS

#endif
#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_FILE_DUMP_H
#define LMP_FILE_DUMP_H

#include <string>
#include <vector>
#include "dump.h"

namespace LAMMPS_NS {

/// Base of dumps that write one file a frame, which is no list of lines per atom: the derived style
/// gives write(). Its names have units of SI in them.
class FileDump : public Dump {
 public:
  FileDump(class LAMMPS* lmp, int narg, char** arg) : Dump(lmp, narg, arg) {}

 protected:
  /// Stops the run unless the file's name ends in one of these, and stands for all ranks.
  void require_ending(const std::vector<std::string>& endings);
  bool ends_in(const std::string& ending) const;
  /// Stops the run unless its units are those of `names` ("keys") and the file can be made.
  void require_si_and_folder(const std::string& names);
  /// The name of the file of this step.
  std::string file_name() const;

  // Dump::write's steps for lines per atom, of which there are none here.
  void write_header(bigint) {}
  void pack(int*) {}
  void write_data(int, double*) {}
};

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_OUTPUT_FILE_H
#define RODPACK_OUTPUT_FILE_H

#include <sys/types.h>

#include <cstdio>
#include <string>

namespace LAMMPS_NS {

/// A file of output, plain or compressed by gzip, that appears under its name when it is whole:
/// until then it is NAME.part. One that is appended to, or that grows over the whole run, has its
/// name from the start. Errors are texts for the end of a message, empty where there is none.
class OutputFile {
 public:
  enum class Kind { whole, growing, appended };

  /// Opens it for writing; NULL if that is not possible, with the reason in errno.
  std::FILE* open(const std::string& name, Kind kind, bool compressed);
  const std::string& name() const { return name_; }

  /// Brings what has been written so far to the system; returns what went wrong.
  static std::string flush(std::FILE* file);
  /// Gives the file, which is closed by now, its name; returns what went wrong.
  std::string finish();

 private:
  std::FILE* open_gzip(int file);

  std::string name_, written_to_;
  pid_t gzip_ = -1;
};

/// What is wrong with the folder in which `file` is to be written; empty if files can be made
/// there.
std::string fault_of_folder(const std::string& file);

}  // namespace LAMMPS_NS

#endif

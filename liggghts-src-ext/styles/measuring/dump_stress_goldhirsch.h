// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef DUMP_CLASS
// clang-format off
DumpStyle(stress/goldhirsch,DumpStressGoldhirsch)
// clang-format on
#else
#ifndef LMP_DUMP_STRESS_GOLDHIRSCH_H
#define LMP_DUMP_STRESS_GOLDHIRSCH_H

#include <string>
#include "file_dump.h"

namespace LAMMPS_NS {

/// dump stress/goldhirsch: writes the fields of a compute stress/goldhirsch to .vti or .csv files;
/// see doc/dump_stress_goldhirsch.md.
class DumpStressGoldhirsch : public FileDump {
 public:
  DumpStressGoldhirsch(class LAMMPS* lmp, int narg, char** arg);
  void write();

 protected:
  void init_style();

 private:
  std::string compute_id_;
  class ComputeStressGoldhirsch* compute_;
  bool image_;  // .vti, else .csv
};

}  // namespace LAMMPS_NS

#endif
#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef DUMP_CLASS
// clang-format off
DumpStyle(multisphere/sphere,DumpMultisphereSphere)
// clang-format on
#else
#ifndef LMP_DUMP_MULTISPHERE_SPHERE_H
#define LMP_DUMP_MULTISPHERE_SPHERE_H

#include "contact_recorder.h"
#include "table_dump.h"

namespace LAMMPS_NS {

/// dump multisphere/sphere: writes one line per primary sphere, with the contact forces on it; see
/// doc/dump_multisphere_sphere.md.
class DumpMultisphereSphere : public TableDump {
 public:
  DumpMultisphereSphere(class LAMMPS* lmp, int narg, char** arg);

 protected:
  void init_style();
  void list_rows();

 private:
  ContactRecorder recorder_;
};

}  // namespace LAMMPS_NS

#endif
#endif

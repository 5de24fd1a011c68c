// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef DUMP_CLASS
// clang-format off
DumpStyle(contact/gran,DumpContactGran)
// clang-format on
#else
#ifndef LMP_DUMP_CONTACT_GRAN_H
#define LMP_DUMP_CONTACT_GRAN_H

#include "contact_recorder.h"
#include "table_dump.h"

namespace LAMMPS_NS {

/// dump contact/gran: writes one line per contact, of two spheres or of a sphere and a wall; see
/// doc/dump_contact_gran.md.
class DumpContactGran : public TableDump {
 public:
  DumpContactGran(class LAMMPS* lmp, int narg, char** arg);

 protected:
  void init_style();
  void list_rows();

 private:
  ContactRecorder recorder_;
};

}  // namespace LAMMPS_NS

#endif
#endif

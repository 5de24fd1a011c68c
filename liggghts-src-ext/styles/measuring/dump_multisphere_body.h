// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef DUMP_CLASS
// clang-format off
DumpStyle(multisphere/body,DumpMultisphereBody)
// clang-format on
#else
#ifndef LMP_DUMP_MULTISPHERE_BODY_H
#define LMP_DUMP_MULTISPHERE_BODY_H

#include <set>

#include "table_dump.h"

namespace LAMMPS_NS {

/// dump multisphere/body: writes one line per particle, body or plain sphere; see
/// doc/dump_multisphere_body.md.
class DumpMultisphereBody : public TableDump {
 public:
  DumpMultisphereBody(class LAMMPS* lmp, int narg, char** arg);

 protected:
  void list_rows();

 private:
  std::set<int> bodies_of_group(const class ParticleIdentity& particles) const;
  void list_bodies(const class ParticleIdentity& particles);
  void list_plain_spheres(const class ParticleIdentity& particles);
};

}  // namespace LAMMPS_NS

#endif
#endif

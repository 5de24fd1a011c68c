// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef DUMP_CLASS
// clang-format off
DumpStyle(scene,DumpScene)
// clang-format on
#else
#ifndef LMP_DUMP_SCENE_H
#define LMP_DUMP_SCENE_H

#include <string>
#include "file_dump.h"

namespace LAMMPS_NS {

/// dump scene: writes what surrounds the particles, walls, box and gravity, as a JSON file; see
/// doc/dump_scene.md.
class DumpScene : public FileDump {
 public:
  DumpScene(class LAMMPS* lmp, int narg, char** arg);
  void write();

 protected:
  void init_style();

 private:
  // Parts of the file. Those of meshes are collective.
  std::string scene() const;
  std::string box() const;
  std::string gravity() const;
  std::string walls() const;
  std::string meshes_of(class FixWallGran& wall, const std::string& begin) const;
  std::string friction() const;
  std::string templates() const;
};

}  // namespace LAMMPS_NS

#endif
#endif

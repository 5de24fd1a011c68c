// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/solid,FixWallGranSolid)
// clang-format on
#else
#ifndef LMP_FIX_WALL_GRAN_SOLID_H
#define LMP_FIX_WALL_GRAN_SOLID_H

#include <string>
#include <vector>
#include "fix_wall_gran.h"

namespace LAMMPS_NS {

/// fix wall/gran/solid: a plane with a solid behind it, which pushes spheres back to its free side,
/// however deep they are. The planes of `wall/gran` push to both sides, which throws out what has
/// come in by more than its radius.
class FixWallGranSolid : public FixWallGran {
 public:
  FixWallGranSolid(class LAMMPS* lmp, int narg, char** arg);
  void pre_force(int vflag);

  int axis() const { return axis_; }
  double position() const { return position_; }
  /// Direction of the free side along the axis, 1 or -1.
  int free_side() const { return free_side_; }

 protected:
  void post_force_primitive(int vflag);

 private:
  struct Arguments;
  FixWallGranSolid(class LAMMPS* lmp, Arguments given);
  double depth(int i) const { return free_side_ * (position_ - x_[i][axis_]) + radius_[i]; }
  void refuse_what_it_cannot() const;
  /// Whether a sphere's contact with the plane remembers nothing.
  bool is_empty(const double* history) const;

  int axis_;
  double position_;
  int free_side_;
  std::vector<int> near_;  // spheres that may touch before the next list
};

}  // namespace LAMMPS_NS

#endif
#endif

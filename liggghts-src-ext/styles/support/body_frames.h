// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_BODY_FRAMES_H
#define RODPACK_BODY_FRAMES_H

#include <array>
#include <vector>

#include "lammps.h"

namespace LAMMPS_NS {

class ParticleIdentity;

/// Frame of a body in which it is dumped: its x axis in space, and the rotation from it to space.
struct BodyFrame {
  std::array<double, 3> axis;
  std::array<double, 4> quaternion;
};

/// Frames of the bodies of this rank. A spherocylinder's is that of its principal axes, the first
/// of which is its long one. LIGGGHTS orders the principal axes of a stock template's bodies by no
/// rule: the x axis of theirs is the line along which their spheres' centres are spread most, where
/// there is one; its sense and the other two axes are fixed in the body.
std::vector<BodyFrame> body_frames(LAMMPS* lmp, const ParticleIdentity& particles);

}  // namespace LAMMPS_NS

#endif

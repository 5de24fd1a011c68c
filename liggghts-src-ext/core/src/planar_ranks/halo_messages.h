// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_HALO_MESSAGES_H
#define RODPACK_PLANAR_HALO_MESSAGES_H

#include <cstddef>
#include <vector>

#include "../planar/contact.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

// What ranks tell each other of their bodies, as lists of doubles. A pack function writes to `to`,
// an unpack function reads from `from`; both return where they have ended.

/// Position, orientation and velocity of a body: what its ghosts need in every step.
double* pack_kinematics(const PlanarKinematics& kinematics, double* to);
/// Sets all but the radius, which a message does not tell.
const double* unpack_kinematics(const double* from, PlanarKinematics& kinematics);

/// What an event did to a body, if it let the acceleration jump.
double* pack_jump(const PlanarJump& jump, double* to);
const double* unpack_jump(const double* from, PlanarJump& jump);

/// The largest number of doubles of a message of one step about so many bodies.
std::size_t most_step_values(std::size_t bodies);

/// All that a new ghost needs of its body: what is constant, the kinematics, the last event.
void append_body(const PlanarBody& body, std::vector<double>& to);
const double* unpack_body(const double* from, PlanarBody& body);

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_ORIENTATION_H
#define RODPACK_PLANAR_ORIENTATION_H

namespace LAMMPS_NS {

/// Orientations of a body that moves in a plane z = const: q = (turn about z) * reference.
/// Quaternions are (w, x, y, z), body to space; axes are the body's principal axes in space.

/// The orientation of angle 0 of a body that is now in the orientation `quat`. A body whose third
/// axis lies within 0.01 rad of +z is taken to turn about just that axis: its reference is the
/// identity. (The eigenvectors of a sampled inertia tensor are off by a few mrad.)
void planar_reference(const double* quat, double* reference);

/// Brings `quat` back to the nearest orientation that is a turn about z from `reference`, and sets
/// the axes to match: their z components never change, and those that are 0 or +-1 are so exactly.
/// An orientation that is in the plane already stays as it is, bit by bit.
void flatten_orientation(const double* reference, double* quat, double* ex, double* ey, double* ez);

}  // namespace LAMMPS_NS

#endif

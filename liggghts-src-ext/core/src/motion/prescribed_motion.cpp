// SPDX-License-Identifier: GPL-2.0-or-later
#include "rodpack/motion/prescribed_motion.h"

#include <cmath>

#include "rodpack/geometry/vector3.h"
#include "rodpack/motion/rigid_motion.h"

namespace rodpack {

namespace {

const double full_turn = 6.283185307179586;

/// Sets `quaternion` to that of a rotation by `angle`, rad, about the direction of `axis`, not 0.
void set_rotation(const double (&axis)[3], double angle, double (&quaternion)[4]) {
  const double length = std::sqrt(dot(axis, axis));
  quaternion[0] = std::cos(0.5 * angle);
  for (int d = 0; d < 3; ++d) quaternion[1 + d] = std::sin(0.5 * angle) * axis[d] / length;
}

/// The rotation `first`, then `second`.
void compose(const double (&second)[4], const double (&first)[4], double (&result)[4]) {
  const double *a = second, *b = first;
  result[0] = a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3];
  result[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  result[2] = a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1];
  result[3] = a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0];
  normalise(result);
}

}  // namespace

bool PrescribedMotion::turns() const { return dot(angular_velocity, angular_velocity) > 0.0; }

bool PrescribedMotion::is_steady() const {
  return dot(amplitude, amplitude) == 0.0 && !(turns() && about_origin);
}

bool PrescribedMotion::is_in_plane() const {
  return velocity[2] == 0.0 && amplitude[2] == 0.0 && angular_velocity[0] == 0.0 &&
         angular_velocity[1] == 0.0;
}

void PrescribedMotion::path(double time, double (&result)[3]) const {
  const double swing = period > 0.0 ? std::sin(full_turn * time / period) : 0.0;
  for (int d = 0; d < 3; ++d) result[d] = velocity[d] * time + amplitude[d] * swing;
}

void PrescribedMotion::pivot(double time, double (&result)[3]) const {
  path(time, result);
  for (int d = 0; d < 3; ++d) result[d] += origin[d];
}

PrescribedState PrescribedMotion::at(const BodyPose& start, double began, double time) const {
  PrescribedState now = {start, {0.0, 0.0, 0.0}};
  const double frequency = period > 0.0 ? full_turn / period : 0.0;
  for (int d = 0; d < 3; ++d)
    now.velocity[d] = velocity[d] + frequency * amplitude[d] * std::cos(frequency * time);
  double from[3], to[3];
  path(began, from);
  path(time, to);
  for (int d = 0; d < 3; ++d) now.pose.position[d] += to[d] - from[d];
  if (!turns()) return now;

  double turn[4];
  set_rotation(angular_velocity,
               std::sqrt(dot(angular_velocity, angular_velocity)) * (time - began), turn);
  compose(turn, start.quaternion, now.pose.quaternion);
  if (!about_origin) return now;
  double pivot_before[3], pivot_now[3], arm[3], turned[3];
  pivot(began, pivot_before);
  pivot(time, pivot_now);
  for (int d = 0; d < 3; ++d) arm[d] = start.position[d] - pivot_before[d];
  rotate(turn, arm, false, turned);
  for (int d = 0; d < 3; ++d) now.pose.position[d] = pivot_now[d] + turned[d];
  const double of_path[3] = {now.velocity[0], now.velocity[1], now.velocity[2]};
  velocity_at(of_path, angular_velocity, turned, now.velocity);
  return now;
}

}  // namespace rodpack

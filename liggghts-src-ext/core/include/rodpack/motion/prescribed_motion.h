// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_MOTION_PRESCRIBED_MOTION_H
#define RODPACK_MOTION_PRESCRIBED_MOTION_H

namespace rodpack {

/// Where a rigid body is: its centre of mass, m, and its orientation, a unit quaternion (w, x, y,
/// z) that turns body into space frame.
struct BodyPose {
  double position[3];
  double quaternion[4];
};

struct PrescribedState {
  BodyPose pose;
  double velocity[3];  // of the centre of mass, m/s
};

/// A motion that is prescribed to rigid bodies, as a closed form of the time: what rounding adds
/// does not grow with the number of steps. Bodies are carried along the path
///   s(t) = velocity t + amplitude sin(2 pi t / period)
/// and turn at the constant `angular_velocity`, each about its own centre of mass or all of them
/// about one point, which is at `origin` at the time 0 and is carried along as they are. Space
/// frame.
struct PrescribedMotion {
  double velocity[3] = {0.0, 0.0, 0.0};          // m/s
  double amplitude[3] = {0.0, 0.0, 0.0};         // m
  double period = 0.0;                           // s; 0: no oscillation
  double angular_velocity[3] = {0.0, 0.0, 0.0};  // rad/s
  bool about_origin = false;
  double origin[3] = {0.0, 0.0, 0.0};  // m

  bool turns() const;
  /// Whether velocities and angular velocity stay what they are at the start.
  bool is_steady() const;
  /// Whether z and the orientation of z stay as they are.
  bool is_in_plane() const;

  /// The point of the common rotation at `time`, m; of meaning with about_origin.
  void pivot(double time, double (&result)[3]) const;
  /// At `time` (s), of a body that was at `start` at the time `began`. With no motion it is there
  /// to the last bit.
  PrescribedState at(const BodyPose& start, double began, double time) const;

 private:
  void path(double time, double (&result)[3]) const;
};

}  // namespace rodpack

#endif

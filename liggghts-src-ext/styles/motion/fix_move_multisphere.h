// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef FIX_CLASS

// clang-format off
FixStyle(move/multisphere,FixMoveMultisphere)
// clang-format on

#else

#ifndef RODPACK_FIX_MOVE_MULTISPHERE_H
#define RODPACK_FIX_MOVE_MULTISPHERE_H

#include <map>
#include <vector>

#include "fix.h"
#include "rodpack/motion/prescribed_motion.h"

namespace LAMMPS_NS {

/// fix move/multisphere: holds the bodies of a group fixed or moves them as prescribed, whatever
/// acts on them, and adds up the forces on them.
///
/// It knows the motion and where each body began it; fix multisphere/ab moves the bodies
/// (fix_multisphere_ab_prescribed.cpp). All ranks know all of its bodies.
class FixMoveMultisphere : public Fix {
 public:
  FixMoveMultisphere(LAMMPS* lmp, int narg, char** arg);
  ~FixMoveMultisphere();

  int setmask() { return 0; }
  void init();
  void reset_dt();
  /// Force (N) on the bodies by contacts, x, y, z, and its torque (N m): about the centres of mass,
  /// or about the common point of the rotation.
  double compute_vector(int);
  void write_restart(FILE*);
  void restart(char*);

  // What fix multisphere/ab and the planar engine ask for.

  /// Finds the bodies of the group; those that are new to it begin here and now. Collective.
  void take_bodies();
  bool moves(int tag) const { return bodies_.count(tag) != 0; }
  /// A body that is moved, at the present step; `image` counts the periodic images.
  rodpack::PrescribedState state(int tag, tagint image) const;
  const rodpack::PrescribedMotion& motion() const { return motion_; }
  /// Ends the run if a sphere of this rank is in the group and of no body that is moved.
  void refuse_newcomers() const;

 private:
  /// Where and when a body began to be moved.
  struct Start {
    rodpack::BodyPose pose;
    double time;   // s
    tagint image;  // periodic, of the body
  };

  double time() const;
  void follow_timestep();
  std::map<int, Start> bodies_of_group() const;
  double own_component(int n) const;
  std::vector<double> parameters() const;

  rodpack::PrescribedMotion motion_;
  std::map<int, Start> bodies_;  // by tag
  // The time is 0 when the fix begins; it is `time_before_` at step_, and from there on grows by
  // dt_ in each step.
  double time_before_, dt_;
  bigint step_;
};

}  // namespace LAMMPS_NS

#endif
#endif

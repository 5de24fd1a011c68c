// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_CONTACT_EVENTS_H
#define LMP_CONTACT_EVENTS_H

#include <vector>
#include "contact_interface.h"
#include "pointers.h"
#include "rodpack/contact/contact_motion.h"
#include "rodpack/contact/force_change.h"

namespace LAMMPS_NS {

/// Carries events of contacts (rodpack/force_change.h) from the contact models to the integrator of
/// the bodies, and what they did to the bodies back to the models in the step after.
///
/// Per atom, since a body's spheres and its contacts may be spread over ranks: the changes of the
/// forces on a sphere travel as the forces do, and the motion of a sphere as its velocity does.
class ContactEvents : protected Pointers {
 public:
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::SurfacesCloseData ClosePair;

  /// `bodies`: whose spheres are corrected. A contact of a sphere that belongs to none has no
  /// events: what its partner would gain, it would not lose.
  ContactEvents(class LAMMPS* lmp, const class FixMultisphere* bodies)
      : Pointers(lmp), bodies_(bodies) {}
  ~ContactEvents() { disarm(); }

  // ---- for the contact models

  /// The events of the integrator that runs, while forces are evaluated in a step; else null.
  static ContactEvents* armed() { return armed_; }

  /// The force on i has changed to another branch `since` seconds ago: by `now` (N), growing by
  /// `rate` (N/s) in a frame that turns with the contact. `jumps`: it did not grow from 0, so the
  /// acceleration of the bodies jumped.
  void add(const Contact& contact, const double (&now)[3], const double (&rate)[3], double since,
           bool jumps = false);
  void add(const Contact& contact, const rodpack::ForceChange& on_i, bool jumps = false);

  /// By how much the motion of i's surface relative to j's, at the contact, has changed in the step
  /// before because forces jumped; false if it has not. Also right at set-up, for the evaluation
  /// that is repeated there.
  typedef rodpack::MotionChange Motion;
  bool motion_changed(const Contact& contact, Motion& change) const {
    return follows_jump_ && find_change(contact, change);
  }

  /// A pair that has just lost contact as if it were still in touch, of negative overlap: what the
  /// surface model sets for a pair in contact, and `meff`.
  Contact as_if_in_contact(const ClosePair& pair) const;

  // ---- for the integrator

  /// Makes the properties of the atoms; call in post_create.
  void create_properties(const char* caller);
  /// Call in init: forgets what belongs to other steps than those to come.
  void init();

  void arm();
  void disarm();
  /// After the forces: whether any rank has events. Then changes() is complete on owned atoms and
  /// ghosts.
  bool collect();
  /// Atoms whose forces have changed, with ghosts.
  const std::vector<int>& changed() const { return changed_; }
  struct Changes {
    rodpack::ForceChange force, torque;  // torque about the centre of the sphere
    double jumps;                        // how many of the forces jumped
  };
  Changes changes(int i) const;
  /// Forgets the changes.
  void clear();
  /// Whether, on any rank, accelerations have jumped, so that the integrator has to publish.
  bool jumped() const { return any_jumped_; }

  /// Change of the motion of a point of a body, the centre of a sphere or of mass, and of the
  /// body's rotation, as in Motion.
  struct RigidMotion {
    double acceleration[3], velocity[3], displacement[3];
    double angular_acceleration[3], angular_velocity[3], rotation[3];
    double step;  // at whose end it happened, plus 1; 0: never
  };
  /// What was published for the next step, null if nothing.
  const RigidMotion* motion_for_next_step(int i) const;
  /// Before publish() is called for the spheres of the bodies that this rank owns, and after.
  void begin_publishing();
  void publish(int i, const RigidMotion& motion);
  void end_publishing();
  /// After the neighbour lists, and with them the ghosts, were made anew.
  void renew_ghosts();

 private:
  RigidMotion& motion(class FixPropertyAtom* property, int i) const;
  const RigidMotion* changed_motion(int i) const;
  bool find_change(const Contact& contact, Motion& change) const;

  static ContactEvents* armed_;
  const class FixMultisphere* bodies_;
  class FixPropertyAtom* force_changes_ = NULL;
  class FixPropertyAtom* torque_changes_ = NULL;
  class FixPropertyAtom* last_motion_ = NULL;
  class FixPropertyAtom* motion_before_ = NULL;  // for contacts of a restart, one step old
  std::vector<int> changed_;
  std::vector<char> is_changed_;  // of each atom, whether it is in that list
  bool local_jump_ = false, any_jumped_ = false;
  bigint last_step_ = -1;
  // Whether motions may have changed in this step, in the last one; unknown after a restart.
  bool pending_ = true, follows_jump_ = true;
};

}  // namespace LAMMPS_NS

#endif

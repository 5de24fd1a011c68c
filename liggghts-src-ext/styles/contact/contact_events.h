// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_CONTACT_EVENTS_H
#define LMP_CONTACT_EVENTS_H

#include <vector>
#include "contact_interface.h"
#include "pointers.h"
#include "rodpack/contact/event_correction.h"

namespace LAMMPS_NS {

/// Carries events of contacts (rodpack/contact/force_change.h) from the contact models to the
/// integrator of the bodies, and what they did to the bodies back to the models in the step after.
///
/// Per atom, since a body's spheres and its contacts may be spread over ranks: the changes of the
/// forces on a sphere travel as the forces do, and the motion of a sphere as its velocity does.
class ContactEvents : protected Pointers {
 public:
  /// Has the members that rodpack/contact/contact_motion.h asks of a `Contact`.
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::SurfacesCloseData ClosePair;

  /// `bodies` holds those whose spheres are corrected. A contact of a sphere that belongs to none
  /// has no events: what its partner would gain, it would not lose.
  ContactEvents(class LAMMPS* lmp, const class FixMultisphere* bodies)
      : Pointers(lmp), bodies_(bodies) {
    ask_for_ends();
  }
  ~ContactEvents() { disarm(); }

  // ---- for the contact models

  /// Asks stock code for the end of every contact, where it is mended to tell
  /// (stock/contact_ends.h): of one whose end is not told, the history stays until the lists are
  /// made anew, and a restart file takes it for one that goes on.
  static void ask_for_ends();

  /// The events of the integrator that runs, while forces are evaluated in a step; else null.
  static ContactEvents* armed() { return armed_; }

  /// The force on i has changed to another branch in the last step. `jumps`: it did not grow from
  /// 0, so the acceleration of the bodies jumped.
  void add(const Contact& contact, const rodpack::ForceChange& on_i, bool jumps);

  /// By how much the motion of i's surface relative to j's, at the contact, has changed in the step
  /// before because forces jumped; false if it has not. Also right at set-up, for the evaluation
  /// that is repeated there.
  bool motion_changed(const Contact& contact, rodpack::ContactJump& jump) const {
    return follows_jump_ && find_jump(contact, jump);
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
  /// To be called after the forces: returns whether any rank has events. If so, changes() is
  /// complete on owned atoms and ghosts.
  bool collect();
  /// Local indices of the atoms whose forces have changed, ghosts among them.
  const std::vector<int>& changed() const { return changed_; }
  struct SphereChanges {
    rodpack::BodyChange sum;  // torque about the centre of the sphere
    double jumps;             // how many of the forces jumped
  };
  SphereChanges changes(int i) const;
  /// Forgets the changes of this step.
  void clear();
  /// Whether, on any rank, accelerations have jumped, so that the integrator has to publish.
  bool jumped() const { return any_jumped_; }

  /// The jump of an atom that was published for the next step; null if none was.
  const rodpack::SpatialJump* jump_for_next_step(int i) const;
  /// To be called before publish() is called for the spheres of the bodies that this rank owns;
  /// end_publishing() afterwards.
  void begin_publishing();
  /// Tells the contacts of the sphere with local index i, in the next step, of the jump of its
  /// centre.
  void publish(int i, const rodpack::SpatialJump& jump);
  void end_publishing();
  /// Brings the jumps to the ghosts after the neighbour lists, and with them the ghosts, were made
  /// anew.
  void renew_ghosts();

 private:
  /// A jump as it is stored for each sphere.
  struct StampedJump {
    rodpack::SpatialJump jump;
    double step;  // at whose end it happened, plus 1; 0: never
  };
  static const int jump_values = sizeof(StampedJump) / sizeof(double);
  StampedJump& stored(class FixPropertyAtom* property, int i);
  const StampedJump& stored(const class FixPropertyAtom* property, int i) const;
  const rodpack::SpatialJump* last_jump(int i) const;
  bool find_jump(const Contact& contact, rodpack::ContactJump& jump) const;

  static ContactEvents* armed_;
  const class FixMultisphere* bodies_;
  class FixPropertyAtom* force_changes_ = NULL;
  class FixPropertyAtom* torque_changes_ = NULL;
  class FixPropertyAtom* last_jump_ = NULL;
  class FixPropertyAtom* jump_before_ = NULL;  // for contacts of a restart, one step old
  std::vector<int> changed_;
  std::vector<char> is_changed_;  // of each atom, whether it is in that list
  bool local_jump_ = false, any_jumped_ = false;
  bigint last_step_ = -1;
  // Whether jumps may have changed motions in this step, and whether in the last one; after a
  // restart that is not known.
  bool pending_ = true, follows_jump_ = true;
  int frozen_groups_ = 0;  // bits of the groups that are infinitely heavy in a contact
};

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_CONTACT_COUNTS_H
#define LMP_CONTACT_COUNTS_H

#include <string>
#include "contact_interface.h"
#include "pointers.h"

namespace LAMMPS_NS {

/// How many contacts each sphere has in the present evaluation of the forces, as the spring_dashpot
/// models report them: for mass scaling (rodpack/motion/mass_scaling.h).
class ContactCounts : protected Pointers {
 public:
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;

  explicit ContactCounts(class LAMMPS* lmp) : Pointers(lmp) { active_ = this; }
  ~ContactCounts() {
    if (active_ == this) active_ = NULL;
  }
  ContactCounts(const ContactCounts&) = delete;
  ContactCounts& operator=(const ContactCounts&) = delete;

  /// Those of the integrator that asks for them; null if none does.
  static ContactCounts* active() { return active_; }
  /// Counts a contact whose force enters the motion.
  void add(const Contact& contact);

  /// Makes the property of the atoms; call in post_create.
  void create_property(const char* caller);
  /// Stops if there are contacts of models that do not report theirs; `who` wants the counts.
  void check_models(const std::string& who) const;
  /// To be called before the forces are evaluated.
  void begin();
  /// To be called after that: of() is then known of ghosts, too. Collective.
  void complete();
  double of(int atom) const;

 private:
  static ContactCounts* active_;
  class FixPropertyAtom* counts_ = NULL;
};

}  // namespace LAMMPS_NS

#endif

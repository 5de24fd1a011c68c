// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_CONTACT_RECORDER_H
#define LMP_CONTACT_RECORDER_H

#include <functional>
#include <string>
#include <vector>
#include "contact_interface.h"
#include "lmptype.h"
#include "pointers.h"
#include "rodpack/contact/contact_pairs.h"
#include "rodpack/contact/rolling_spring.h"

namespace LAMMPS_NS {

/// One contact of two spheres, or of a sphere and a wall, as this rank sees it. SI units.
struct ContactRecord {
  int i;             // local index of sphere i, owned by this rank
  int j;             // local index of sphere j, owned or ghost; -1 for a wall
  bool primary;      // true on exactly one of the records of a contact, over all ranks
  double normal[3];  // unit vector from j to i, out of a wall
  double point[3];   // contact point, half-way into the overlap, in the periodic image of i, m
  double force[3];   // exerted on i by j, N
  double overlap;    // normal overlap, m; negative where a liquid bridge acts across a gap
  double spring;     // length of the tangential spring, m
  // The elastic normal force is kn times the overlap, and grows with its power `exponent`: 1 of a
  // linear spring, 3/2 of Hertz. 0: it is no function of the overlap, and kn, kt and the dashpots
  // are 0 too.
  double exponent;
  double kn, kt;  // at the present overlap, N/m; kt is 0 without a tangential spring
  // Dashpot constants, kg/s (that in the plane of contact acts where kt > 0); effective mass, kg.
  double damping_n, damping_t, effective_mass;
  int type_i, type_j;  // atom types; of a wall its material
  rodpack::RollingLaw rolling;
};

/// The contact of a record as one of particles, which knows their centres of mass in the periodic
/// images that touch; for a wall the id is 0 and the contact point stands for the centre.
/// `centres` by ParticleIdentity::all_body_centres().
rodpack::SphereContact contact_of(const ContactRecord& record,
                                  const class ParticleIdentity& particles,
                                  const std::vector<rodpack::Vector>& centres);

/// The contact that a model has evaluated, without its spring; `exponent` as in ContactRecord.
ContactRecord record_of(const class Atom& atom,
                        const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                        const LIGGGHTS::ContactModels::ForceData& on_i, double exponent);

/// Lists the contacts of this step, in one of two ways.
///
/// The spring_dashpot models are evaluated once more, at the present positions and velocities,
/// without touching forces, contact histories or stored wall forces; they report to the recorder
/// that is armed meanwhile. The contacts of all others are those that the step itself has
/// evaluated, with its forces (StepContacts), since a second evaluation would give others: it
/// would, for one, add the dashpot to every contact that slides under 'tangential history'.
class ContactRecorder : protected Pointers {
 public:
  /// Whether contacts are asked for in the step of this number.
  typedef std::function<bool(bigint)> Asked;

  /// `caller` is the style that wants the contacts, as messages name it: "compute contact/energy".
  /// `asked` tells of the steps, besides those of output and the first and last of a run, in which
  /// it will.
  ContactRecorder(class LAMMPS* lmp, const std::string& caller, Asked asked = nullptr);
  ~ContactRecorder();
  ContactRecorder(const ContactRecorder&) = delete;
  ContactRecorder& operator=(const ContactRecorder&) = delete;

  /// Stops if contacts of a style that runs cannot be listed.
  void check_models() const;
  /// Stops if a normal force is no function of the overlap, so that it has neither energy nor
  /// stiffness.
  void check_potentials() const;
  /// Stops if a contact has something else than springs and dashpots.
  void check_springs() const;

  /// All records of this rank. A contact across the border of two ranks, or of a periodic image, is
  /// in two lists; one of them is primary. Stops if the contacts are not known yet. Collective.
  const std::vector<ContactRecord>& collect();

  bool is_asked(bigint step) const { return asked_ && asked_(step); }

  /// Tells the models which recorder is collecting; null if none is.
  static ContactRecorder* armed() { return armed_; }
  void add_contact(const LIGGGHTS::ContactModels::SurfacesIntersectData& sidata,
                   const LIGGGHTS::ContactModels::ForceData& i_forces);
  /// Completes the newest contact; `i_forces` then holds the whole force.
  void add_tangential(const double* spring, double kt,
                      const LIGGGHTS::ContactModels::ForceData& i_forces);

 private:
  void evaluate(class PairGran* pair);
  void evaluate(class FixWallGran* wall);
  template <class Style>
  void add_contacts_of(Style* style, const std::string& name);
  template <class Found>
  void for_each_style(Found found) const;

  static ContactRecorder* armed_;
  std::string caller_;
  Asked asked_;
  std::vector<ContactRecord> records_;
};

}  // namespace LAMMPS_NS

#endif

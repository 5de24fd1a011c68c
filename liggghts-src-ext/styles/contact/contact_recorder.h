// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_CONTACT_RECORDER_H
#define LMP_CONTACT_RECORDER_H

#include <string>
#include <vector>
#include "contact_interface.h"
#include "pointers.h"
#include "rodpack/contact/contact_pairs.h"

namespace LAMMPS_NS {

/// One contact of two spheres, or of a sphere and a wall, as this rank sees it. SI units.
struct ContactRecord {
  int i;             // local index of sphere i, owned by this rank
  int j;             // local index of sphere j, owned or ghost; -1 for a wall
  bool primary;      // true on exactly one of the records of a contact, over all ranks
  double normal[3];  // unit vector from j to i, out of a wall
  double point[3];   // contact point, half-way into the overlap, in the periodic image of i, m
  double force[3];   // exerted on i by j, N
  double overlap;    // normal overlap, m
  double spring;     // length of the tangential spring, m
  double kn, kt;     // contact stiffnesses, N/m; kt is 0 without a tangential model
  // Dashpot constants, kg/s (that in the plane of contact acts where kt > 0); effective mass, kg.
  double damping_n, damping_t, effective_mass;
  int type_i, type_j;  // atom types; of a wall its material
};

/// The contact of a record as one of particles, which knows their centres of mass in the periodic
/// images that touch; for a wall the id is 0 and the contact point stands for the centre.
/// `centres` by ParticleIdentity::all_body_centres().
rodpack::SphereContact contact_of(const ContactRecord& record,
                                  const class ParticleIdentity& particles,
                                  const std::vector<rodpack::Vector>& centres);

/// Lists the contacts of this step. `collect` evaluates the contact forces of the pair style and of
/// all wall/gran fixes once more, at the present positions and velocities, without touching forces,
/// contact histories or stored wall forces; the spring_dashpot models report to the recorder that
/// is armed meanwhile.
class ContactRecorder : protected Pointers {
 public:
  /// `caller` is the style that wants the contacts, as messages name it: "compute contact/energy".
  ContactRecorder(class LAMMPS* lmp, const std::string& caller) : Pointers(lmp), caller_(caller) {}

  /// Stops if a contact model that runs does not report.
  void check_models() const;

  /// All records of this rank. A contact across the border of two ranks, or of a periodic image, is
  /// in two lists; one of them is primary. Stops if the contacts are not known yet. Collective.
  const std::vector<ContactRecord>& collect();

  /// Tells the models which recorder is collecting; null if none is.
  static ContactRecorder* armed() { return armed_; }
  void add_contact(const LIGGGHTS::ContactModels::SurfacesIntersectData& sidata,
                   const LIGGGHTS::ContactModels::ForceData& i_forces);
  /// Completes the newest contact; `i_forces` then holds the whole force.
  void add_tangential(const double* spring, double kt,
                      const LIGGGHTS::ContactModels::ForceData& i_forces);

 private:
  void evaluate_wall(class FixWallGran* wall);
  bool is_primary(int i, int j) const;

  static ContactRecorder* armed_;
  std::string caller_;
  std::vector<ContactRecord> records_;
};

}  // namespace LAMMPS_NS

#endif

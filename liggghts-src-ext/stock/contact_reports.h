// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_CONTACT_REPORTS_H
#define RODPACK_CONTACT_REPORTS_H

namespace LAMMPS_NS {
class LAMMPS;
class PairGran;
class FixWallGran;
}  // namespace LAMMPS_NS

namespace LIGGGHTS {
namespace ContactModels {
struct SurfacesIntersectData;
struct ForceData;
}  // namespace ContactModels
}  // namespace LIGGGHTS

namespace rodpack {

/// Is told of every contact while a step evaluates its forces, with the force that acts in the step
/// then. A second evaluation would not find the same one: what a stock model remembers of a contact
/// has moved on, and so may have the velocities.
class ContactReports {
 public:
  /// The style begins to evaluate the forces of this step. Returns whether its contacts are wanted.
  /// `spring`: where in a contact's history the tangential spring begins, -1 if it has none.
  virtual bool begin(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::PairGran* style, int spring) = 0;
  virtual bool begin(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::FixWallGran* style, int spring) = 0;
  /// A contact of the style that has begun, once its models are through.
  virtual void add(const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                   const LIGGGHTS::ContactModels::ForceData& on_i) = 0;

 protected:
  ~ContactReports() {}
};

/// Who is told; null until it has said so.
inline ContactReports*& contact_reports() {
  static ContactReports* reports = nullptr;
  return reports;
}

/// The same while the contacts of the style that evaluates its forces are wanted, else null.
inline ContactReports*& open_reports() {
  static ContactReports* reports = nullptr;
  return reports;
}

template <class Style>
void begin_contacts(LAMMPS_NS::LAMMPS* lmp, Style* style, int spring) {
  ContactReports* const reports = contact_reports();
  open_reports() = reports && reports->begin(lmp, style, spring) ? reports : nullptr;
}

inline void report_contact(const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                           const LIGGGHTS::ContactModels::ForceData& on_i) {
  if (ContactReports* const reports = open_reports()) reports->add(contact, on_i);
}

}  // namespace rodpack

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PARTICLE_IDENTITY_H
#define LMP_PARTICLE_IDENTITY_H

#include <vector>
#include "pointers.h"
#include "rodpack/contact/contact_pairs.h"

namespace LAMMPS_NS {

/// Gives every particle an id: the bodies of fix multisphere (or multisphere/ab) keep theirs, a
/// plain sphere, which belongs to none, has its atom id plus the largest body id.
class ParticleIdentity : protected Pointers {
 public:
  explicit ParticleIdentity(class LAMMPS* lmp);

  /// The fix that owns the bodies, null if there is none.
  class FixMultisphere* bodies() const {
    return bodies_;
  }

  /// Body id of an owned or ghost sphere, -1 for a plain one.
  int body_of(int atom_index) const;

  /// Id of the particle that an owned or ghost sphere belongs to.
  int id_of(int atom_index) const;

  /// Centres of mass of all bodies of all ranks, by body id, m; collective. Absent ids hold zeros.
  std::vector<rodpack::Vector> all_body_centres() const;

  /// Largest id of a particle on any rank; collective.
  int largest_id() const;

  /// Centre of mass of the particle that a sphere belongs to, in the periodic image of that sphere,
  /// m. `centres` by all_body_centres().
  rodpack::Vector centre_near(int sphere, const std::vector<rodpack::Vector>& centres) const;

 private:
  class FixMultisphere* bodies_;
  int largest_body_id_;
};

}  // namespace LAMMPS_NS

#endif

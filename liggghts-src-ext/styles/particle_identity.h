// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PARTICLE_IDENTITY_H
#define LMP_PARTICLE_IDENTITY_H

#include <array>
#include <vector>
#include "pointers.h"

namespace LAMMPS_NS {

/// Particles are the bodies of fix multisphere (or multisphere/ab) and the plain spheres that
/// belong to none. Ids: a body has its own; a plain sphere has its atom id, shifted by the largest
/// body id.
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
  std::vector<std::array<double, 3>> all_body_centres() const;

 private:
  class FixMultisphere* bodies_;
  int largest_body_id_;
};

}  // namespace LAMMPS_NS

#endif

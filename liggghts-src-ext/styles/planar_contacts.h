// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PLANAR_CONTACTS_H
#define LMP_PLANAR_CONTACTS_H

#include <string>
#include <utility>
#include <vector>
#include "pointers.h"
#include "rodpack/planar_scene.h"

namespace LAMMPS_NS {

/// Sphere `sphere` of body `body`, by local indices.
struct PlanarPlace {
  int body, sphere;
};

/// The contacts of pair_style gran and of primitive walls, and their histories, between LIGGGHTS
/// and the planar engine. Of one rank without periodic boundaries: there are no ghosts.
class PlanarContacts : protected Pointers {
 public:
  explicit PlanarContacts(class LAMMPS* lmp) : Pointers(lmp) {}

  /// Finds the pair style and the walls; stops if one of them is of another kind than the engine
  /// knows.
  void connect();
  /// Tangential velocities in the history of a contact.
  int remembered() const { return slots_; }
  /// Contact constants per pair of types, and the walls.
  std::vector<rodpack::PlanarLaw> laws() const;
  std::vector<rodpack::PlanarWall> walls() const;

  /// The contacts of this step. `places`: of each atom.
  std::vector<rodpack::PlanarContactState> read(const std::vector<PlanarPlace>& places) const;
  /// Writes them in the place of those that LIGGGHTS has; the neighbour list must hold their pairs.
  /// `atoms`: of each body.
  void write(const std::vector<rodpack::PlanarContactState>& contacts,
             const std::vector<std::vector<int> >& atoms) const;
  /// Neighbour lists of the walls will be made anew.
  void renew_wall_lists() const;

 private:
  struct Record;
  void refuse(const std::string& what) const;
  int find_in_list(int i, int j, int& owner) const;

  class PairGran* pair_ = NULL;
  std::vector<class FixWallGran*> walls_;
  int values_ = 0, slots_ = 0;  // of a contact's history, of the velocities in it
};

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PLANAR_CONTACTS_H
#define LMP_PLANAR_CONTACTS_H

#include <string>
#include <vector>
#include "planar_owners.h"
#include "pointers.h"
#include "rodpack/planar/scene.h"

namespace LAMMPS_NS {

/// A contact as an atom sees it, on its way between the ranks.
struct PlanarContactRecord {
  int atom, partner;  // tags; a wall: -1 - its index
  double normal[2];   // from the partner to the atom
  rodpack::PlanarContactState state;
};

/// The contacts of pair_style gran and of primitive walls, and their histories, between LIGGGHTS
/// and the planar engine. No periodic boundaries: an atom is there once on a rank.
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

  /// The contacts of this step that bodies of this rank have, each once. Collective.
  std::vector<PlanarContactRecord> read(const PlanarOwners& owners) const;
  /// Both put contacts in the place of those that LIGGGHTS has. Each comes to the ranks of both of
  /// its atoms, as seen from the atom there.
  /// In the neighbour lists, which must hold the pairs:
  void write_to_lists(const std::vector<PlanarContactRecord>& records) const;
  /// Where they travel with the atoms and wait for new lists; after pre_exchange of the fixes:
  void write_to_atoms(const std::vector<PlanarContactRecord>& records) const;

 private:
  struct Record;
  [[noreturn]] void refuse(const std::string& what) const;
  int local_atom(int tag) const;
  void write_to_walls(const std::vector<PlanarContactRecord>& records) const;

  class PairGran* pair_ = NULL;
  std::vector<class FixWallGran*> walls_;
  int values_ = 0, slots_ = 0;  // of a contact's history, of the velocities in it
};

}  // namespace LAMMPS_NS

#endif

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef LMP_PLANAR_CONTACT_TRANSFER_H
#define LMP_PLANAR_CONTACT_TRANSFER_H

#include <vector>
#include "planar_owners.h"
#include "pointers.h"
#include "rodpack/planar/scene.h"

namespace LAMMPS_NS {

/// One contact as one of its two atoms sees it, in the form that is sent between ranks.
struct PlanarContactRecord {
  int atom, partner;  // atom ids; for a wall -1 - its index
  double normal[2];   // unit vector from the partner to the atom
  rodpack::PlanarContactState state;
};

/// Carries the contacts of pair_style gran and of primitive walls, with their histories, from
/// LIGGGHTS to the planar engine and back. There must be no periodic boundaries, so that an atom
/// has one image on a rank.
class PlanarContactTransfer : protected Pointers {
 public:
  explicit PlanarContactTransfer(class LAMMPS* lmp) : Pointers(lmp) {}

  /// Finds the pair style and the walls; stops the run if one of them is of a kind that the engine
  /// does not know.
  void connect();
  /// Number of tangential velocities that the history of a contact holds.
  int slots() const { return slots_; }
  /// Whether friction is capped at mu times the whole normal force, by totalForceCap.
  bool has_total_cap() const { return has_total_cap_; }
  /// Contact constants of each pair of atom types (row by row), and the walls.
  std::vector<rodpack::PlanarLaw> laws() const;
  std::vector<rodpack::PlanarWall> walls() const;

  /// The contacts of this step in which bodies of this rank take part, each once; collective.
  std::vector<PlanarContactRecord> read(const PlanarOwners& owners) const;
  /// Replaces the contacts that LIGGGHTS has, in its neighbour lists, which must hold the pairs.
  /// `records`: for each contact those of its atoms that this rank owns, as seen from the atom.
  void write_to_lists(const std::vector<PlanarContactRecord>& records);
  /// The same where histories travel with the atoms until new lists are built; to be called after
  /// pre_exchange() of the fixes.
  void write_to_atoms(const std::vector<PlanarContactRecord>& records);

 private:
  struct Record;
  int local_atom(int tag) const;
  /// What is stored of a contact.
  Record record_of(const double* stored) const;
  void store(const PlanarContactRecord& contact, double* stored) const;
  void write_to_walls(const std::vector<PlanarContactRecord>& records);

  class PairGran* pair_ = NULL;
  std::vector<class FixWallGran*> walls_;
  int values_ = 0;  // in a contact's history
  int slots_ = 0;   // tangential velocities among them
  bool has_total_cap_ = false;
};

}  // namespace LAMMPS_NS

#endif

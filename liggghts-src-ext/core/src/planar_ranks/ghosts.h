// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_PLANAR_GHOSTS_H
#define RODPACK_PLANAR_GHOSTS_H

#include <unordered_map>
#include <vector>

#include "../planar/contact.h"
#include "rodpack/planar/scene.h"

namespace rodpack {

class PlanarBodyStates;
class PlanarEvents;
class PlanarNeighbours;

/// The ghost bodies of a rank, as its bodies, neighbour lists and events know them. Knows nothing
/// of the other ranks.
class PlanarGhosts {
 public:
  PlanarGhosts(PlanarBodyStates& bodies, PlanarNeighbours& neighbours, PlanarEvents& events)
      : bodies_(bodies), neighbours_(neighbours), events_(events) {}

  /// Makes these bodies the ghosts. Those that have been ghosts before, by their tags, keep their
  /// index, and with it their contacts. Appends to `to_list` those that have to be listed anew.
  void choose(const std::vector<PlanarBody>& chosen, std::vector<int>& to_list);
  /// Index among the bodies of the ghost with this tag.
  int of_tag(int tag) const { return of_tag_.at(tag); }
  /// Brings a ghost to the next step; appends it to `to_list` if it has to be listed anew.
  void move(int ghost, const PlanarKinematics& kinematics, std::vector<int>& to_list);

 private:
  void drop_all_but(const std::vector<PlanarBody>& chosen);
  int new_ghost();

  PlanarBodyStates& bodies_;
  PlanarNeighbours& neighbours_;
  PlanarEvents& events_;
  std::unordered_map<int, int> of_tag_;
  std::vector<int> unused_;  // indices that ghosts have had
};

}  // namespace rodpack

#endif

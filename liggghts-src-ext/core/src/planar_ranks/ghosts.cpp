// SPDX-License-Identifier: GPL-2.0-or-later
#include "ghosts.h"

#include <algorithm>

#include "../planar/bodies.h"
#include "../planar/events.h"
#include "../planar_lists/neighbours.h"

namespace rodpack {

void PlanarGhosts::choose(const std::vector<PlanarBody>& chosen, std::vector<int>& to_list) {
  drop_all_but(chosen);
  bodies_.forget_ghost_spheres();
  for (const PlanarBody& body : chosen) {
    const auto known = of_tag_.find(body.tag);
    const int ghost = known == of_tag_.end() ? new_ghost() : known->second;
    const PlanarKinematics before = bodies_.kinematics(ghost);
    bodies_.set_ghost(ghost, body);
    if (body.jumped) events_.set_jumped(ghost, body.jump);
    if (known != of_tag_.end()) {
      if (neighbours_.follow_ghost(ghost, before)) to_list.push_back(ghost);
      continue;
    }
    of_tag_[body.tag] = ghost;
    neighbours_.add_ghost(ghost);
    if (neighbours_.exist()) to_list.push_back(ghost);
  }
}

void PlanarGhosts::drop_all_but(const std::vector<PlanarBody>& chosen) {
  std::unordered_map<int, int> before;
  before.swap(of_tag_);
  for (const PlanarBody& body : chosen) {
    const auto known = before.find(body.tag);
    if (known == before.end()) continue;
    of_tag_.insert(*known);
    before.erase(known);
  }
  // The order must not depend on that of the map.
  std::vector<int> dropped;
  for (const auto& entry : before) dropped.push_back(entry.second);
  std::sort(dropped.begin(), dropped.end());
  for (int ghost : dropped) {
    neighbours_.remove_ghost(ghost);
    bodies_.clear_ghost(ghost);
    unused_.push_back(ghost);
  }
}

int PlanarGhosts::new_ghost() {
  if (!unused_.empty()) {
    const int ghost = unused_.back();
    unused_.pop_back();
    return ghost;
  }
  const int ghost = bodies_.size();
  bodies_.resize(ghost + 1);
  neighbours_.resize(ghost + 1);
  events_.resize(ghost + 1);
  return ghost;
}

void PlanarGhosts::move(int ghost, const PlanarKinematics& kinematics, std::vector<int>& to_list) {
  const PlanarKinematics before = bodies_.kinematics(ghost);
  bodies_.move_ghost(ghost, kinematics);
  if (neighbours_.follow_ghost(ghost, before)) to_list.push_back(ghost);
}

}  // namespace rodpack

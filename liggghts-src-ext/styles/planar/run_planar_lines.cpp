// SPDX-License-Identifier: GPL-2.0-or-later
// New particles that the planar engine takes in without a step of LIGGGHTS's own. An observed step
// costs as much as some 200 steps of the engine, and an inserted line changes nothing but that
// there are more bodies.
#include <map>
#include <utility>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "fix_gravity.h"
#include "fix_insert_line.h"
#include "fix_multisphere_ab.h"
#include "modify.h"
#include "multisphere.h"
#include "output.h"
#include "rodpack/planar/scene.h"
#include "run_planar.h"
#include "update.h"

namespace LAMMPS_NS {

/// The fix whose line is all that happens in the next observed step, `step`; NULL if there is more,
/// or if the engine cannot take the line in: bodies of several ranks change their rank in observed
/// steps, and what touches walls when it comes has forces already, which LIGGGHTS evaluates.
FixInsertLine* RunPlanar::line_alone_in(bigint step) const {
  if (comm->nprocs > 1 || step >= update->laststep || step == output->next) return NULL;
  FixInsertLine* line = NULL;
  for (int k = 0; k < modify->nfix; ++k) {
    if (next_step_of(k) != step) continue;
    if (line) return NULL;
    line = dynamic_cast<FixInsertLine*>(modify->fix[k]);
    if (!line) return NULL;
  }
  if (!line) return NULL;
  for (const rodpack::PlanarWall& wall : contacts_.walls())
    if (!line->keeps_clear_of(wall.axis, wall.position)) return NULL;
  return line;
}

/// Inserts the line in the step that the scene has reached, and goes on with a scene that has its
/// bodies too, behind the others.
void RunPlanar::take_in_line(FixInsertLine& line) {
  give_bodies_back();  // the line must not overlap them
  std::vector<rodpack::PlanarBody> bodies = take_bodies();
  std::vector<rodpack::PlanarContactState> contacts = scene_->contacts();
  count_steps();

  const int first_atom = atom->nlocal;
  line.pre_exchange();
  std::map<int, std::vector<int> > atoms_of;  // by the tag of their body
  for (int i = first_atom; i < atom->nlocal; ++i) atoms_of[bodies_->belongs_to(i)].push_back(i);
  for (const auto& atoms : atoms_of) {
    order_.push_back(bodies_->data().map(atoms.first));
    atoms_.push_back(atoms.second);
    bodies.push_back(new_body(order_.back(), atoms_.back()));
  }
  lists_lack_atoms_ = true;

  make_scene(bodies, [&] { return std::move(contacts); });
}

/// A body that nothing touches yet: only its weight acts on it.
rodpack::PlanarBody RunPlanar::new_body(int body, const std::vector<int>& atoms) {
  rodpack::PlanarBody taken = take_body(body, atoms);
  double gravity[3] = {0.0, 0.0, 0.0};
  if (gravity_) gravity_->get_gravity(gravity);
  for (int d = 0; d < 2; ++d) taken.load[d] = taken.mass * gravity[d];
  taken.load[2] = 0.0;
  return taken;
}

}  // namespace LAMMPS_NS

// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_wall_gran_solid.h"

#include <algorithm>
#include <limits>
#include <string>

#include "atom.h"
#include "contact_interface.h"
#include "fix_property_atom.h"
#include "granular_wall.h"
#include "neighbor.h"
#include "stop_run.h"
#include "style_arguments.h"

using namespace LAMMPS_NS;

/// The command, taken apart: the words that wall/gran understands, and which side is free.
struct FixWallGranSolid::Arguments {
  std::vector<char*> words;
  int axis;
  double position;
  int free_side;

  Arguments(LAMMPS* lmp, int narg, char** arg) : words(arg, arg + narg) {
    StyleArguments wall(lmp, narg, arg), side(lmp, narg, arg);
    if (wall.find("primitive") < 0)
      wall.fail("keyword primitive is missing, expected 'primitive type T PLANE POSITION'");
    wall.choice("primitive", {"type"});
    const std::string type = wall.peek();
    const int types = lmp->atom->ntypes;
    if (wall.integer("T", an_atom_type) > types)
      wall.reject("T", "at most " + std::to_string(types) + ", the number of atom types", type);
    axis = wall.choice("PLANE", {"xplane", "yplane", "zplane"});
    position = wall.number("POSITION", a_position);
    const int place = side.find("bound");
    if (place < 0) side.fail("keyword bound is missing, expected 'bound lo' or 'bound hi'");
    free_side = side.choice("bound", {"lo", "hi"}) == 0 ? 1 : -1;
    words.erase(words.begin() + place, words.begin() + place + 2);
  }
};

FixWallGranSolid::FixWallGranSolid(LAMMPS* lmp, int narg, char** arg)
    : FixWallGranSolid(lmp, Arguments(lmp, narg, arg)) {}

FixWallGranSolid::FixWallGranSolid(LAMMPS* lmp, Arguments given)
    : FixWallGran(lmp, static_cast<int>(given.words.size()), given.words.data()),
      axis_(given.axis),
      position_(given.position),
      free_side_(given.free_side) {
  refuse_what_it_cannot();
}

void FixWallGranSolid::refuse_what_it_cannot() const {
  if (shear_) stop_run(lmp, *this, "'shear' is not supported, expected a wall at rest");
  if (Temp_wall >= 0.0)
    stop_run(lmp, *this, "'temperature' is not supported, expected a wall without heat");
}

void FixWallGranSolid::pre_force(int vflag) {
  const bool stale = rebuildPrimitiveNeighlist_;
  FixWallGran::pre_force(vflag);
  if (!stale) return;
  near_.clear();
  for (int i = 0; i < atom->nlocal; ++i)
    if (depth(i) > -neighbor->skin) near_.push_back(i);
}

/// Does what wall/gran does, with a distance that is negative behind the plane.
void FixWallGranSolid::post_force_primitive(int) {
  double** const histories = dnum() > 0 ? fix_history_primitive_->array_atom : NULL;
  double at_rest[] = {0.0, 0.0, 0.0};
  LCM::SurfacesIntersectData contact;
  contact.is_wall = true;
  for (int i : near_) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double overlap = depth(i);
    const bool far = overlap < -(neighbor->contactDistanceFactor - 1.0) * radius_[i];
    // A contact has an end, however far the sphere has gone in its last step.
    if (far && (!histories || is_empty(histories[i]))) continue;
    contact.i = i;
    contact.contact_history = histories ? histories[i] : NULL;
    contact.radi = radius_[i];
    contact.deltan = overlap;
    // The models divide by the distance, radius - overlap.
    if (contact.deltan == contact.radi)
      contact.deltan *= 1.0 - std::numeric_limits<double>::epsilon();
    for (int d = 0; d < 3; ++d) contact.delta[d] = 0.0;
    contact.delta[axis_] = free_side_ * (contact.radi - contact.deltan);
    impl->compute_force(this, contact, overlap >= 0.0, at_rest);
    if (far) std::fill_n(histories[i], dnum(), 0.0);
  }
}

bool FixWallGranSolid::is_empty(const double* history) const {
  return std::all_of(history, history + dnum(), [](double value) { return value == 0.0; });
}

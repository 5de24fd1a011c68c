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
  std::string plane, bound;
  double position;

  Arguments(LAMMPS* lmp, int narg, char** arg) : words(arg, arg + narg), position(0.0) {
    StyleArguments wall(lmp, narg, arg), side(lmp, narg, arg);
    if (wall.find("primitive") >= 0 && wall.left() >= 4) {
      wall.word("primitive", "type");
      wall.word("type", "an atom type");
      plane = wall.word("primitive", "a plane");
      position = wall.number("position of the plane", "a number in m");
    }
    const int place = side.find("bound");
    if (place < 0) return;
    bound = side.more() ? side.peek() : "nothing";
    words.erase(words.begin() + place, words.begin() + std::min(place + 2, narg));
  }
};

FixWallGranSolid::FixWallGranSolid(LAMMPS* lmp, int narg, char** arg)
    : FixWallGranSolid(lmp, Arguments(lmp, narg, arg)) {}

FixWallGranSolid::FixWallGranSolid(LAMMPS* lmp, Arguments given)
    : FixWallGran(lmp, static_cast<int>(given.words.size()), given.words.data()),
      axis_(-1),
      position_(given.position),
      free_side_(given.bound == "lo" ? 1 : -1) {
  const char* const planes[] = {"xplane", "yplane", "zplane"};
  for (int d = 0; d < 3; ++d)
    if (given.plane == planes[d]) axis_ = d;
  if (axis_ < 0)
    stop_run(lmp, *this,
             "expected a plane, 'primitive type T xplane|yplane|zplane POSITION', got '" +
                 given.plane + "'");
  if (given.bound != "lo" && given.bound != "hi")
    stop_run(lmp, *this,
             "bound must be lo (the particles are above the plane) or hi (below it), got '" +
                 given.bound + "'");
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

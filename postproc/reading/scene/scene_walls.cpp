// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/scene/scene_walls.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "reading/number_text.h"

namespace rodpack {
namespace {

constexpr const char* scene_axes = "xyz";

// Centres of the particles of any dump: contacts know those of their bodies.
VectorColumns centres_of(const Frame& frame) {
  if (frame.has("bix")) return vector_columns(frame, {"bix", "biy", "biz"});
  return vector_columns(frame, {"x", "y", "z"});
}

// The planes next to the particles, per axis, and the walls that are none of them.
struct Container {
  std::array<const SceneWall*, 3> low{}, high{};
  const SceneWall* side = nullptr;  // an upright cylinder
  std::vector<std::string> notes;
};

class ContainerSearch {
 public:
  ContainerSearch(const RunScene& scene, const Frame& frame, std::size_t vertical,
                  const std::set<std::size_t>& axes, bool in_space)
      : scene_(scene),
        frame_(frame),
        centre_(centres_of(frame)),
        vertical_(vertical),
        axes_(axes),
        in_space_(in_space) {}

  Container find() {
    for (const auto& wall : scene_.walls) {
      if (!wall.touches_all)
        leave_out(wall, "acts on some particles alone");
      else if (wall.kind == SceneWall::Kind::plane)
        add_plane(wall);
      else if (wall.kind == SceneWall::Kind::cylinder)
        add_cylinder(wall);
      else
        leave_out(wall, "");
    }
    return found_;
  }

 private:
  void leave_out(const SceneWall& wall, const std::string& why) {
    found_.notes.push_back("walls: " + wall.description() + ", is not taken for a wall of the " +
                           "container" + (why.empty() ? "" : ": it " + why));
  }

  void add_plane(const SceneWall& wall) {
    if (axes_.count(wall.axis) == 0) return;  // in front of or behind a plane
    if (frame_.periodic[wall.axis]) return leave_out(wall, "is in a periodic direction");
    const auto& place = *centre_[wall.axis];
    const auto above = static_cast<std::size_t>(std::count_if(
        place.begin(), place.end(), [&](double each) { return each > wall.position; }));
    int side = wall.free_side;
    if (side == 0 && above == place.size()) side = 1;
    if (side == 0 && above == 0) side = -1;
    if (side == 0)
      return leave_out(
          wall, "has particles on both sides, " + std::to_string(above) + " of them beyond it");
    if (side < 0 && wall.axis == vertical_)
      return leave_out(wall, "is above the bed, whose top is open");
    auto& nearest = (side > 0 ? found_.low : found_.high)[wall.axis];
    if (!nearest || side * (wall.position - nearest->position) > 0) nearest = &wall;
  }

  void add_cylinder(const SceneWall& wall) {
    if (!in_space_ || wall.axis != vertical_) return leave_out(wall, "is not upright");
    const auto a = (vertical_ + 1) % 3, b = (vertical_ + 2) % 3;
    if (frame_.periodic[a] || frame_.periodic[b])
      return leave_out(wall, "is in a periodic direction");
    for (std::size_t row = 0; row < frame_.rows; ++row)
      if (std::hypot((*centre_[a])[row] - wall.middle[a], (*centre_[b])[row] - wall.middle[b]) >
          wall.radius)
        return leave_out(wall, "has particles outside it");
    if (!found_.side || wall.radius < found_.side->radius) found_.side = &wall;
  }

  const RunScene& scene_;
  const Frame& frame_;
  VectorColumns centre_;
  std::size_t vertical_;
  std::set<std::size_t> axes_;
  bool in_space_;
  Container found_;
};

// "run/scene.7.json", and where it has no wall: "run/scene.7.json; box bounds: x low".
std::string source_of(const RunScene& scene, const std::vector<std::string>& missing) {
  std::string text = scene.file;
  for (std::size_t k = 0; k < missing.size(); ++k)
    text += (k == 0 ? "; box bounds: " : ", ") + missing[k];
  return text;
}

}  // namespace

Walls walls_of_scene(const RunScene& scene, const Frame& frame) {
  constexpr std::size_t x = 0, y = 1;
  const auto found = ContainerSearch(scene, frame, y, {x, y}, false).find();
  Walls walls;
  walls.sides = !frame.periodic[x];
  walls.bottom = !frame.periodic[y];
  std::vector<std::string> missing;
  const auto place = [&](const SceneWall* wall, double bound, bool needed, const char* name) {
    if (!wall && needed) missing.emplace_back(name);
    return wall ? wall->position : bound;
  };
  walls.left = place(found.low[x], frame.bounds[x][0], walls.sides, "left");
  walls.right = place(found.high[x], frame.bounds[x][1], walls.sides, "right");
  walls.floor = place(found.low[y], frame.bounds[y][0], walls.bottom, "floor");
  walls.source = source_of(scene, missing);
  walls.notes = found.notes;
  const auto& g = scene.gravity;
  if (g && std::hypot((*g)[0], (*g)[1], (*g)[2]) > 0 && scene.vertical() != y)
    walls.notes.push_back("gravity is (" + number_text((*g)[0], 4) + ", " +
                          number_text((*g)[1], 4) + ", " + number_text((*g)[2], 4) +
                          ") m/s2: the measures in a plane have y up all the same");
  return walls;
}

SpatialWalls spatial_walls_of_scene(const RunScene& scene, const Frame& bodies,
                                    std::size_t vertical) {
  const auto found = ContainerSearch(scene, bodies, vertical, {0, 1, 2}, true).find();
  SpatialWalls walls;
  walls.vertical = vertical;
  walls.periodic = bodies.periodic;
  std::vector<std::string> missing;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool side_known = found.side && axis != vertical;
    const std::string name(1, scene_axes[axis]);
    for (const bool upper : {false, true}) {
      const auto* wall = (upper ? found.high : found.low)[axis];
      const bool open = upper && axis == vertical;
      if (!wall && !side_known && !open && !walls.periodic[axis])
        missing.push_back(name + (upper ? " high" : " low"));
      (upper ? walls.high : walls.low)[axis] =
          wall ? wall->position : bodies.bounds[axis][upper ? 1 : 0];
    }
  }
  if (found.side) {
    walls.round = true;
    walls.radius = found.side->radius;
    for (const std::size_t which : {0U, 1U})
      walls.middle[which] = found.side->middle[walls.horizontal(which)];
  }
  walls.source = source_of(scene, missing);
  walls.notes = found.notes;
  return walls;
}

}  // namespace rodpack

// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef RODPACK_READING_SCENE_RUN_SCENE_H
#define RODPACK_READING_SCENE_RUN_SCENE_H

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reading/checks/body_axes.h"
#include "reading/dump.h"

namespace rodpack {

/// A wall of a run, as `dump scene` tells it.
struct SceneWall {
  enum class Kind { plane, cylinder, mesh, other };
  Kind kind = Kind::other;
  std::string name;         // "fix floor", "fix walls (mesh hopper)"
  bool touches_all = true;  // false: it acts on a group of particles alone
  std::size_t axis = 0;     // normal of a plane, axis of a cylinder
  double position = 0;      // of a plane along its axis, m
  int free_side = 0;        // of a plane: 1 or -1, where the particles may be; 0: both
  Vector3 middle{};         // a point of a cylinder's axis, m
  double radius = 0;        // of a cylinder, m
  Vector3 low{}, high{};    // box around a mesh, m

  /// What and where it is, for reports.
  std::string description() const;
};

/// Coefficients of friction between atom types, row by row, the first type's first.
using FrictionTable = std::vector<std::vector<double>>;

/// What surrounds the particles of a run at one step.
struct RunScene {
  std::string file;
  long timestep = 0;
  double timestep_length = 0;      // s
  std::optional<Vector3> gravity;  // m/s^2; none: not the same for all particles
  std::vector<SceneWall> walls;
  FrictionTable friction;  // empty: the deck has none

  /// The axis that points up, 0 to 2: gravity's own, the other way; none where it is along no axis,
  /// or where there is none. @throws DataError when it points up along one.
  std::optional<std::size_t> vertical() const;
};

/// Reads a file of `dump scene`. @throws DataError naming file, wall and key of what is missing or
/// wrong, units other than SI among them.
RunScene read_scene(const std::string& file);

/// Reads the scene of a frame: scene.STEP.json or scene.json in the frame's folder, else one folder
/// up; none where there is no such file.
/// @throws DataError as read_scene(), and when there are scenes, but of other timesteps.
std::optional<RunScene> find_scene(const Frame& frame);

/// Length of a time step, s: the scene's, else timestep_s of parameters.json (at `parameters`, or
/// as find_parameters() finds it); none where nobody says it.
std::optional<double> find_timestep(const Frame& frame, const std::string& parameters);

/// The coefficients of friction of a run's contacts, or why there are none.
struct FrictionFound {
  FrictionTable table;  // of one coefficient: that of all contacts; empty: none
  std::string missing;
};
/// Finds them: `given` for all, else the scene's, where they differ between atom types only if the
/// contacts tell theirs (columns `type_i type_j`), else `friction` of parameters.json as above;
/// none if that is missing or 0. @throws DataError when it is negative.
FrictionFound find_friction(const Frame& contacts, const std::string& parameters,
                            std::optional<double> given);

}  // namespace rodpack

#endif

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

/// What surrounds the particles of a run at one step.
struct RunScene {
  std::string file;
  long timestep = 0;
  double timestep_length = 0;      // s
  std::optional<Vector3> gravity;  // m/s^2; none: not the same for all particles
  std::vector<SceneWall> walls;
  std::vector<std::vector<double>> friction;  // between atom types; empty: the deck has none

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

/// The coefficient of friction of a run's contacts, or why there is none.
struct FrictionFound {
  std::optional<double> coefficient;
  std::string missing;
};
/// Finds it: `given`, else the scene's, if all atom types have the same, else `friction` of
/// parameters.json as above; none if that is missing or 0. @throws DataError when it is negative.
FrictionFound find_friction(const Frame& frame, const std::string& parameters,
                            std::optional<double> given);

}  // namespace rodpack

#endif

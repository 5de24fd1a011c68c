// SPDX-License-Identifier: GPL-2.0-or-later
#include "reading/scene/run_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "reading/checks/number_range.h"
#include "reading/json_file.h"
#include "reading/number_text.h"
#include "reading/parameters.h"
#include "reading/parsing.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr NumberRange any_place{-1e6, 1e6}, any_length{0, 1e6, false, true};

// One object of the file, whose values are asked for by their keys.
class SceneObject {
 public:
  SceneObject(const Json& values, std::string where) : values_(values), where_(std::move(where)) {
    if (!values.is_object())
      throw DataError(where_ + ": expected an object, found " + text(values));
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& expected) const {
    throw DataError(where_ + ": key '" + key + "': expected " + expected + ", found " +
                    (values_.contains(key) ? text(values_.at(key)) : std::string("none")));
  }
  const Json& value(const std::string& key, const std::string& expected) const {
    if (!values_.contains(key)) refuse(key, expected);
    return values_.at(key);
  }
  bool has(const std::string& key) const { return values_.contains(key); }

  double number(const std::string& key, const NumberRange& range) const {
    const auto& found = value(key, range.text());
    if (!found.is_number() || !range.contains(found.get<double>())) refuse(key, range.text());
    return found.get<double>();
  }
  std::string word(const std::string& key) const {
    const auto& found = value(key, "a text");
    if (!found.is_string()) refuse(key, "a text");
    return shortened(found.get<std::string>());
  }
  std::size_t axis(const std::string& key) const {
    const auto at = std::string("xyz").find(word(key));
    if (word(key).size() != 1 || at == std::string::npos) refuse(key, "\"x\", \"y\" or \"z\"");
    return at;
  }
  Vector3 vector(const std::string& key, const NumberRange& range) const {
    const std::string expected = "three of " + range.text();
    const auto& found = value(key, expected);
    const auto good = [&](const Json& each) {
      return each.is_number() && range.contains(each.get<double>());
    };
    if (!found.is_array() || found.size() != 3 || !std::all_of(found.begin(), found.end(), good))
      refuse(key, expected);
    return {found[0].get<double>(), found[1].get<double>(), found[2].get<double>()};
  }

 private:
  static std::string text(const Json& value) { return shortened(value.dump()); }

  const Json& values_;
  std::string where_;
};

SceneWall read_wall(const SceneObject& values) {
  SceneWall wall;
  wall.name = "fix " + values.word("fix");
  wall.touches_all = !values.has("group");
  const auto kind = values.word("kind");
  if (kind == "plane") {
    wall.kind = SceneWall::Kind::plane;
    wall.axis = values.axis("axis");
    wall.position = values.number("position_m", any_place);
    wall.free_side = static_cast<int>(values.number("free_side", {-1, 1, true}));
  } else if (kind == "cylinder") {
    wall.kind = SceneWall::Kind::cylinder;
    wall.axis = values.axis("axis");
    wall.middle = values.vector("middle_m", any_place);
    wall.radius = values.number("radius_m", any_length);
  } else if (kind == "mesh") {
    wall.kind = SceneWall::Kind::mesh;
    wall.name += " (mesh " + values.word("mesh") + ")";
    wall.low = values.vector("low_m", any_place);
    wall.high = values.vector("high_m", any_place);
  } else if (kind != "other") {
    values.refuse("kind", "plane, cylinder, mesh or other");
  }
  return wall;
}

FrictionTable read_friction(const SceneObject& scene) {
  const std::string expected = "a square table of numbers of 0 to 1000, or null";
  const auto& found = scene.value("friction", expected);
  if (found.is_null()) return {};
  if (!found.is_array()) scene.refuse("friction", expected);
  constexpr NumberRange range{0, 1000};
  FrictionTable table;
  for (const auto& row : found) {
    table.emplace_back();
    if (!row.is_array() || row.size() != found.size()) scene.refuse("friction", expected);
    for (const auto& each : row) {
      if (!each.is_number() || !range.contains(each.get<double>()))
        scene.refuse("friction", expected);
      table.back().push_back(each.get<double>());
    }
  }
  return table;
}

// The step in a name such as scene.1200.json; none in scene.json.
std::optional<long> step_in_name(const std::string& name) {
  static const std::regex form("scene\\.(?:.*\\.)?0*([0-9]{1,16})\\.json");
  std::smatch match;
  if (!std::regex_match(name, match, form)) return std::nullopt;
  return std::stol(match[1]);
}

struct SceneFiles {
  std::string of_step, without_step, another;
};

SceneFiles scenes_in(const fs::path& folder, long timestep) {
  SceneFiles found;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const auto name = entry->path().filename().string();
    const auto step = step_in_name(name);
    if (name == "scene.json")
      found.without_step = entry->path().string();
    else if (step == timestep)
      found.of_step = entry->path().string();
    else if (step && (found.another.empty() || entry->path().string() < found.another))
      found.another = entry->path().string();
  }
  return found;
}

std::string place(const Vector3& at) {
  return "(" + number_text(at[0], 4) + ", " + number_text(at[1], 4) + ", " + number_text(at[2], 4) +
         ")";
}

}  // namespace

std::string SceneWall::description() const {
  const std::string along(1, "xyz"[axis]);
  switch (kind) {
    case Kind::plane:
      return name + ", the plane " + along + " = " + number_text(position, 6) + " m";
    case Kind::cylinder:
      return name + ", a cylinder along " + along + " of radius " + number_text(radius, 6) +
             " m about " + place(middle) + " m";
    case Kind::mesh:
      return name + ", a mesh from " + place(low) + " to " + place(high) + " m";
    case Kind::other:
      break;
  }
  return name + ", a wall of another kind";
}

std::optional<std::size_t> RunScene::vertical() const {
  if (!gravity) return std::nullopt;
  const auto& g = *gravity;
  const double size = std::hypot(g[0], g[1], g[2]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!(size > 0) || std::abs(std::abs(g[axis]) - size) > 1e-9 * size) continue;
    if (g[axis] < 0) return axis;
    throw DataError(
        file + ": key 'gravity_m_s2': expected gravity along -x, -y or -z, found it along +" +
        "xyz"[axis] + "; --vertical and a deck with that axis the other way measure it");
  }
  return std::nullopt;
}

RunScene read_scene(const std::string& file) {
  const auto content = read_json_object(file);
  const SceneObject values(content, file);
  if (values.word("format") != "rodpack-scene 1") values.refuse("format", "\"rodpack-scene 1\"");
  if (values.word("units") != "si") values.refuse("units", "\"si\"");
  RunScene scene;
  scene.file = file;
  scene.timestep = static_cast<long>(values.number("timestep", {0, 9007199254740992.0, true}));
  scene.timestep_length = values.number("timestep_s", {0, 1e6, false, true});
  if (!values.value("gravity_m_s2", "three numbers, or null").is_null())
    scene.gravity = values.vector("gravity_m_s2", {-1e9, 1e9});
  const auto& walls = values.value("walls", "a list");
  if (!walls.is_array()) values.refuse("walls", "a list");
  for (std::size_t k = 0; k < walls.size(); ++k)
    scene.walls.push_back(
        read_wall(SceneObject(walls[k], file + ": wall " + std::to_string(k + 1))));
  scene.friction = read_friction(values);
  return scene;
}

std::optional<RunScene> find_scene(const Frame& frame) {
  const auto folder = fs::absolute(frame.file).parent_path();
  for (const auto& each : {folder, folder.parent_path()}) {
    const auto files = scenes_in(each, frame.timestep);
    const auto& file = !files.of_step.empty()        ? files.of_step
                       : !files.without_step.empty() ? files.without_step
                                                     : files.another;
    if (file.empty()) continue;
    auto scene = read_scene(file);
    if (scene.timestep != frame.timestep)
      throw DataError(file + ": expected a scene of timestep " + std::to_string(frame.timestep) +
                      " as " + frame.file + ", found timestep " + std::to_string(scene.timestep) +
                      "; dump scene has to be written as often as the particles");
    return scene;
  }
  return std::nullopt;
}

std::optional<double> find_timestep(const Frame& frame, const std::string& parameters) {
  if (const auto scene = find_scene(frame)) return scene->timestep_length;
  const auto found = find_parameters(frame.file, parameters);
  if (!found || !found->values.contains("timestep_s")) return std::nullopt;
  return found->number("timestep_s");
}

FrictionFound find_friction(const Frame& contacts, const std::string& parameters,
                            std::optional<double> given) {
  if (given) return {{{*given}}, ""};
  const std::string hint = ", so that the mobilised friction is left out; --friction gives one";
  const auto scene = find_scene(contacts);
  if (scene && !scene->friction.empty()) {
    const double first = scene->friction[0][0];
    for (const auto& row : scene->friction)
      for (const double each : row) {
        if (each == first) continue;
        if (contacts.has("type_i") && contacts.has("type_j")) return {scene->friction, ""};
        return {{},
                scene->file + " has another friction between other atom types, " +
                    number_text(first, 4) + " and " + number_text(each, 4) +
                    ", and the contacts do not tell theirs (columns 'type_i type_j', which dumps "
                    "of earlier versions lack)" +
                    hint};
      }
    if (first > 0) return {{{first}}, ""};
    return {{}, scene->file + " has friction 0" + hint};
  }
  const auto found = find_parameters(contacts.file, parameters);
  if (found && found->values.contains("friction")) {
    const double mu = found->number("friction");
    if (mu < 0)
      throw DataError(found->file + ": key 'friction': expected a value of at least 0, found " +
                      number_text(mu));
    if (mu > 0) return {{{mu}}, ""};
  }
  return {{}, "no positive friction in parameters.json" + hint};
}

}  // namespace rodpack

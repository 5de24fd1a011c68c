// SPDX-License-Identifier: GPL-2.0-or-later
// What `dump scene` tells of a run, and what the measures take from it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../space/spatial_scene.h"
#include "liggghts_run.h"
#include "periodic_bed.h"
#include "reading/scene/run_scene.h"
#include "reading/scene/scene_walls.h"

namespace {
using namespace rodpack;
using nlohmann::json;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;
namespace fs = std::filesystem;

json plane(const std::string& fix, const std::string& axis, double position, int free_side = 0) {
  return {{"fix", fix},   {"style", "wall/gran"},   {"kind", "plane"},
          {"axis", axis}, {"position_m", position}, {"free_side", free_side}};
}

json cylinder(const std::string& fix, const std::string& axis, const std::vector<double>& middle,
              double radius) {
  return {{"fix", fix},   {"style", "wall/gran"}, {"kind", "cylinder"},
          {"axis", axis}, {"middle_m", middle},   {"radius_m", radius}};
}

json mesh(const std::string& fix) {
  return {{"fix", fix},       {"style", "wall/gran"}, {"kind", "mesh"},
          {"mesh", "hopper"}, {"low_m", {0, 0, 0}},   {"high_m", {0.1, 0.2, 0.3}}};
}

json scene_with(const std::vector<json>& walls) {
  return {{"format", "rodpack-scene 1"},
          {"units", "si"},
          {"timestep", 7},
          {"timestep_s", 1e-5},
          {"gravity_m_s2", {0, 0, -9.81}},
          {"walls", walls},
          {"friction", {{0.3}}},
          {"templates", json::array()}};
}

class SceneOfADeck : public testing::Test {
 protected:
  // A frame of bodies on or off the walls, in a box from 0 to 0.1.
  Frame frame(const std::vector<Vector3>& places, const std::string& flags = "ff ff ff") const {
    return last_frame(
        {put(folder_ / "bodies.7.dump",
             rodpack::test::spatial_bodies(places, std::vector<Vector3>(places.size(), {1, 0, 0}),
                                           {0.1, 0.1, 0.1}, flags))});
  }
  Frame middle() const { return frame({{0.05, 0.05, 0.05}, {0.06, 0.04, 0.02}}); }
  void tell(const json& scene, const std::string& name = "scene.7.json") const {
    put(folder_ / name, scene.dump());
  }
  void tell_walls(const std::vector<json>& walls) const { tell(scene_with(walls)); }
  SpatialWalls walls_in_space(const Frame& bodies, const SpaceOptions& space = {}) const {
    return read_spatial_packing(bodies, {}, space).walls;
  }
  std::string refusal(const json& scene) const {
    tell(scene);
    try {
      find_scene(middle());
    } catch (const DataError& reason) {
      return reason.what();
    }
    return "";
  }
  fs::path folder_ = fresh_folder();
};

TEST_F(SceneOfADeck, PlanesNextToTheParticlesAreTheContainer) {
  tell_walls({plane("floor", "z", 0.01, 1), plane("far", "x", -0.02), plane("left", "x", 0.005),
              plane("right", "x", 0.09, -1), plane("front", "y", 0.0), plane("back", "y", 0.1)});
  const auto walls = walls_in_space(middle());
  EXPECT_EQ(walls.vertical, 2U);
  EXPECT_THAT(walls.low, ElementsAre(0.005, 0.0, 0.01));
  EXPECT_THAT(walls.high, ElementsAre(0.09, 0.1, 0.1));
  EXPECT_FALSE(walls.round);
  EXPECT_THAT(walls.source, testing::EndsWith("scene.7.json"));
  EXPECT_THAT(walls.notes, IsEmpty());
}

TEST_F(SceneOfADeck, AnUprightCylinderIsTheSideWall) {
  tell_walls({plane("floor", "z", 0.0), cylinder("side", "z", {0.05, 0.04, 0}, 0.04),
              cylinder("wide", "z", {0.05, 0.04, 0}, 0.06)});
  const auto walls = walls_in_space(middle());
  EXPECT_TRUE(walls.round);
  EXPECT_EQ(walls.radius, 0.04);
  EXPECT_THAT(walls.middle, ElementsAre(0.05, 0.04));
  EXPECT_THAT(walls.notes, IsEmpty());
  EXPECT_THAT(walls.source, testing::EndsWith("scene.7.json"));
}

// A wall that is not understood is named, and the box that stands in for it is too.
TEST_F(SceneOfADeck, WhatIsNoWallOfTheContainerIsNamedAndNotTaken) {
  auto of_group = plane("some", "x", 0.02);
  of_group["group"] = "rods";
  tell_walls({mesh("hopper"), plane("half", "x", 0.055),
              cylinder("drum", "y", {0.05, 0, 0.05}, 0.05), plane("lid", "z", 0.09), of_group,
              cylinder("core", "z", {0.05, 0.05, 0}, 0.001),
              json{{"fix", "edge"}, {"style", "wall/reflect"}, {"kind", "other"}}});
  const auto walls = walls_in_space(middle());
  EXPECT_THAT(walls.low, ElementsAre(0.0, 0.0, 0.0));
  EXPECT_THAT(walls.high, ElementsAre(0.1, 0.1, 0.1));
  EXPECT_FALSE(walls.round);
  EXPECT_THAT(walls.source, HasSubstr("scene.7.json; box bounds: x low, x high, y low, y high, "
                                      "z low"));
  EXPECT_THAT(
      walls.notes,
      ElementsAre(AllOf(HasSubstr("fix hopper (mesh hopper), a mesh from (0, 0, 0) to (0.1, 0.2, "
                                  "0.3) m, is not taken for a wall of the container")),
                  AllOf(HasSubstr("fix half, the plane x = 0.055 m"),
                        HasSubstr("has particles on both sides, 1 of them beyond it")),
                  AllOf(HasSubstr("fix drum, a cylinder along y of radius 0.05 m"),
                        HasSubstr("is not upright")),
                  AllOf(HasSubstr("fix lid, the plane z = 0.09 m"), HasSubstr("above the bed")),
                  AllOf(HasSubstr("fix some"), HasSubstr("acts on some particles alone")),
                  AllOf(HasSubstr("fix core"), HasSubstr("has particles outside it")),
                  AllOf(HasSubstr("fix edge, a wall of another kind"))));
}

TEST_F(SceneOfADeck, TheFreeSideOfASolidPlaneDecidesWhereParticlesHaveCrossedIt) {
  tell_walls({plane("floor", "z", 0.0205, 1)});  // half a millimetre above a centre
  EXPECT_EQ(walls_in_space(middle()).low[2], 0.0205);
}

TEST_F(SceneOfADeck, OptionsComeBeforeTheSceneAndItBeforeParameters) {
  tell_walls({plane("floor", "z", 0.01)});
  put(folder_ / "parameters.json",
      "{\"vertical_axis\": \"y\", \"container\": \"box\", \"container_width_m\": 0.07, "
      "\"friction\": 0.5, \"timestep_s\": 1}");
  EXPECT_EQ(walls_in_space(middle()).low[2], 0.01);
  const auto given = walls_in_space(middle(), {"y", {0, 1, 0, 1, 0, 1}, {}});
  EXPECT_EQ(given.source, "--container");
  EXPECT_EQ(given.vertical, 1U);
  const auto round = walls_in_space(middle(), {"", {}, {0.05, 0.05, 0.05}});
  EXPECT_TRUE(round.round);
  EXPECT_EQ(round.low[2], 0.01);
  EXPECT_THAT(round.source, testing::StartsWith("--cylinder, "));
  EXPECT_EQ(find_timestep(middle(), ""), 1e-5);
  EXPECT_EQ(find_friction(middle(), "", {}).table, FrictionTable{{0.3}});
  EXPECT_EQ(find_friction(middle(), "", 0.4).table, FrictionTable{{0.4}});
}

TEST_F(SceneOfADeck, APlaneHasSidesAndAFloor) {
  auto scene = scene_with({plane("floor", "y", 0.01), plane("left", "x", 0.02),
                           plane("plate", "z", -0.1), mesh("hopper")});
  scene["gravity_m_s2"] = {0, -9.81, 0};
  tell(scene);
  const auto flat = frame({{0.05, 0.05, 0.05}, {0.06, 0.04, 0.05}});
  const auto walls = read_packing(flat).walls;
  EXPECT_EQ(walls.left, 0.02);
  EXPECT_EQ(walls.right, 0.1);
  EXPECT_EQ(walls.floor, 0.01);
  EXPECT_THAT(walls.source, HasSubstr("scene.7.json; box bounds: right"));
  EXPECT_THAT(walls.notes, ElementsAre(HasSubstr("mesh hopper")));

  // A side that is periodic has no wall and needs none.
  const auto periodic = frame({{0.05, 0.05, 0.05}, {0.06, 0.04, 0.05}}, "pp ff ff");
  const auto of_period = read_packing(periodic).walls;
  EXPECT_FALSE(of_period.sides);
  EXPECT_EQ(of_period.left, 0.0);
  EXPECT_THAT(of_period.notes, ElementsAre(HasSubstr("fix left"), HasSubstr("mesh hopper")));

  // Gravity down an inclined floor: the measures of a plane have y up, which is said.
  scene["gravity_m_s2"] = {3, -9, 0};
  tell(scene);
  EXPECT_THAT(read_packing(flat).walls.notes.back(), HasSubstr("gravity is (3, -9, 0) m/s2"));
}

TEST_F(SceneOfADeck, GravitySaysWhichAxisPointsUp) {
  auto scene = scene_with({});
  for (const std::size_t axis : {0U, 1U, 2U}) {
    scene["gravity_m_s2"] = {axis == 0 ? -1 : 0, axis == 1 ? -1 : 0, axis == 2 ? -1 : 0};
    tell(scene);
    EXPECT_EQ(find_vertical(middle(), "", {}), axis);
    EXPECT_EQ(find_vertical(middle(), "", {"x", {}, {}}), 0U);
  }
  for (const json& none : {json{0, 0, 0}, json{1, 0, -1}, json()}) {
    scene["gravity_m_s2"] = none;
    tell(scene);
    EXPECT_FALSE(find_vertical(middle(), "", {}));
  }
  EXPECT_THAT([&] { is_in_space(middle(), {}, {}); },
              ThrowsMessage<DataError>(HasSubstr("a scene in space needs --vertical")));
  scene["gravity_m_s2"] = {0, 0, 9.81};
  tell(scene);
  EXPECT_THAT([&] { find_vertical(middle(), "", {}); },
              ThrowsMessage<DataError>(HasSubstr("expected gravity along -x, -y or -z, found it "
                                                 "along +z")));
}

TEST_F(SceneOfADeck, FrictionIsThatOfTypesOnlyWhereContactsTellTheirs) {
  auto scene = scene_with({});
  scene["friction"] = {{0.3, 0.3}, {0.3, 0.3}};
  tell(scene);
  EXPECT_EQ(find_friction(middle(), "", {}).table, FrictionTable{{0.3}});
  scene["friction"] = {{0.3, 0.3}, {0.3, 0.5}};
  tell(scene);
  const auto mixed = find_friction(middle(), "", {});
  EXPECT_TRUE(mixed.table.empty());
  EXPECT_THAT(mixed.missing, HasSubstr("another friction between other atom types, 0.3 and 0.5, "
                                       "and the contacts do not tell theirs"));
  auto telling = middle();
  telling.names = {"type_i", "type_j"};
  EXPECT_EQ(find_friction(telling, "", {}).table, (FrictionTable{{0.3, 0.3}, {0.3, 0.5}}));
  EXPECT_EQ(find_friction(telling, "", 0.4).table, FrictionTable{{0.4}});
  scene["friction"] = {{0}};
  tell(scene);
  EXPECT_THAT(find_friction(middle(), "", {}).missing, HasSubstr("friction 0"));
  scene["friction"] = json();
  tell(scene);
  EXPECT_TRUE(find_friction(middle(), "", {}).table.empty());
}

TEST_F(SceneOfADeck, IsThatOfTheFramesTimestep) {
  const auto other = scene_with({});
  auto later = other;
  later["timestep"] = 70;
  tell(later, "scene.00070.json");
  EXPECT_THAT([&] { find_scene(middle()); },
              ThrowsMessage<DataError>(AllOf(HasSubstr("scene.00070.json: expected a scene of "
                                                       "timestep 7 as"),
                                             HasSubstr("found timestep 70; dump scene has to"))));
  tell(other, "scene.0007.json");
  EXPECT_THAT(find_scene(middle())->file, testing::EndsWith("scene.0007.json"));
  fs::remove(folder_ / "scene.0007.json");
  tell(other, "scene.json");
  EXPECT_EQ(find_scene(middle())->timestep, 7);
  // A name that lies is found out.
  tell(later, "scene.7.json");
  EXPECT_THROW(find_scene(middle()), DataError);
  // One folder up, as for parameters.json.
  fs::create_directories(folder_ / "dumps");
  Frame in_dumps = middle();
  in_dumps.file = (folder_ / "dumps/bodies.7.dump").string();
  fs::remove(folder_ / "scene.7.json");
  EXPECT_TRUE(find_scene(in_dumps));
  for (const std::string name : {"scene.json", "scene.00070.json"}) fs::remove(folder_ / name);
  EXPECT_FALSE(find_scene(in_dumps));
}

TEST_F(SceneOfADeck, WhatIsMissingOrWrongIsSaidWithItsKey) {
  const auto good =
      scene_with({plane("floor", "z", 0), cylinder("side", "z", {0, 0, 0}, 1), mesh("hopper")});
  EXPECT_EQ(refusal(good), "");
  const auto with = [&](const std::string& pointer, const json& value) {
    auto scene = good;
    scene[json::json_pointer(pointer)] = value;
    return refusal(scene);
  };
  EXPECT_THAT(with("/format", "rodpack-scene 2"), HasSubstr("key 'format': expected"));
  EXPECT_THAT(with("/units", "cgs"), HasSubstr("key 'units': expected \"si\", found \"cgs\""));
  EXPECT_THAT(with("/timestep", 1.5), HasSubstr("key 'timestep': expected a whole number"));
  EXPECT_THAT(with("/timestep_s", 0), HasSubstr("key 'timestep_s': expected a number above 0"));
  EXPECT_THAT(with("/gravity_m_s2", {1, 2}), HasSubstr("key 'gravity_m_s2': expected three of"));
  EXPECT_THAT(with("/walls", 1), HasSubstr("key 'walls': expected a list"));
  EXPECT_THAT(with("/walls/0", 1), HasSubstr("wall 1: expected an object"));
  EXPECT_THAT(with("/walls/0/kind", "cone"), HasSubstr("wall 1: key 'kind': expected plane"));
  EXPECT_THAT(with("/walls/0/axis", "w"), HasSubstr("wall 1: key 'axis': expected \"x\""));
  EXPECT_THAT(with("/walls/0/position_m", "0"), HasSubstr("key 'position_m': expected a number"));
  EXPECT_THAT(with("/walls/0/free_side", 2), HasSubstr("key 'free_side': expected a whole"));
  EXPECT_THAT(with("/walls/0/fix", 2), HasSubstr("key 'fix': expected a text"));
  EXPECT_THAT(with("/walls/1/radius_m", 0), HasSubstr("wall 2: key 'radius_m': expected"));
  EXPECT_THAT(with("/walls/1/middle_m", {0, 0, "a"}), HasSubstr("key 'middle_m': expected three"));
  EXPECT_THAT(with("/walls/2/low_m", json()), HasSubstr("wall 3: key 'low_m': expected three"));
  EXPECT_THAT(with("/friction", {{1, 2}}), HasSubstr("key 'friction': expected a square table"));
  EXPECT_THAT(with("/friction", {{-1}}), HasSubstr("key 'friction': expected a square table"));
  for (const std::string key :
       {"format", "units", "timestep", "timestep_s", "gravity_m_s2", "walls", "friction"}) {
    auto scene = good;
    scene.erase(key);
    EXPECT_THAT(refusal(scene), AllOf(HasSubstr("key '" + key + "'"), HasSubstr("found none")));
  }
}

// A folder with dumps and a scene needs nothing else.
TEST_F(SceneOfADeck, AnalyseTakesItAndSaysSo) {
  SyntheticPacking packing;
  packing.fill();
  put(folder_ / "mine/bodies.2000.dump", packing.bodies_frame(2000));
  put(folder_ / "mine/spheres.2000.dump", packing.spheres_frame(2000));
  put(folder_ / "mine/contacts.2000.dump", packing.contacts_frame(2000));
  auto scene = scene_with({plane("floor", "y", -0.001, 1), plane("left", "x", -0.002, 1),
                           plane("right", "x", 0.302, -1), mesh("hopper")});
  scene["gravity_m_s2"] = {0, -9.81, 0};
  scene["timestep"] = 2000;
  put(folder_ / "mine/scene.2000.json", scene.dump());
  const auto run = rodpack::test::run_rodpack("analyse mine --dp 0.003 --ar 5", folder_);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto found = json::parse(rodpack::test::text_of(folder_ / "mine/analysis/summary.json"));
  EXPECT_THAT(found["walls_from"].get<std::string>(), testing::EndsWith("mine/scene.2000.json"));
  EXPECT_NEAR(found["time_s"].get<double>(), 0.02, 1e-12);
  EXPECT_EQ(found["mobilised_friction_mean"], 0.0);  // known, and the forces are normal ones
  EXPECT_THAT(run.output, HasSubstr("note: walls: fix hopper (mesh hopper), a mesh from"));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("note: times")));
  EXPECT_THAT(run.output, testing::Not(HasSubstr("box bounds")));
  // The floor that the scene tells is 1 mm lower than the box.
  const auto stated =
      rodpack::test::run_rodpack("analyse mine --dp 0.003 --ar 5 --walls 0 0.3 0", folder_);
  const auto with_options =
      json::parse(rodpack::test::text_of(folder_ / "mine/analysis/summary.json"));
  EXPECT_EQ(with_options["walls_from"], "--walls");
  EXPECT_EQ(stated.exit_code, 0);
  EXPECT_NE(with_options["bed_height_m"], found["bed_height_m"]);

  const auto rdf = rodpack::test::run_rodpack("rdf mine/bodies.2000.dump", folder_);
  EXPECT_THAT(rdf.output, AllOf(HasSubstr("walls: "), HasSubstr("scene.2000.json; d_p"),
                                HasSubstr("note: walls: fix hopper")));
}

}  // namespace

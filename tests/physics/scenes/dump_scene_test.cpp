// SPDX-License-Identifier: GPL-2.0-or-later
// dump scene: what it tells is where the contacts are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "deck.h"
#include "liggghts_run.h"
#include "table.h"

namespace {
using namespace rodpack::test;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string models = "model spring_dashpot tangential spring_dashpot";

json scene_in(const fs::path& file) { return json::parse(text_of(file)); }

void write_plate(const fs::path& file) {
  std::ofstream stl(file);
  stl << "solid plate\n";
  for (const std::string corners : {"0.02 0.05 0.01\nvertex 0.08 0.05 0.01\nvertex 0.08 0.05 0.09",
                                    "0.02 0.05 0.01\nvertex 0.08 0.05 0.09\nvertex 0.02 0.05 0.09"})
    stl << "facet normal 0 1 0\nouter loop\nvertex " << corners << "\nendloop\nendfacet\n";
  stl << "endsolid plate\n";
}

Deck box() { return Deck().box("0 0.1 0 0.1 0 0.1").boundary("p f f"); }

const std::string everything = R"(
fix gravity all gravity 9.81 vector 0 -1 0
fix floor all wall/gran )" + models +
                               R"( primitive type 1 yplane 0.012
fix left all wall/gran/solid )" +
                               models + R"( primitive type 2 xplane 0.0125 bound lo
fix xc all wall/gran )" + models +
                               R"( primitive type 1 xcylinder 0.04 0.05 0.06
fix yc all wall/gran )" + models +
                               R"( primitive type 1 ycylinder 0.04 0.05 0.06
fix zc all wall/gran )" + models +
                               R"( primitive type 1 zcylinder 0.04 0.05 0.06
fix plate all mesh/surface file plate.stl type 1
fix meshes all wall/gran )" + models +
                               R"( mesh n_meshes 1 meshes plate
fix drive all move/mesh mesh plate linear 0. -1.0 0.
create_atoms 1 single 0.05 0.03 0.05 units box
set group all diameter 0.003 density 2500
fix rods all particletemplate/multisphere/spherocylinder 1 atom_type 2 type 1 aspect_ratio 5 diameter 0.003 surface smooth density 2500 planar yes
fix move all multisphere/ab
dump scene all scene 100 scene.*.json
run 200
)";

TEST(DumpScene, TellsBoxWallsGravityAndFrictionAtItsStep) {
  const auto folder = fresh_folder();
  write_plate(folder / "plate.stl");
  const auto run = run_liggghts_in(folder, box().atom_types(2).friction("0.4").with(everything));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto scene = scene_in(folder / "scene.200.json");
  EXPECT_EQ(scene["format"], "rodpack-scene 1");
  EXPECT_EQ(scene["units"], "si");
  EXPECT_EQ(scene["timestep"], 200);
  EXPECT_EQ(scene["timestep_s"], 1e-5);
  EXPECT_THAT(scene["box"]["periodic"], ElementsAre(true, false, false));
  EXPECT_THAT(scene["box"]["high_m"], ElementsAre(0.1, 0.1, 0.1));
  EXPECT_THAT(scene["gravity_m_s2"], ElementsAre(0, -9.81, 0));
  EXPECT_EQ(scene["friction"], json::parse("[[0.4, 0.4], [0.4, 0.4]]"));
  EXPECT_EQ(scene["templates"], json::parse(R"([{"fix": "rods", "type": 1, "atom_type": 2}])"));
  const auto& walls = scene["walls"];
  ASSERT_EQ(walls.size(), 6U);
  EXPECT_EQ(walls[0],
            json::parse(R"({"fix": "floor", "style": "wall/gran", "kind": "plane", "axis": "y",
                            "position_m": 0.012, "free_side": 0, "atom_type": 1})"));
  EXPECT_EQ(walls[1], json::parse(R"({"fix": "left", "style": "wall/gran/solid", "kind": "plane",
                            "axis": "x", "position_m": 0.0125, "free_side": 1, "atom_type": 2})"));
  for (const int k : {2, 3, 4}) {
    EXPECT_EQ(walls[k]["kind"], "cylinder");
    EXPECT_EQ(walls[k]["axis"], std::string(1, "xyz"[k - 2]));
    EXPECT_NEAR(walls[k]["radius_m"].get<double>(), 0.04, 1e-12);
  }
  // The plate has come down by 1 m/s x 200 steps of 10 us.
  const auto& mesh = walls[5];
  EXPECT_EQ(mesh["kind"], "mesh");
  EXPECT_EQ(mesh["mesh"], "plate");
  EXPECT_EQ(mesh["triangles"], 2);
  EXPECT_EQ(mesh["moves"], true);
  EXPECT_NEAR(mesh["low_m"][0].get<double>(), 0.02, 1e-9);
  EXPECT_NEAR(mesh["high_m"][2].get<double>(), 0.09, 1e-9);
  for (const std::string end : {"low_m", "high_m"})
    EXPECT_NEAR(mesh[end][1].get<double>(), 0.048, 1e-6);
  EXPECT_NEAR(scene_in(folder / "scene.0.json")["walls"][5]["low_m"][1].get<double>(), 0.05, 1e-9);
}

TEST(DumpScene, IsTheSameOnTwoRanks) {
  std::string one;
  for (const int ranks : {1, 2}) {
    const auto folder = fresh_folder();
    write_plate(folder / "plate.stl");
    const auto run = run_liggghts_in(folder, box().atom_types(2).with(everything), {}, ranks);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto text = text_of(folder / "scene.200.json");
    if (ranks == 1)
      one = text;
    else
      EXPECT_EQ(text, one);
  }
}

// A sphere that touches the wall of a cylinder along each axis: the contact lies on the wall that
// is told, as far from the axis as the radius.
TEST(DumpScene, ContactsWithACylinderLieWhereItIs) {
  const char* const names[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = names[axis];
    const auto run = run_liggghts(
        Deck()
            .box("0 0.1 0 0.1 0 0.1")
            .with("fix side all wall/gran " + models + " primitive type 1 " + name +
                  "cylinder 0.02 0.05 0.06\nfix move all nve/sphere\n"
                  // Places all around, none of them on the axis, where LIGGGHTS finds no direction.
                  "region near cylinder " +
                  name +
                  " 0.055 0.055 0.04 0.03 0.07 units box\n"
                  "lattice sc 0.002 origin 0.3 0.2 0.1\ncreate_atoms 1 region near\n"
                  "set group all diameter 0.0015 density 2500\n"
                  "dump contacts all contact/gran 1 contacts.*.dump\n"
                  "dump scene all scene 1 scene.*.json\nrun 0\n"));
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto wall = scene_in(run.folder / "scene.0.json")["walls"][0];
    EXPECT_EQ(wall["axis"], name);
    const Table contacts = read_dump(run.folder / "contacts.0.dump");
    int seen = 0;
    for (std::size_t k = 0; k < contacts.rows(); ++k) {
      if (contacts.column("wall")[k] == 0) continue;
      double square = 0;
      for (int d = 0; d < 3; ++d)
        if (d != axis)
          square += std::pow(contacts.column(names[d])[k] - wall["middle_m"][d].get<double>(), 2);
      // Half-way into the overlap.
      const double off = std::abs(std::sqrt(square) - wall["radius_m"].get<double>());
      EXPECT_LE(off, 0.5 * contacts.column("overlap_n")[k] + 1e-9) << name << k;
      ++seen;
    }
    EXPECT_GT(seen, 20) << name;
  }
}

TEST(DumpScene, GravityAndWallsOfSomeParticlesAreNotThoseOfAll) {
  const auto run = run_liggghts(Deck().with(
      "create_atoms 1 single 0.05 0.05 0 units box\nset group all diameter 0.003 density 2500\n"
      "group one id 1\nfix g one gravity 9.81 vector 0 -1 0\n"
      "fix part one wall/gran " +
      models +
      " primitive type 1 yplane 0.01\nfix move all nve/sphere\n"
      "write_dump all scene scene.json\n"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto scene = scene_in(run.folder / "scene.json");
  EXPECT_TRUE(scene["gravity_m_s2"].is_null());
  EXPECT_EQ(scene["walls"][0]["group"], "one");
}

TEST(DumpScene, WrongCommandsAreRefused) {
  const std::string sphere =
      "create_atoms 1 single 0.05 0.05 0 units box\nset group all diameter 0.003 density 2500\n"
      "fix move all nve/sphere\n";
  const auto refused = [&](std::string text, const std::string& reason) {
    const auto run = run_liggghts(text);
    EXPECT_NE(run.exit_code, 0) << reason;
    EXPECT_THAT(run.output, HasSubstr(reason));
  };
  refused(Deck().with(sphere + "dump s all scene 1 scene.dump\nrun 1\n"),
          "Dump scene (id s): file is scene.dump, expected a name that ends in .json, without %");
  refused(Deck().with(sphere + "dump s all scene 1 scene.%.json\nrun 1\n"), "without %");
  refused(Deck().with(sphere + "dump s all scene 1 scene.json x\nrun 1\n"), "unknown argument x");
  refused(Deck().with(sphere + "dump s all scene 1 /proc/none/scene.json\nrun 1\n"),
          "Cannot write dump file");
  auto cgs = Deck().with(sphere + "dump s all scene 1 scene.json\nrun 1\n");
  cgs.replace(cgs.find("units si"), 8, "units cgs");
  refused(cgs, "the deck's units are cgs, expected si");
}

}  // namespace

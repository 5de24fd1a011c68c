// SPDX-License-Identifier: GPL-2.0-or-later
// rodpack analyse on dumps of decks of one's own: no parameters.json, or in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../synthetic_packing.h"
#include "liggghts_run.h"
#include "spatial_scene.h"

namespace {
using namespace rodpack;
using nlohmann::json;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using rodpack::test::text_of;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

const Vector3 box{0.1, 0.1, 0.1};

class AnalyseAnyRun : public testing::Test {
 protected:
  rodpack::test::Run run(const std::string& arguments) const {
    return rodpack::test::run_rodpack(arguments, folder_);
  }
  json summary(const std::string& run_folder) const {
    return json::parse(text_of(folder_ / run_folder / "analysis" / "summary.json"));
  }
  std::string page(const std::string& run_folder) const {
    return text_of(folder_ / run_folder / "analysis" / "report.html");
  }
  void expect_refusal(const std::string& arguments, const std::string& reason) const {
    const auto result = run(arguments);
    EXPECT_EQ(result.exit_code, 1) << arguments << result.output;
    EXPECT_THAT(result.output, HasSubstr(reason)) << arguments;
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 1) << result.output;
  }
  fs::path folder_ = fresh_folder();
};

// So many rods at random places in the box, more of them upright than flat.
std::string rods(const std::vector<Vector3>& places) {
  return rodpack::test::spatial_bodies(
      places, rodpack::test::watson_axes(4, static_cast<int>(places.size()), 6), box);
}

// Contacts of each body with the next one: upright normals, tilted by `tilt`, of force 1 mN.
std::string contacts_of(const std::vector<Vector3>& places, double tilt) {
  std::ostringstream text;
  text.precision(15);
  text << "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ENTRIES\n"
       << places.size() - 1 << "\nITEM: BOX BOUNDS ff ff ff\n0 0.1\n0 0.1\n0 0.1\n"
       << "ITEM: ENTRIES body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy "
          "bjz overlap_n overlap_t nx ny nz\n";
  const Vector3 n{std::sin(tilt), 0, std::cos(tilt)};
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    text << k + 1 << ' ' << k + 2 << ' ' << k + 1 << ' ' << k + 2 << " 0";
    for (const double each : places[k]) text << ' ' << each;
    for (const double each : n) text << ' ' << 1e-3 * each;
    for (const double each : places[k]) text << ' ' << each;
    for (const double each : places[k + 1]) text << ' ' << each;
    text << " 1e-6 0";
    for (const double each : n) text << ' ' << each;
    text << '\n';
  }
  return text.str();
}

// A line of bodies, each within a particle's length of the next, up through the box.
std::vector<Vector3> column_of_places(int number) {
  std::vector<Vector3> places;
  for (int k = 0; k < number; ++k) places.push_back({0.05, 0.05, 0.005 + 0.09 * k / (number - 1)});
  return places;
}

TEST_F(AnalyseAnyRun, BodiesAloneInAPlaneGiveTheNumbersOfTheWholeRun) {
  SyntheticPacking packing;
  packing.fill();
  packing.write_run(folder_ / "whole");
  put(folder_ / "mine" / "bodies.2000.dump", packing.bodies_frame(2000));
  put(folder_ / "dumped" / "dumps" / "bodies.dump", packing.bodies_frame(2000));
  ASSERT_EQ(run("analyse whole").exit_code, 0);
  const auto known = summary("whole");
  const auto plain = run("analyse dumped");
  ASSERT_EQ(plain.exit_code, 0) << plain.output;
  EXPECT_NEAR(summary("dumped")["particle_diameter_m"].get<double>(), 3e-3, 1e-14);
  EXPECT_NEAR(summary("dumped")["aspect_ratio"].get<double>(), 5, 1e-11);
  for (const std::string missing : {"times", "spheres", "contacts", "energies", "walls"})
    EXPECT_THAT(plain.output, HasSubstr("note: " + missing + ": "));
  // Of the same d_p and AR to the last bit, for a lattice jumps over the edges of layers.
  const auto result = run("analyse mine --dp 0.003 --ar 5");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto found = summary("mine");
  EXPECT_EQ(found["format"], known["format"]);
  for (const std::string key : {"time_s", "mean_normal_force_N", "parameters"})
    EXPECT_FALSE(found.contains(key)) << key;
  for (const std::string key :
       {"bed_height_m", "orientation_particles", "nematic_order_S2", "rdf_centres", "rdf_tail_mean",
        "covered_area_over_area_below_surface",
        "solid_fraction_from_3_omega_above_floor_to_3_omega_below_surface"})
    EXPECT_EQ(found[key], known[key]) << key;
  EXPECT_THAT(page("mine"), HasSubstr("has no <code>parameters.json</code>"));
  EXPECT_THAT(page("mine"), HasSubstr("figure-rdf"));
  EXPECT_EQ(run("report mine").exit_code, 0);
  EXPECT_FALSE(known.contains("walls_from"));
}

TEST_F(AnalyseAnyRun, OptionsReplaceWhatParametersWouldSay) {
  SyntheticPacking packing;
  packing.fill();
  put(folder_ / "mine" / "bodies.2000.dump", packing.bodies_frame(2000));
  put(folder_ / "mine" / "spheres.2000.dump", packing.spheres_frame(2000));
  put(folder_ / "mine" / "contacts.2000.dump", packing.contacts_frame(2000));
  ASSERT_EQ(run("analyse mine --walls 0 0.3 0 --dp 0.003 --ar 5 --friction 0.3").exit_code, 0);
  const auto found = summary("mine");
  EXPECT_EQ(found["walls_from"], "--walls");
  EXPECT_EQ(found["particle_diameter_m"], 0.003);
  EXPECT_EQ(found["aspect_ratio"], 5);
  EXPECT_EQ(found["mobilised_friction_mean"], 0.0);
  EXPECT_THAT(page("mine"), HasSubstr("figure-forces_chains"));
  EXPECT_THAT(page("mine"), HasSubstr("packing-0"));
  expect_refusal("analyse mine --container 0 1 0 1 0 1",
                 "--container: expected in a scene in space");
}

TEST_F(AnalyseAnyRun, BodiesAndContactsInSpaceGiveTheSpatialMeasures) {
  const auto places = rodpack::test::random_places(box, 3000, 5);
  put(folder_ / "mine" / "bodies.7.dump", rods(places));
  // Long branches: bodies lie at random, so that a contact of each with the next is far.
  const auto column = column_of_places(60);
  put(folder_ / "column" / "bodies.7.dump", rods(column));
  put(folder_ / "column" / "contacts.7.dump", contacts_of(column, 0));

  const auto alone = run("analyse mine --vertical z");
  ASSERT_EQ(alone.exit_code, 0) << alone.output;
  auto found = summary("mine");
  EXPECT_EQ(found["vertical_axis"], "z");
  const double exact = (3 * rodpack::test::watson_mean_square(4) - 1) / 2;
  EXPECT_NEAR(found["order_about_vertical"].get<double>(), exact,
              4 * found["order_about_vertical_standard_error"].get<double>());
  EXPECT_NEAR(found["order_tensor_S2"].get<double>(), exact,
              4 * found["order_tensor_S2_standard_error"].get<double>());
  for (const std::string key : {"nematic_order_S2", "mean_normal_force_N", "contact_normals_S2"})
    EXPECT_FALSE(found.contains(key)) << key;
  EXPECT_GT(found["rdf_centres"].get<int>(), 2);
  const auto html = page("mine");
  for (const std::string stem : {"orientation", "orientation_azimuth", "rdf", "solid_fraction"})
    EXPECT_THAT(html, HasSubstr("id=\"figure-" + stem + "\"")) << stem;
  EXPECT_THAT(html, HasSubstr("Angle of the long axis to the vertical"));
  EXPECT_THAT(html, HasSubstr("the scene is in space"));
  EXPECT_THAT(html, HasSubstr("What was left out, and why"));

  const auto with = run("analyse column --vertical z");
  ASSERT_EQ(with.exit_code, 0) << with.output;
  found = summary("column");
  // All normals upright: one principal value is 1, and so is the order about the vertical.
  EXPECT_NEAR(found["contact_normals_S2"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(found["contact_normals_about_vertical"].get<double>(), 1, 1e-12);
  EXPECT_NEAR(found["mean_normal_force_N"].get<double>(), 1e-3, 1e-15);
  for (const std::string name : {"forces_fabric.png", "profile.png", "forces_fabric_order.csv"})
    EXPECT_TRUE(fs::exists(folder_ / "column" / "analysis" / name)) << name;

  // Nothing of the earlier analysis stays.
  fs::remove(folder_ / "column" / "contacts.7.dump");
  ASSERT_EQ(run("analyse column --vertical z").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "column" / "analysis" / "forces_fabric.png"));
  EXPECT_FALSE(fs::exists(folder_ / "column" / "analysis" / "forces_fabric_order.csv"));
}

TEST_F(AnalyseAnyRun, ParametersOfASceneInSpaceSayItsVertical) {
  put(folder_ / "mine" / "dumps" / "bodies.7.dump",
      rods(rodpack::test::random_places(box, 300, 5)));
  put(folder_ / "mine" / "parameters.json",
      "{\"vertical_axis\": \"z\", \"timestep_s\": 1e-3, \"seed\": 1, \"aspect_ratio\": 5, "
      "\"particle_diameter_m\": 2e-3, \"container_width_m\": 0.1, \"container_height_m\": 0.1}\n");
  const auto result = run("analyse mine");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  EXPECT_NEAR(summary("mine")["time_s"].get<double>(), 7e-3, 1e-15);
  EXPECT_EQ(summary("mine")["parameters"]["vertical_axis"], "z");
  EXPECT_THAT(page("mine"), Not(HasSubstr("the paper's scene")));
  expect_refusal("analyse mine --walls 0 1 0", "--walls: expected in a scene in a plane alone");
}

TEST_F(AnalyseAnyRun, WhatCannotBeMeasuredIsRefusedInOneLine) {
  fs::create_directories(folder_ / "empty");
  expect_refusal("analyse empty",
                 "empty: expected dumps of bodies (dump multisphere/body), "
                 "bodies.*.dump, here or in its dumps/, found none");
  put(folder_ / "mine" / "bodies.7.dump", rods(rodpack::test::random_places(box, 300, 5)));
  expect_refusal("analyse mine", "a scene in space needs --vertical");
  put(folder_ / "one" / "bodies.7.dump",
      rodpack::test::spatial_bodies({{0.05, 0.05, 0.05}}, {{0, 0, 1}}, box, "pp pp pp"));
  expect_refusal("analyse one --vertical z", "one: nothing could be measured: orientation: ");
  for (const std::string name : {"empty", "mine", "one"})
    EXPECT_FALSE(fs::exists(folder_ / name / "analysis")) << name;
}

TEST_F(AnalyseAnyRun, DumpsOfTwoRunsAreRefused) {
  SyntheticPacking packing, other;
  packing.fill();
  other.shape.aspect_ratio = 3;
  other.fill();
  const auto name = [&](const std::string& run, const std::string& file) {
    return folder_ / run / file;
  };
  put(name("sizes", "bodies.1000.dump"), packing.bodies_frame(1000));
  put(name("sizes", "bodies.2000.dump"), other.bodies_frame(2000));
  expect_refusal("analyse sizes", "expected dumps of one run, found particle 1 with nspheres 9");
  put(name("times", "bodies.a.1000.dump"), packing.bodies_frame(1000));
  put(name("times", "bodies.b.1000.dump"), packing.bodies_frame(1000));
  expect_refusal("analyse times", "expected dumps of one run, found timestep 1000 here and in ");
  put(name("places", "bodies.1000.dump"), packing.bodies_frame(1000));
  put(name("places", "dumps/bodies.2000.dump"), packing.bodies_frame(2000));
  expect_refusal("analyse places", "found some here and some in ");
  put(name("contacts", "bodies.1000.dump"), packing.bodies_frame(1000));
  put(name("contacts", "contacts.1000.dump"), other.contacts_frame(1000));
  expect_refusal("analyse contacts", "no particle 2001, which has a contact in");
  put(name("moved", "bodies.1000.dump"), other.bodies_frame(1000));
  put(name("moved", "contacts.1000.dump"), packing.contacts_frame(1000));
  expect_refusal("analyse moved", "expected contacts and bodies of one run");
  for (const std::string run : {"sizes", "times", "places", "contacts", "moved"})
    EXPECT_FALSE(fs::exists(name(run, "analysis"))) << run;
}

TEST_F(AnalyseAnyRun, AnEnsembleRefusesSuchRunsByName) {
  SyntheticPacking packing;
  packing.fill();
  put(folder_ / "bare" / "bodies.2000.dump", packing.bodies_frame(2000));
  ASSERT_EQ(run("analyse bare").exit_code, 0);
  expect_refusal("ensemble bare", "bare: dumps without parameters.json");
  put(folder_ / "space" / "dumps" / "bodies.7.dump",
      rods(rodpack::test::random_places(box, 300, 5)));
  put(folder_ / "space" / "parameters.json",
      "{\"vertical_axis\": \"z\", \"seed\": 1, \"aspect_ratio\": 5, \"surface\": \"smooth\"}\n");
  put(folder_ / "space" / "result.json", "{\"step\": 7}\n");
  ASSERT_EQ(run("analyse space").exit_code, 0);
  expect_refusal("ensemble space", "space: is a scene in space, expected runs in a plane");
}

}  // namespace

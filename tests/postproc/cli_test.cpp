// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "liggghts_run.h"
#include "rodpack/version.h"
#include "synthetic_packing.h"

namespace {
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using rodpack::test::text_of;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

auto rodpack_command(const std::string& arguments, const fs::path& folder = fresh_folder()) {
  return rodpack::test::run_rodpack(arguments, folder);
}

struct Size {
  unsigned width, height;
};

// Width and height from the header of a PNG file; 0 x 0 when it is none.
Size png_size(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  unsigned char head[24] = {};
  in.read(reinterpret_cast<char*>(head), sizeof head);
  if (std::string(head + 1, head + 4) != "PNG" || std::string(head + 12, head + 16) != "IHDR")
    return {0, 0};
  const auto number = [&](int at) {
    return (unsigned{head[at]} << 24U) + (unsigned{head[at + 1]} << 16U) +
           (unsigned{head[at + 2]} << 8U) + head[at + 3];
  };
  return {number(16), number(20)};
}

SyntheticPacking small_packing(double curvature = 0) {
  SyntheticPacking packing;
  packing.shape.curvature_angle = curvature;
  packing.fill();
  return packing;
}

TEST(CommandLine, SaysItsVersionAndCommit) {
  const auto run = rodpack_command("--version");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.output,
            std::string("rodpack ") + rodpack::version() + " (" + rodpack::commit() + ")\n");
}

TEST(CommandLine, HelpTeachesWithAnExampleAndSucceeds) {
  EXPECT_EQ(rodpack_command("--help").exit_code, 0);
  for (const std::string name :
       {"orientation", "rdf", "forces", "render", "stress", "solid-fraction", "profile", "export",
        "analyse", "report", "ensemble", "discharge"}) {
    const auto run = rodpack_command(name + " --help");
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_THAT(run.output, HasSubstr("Example"));
    EXPECT_THAT(run.output, HasSubstr("rodpack " + name));
  }
}

TEST(CommandLine, WrongUsageExitsWithTwo) {
  EXPECT_EQ(rodpack_command("").exit_code, 2);
  EXPECT_EQ(rodpack_command("stress").exit_code, 2);
  EXPECT_EQ(rodpack_command("rdf").exit_code, 2);
  EXPECT_EQ(rodpack_command("rdf a.dump --bin -1").exit_code, 2);
  EXPECT_EQ(rodpack_command("forces a.dump --bin 0").exit_code, 2);
  EXPECT_EQ(rodpack_command("forces a.dump --friction -0.3").exit_code, 2);
  EXPECT_EQ(rodpack_command("orientation a.dump --bins many").exit_code, 2);
  EXPECT_EQ(rodpack_command("render a.dump --colour pink").exit_code, 2);
  EXPECT_EQ(rodpack_command("render a.dump --window 1 0 0 1").exit_code, 2);
  EXPECT_EQ(rodpack_command("orientation a.dump --walls 0 1").exit_code, 2);
}

TEST(CommandLine, BadDataExitsWithOneAndOneLineAndWritesNothing) {
  const auto folder = fresh_folder();
  put(folder / "a.dump", "nonsense\n");
  for (const std::string command : {"orientation", "rdf", "forces", "render", "export"}) {
    const auto run = rodpack_command(command + " a.dump", folder);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.output, "rodpack: a.dump:1: expected 'ITEM: TIMESTEP', found 'nonsense'\n");
    EXPECT_EQ(rodpack_command(command + " none.dump", folder).output,
              "rodpack: none.dump: no such file\n");
    EXPECT_EQ(rodpack_command(command + " 'x*.dump'", folder).output,
              "rodpack: no file matches 'x*.dump'\n");
  }
  // a.dump and the captured output of the last command
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2) << "something was written";
}

TEST(CommandLine, MissingColumnIsNamed) {
  const auto folder = fresh_folder();
  auto bodies = small_packing().bodies_frame(1);
  bodies.replace(bodies.find(" angle "), 7, " phi ");
  put(folder / "bodies.dump", bodies);
  const auto run = rodpack_command("orientation bodies.dump", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output,
              HasSubstr("rodpack: bodies.dump:9: no column 'angle'; the columns are: id type "
                        "nspheres x y z phi vx vy vz "));
}

TEST(Orientation, WritesTableAndFigures) {
  const auto folder = fresh_folder();
  put(folder / "b.dump", small_packing().bodies_frame(1));
  const auto run = rodpack_command("orientation b.dump --bins 18 -o gamma", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto table = rodpack::test::read_table(folder / "gamma.csv");
  EXPECT_THAT(text_of(folder / "gamma.csv"),
              HasSubstr("gamma_deg,count,probability_density_per_deg,standard_error_per_deg\n0,"));
  EXPECT_EQ(table.rows(), 18U);
  double integral = 0;
  for (const double density : table.column("probability_density_per_deg")) integral += 10 * density;
  EXPECT_NEAR(integral, 1, 1e-8);
  EXPECT_THAT(run.output, HasSubstr("S2 = "));
  EXPECT_EQ(png_size(folder / "gamma.png").width, 1600U);
  EXPECT_EQ(png_size(folder / "gamma_polar.png").width, 1600U);
  for (const std::string name : {"gamma.svg", "gamma_polar.svg"}) {
    EXPECT_THAT(text_of(folder / name), HasSubstr("<svg"));
    EXPECT_THAT(text_of(folder / name), HasSubstr("</svg>"));
    EXPECT_THAT(text_of(folder / name), HasSubstr("probability density (1/°)"));
  }
}

TEST(RdfCommand, WritesTableAndFigure) {
  const auto folder = fresh_folder();
  put(folder / "b.dump", small_packing().bodies_frame(1));
  const auto run = rodpack_command("rdf b.dump --r-max 5", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(rodpack::test::read_table(folder / "rdf.csv").column("r_over_dp").size(), 50U);
  EXPECT_EQ(png_size(folder / "rdf.png").width, 1600U);
  EXPECT_THAT(text_of(folder / "rdf.svg"), HasSubstr("</svg>"));
}

TEST(Render, KeepsTheAspectRatioOfTheWindow) {
  const auto folder = fresh_folder();
  put(folder / "s.dump", small_packing().spheres_frame(1));
  // Without colour bar the margins are the same left and right, so a window twice as wide as
  // another is drawn with twice the width inside the margins.
  ASSERT_EQ(
      rodpack_command("render s.dump --colour none --window 0 0.1 0 0.1 --pixels 500 -o a", folder)
          .exit_code,
      0);
  ASSERT_EQ(
      rodpack_command("render s.dump --colour none --window 0 0.1 0 0.05 --pixels 500 -o b", folder)
          .exit_code,
      0);
  const auto text = text_of(folder / "b.svg");
  const auto clip = text.substr(text.find("<clipPath"));
  EXPECT_THAT(clip.substr(0, 200), HasSubstr("width=\"500\" height=\"250\""));
  EXPECT_THAT(text_of(folder / "a.svg"), HasSubstr("width=\"500\" height=\"500\""));
  const auto size = png_size(folder / "a.png");
  EXPECT_GT(size.width, 500U);
  EXPECT_LT(size.width, 560U);
}

TEST(Render, WindowInDiametersIsTheSameAsInMetres) {
  const auto folder = fresh_folder();
  put(folder / "s.dump", small_packing().spheres_frame(1));
  ASSERT_EQ(rodpack_command("render s.dump --window 0.03 0.09 0 0.06 -o a", folder).exit_code, 0);
  ASSERT_EQ(rodpack_command("render s.dump --window 10 30 0 20 --in-dp -o b", folder).exit_code, 0);
  EXPECT_EQ(text_of(folder / "a.svg"), text_of(folder / "b.svg"));
}

TEST(Render, EveryColourHasItsBarWithUnit) {
  const auto folder = fresh_folder();
  put(folder / "s.dump", small_packing().spheres_frame(1));
  for (const auto& [colour, label] :
       {std::pair<std::string, std::string>{"force", "contact force on sphere (mN)"},
        {"fsum", "sum of contact forces (mN)"},
        {"orientation", "direction of the long axis (°)"}}) {
    const auto run = rodpack_command("render s.dump --pixels 400 --colour " + colour, folder);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(text_of(folder / "packing.svg"), HasSubstr(label));
    EXPECT_GT(png_size(folder / "packing.png").width, 400U);
  }
  const auto empty = rodpack_command("render s.dump --window 5 6 5 6", folder);
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_THAT(empty.output, HasSubstr("no sphere lies in the window x 5 ... 6 m, y 5 ... 6 m"));
}

TEST(Forces, WritesTablesAndFigures) {
  const auto folder = fresh_folder();
  const auto packing = small_packing();
  packing.write_run(folder);
  const auto run = rodpack_command(
      "forces 'dumps/contacts.*.dump' --all-frames --bodies 'dumps/bodies.*.dump' -o f", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr(std::to_string(2 * packing.contact_count) + " contacts; left"));
  EXPECT_THAT(run.output, HasSubstr("0 have no contact"));
  const auto table = rodpack::test::read_table(folder / "f.csv");
  EXPECT_NEAR(table.column("normal_density").back(), 4, 1e-9);  // all forces are equal
  EXPECT_EQ(rodpack::test::read_table(folder / "f_friction.csv").rows(), 20U);
  EXPECT_EQ(rodpack::test::read_table(folder / "f_coordination.csv")
                .column("particles_with_touching_particles"),
            (std::vector<double>{0, 0.4 * 2 * packing.body_count, 0.6 * 2 * packing.body_count}));
  for (const std::string stem : {"f", "f_friction", "f_coordination", "f_chains"}) {
    EXPECT_GT(png_size(folder / (stem + ".png")).width, 1000U) << stem;
    EXPECT_THAT(text_of(folder / (stem + ".svg")), HasSubstr("</svg>")) << stem;
  }
  EXPECT_THAT(text_of(folder / "f_chains.svg"), HasSubstr("force between particles (µN)"));
}

TEST(Forces, WhatIsNotKnownIsLeftOutAndTheReportSaysSo) {
  const auto folder = fresh_folder();
  put(folder / "c.dump", small_packing().contacts_frame(7));
  const auto run = rodpack_command("forces c.dump", folder);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("mobilised friction is left out"));
  EXPECT_THAT(run.output, HasSubstr("those without contact are missed: no --bodies"));
  EXPECT_FALSE(fs::exists(folder / "forces_friction.csv"));
  EXPECT_EQ(rodpack_command("forces c.dump --friction 0.5", folder).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "forces_friction.csv"));
}

TEST(Forces, AMissingColumnOfThePictureIsNamedBeforeAnythingIsWritten) {
  const auto folder = fresh_folder();
  auto text = small_packing().contacts_frame(7);
  text.replace(text.find("bjy"), 3, "own");
  put(folder / "c.dump", text);
  const auto run = rodpack_command("forces c.dump", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("c.dump:9: no column 'bjy'"));
  EXPECT_FALSE(fs::exists(folder / "forces.csv"));
}

// The chains of a pair that touches across a periodic border are drawn at both.
TEST(Forces, APeriodicPackingHasNoSideWalls) {
  const auto folder = fresh_folder();
  const std::string columns =
      "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz nx ny nz";
  const std::string row = "1 2 1 2 0 0 0.5 0 1e-3 0 0 0.05 0.5 0 -0.05 0.5 0 1 0 0\n";
  const auto lines = [&](const std::string& flags) {
    put(folder / "c.dump", rodpack::test::frame_head(1, 1, 1, 1, columns, flags) + row);
    EXPECT_EQ(rodpack_command("forces c.dump", folder).exit_code, 0);
    const auto text = text_of(folder / "forces_chains.svg");
    int count = 0;
    for (auto at = text.find("\"round\""); at != std::string::npos;
         at = text.find("\"round\"", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(lines("ff ff pp"), 1);
  EXPECT_EQ(lines("pp ff pp"), 2);
}

TEST(Forces, BodiesOfAnotherTimestepAndFramesWithoutContactsAreRefused) {
  const auto folder = fresh_folder();
  const auto packing = small_packing();
  put(folder / "c.dump", packing.contacts_frame(7));
  put(folder / "b.dump", packing.bodies_frame(5) + packing.bodies_frame(6));
  EXPECT_EQ(rodpack_command("forces c.dump --bodies b.dump", folder).output,
            "rodpack: b.dump: expected a frame of timestep 7, found timestep 6\n");
  const auto head = rodpack::test::frame_head(
      8, 0, 0.3, 2, "body_i body_j wall x y z fx fy fz bix biy biz bjx bjy bjz nx ny nz");
  put(folder / "e.dump", head);
  const auto run = rodpack_command("forces e.dump", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "rodpack: e.dump:9: no contacts in the frame of timestep 8\n");
  EXPECT_EQ(rodpack_command("forces e.dump --all-frames", folder).output,
            "rodpack: e.dump: no rows in any frame\n");
  EXPECT_THAT(rodpack_command("forces c.dump e.dump --all-frames", folder).output,
              HasSubstr("passed over: 1 empty frame\n"));
}

TEST(Analyse, WholeRunGivesEveryTableFigureAndTheSummary) {
  for (const double curvature : {0.0, 2.0}) {
    const auto run_folder = fresh_folder() / "run";
    const auto packing = small_packing(curvature);
    packing.write_run(run_folder);
    const auto foreign = run_folder / "analysis" / "notes.txt";
    put(foreign, "mine");
    put(run_folder / "analysis" / "vtk" / "bodies.1.vtp", "left over from an earlier frame");
    const auto run = rodpack_command("analyse '" + run_folder.string() + "'");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    const auto out = run_folder / "analysis";
    for (const std::string stem :
         {"orientation", "orientation_polar", "rdf", "solid_fraction", "energies", "packing",
          "forces", "forces_friction", "forces_coordination", "forces_chains"}) {
      EXPECT_GT(png_size(out / (stem + ".png")).width, 1000U) << stem;
      EXPECT_THAT(text_of(out / (stem + ".svg")), HasSubstr("</svg>")) << stem;
    }
    const auto summary = nlohmann::json::parse(text_of(out / "summary.json"));
    EXPECT_EQ(summary["timestep"], 2000);
    EXPECT_NEAR(summary["time_s"].get<double>(), 0.022, 1e-12);
    EXPECT_EQ(summary["particles"], packing.body_count);
    EXPECT_EQ(summary["parameters"]["format"], "rodpack-run 1");
    EXPECT_EQ(summary["rodpack"]["version"], rodpack::version());
    EXPECT_EQ(summary["rodpack"]["commit"], rodpack::commit());
    // Squares of 15 mm fill 0.3 m x 0.3 m: surface at 0.3 m, phi = 5 areas per square.
    EXPECT_NEAR(summary["bed_height_m"].get<double>(), 0.3, 0.003);
    const double phi = 5 * rodpack::covered_area(packing.shape) / (0.015 * 0.015);
    EXPECT_NEAR(
        summary["solid_fraction_from_3_omega_above_floor_to_3_omega_below_surface"].get<double>(),
        phi, 0.01 * phi);
    EXPECT_TRUE(summary["rdf_centres"].get<int>() > 0);
    // Each contact pushes with 1e-3 times d; five particles in a row make four pairs.
    EXPECT_NEAR(summary["mean_normal_force_N"].get<double>(), 1e-3 * packing.shape.diameter, 1e-9);
    EXPECT_EQ(summary["mean_tangential_force_N"], 0.0);
    EXPECT_EQ(summary["mobilised_friction_mean"], 0.0);
    EXPECT_EQ(summary["sliding_fraction"], 0.0);
    EXPECT_NEAR(summary["coordination_number"].get<double>(), 1.6, 1e-12);
    EXPECT_NEAR(summary["contacts_per_particle"].get<double>(), 1.6, 1e-12);
    EXPECT_EQ(summary["rattlers"], 0);
    for (const std::string kind : {"bodies", "spheres", "contacts"}) {
      EXPECT_TRUE(fs::exists(out / "vtk" / (kind + ".2000.vtp")));
      EXPECT_FALSE(fs::exists(out / "vtk" / (kind + ".1000.vtp")));
      EXPECT_FALSE(fs::exists(out / "vtk" / "bodies.1.vtp"));
      EXPECT_THAT(text_of(out / "vtk" / (kind + ".pvd")), HasSubstr("timestep=\"0.022\""));
    }
    EXPECT_EQ(text_of(foreign), "mine");
  }
}

TEST(Analyse, MissingFolderParametersOrDumpsGiveOneLine) {
  const auto folder = fresh_folder();
  EXPECT_EQ(rodpack_command("analyse none", folder).output, "rodpack: none: no such run folder\n");
  fs::create_directory(folder / "run");
  EXPECT_EQ(
      rodpack_command("analyse run", folder).output,
      "rodpack: run: expected dumps of bodies (dump multisphere/body), bodies.*.dump, here or "
      "in its dumps/, found none\n");
  put(folder / "run" / "parameters.json", "{}");
  const auto run = rodpack_command("analyse run", folder);
  EXPECT_EQ(run.output, "rodpack: no file matches 'run/dumps/bodies.*.dump*'\n");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_FALSE(fs::exists(folder / "run" / "analysis"));
}

// A run that went on from a restart at t = 1 s after it had been interrupted at t = 3 s has the
// rows of 2 s and 3 s twice; the later ones hold.
TEST(Analyse, RowsThatAResumedRunComputedAgainReplaceTheEarlierOnes) {
  const auto run_folder = fresh_folder() / "run";
  small_packing().write_run(run_folder);
  put(run_folder / "energies.csv",
      "time_s,kinetic_translational_J,kinetic_rotational_J,elastic_normal_J,elastic_tangential_J\n"
      "1,4,1,4,1\n2,9,9,9,9\n3,9,9,9,9\n2,3,1,2,1\n");
  ASSERT_EQ(rodpack_command("analyse '" + run_folder.string() + "'").exit_code, 0);
  const auto out = run_folder / "analysis";
  const auto summary = nlohmann::json::parse(text_of(out / "summary.json"));
  EXPECT_EQ(summary["kinetic_energy_J"], 4.0);
  EXPECT_EQ(summary["elastic_energy_J"], 3.0);

  put(run_folder / "energies.csv", "time_s,kinetic_translational_J\n1,two\n");
  const auto bad = rodpack_command("analyse '" + run_folder.string() + "'");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.output, HasSubstr("energies.csv:2: expected a number, found 'two'"));
  EXPECT_EQ(nlohmann::json::parse(text_of(out / "summary.json")), summary) << "was overwritten";
}

// A run resumed from step 1000 that came to rest at step 1500 leaves the dumps of step 2000, which
// the interrupted run had reached, behind.
TEST(Analyse, DumpsAfterTheEndOfTheRunDoNotCount) {
  const auto run_folder = fresh_folder() / "run";
  small_packing().write_run(run_folder);
  const auto command = "analyse '" + run_folder.string() + "'";
  const auto dumps = run_folder / "dumps";
  put(run_folder / "result.json", "{\"step\": 500}");
  const auto none = rodpack_command(command);
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.output, HasSubstr("no dump of bodies up to step 500"));

  put(run_folder / "result.json", "{\"step\": 1500}");
  for (const std::string kind : {"bodies", "spheres", "contacts"}) {
    auto text = text_of(dumps / (kind + ".2000.dump"));
    text.replace(text.find("2000"), 4, "1500");
    put(dumps / (kind + ".1500.dump"), text);
  }
  ASSERT_EQ(rodpack_command(command).exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(text_of(run_folder / "analysis/summary.json"))["timestep"], 1500);

  put(run_folder / "result.json", "not JSON");
  const auto bad = rodpack_command(command);
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_THAT(bad.output, HasSubstr("result.json:1: expected a JSON object"));
}

// Dumps of earlier versions have no normals, a run without gravity may have no contacts.
TEST(Analyse, ContactsThatCannotBeMeasuredAreANote) {
  const auto run_folder = fresh_folder() / "run";
  const auto packing = small_packing();
  packing.write_run(run_folder);
  const auto dump = run_folder / "dumps" / "contacts.2000.dump";
  const auto expect_note = [&](const std::string& text) {
    const auto run = rodpack_command("analyse '" + run_folder.string() + "'");
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("note: contacts: "));
    EXPECT_THAT(run.output, HasSubstr(text));
    EXPECT_FALSE(fs::exists(run_folder / "analysis" / "forces.csv"));
    EXPECT_FALSE(fs::exists(run_folder / "analysis" / "forces_chains.png"));
  };
  const auto command = "analyse '" + run_folder.string() + "'";
  ASSERT_EQ(rodpack_command(command).exit_code, 0);
  ASSERT_TRUE(fs::exists(run_folder / "analysis" / "forces_chains.png"));
  auto old = text_of(dump);
  old.replace(old.find("nx ny nz"), 8, "nu nv nw");
  put(dump, old);
  expect_note("contacts.2000.dump:9: no column 'nx'");
  put(dump, rodpack::test::frame_head(2000, 0, 0.3, 2,
                                      "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy "
                                      "biz bjx bjy bjz overlap_n overlap_t nx ny nz"));
  expect_note("no contacts in the frame of timestep 2000");
  fs::remove(dump);
  expect_note("expected a frame of timestep 2000, found timestep 1000");

  auto bad = packing.contacts_frame(2000);
  bad.replace(bad.rfind(" 0\n"), 3, " x\n");
  put(dump, bad);
  const auto summary = text_of(run_folder / "analysis" / "summary.json");
  const auto run = rodpack_command(command);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("column 'nz': expected a finite number, found 'x'"));
  EXPECT_EQ(text_of(run_folder / "analysis" / "summary.json"), summary) << "was overwritten";
}

TEST(Analyse, ABedOfSpheresLeavesOrientationOutAndSaysSo) {
  const auto run_folder = fresh_folder() / "run";
  SyntheticPacking packing;
  packing.shape = {1, 3e-3, 0.5, 0, 3e-3};
  packing.width = packing.height = 0.1;
  packing.fill();
  packing.write_run(run_folder);
  const auto run = rodpack_command("analyse '" + run_folder.string() + "'");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("no particle to take the orientation of"));
  EXPECT_FALSE(fs::exists(run_folder / "analysis" / "orientation.csv"));
  EXPECT_TRUE(fs::exists(run_folder / "analysis" / "rdf.csv"));
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;
using testing::HasSubstr;
using Vars = std::map<std::string, std::string>;

namespace {

const char* const collision = "verification/collision/in.collision";

void expect_error(const std::string& deck, const Vars& vars, const std::string& message) {
  const auto run = run_liggghts(deck, vars);
  EXPECT_NE(run.exit_code, 0) << message;
  EXPECT_THAT(run.output, HasSubstr(message));
}

/// Two spheres at rest; `models` follows pair_style gran, `commands` come before a run of 0 steps.
std::string small_deck(const std::string& models, const std::string& commands) {
  return Deck().boundary("f f p").box("-0.02 0.02 -0.02 0.02 -0.01 0.01").models(models).with(R"(
fix gn all property/global gamman peratomtypepair 1 1
fix gt all property/global gammat peratomtypepair 1 1
create_atoms 1 single -0.00149 0 0 units box
create_atoms 1 single  0.00149 0 0 units box
set group all diameter 0.003 density 2500
fix integrate all nve/sphere
variable one equal 1
variable name string text
)" + commands + "\nrun 0\n");
}

const std::string ours = "model spring_dashpot tangential spring_dashpot";

}  // namespace

// Wrong values of all keywords and properties: trust/keyword_sweep_test.cpp.

TEST(ContactErrors, MultistepOrder) {
  expect_error(collision, {{"order", "4"}}, "append 'multistepOrder 4'");
  EXPECT_EQ(run_liggghts(collision, {{"order", "4"}, {"multistep", "4"}}).exit_code, 0);
}

TEST(ContactErrors, DashpotsRelaxUnderVelocityVerletAlone) {
  const std::string relaxation = "fix tau all property/global dashpotRelaxation ";
  std::string second_order = small_deck(ours, relaxation + "scalar 1e-5");
  second_order.replace(second_order.find("nve/sphere"), 10, "nve/sphere/ab order 2");
  expect_error(second_order, {},
               "property/global dashpotRelaxation: the integrator that runs is of order 2, "
               "expected velocity Verlet: 'fix multisphere/ab order 0', or LIGGGHTS's own");
  expect_error(small_deck(ours, relaxation + "peratomtypepair 1 1e-5"), {},
               "scalar style required for fix property/global variable dashpotRelaxation");
  EXPECT_EQ(run_liggghts(small_deck(ours, relaxation + "scalar 1e-5")).exit_code, 0);
}

TEST(ContactErrors, SettingsOfStockModelsSayWhatIsRight) {
  const std::string stock = "model hooke/stiffness tangential history";
  expect_error(small_deck(stock + " tangential_damping maybe", ""), {},
               "'tangential_damping' argument: unknown option or wrong keyword order: 'maybe', "
               "expected off or on");
  const std::string message = "'tangential_damping' needs a value";
  expect_error(small_deck(stock + " tangential_damping", ""), {}, message);
  expect_error(small_deck(stock, "fix w all wall/gran " + stock +
                                     " primitive type 1 yplane -0.01 tangential_damping"),
               {}, message);
}

// A contact that remembers what it has been through has no elastic energy; its force is listed.
TEST(ContactErrors, EnergyOfModelsWithoutAPotential) {
  const std::string properties =
      "fix e all property/global youngsModulus peratomtype 1e6\n"
      "fix nu all property/global poissonsRatio peratomtype 0.3\n"
      "fix cr all property/global coefficientRestitution peratomtypepair 1 0.5\n"
      "fix cv all property/global characteristicVelocity scalar 1\n"
      "fix ke all property/global coefficientMaxElasticStiffness peratomtypepair 1 3\n"
      "fix ka all property/global coefficientAdhesionStiffness peratomtypepair 1 0.5\n"
      "fix ph all property/global coefficientPlasticityDepth peratomtypepair 1 0.1\n";
  const std::string stock = "model hooke/hysteresis tangential history";
  const std::string wall = "fix w all wall/gran " + stock + " primitive type 1 yplane -0.01\n";
  const char* const needs =
      "compute contact/energy needs a normal force that is a function of the "
      "overlap, expected 'model' spring_dashpot, hooke, hooke/stiffness, ";
  expect_error(small_deck(stock, properties + "compute c all contact/energy"), {}, needs);
  expect_error(small_deck(ours, properties + wall + "compute c all contact/energy"), {},
               "fix wall/gran w has another");
  const auto run = run_liggghts(small_deck(stock, properties + wall +
                                                      "dump d all contact/gran 1 c.dump\n"
                                                      "compute c all contact/overlap 1e-4"));
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

// Contacts of stock models are those that the step has evaluated: in a step that nobody has
// announced they are not kept.
TEST(ContactErrors, ContactsThatNobodyHasAnnounced) {
  const std::string stock = "model hooke/stiffness tangential history";
  const std::string late = "write_dump all contact/gran c.dump";
  expect_error(small_deck(stock, late), {}, "put a 'run 0' before");
  expect_error(small_deck(stock, "run 1\nreset_timestep 0\n" + late), {},
               "the contacts of this step are not known");
  EXPECT_EQ(run_liggghts(small_deck(stock, "run 1\n" + late)).exit_code, 0);
}

TEST(ContactErrors, ComputesAndDumps) {
  expect_error(small_deck(ours, "compute c all contact/energy all"), {}, "unknown word 'all'");
  expect_error(small_deck(ours, "compute c all multisphere/ke x"), {}, "unknown word 'x'");
  expect_error(small_deck(ours, "group g id 1\ncompute c g contact/energy"), {},
               "the group has to be 'all'");
  expect_error(small_deck(ours, "dump d all contact/gran 1 c.dump x"), {}, "unknown argument x");
  expect_error(small_deck(ours, "dump d all contact/gran 1 c.dump.bin"), {}, "is text only");
  expect_error(small_deck(ours, "dump d all contact/gran 1 c.dump\ndump_modify d format %d"), {},
               "format is '%d'");
  expect_error(small_deck(ours, "write_dump all contact/gran c.dump"), {}, "put a 'run 0' before");
  // write_restart moves atoms, so that the neighbour lists no longer fit.
  expect_error(small_deck(ours, "run 1\nwrite_restart r\nwrite_dump all contact/gran c.dump"), {},
               "put a 'run 0' before");
}

TEST(ContactErrors, Halt) {
  const auto halt = [](const std::string& arguments) {
    return small_deck(ours, "fix h all halt " + arguments);
  };
  expect_error(
      halt("10 v_none < 1"), {},
      "v_NAME is 'v_none', expected v_ and the name of an equal-style variable: there is no such");
  expect_error(
      halt("10 v_name < 1"), {},
      "v_NAME is 'v_name', expected v_ and the name of an equal-style variable: that one is");
}

// Other models may stand beside ours, whichever is stock: they share stiffness and damping.
TEST(ContactModels, MixWithStockModels) {
  for (const char* models : {"model spring_dashpot tangential history",
                             "model hooke/stiffness tangential spring_dashpot",
                             "model spring_dashpot tangential spring_dashpot rolling_friction cdt",
                             "model spring_dashpot"}) {
    const auto run = run_liggghts(
        small_deck(models,
                   "fix p8 all property/global coefficientRollingFriction peratomtypepair 1 0.1\n"
                   "run 200"));
    EXPECT_EQ(run.exit_code, 0) << models << run.output;
  }
}

// .gz, * in the name, and one conversion for all real numbers.
TEST(Dumps, CompressedFilesPerStepWithAFormat) {
  const std::string folder(90, 'x');  // stock LIGGGHTS has room for 115 characters
  const auto run =
      run_liggghts(small_deck(ours, "dump d all multisphere/sphere 10 " + folder + "/" + folder +
                                        "/s.*.dump.gz\ndump_modify d pad 6 format %.3g\nrun 20"));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto first = run.folder / folder / folder / "s.000000.dump.gz";
  ASSERT_TRUE(std::filesystem::exists(first)) << run.output;
  ASSERT_TRUE(std::filesystem::exists(run.folder / folder / folder / "s.000020.dump.gz"));
  const auto text = run_command("gunzip -c " + first.string());
  EXPECT_THAT(text.output, HasSubstr("ITEM: ATOMS id body type x y z radius fx fy fz fsum\n"
                                     "1 1 1 -0.00149 0 0 0.0015 -0.02 0 0 0.02\n"));
}

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

TEST(ContactErrors, PropertiesOutOfRange) {
  expect_error(collision, {{"k", "0"}}, "property/global kn: value 0.0");
  expect_error(collision, {{"kt", "-5"}}, "property/global kt: value -5.0");
  expect_error(collision, {{"eta_n", "1"}}, "expected 0 <= ratio < 1");
  expect_error(collision, {{"eta_t", "-0.1"}},
               "property/global dampingRatioTangential: value -0.1");
  expect_error(collision, {{"mu", "-0.1"}}, "property/global coefficientFriction: value -0.1");
}

TEST(ContactErrors, MissingProperty) {
  std::string deck = small_deck(ours, "");
  deck.replace(deck.find("dampingRatioNormal"), 18, "dampingRatioNornal");
  expect_error(deck, {}, "dampingRatioNormal");
}

TEST(ContactErrors, MultistepOrder) {
  expect_error(collision, {{"multistep", "5"}}, "multistepOrder is 5.0");
  expect_error(collision, {{"multistep", "2.5"}}, "expected 1, 2, 3 or 4");
  expect_error(collision, {{"order", "4"}}, "append 'multistepOrder 4'");
  EXPECT_EQ(run_liggghts(collision, {{"order", "4"}, {"multistep", "4"}}).exit_code, 0);
}

TEST(ContactErrors, TotalForceCap) {
  expect_error(small_deck(ours + " totalForceCap maybe", ""), {},
               "'totalForceCap' argument: unknown option or wrong keyword order: 'maybe', "
               "expected off or on");
  for (const std::string setting : {"totalForceCap", "multistepOrder"}) {
    const std::string message = "'" + setting + "' needs a value";
    expect_error(small_deck(ours + " " + setting, ""), {}, message);
    expect_error(small_deck(ours, "fix w all wall/gran " + ours +
                                      " primitive type 1 yplane -0.01 " + setting),
                 {}, message);
  }
}

// A stock model lists nothing to the recorder: those who ask for the contacts say so.
TEST(ContactErrors, ContactsOfOtherModels) {
  const std::string stock = "model hooke/stiffness tangential history";
  expect_error(small_deck(stock, "compute c all contact/energy\nvariable v equal c_c"), {},
               "compute contact/energy lists contacts of 'model spring_dashpot'");
  expect_error(small_deck(stock, "dump d all contact/gran 1 c.dump"), {},
               "dump contact/gran lists contacts of 'model spring_dashpot'");
  expect_error(small_deck(ours, "fix w all wall/gran " + stock +
                                    " primitive type 1 yplane -0.01\n"
                                    "compute c all contact/overlap 1e-4"),
               {}, "fix wall/gran w has another");
}

TEST(ContactErrors, ComputesAndDumps) {
  expect_error(small_deck(ours, "compute c all contact/overlap"), {},
               "the largest overlap allowed");
  expect_error(small_deck(ours, "compute c all contact/overlap 0"), {}, "overlap is 0");
  expect_error(small_deck(ours, "compute c all contact/overlap 1e-4m"), {},
               "Compute contact/overlap (id c): overlap is 1e-4m, expected a length > 0");
  expect_error(small_deck(ours, "compute c all contact/energy all"), {}, "unknown keyword all");
  expect_error(small_deck(ours, "compute c all multisphere/ke x"), {}, "unknown keyword x");
  expect_error(small_deck(ours, "group g id 1\ncompute c g contact/energy"), {},
               "the group has to be 'all'");
  expect_error(small_deck(ours, "group g id 1\ndump d g multisphere/body 1 b.dump"), {},
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
  expect_error(halt("100 v_one <"), {}, "expected: N v_name operator value");
  expect_error(halt("0 v_one < 1"), {}, "N is 0");
  expect_error(halt("10 one < 1"), {}, "condition on one");
  expect_error(halt("10 v_one =< 1"), {}, "operator is =<");
  expect_error(halt("10 v_none < 1"), {}, "there is no variable none");
  expect_error(halt("10 v_name < 1"), {}, "variable name is not of style equal");
  expect_error(halt("10 v_one < 1 start -1"), {}, "start is -1");
  expect_error(halt("10 v_one < 1 start"), {}, "start needs a value");
  expect_error(halt("10 v_one < 1 message maybe"), {}, "message is maybe");
  expect_error(halt("10 v_one < 1 hold -1"), {}, "hold is -1");
  expect_error(halt("10 v_one < 1 after 5"), {}, "unknown keyword after");
  // LIGGGHTS's own reader would take the leading digits of these.
  expect_error(halt("ten v_one < 1"), {}, "N is ten, expected N > 0");
  expect_error(halt("10 v_one < 1x"), {}, "value is 1x, expected a number");
  expect_error(halt("10 v_one < 1 start 1e3"), {}, "start is 1e3, expected a step >= 0");
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

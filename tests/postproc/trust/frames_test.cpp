// SPDX-License-Identifier: GPL-2.0-or-later
// Which frames of several count, and with whom.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "liggghts_run.h"
#include "reading/checks/frame_pool.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using rodpack::test::text_of;
using testing::HasSubstr;
namespace fs = std::filesystem;

auto rodpack_command(const std::string& arguments, const fs::path& folder) {
  return rodpack::test::run_rodpack(arguments, folder);
}

SyntheticPacking packing_of(double aspect_ratio = 5, unsigned seed = 1) {
  SyntheticPacking packing;
  packing.shape.aspect_ratio = aspect_ratio;
  packing.seed = seed;
  packing.fill();
  return packing;
}

std::string emptied(std::string frame) {
  const auto count = frame.find("ATOMS\n") == std::string::npos ? frame.find("ENTRIES\n") + 8
                                                                : frame.find("ATOMS\n") + 6;
  frame.replace(count, frame.find('\n', count) - count, "0");
  const auto names = frame.find("ITEM: ", frame.find("BOX BOUNDS"));
  return frame.substr(0, frame.find('\n', names) + 1);
}

TEST(Frames, EmptyOnesArePassedOverAndSaidByEverySubcommandAlike) {
  const auto folder = fresh_folder();
  const auto packing = packing_of();
  put(folder / "bodies.dump", emptied(packing.bodies_frame(0)) + packing.bodies_frame(5));
  put(folder / "contacts.dump", emptied(packing.contacts_frame(0)) + packing.contacts_frame(5));
  for (const std::string command :
       {"orientation bodies.dump", "rdf bodies.dump", "solid-fraction bodies.dump",
        "stress bodies.dump", "profile bodies.dump", "forces contacts.dump"}) {
    const auto run = rodpack_command(command + " --all-frames", folder);
    EXPECT_EQ(run.exit_code, 0) << command << run.output;
    EXPECT_THAT(run.output, HasSubstr("passed over: 1 empty frame\n")) << command;
  }
}

// Counted twice, the same frame would make every standard error too small by the root of 2.
TEST(Frames, ARepeatedOneCountsOnce) {
  const auto folder = fresh_folder();
  const auto packing = packing_of();
  put(folder / "a.dump", packing.bodies_frame(5));
  put(folder / "b.dump", packing.bodies_frame(5) + packing.bodies_frame(5));
  put(folder / "copy" / "a.dump", packing.bodies_frame(5));
  for (const std::string command : {"orientation", "rdf"}) {
    ASSERT_EQ(rodpack_command(command + " a.dump -o once", folder).exit_code, 0);
    const auto run =
        rodpack_command(command + " a.dump b.dump copy/a.dump --all-frames -o often", folder);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_THAT(run.output, HasSubstr("passed over: 3 repeated frames\n"));
    EXPECT_EQ(text_of(folder / "often.csv"), text_of(folder / "once.csv"));
  }
}

TEST(Frames, AnotherCourseOfTheSameRunIsRefusedAndAnotherRunPooled) {
  const auto folder = fresh_folder();
  const auto one = packing_of(5, 1).bodies_frame(5), other = packing_of(5, 2).bodies_frame(5);
  put(folder / "run1" / "a.dump", one);
  put(folder / "run1" / "b.dump", other);
  put(folder / "run2" / "b.dump", other);
  const auto run = rodpack_command("orientation run1/a.dump run1/b.dump --all-frames", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.output,
      "rodpack: run1/b.dump:9: expected each timestep once, found another frame of timestep 5 "
      "than in run1/a.dump\n");
  EXPECT_EQ(rodpack_command("orientation run1/a.dump run2/b.dump --all-frames", folder).exit_code,
            0);
}

TEST(Frames, BedsOfOtherParticlesAreNotPooled) {
  const auto folder = fresh_folder();
  put(folder / "run1" / "a.dump", packing_of(5).bodies_frame(5));
  put(folder / "run2" / "a.dump", packing_of(3).bodies_frame(5));
  for (const std::string command : {"orientation", "rdf", "solid-fraction"}) {
    const auto run =
        rodpack_command(command + " run1/a.dump run2/a.dump --all-frames --dp 3e-3 --ar 5", folder);
    EXPECT_EQ(run.exit_code, 1) << run.output;
    EXPECT_THAT(run.output, HasSubstr("run2/a.dump:9: expected the particles of run1/a.dump (9 "
                                      "spheres, half length 0.0075 m"));
  }
}

// Both runs have the same timestep: the contacts of each go with its own bodies.
TEST(Frames, ContactsOfTheirOwnRunGoWithTheBodies) {
  const auto folder = fresh_folder();
  auto one = packing_of(5, 1), other = packing_of(5, 2);
  put(folder / "run1" / "bodies.dump", one.bodies_frame(5));
  put(folder / "run1" / "contacts.dump", one.contacts_frame(5));
  put(folder / "run2" / "bodies.dump", other.bodies_frame(5));
  put(folder / "run2" / "contacts.dump", other.contacts_frame(5));
  const std::string both = "stress run1/bodies.dump run2/bodies.dump --all-frames -o both";
  ASSERT_EQ(rodpack_command(both, folder).exit_code, 0);
  double mean = 0;
  for (const std::string run : {"run1", "run2"}) {
    ASSERT_EQ(rodpack_command("stress " + run + "/bodies.dump -o alone", folder).exit_code, 0);
    const auto alone = rodpack::test::read_table(folder / "alone.csv");
    mean += alone.column("contact_stress_xx_N_m")[alone.rows() / 2] / 2;
  }
  const auto pooled = rodpack::test::read_table(folder / "both.csv");
  EXPECT_NEAR(pooled.column("contact_stress_xx_N_m")[pooled.rows() / 2], mean, 1e-8 * mean);
  put(folder / "run1" / "contacts.again.dump", one.contacts_frame(5));
  const auto run =
      rodpack_command("stress run1/bodies.dump --contacts 'run1/contacts*.dump'", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("begins with timestep 5 as does"));
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

/// A sphere flies; `condition` is the formula of the variable that `fix halt` looks at.
std::string flight(const std::string& condition, const std::string& halt,
                   const std::string& more = "") {
  return "atom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
         "communicate single vel yes\nunits si\n"
         "region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box\ncreate_box 1 box\n"
         "neighbor 0.001 bin\n"
         "fix kn all property/global kn peratomtypepair 1 1\n"
         "fix kt all property/global kt peratomtypepair 1 1\n"
         "fix dn all property/global dampingRatioNormal peratomtypepair 1 0\n"
         "fix dt all property/global dampingRatioTangential peratomtypepair 1 0\n"
         "fix mu all property/global coefficientFriction peratomtypepair 1 0\n"
         "pair_style gran model spring_dashpot tangential spring_dashpot\npair_coeff * *\n"
         "timestep 1e-6\ncreate_atoms 1 single 0 0 0 units box\n"
         "set group all diameter 0.003 density 2500\nfix move all nve/sphere\n"
         "variable met equal \"" +
         condition + "\"\nfix end all halt 100 v_met != 0 " + halt + "\n" + more +
         "run 2000 upto\nvariable n equal step\nprint 'ended at ${n}'\n";
}

}  // namespace

// From step 500 on, checked every 100 steps.
TEST(Halt, EndsTheRunOnceTheConditionHasHeldForAWhile) {
  EXPECT_THAT(run_liggghts(flight("step >= 500", "")).output, testing::HasSubstr("ended at 500"));
  EXPECT_THAT(run_liggghts(flight("step >= 500", "hold 300")).output,
              testing::HasSubstr("ended at 800"));
}

// Met at 500 and 600, not at 700, and from 1200 on.
TEST(Halt, StartsAnewWhenTheConditionFailsInBetween) {
  EXPECT_THAT(
      run_liggghts(flight("(step >= 500 && step < 700) || step >= 1200", "hold 300")).output,
      testing::HasSubstr("ended at 1500"));
}

TEST(Halt, GoesOnFromARestart) {
  const auto whole = run_liggghts(flight("step >= 500", "hold 300", "restart 600 flight.*\n"));
  ASSERT_THAT(whole.output, testing::HasSubstr("ended at 800"));
  std::string deck = flight("step >= 500", "hold 300");
  const auto cut = [&deck](const std::string& from, const std::string& to,
                           const std::string& with) {
    const auto a = deck.find(from), b = deck.find(to);
    ASSERT_NE(a, std::string::npos);
    deck.replace(a, b - a, with);
  };
  cut("region box", "neighbor", "read_restart flight.600\n");
  cut("create_atoms", "fix move", "");
  const auto resumed = run_liggghts_in(whole.folder, deck);
  EXPECT_THAT(resumed.output, testing::HasSubstr("ended at 800")) << resumed.output;
}

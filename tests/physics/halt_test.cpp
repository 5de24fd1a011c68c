// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "deck.h"
#include "liggghts_run.h"

using namespace rodpack::test;

namespace {

/// A sphere flies; `condition` is the formula of the variable that `fix halt` looks at. `restart`:
/// file to go on from, in place of a new sphere.
std::string flight(const std::string& condition, const std::string& halt,
                   const std::string& more = "", const std::string& restart = "") {
  Deck deck;
  deck.box("-0.01 0.01 -0.01 0.01 -0.01 0.01").timestep("1e-6").restart(restart);
  deck.stiffness("1", "1").damping("0").friction("0");
  const char* const sphere =
      "create_atoms 1 single 0 0 0 units box\nset group all diameter 0.003 density 2500\n";
  return deck.with((restart.empty() ? sphere : "") +
                   std::string("fix move all nve/sphere\nvariable met equal \"") + condition +
                   "\"\nfix end all halt 100 v_met != 0 " + halt + "\n" + more +
                   "run 2000 upto\nvariable n equal step\nprint 'ended at ${n}'\n");
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
  const auto resumed =
      run_liggghts_in(whole.folder, flight("step >= 500", "hold 300", "", "flight.600"));
  EXPECT_THAT(resumed.output, testing::HasSubstr("ended at 800")) << resumed.output;
}

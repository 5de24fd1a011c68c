// SPDX-License-Identifier: GPL-2.0-or-later
// Observed orders of the integrators, through what `rodpack accuracy` does.
#include "campaigns/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include <sstream>

#include "liggghts_run.h"

namespace {

using namespace rodpack;

AccuracySummary measured(const std::string& scene, const std::string& method,
                         const std::vector<double>& steps) {
  AccuracySettings settings;
  settings.liggghts.program = RODPACK_BIN "/liggghts";
  settings.inputs = RODPACK_REPOSITORY "/inputs";
  settings.scenes = {scene};
  settings.methods = {method};
  settings.steps = steps;
  settings.repeats = 1;
  settings.timed_steps = 1000;
  std::ostringstream progress;
  const auto rows = measure_accuracy(settings, rodpack::test::fresh_folder().string(), progress);
  return summarise(rows, accuracy_scene(scene).contact_time / paper_step, 25, 1e-11);
}

}  // namespace

// A smooth motion shows the order of the formula. Stock multisphere turns its bodies to second
// order. The leading error of order 4 is small here, so that the next one shows at these steps.
TEST(Accuracy, FreelySpinningRodShowsTheOrderOfTheFormula) {
  for (const auto& [method, order] :
       {std::pair("builtin", 2), {"ab2", 2}, {"ab3", 3}, {"ab4", 4}}) {
    const auto s = measured("spin_3d", method, {28.37, 57.37, 114.37});
    ASSERT_TRUE(s.order) << method;
    EXPECT_NEAR(*s.order, order, order == 4 ? 0.5 : 0.3) << method;
  }
}

// The dashpot makes the force jump at touch, which plain Adams-Bashforth straddles: first order,
// some 1 % at the paper's step. See inputs/verification/collision.
TEST(Accuracy, DashpotMakesACollisionOfFirstOrder) {
  for (const char* method : {"builtin", "ab3"}) {
    const auto s = measured("collision_0.2", method, {28.37, 57.37, 114.37, 229.37});
    ASSERT_TRUE(s.order && s.paper_error) << method;
    EXPECT_NEAR(*s.order, 1, 0.2) << method;
    EXPECT_GT(*s.paper_error, 5e-3) << method;
    EXPECT_LT(*s.paper_error, 2e-2) << method;
  }
}

// Errors small in comparison with what another law or another geometry would make (some 1e-1): the
// decks and the references describe the same motion.
TEST(Accuracy, DecksTendToTheReferences) {
  for (const char* scene : {"oblique_stick", "oblique_slip", "rod_drop", "rod_rocking"}) {
    const auto s = measured(scene, "ab3", {114.37, 457.37});
    ASSERT_TRUE(s.evaluations) << scene;  // 1e-3 is reached
  }
}

// SPDX-License-Identifier: GPL-2.0-or-later
#include "campaigns/beds/beds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "liggghts_run.h"

using namespace rodpack;

// 30 rods, one seed, the paper's model. Weight: of the bodies' masses; forces: of floor and walls.
TEST(Beds, ASmallBedComesToRestAndItsWeightIsCarried) {
  AccuracySettings settings;
  settings.liggghts.program = RODPACK_BIN "/liggghts";
  settings.inputs = RODPACK_REPOSITORY "/inputs";
  settings.bed_scene.lines = 6;
  const auto row = run_bed(settings, rodpack::test::fresh_folder().string(), {}, 1);
  EXPECT_TRUE(row.at_rest(30));
  EXPECT_EQ(row.rods, 30);
  EXPECT_EQ(row.steps, 100000);
  EXPECT_NEAR(row.carried_weight, 1, 0.01);
  EXPECT_GT(row.elastic, 1e-8);
  EXPECT_LE(row.kinetic, 1e-5 * row.elastic);
  // a shallow bed with an uneven surface; rods on the floor lie flat
  EXPECT_NEAR(row.solid_fraction, 0.77, 0.12);
  EXPECT_GT(row.order, 0.4);
  // between the two of a bridge and the three of a frictionless particle, walls not counted
  EXPECT_NEAR(row.neighbours, 2.3, 1);
  EXPECT_GT(row.contacts, row.neighbours);
  EXPECT_GT(row.overlap, 0);
  EXPECT_LT(row.overlap, 0.01);
  EXPECT_GE(row.largest_force, row.mean_force);
  // a pair's force is of the order of a rod's weight, 2.25 mN
  EXPECT_NEAR(std::log10(row.mean_force / 2.25e-3), 0.4, 0.6);
  EXPECT_GT(row.step_over_limit, 0.1);
  EXPECT_LT(row.step_over_limit, 1);
  EXPECT_GT(row.seconds_per_step, 0);
}

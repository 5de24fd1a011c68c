// SPDX-License-Identifier: GPL-2.0-or-later
// Blocks whose spheres are apart, and for how long they are passed over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "heap.h"
#include "planar/bodies.h"
#include "planar/force_evaluator.h"
#include "planar_lists/neighbours.h"

namespace rodpack {
namespace {

const double apart = 1e-4;  // m, between the surfaces of two rods side by side

struct TwoRods {
  PlanarSettings settings;
  PlanarParts parts = {2, 4};
  PlanarKernel kernel;
  PlanarBodyStates bodies;
  PlanarBlocks blocks = PlanarBlocks(2, 3);
  PlanarEvents events = PlanarEvents(parts);
  PlanarDependencies dependencies = PlanarDependencies(parts);
  PlanarNeighbours neighbours = {settings, bodies, parts, blocks, dependencies};
  PlanarForceEvaluator evaluator = {settings, kernel, bodies, neighbours, blocks, events};

  explicit TwoRods(PlanarInstructions instructions)
      : settings(settings_of()),
        kernel(planar_kernel(instructions, false)),
        bodies(settings, parts, {rod(5, 0, 0, 0), rod(5, 0, diameter + apart, 0)}) {
    settings.instructions = instructions;
    events.resize(2);
    neighbours.set_longest_reach(bodies.longest_reach());
    neighbours.list_all();
    blocks.sort(parts, dependencies);
  }

  void evaluate() {
    for (int part = 0; part < parts.count(); ++part) evaluator.evaluate(part, 7);
  }
  /// The least gap of all blocks, m.
  double gap() const {
    double least = 1.0;
    for (int place = 0; place < blocks.pairs().size(); ++place)
      least = std::min<double>(least, blocks.pairs().head(place).gap);
    return least;
  }
};

}  // namespace

// A rod goes 0.5 mm to and fro: its block is looked at, and sleeps then until the rods have gone
// that way and the gap. That holds for bodies at the same step alone, which those of a block that
// has been listed in the pass need not be.
TEST(PlanarSleep, ABlockSleepsUntilItsBodiesHaveTravelledTheGap) {
  for (const PlanarInstructions instructions :
       {PlanarInstructions::automatic, PlanarInstructions::baseline}) {
    TwoRods rods(instructions);
    ASSERT_GT(rods.blocks.pairs().filled(), 0);
    EXPECT_NEAR(rods.gap(), apart, 1e-6 * apart);
    const double there[3] = {0.25e-3, 0.0, 0.0};
    for (int k = 0; k < 2; ++k) rods.neighbours.add_path(0, there);

    rods.blocks.pairs().set_gap(0, apart);  // it is listed
    rods.evaluate();
    EXPECT_NEAR(rods.gap(), apart, 1e-6 * apart) << "it was listed in this pass";
    rods.blocks.settle();
    rods.evaluate();
    const double travelled = 0.5e-3;
    EXPECT_NEAR(rods.gap(), travelled + apart, 1e-6 * travelled);
    EXPECT_LE(rods.gap(), travelled * (1 + 1e-9) + apart) << "never too late";
  }
}

// The length of a vector is bounded by max + (sqrt(2) - 1) min of its components: exactly where it
// points along an axis or halfway between two, by at most 1/cos(pi/8) times the length elsewhere.
// The end of a rod that turns as well goes the arc in addition.
TEST(PlanarSleep, PathsAreNeverTooShortAndLittleTooLong) {
  const double excess = 1 / std::cos(M_PI / 8);
  for (int k = 0; k <= 32; ++k) {
    TwoRods rods(PlanarInstructions::automatic);
    const double angle = k * M_PI / 16, length = 1e-3, turn = 0.01;
    const double there[3] = {length * std::cos(angle), length * std::sin(angle), -turn};
    rods.neighbours.add_path(1, there);
    const double path = rods.neighbours.travelled()[1] - turn * 2.5 * diameter;
    EXPECT_GE(path, length * (1 - 1e-12)) << k;
    EXPECT_LE(path, length * (k % 4 == 0 ? 1 + 1e-8 : excess + 1e-8)) << k;
  }
}

}  // namespace rodpack

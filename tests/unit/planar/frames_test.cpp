// SPDX-License-Identifier: GPL-2.0-or-later
// Frames that move with the bodies: how they move, and that lists miss nothing for it.
#include "planar_lists/frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "heap.h"
#include "planar/bodies.h"
#include "planar_lists/grid.h"

namespace rodpack {
namespace {

const double cell = 0.1;

/// Bodies on a grid of ten by ten cells of 0.1 m, and frames that have been renewed.
struct Frames {
  PlanarSettings settings;
  PlanarGrid grid;
  PlanarFrames frames;

  Frames(const PlanarSettings& given, std::vector<PlanarBody> bodies)
      : settings(given), frames(settings) {
    // In corners of the grid, at rest; so many that it has all its cells.
    for (int k = 0; k < 30; ++k) bodies.push_back(rod(1, 0.001, 0.001, 0));
    bodies.push_back(rod(1, 0.999, 0.999, 0));
    std::vector<double> x, y;
    for (const PlanarBody& body : bodies) {
      x.push_back(body.position[0]);
      y.push_back(body.position[1]);
    }
    grid.build(x, y, 0.998 * cell);
    const PlanarParts parts{static_cast<int>(bodies.size()), 16};
    frames.renew(grid, PlanarBodyStates(settings, parts, bodies));
  }

  /// Of the cell in this column and row, from 0.
  PlanarFrameStep step(int column, int row) const {
    return frames.step((row + 1) * grid.stride() + column + 1);
  }
};

/// A disc in the middle of a cell.
PlanarBody disc(int column, int row, double vx, double vy) {
  return moving(rod(1, (column + 0.5) * cell, (row + 0.5) * cell, 0), vx, vy);
}

void expect_step(const PlanarFrameStep& step, double x, double y, double strain) {
  EXPECT_NEAR(step.x, x, 1e-15);
  EXPECT_NEAR(step.y, y, 1e-15);
  EXPECT_NEAR(step.strain, strain, 1e-15);
}

}  // namespace

// One body moves: its cell and the eight around it go with it, those farther away stand still, and
// half of the difference is strain on both sides.
TEST(PlanarFrames, GoWithTheBodiesOfTheirCellAndOfThoseAround) {
  const PlanarSettings settings = settings_of();
  const Frames of(settings, {disc(5, 5, 0.05, -0.02)});
  EXPECT_TRUE(of.frames.any_moves());
  EXPECT_EQ(of.frames.steps_within_way(), most_steps_in_pass);
  const double x = 0.05 * settings.dt, y = -0.02 * settings.dt, strain = 0.5 * std::hypot(x, y);
  expect_step(of.step(5, 5), x, y, 0.0);
  for (const auto& place : {std::pair<int, int>{4, 4}, {6, 5}, {5, 6}})
    expect_step(of.step(place.first, place.second), x, y, strain);
  expect_step(of.step(7, 5), 0.0, 0.0, strain);
  expect_step(of.step(8, 5), 0.0, 0.0, 0.0);
}

// Sums are weighted 1 : 2 : 1 along x and along y: a cell has the weight 4, one beside it 2, one
// across its corner 1.
TEST(PlanarFrames, AreWeightedAverages) {
  const PlanarSettings settings = settings_of();
  const Frames of(settings, {disc(5, 5, 0.07, 0.0), disc(6, 5, 0.01, 0.0), disc(4, 6, -0.04, 0.0)});
  EXPECT_NEAR(of.step(5, 5).x, (4 * 0.07 + 2 * 0.01 - 1 * 0.04) / 7 * settings.dt, 1e-15);
  EXPECT_NEAR(of.step(6, 5).x, (4 * 0.01 + 2 * 0.07) / 6 * settings.dt, 1e-15);
}

// A largest skin of 1 mm covers 80 steps of 11 us at up to 1.14 m/s. Faster bodies count where no
// slow one is near.
TEST(PlanarFrames, GoWithSlowBodiesWhereThereAreSome) {
  const PlanarSettings settings = settings_of();
  const Frames of(settings, {disc(2, 5, 0.1, 0.0), disc(3, 5, 0.0, -2.0), disc(7, 5, 0.0, -2.0)});
  EXPECT_NEAR(of.step(2, 5).x, 0.1 * settings.dt, 1e-15);
  EXPECT_NEAR(of.step(3, 5).x, 0.1 * settings.dt, 1e-15);
  EXPECT_NEAR(of.step(3, 5).y, 0.0, 1e-15);
  EXPECT_NEAR(of.step(7, 5).y, -2.0 * settings.dt, 1e-15);
}

// No more than a quarter of the largest skin in a step, 0.25 mm here; and no longer than the
// largest skin, 1 mm, until they are renewed.
TEST(PlanarFrames, StayNearTheirCells) {
  const PlanarSettings settings = settings_of();
  const auto steps = [&](double speed) {
    const Frames of(settings, {disc(5, 5, 0.0, -speed)});
    EXPECT_NEAR(of.step(5, 5).y, -std::min(speed * settings.dt, 2.5e-4), 1e-15);
    return of.frames.steps_within_way();
  };
  EXPECT_EQ(steps(5.0), 8);
  EXPECT_EQ(steps(14.0), 6);  // 1 mm / 0.154 mm
  EXPECT_EQ(steps(200.0), 4);
}

// Walls at x = 0.52 and y = 0.31: no cell less than half a cell away moves across them.
TEST(PlanarFrames, DoNotMoveAcrossWalls) {
  PlanarSettings settings = settings_of();
  settings.walls = {{0, 0.52, 0}, {1, 0.31, 0}};
  std::vector<PlanarBody> bodies;
  for (int column = 0; column < 10; ++column)
    for (int row = 0; row < 10; ++row) bodies.push_back(disc(column, row, 0.05, -0.05));
  const Frames of(settings, bodies);
  const double step = 0.05 * settings.dt;
  for (int k = 2; k < 9; ++k) {
    EXPECT_NEAR(of.step(k, 6).x, k == 4 || k == 5 ? 0.0 : step, 1e-12) << k;
    EXPECT_NEAR(of.step(7, k).y, k == 2 || k == 3 ? 0.0 : -step, 1e-12) << k;
  }
}

// What rests has the least skins in any frame.
TEST(PlanarFrames, StandStillWhereBodiesRest) {
  const Frames of(settings_of(), {disc(5, 5, 1e-3, 0.0)});
  EXPECT_FALSE(of.frames.any_moves());
  expect_step(of.step(5, 5), 0.0, 0.0, 0.0);
}

// At 2 m/s a body leaves its skin of 1 mm every 31 steps: 30 rods in 2000 steps 1900 times, but for
// the frame that flies with them.
TEST(PlanarFrames, BodiesThatFlyTogetherAreNotListedAnew) {
  std::vector<PlanarBody> bodies = heap(30, 5);
  for (PlanarBody& body : bodies) body = moving(body, 1.2, -1.6);
  PlanarScene scene(settings_of(), bodies);
  scene.evaluate();
  scene.run(2000);
  EXPECT_LT(scene.statistics().listings, 30);
}

// Two heaps fly at each other at 6 m/s, from farther away than frames stay together, and a third
// one falls onto a floor, between walls: frames of all kinds meet. Lists of all pairs, for once and
// all, give the same motion.
TEST(PlanarFrames, MissNoContact) {
  const double length = 5 * diameter;
  PlanarSettings settings = box(5);
  settings.walls[2].position = 20 * length;
  std::vector<PlanarBody> bodies;
  for (int part = 0; part < 3; ++part)
    for (PlanarBody body : heap(12, 5)) {
      body.position[0] += length * (part == 2 ? 14.5 : 1.0 + 9.5 * part);
      body.position[1] += length * (part == 2 ? 0.1 : 1.0);
      bodies.push_back(part == 2 ? moving(body, body.velocity[0], -1.0, body.velocity[2])
                                 : moving(body, part == 0 ? 3.0 : -3.0, 0.0, body.velocity[2]));
    }
  for (const double dt : {paper_step, 2.5 * paper_step}) {
    settings.dt = dt;
    const auto end = [&](double least, double most) {
      settings.min_skin = least;
      settings.max_skin = most;
      PlanarScene scene(settings, bodies);
      scene.evaluate();
      scene.run(std::lround(0.024 / dt));
      EXPECT_GT(scene.contacts().size(), 10u);
      return std::make_pair(state_of(scene), scene.statistics().listings);
    };
    const auto everything = end(1.0, 1.0), usual = end(1e-4, 1e-3), narrow = end(2e-5, 2e-4);
    EXPECT_EQ(everything.second, 0);
    EXPECT_GT(usual.second, 100);
    EXPECT_LT(difference(everything.first, usual.first), 1e-10);
    EXPECT_LT(difference(everything.first, narrow.first), 1e-10);
  }
}

}  // namespace rodpack

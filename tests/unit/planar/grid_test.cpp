// SPDX-License-Identifier: GPL-2.0-or-later
// The cell grid of the planar engine against a comparison of all bodies with all.
#include "planar_lists/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace rodpack {
namespace {

struct Points {
  std::vector<double> x, y;
  std::set<int> in_grid;
};

Points random_points(int count, double width, double height) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Points points;
  for (int k = 0; k < count; ++k) {
    points.x.push_back(width * share(random));
    points.y.push_back(height * share(random));
    points.in_grid.insert(k);
  }
  return points;
}

std::vector<int> found_around(const PlanarGrid& grid, double x, double y, double reach) {
  std::vector<int> found;
  grid.around(x, y, reach, [&](int other) { found.push_back(other); });
  std::sort(found.begin(), found.end());
  return found;
}

/// Everybody finds each body that is no farther than `reach`, once, and nobody who is not there.
void expect_neighbours_are_found(const PlanarGrid& grid, const Points& points, double reach) {
  for (const int k : points.in_grid) {
    const std::vector<int> found = found_around(grid, points.x[k], points.y[k], reach);
    EXPECT_EQ(std::adjacent_find(found.begin(), found.end()), found.end());
    for (const int other : found) EXPECT_EQ(points.in_grid.count(other), 1u);
    for (const int other : points.in_grid) {
      const double distance =
          std::hypot(points.x[other] - points.x[k], points.y[other] - points.y[k]);
      if (distance < reach) {
        EXPECT_TRUE(std::binary_search(found.begin(), found.end(), other)) << k << ' ' << other;
      }
    }
  }
}

}  // namespace

TEST(PlanarGrid, FindsAllBodiesThatAreCloserThanACell) {
  const Points points = random_points(300, 3.0, 2.0);
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.25);
  expect_neighbours_are_found(grid, points, 0.25);
  expect_neighbours_are_found(grid, points, 0.1);
  expect_neighbours_are_found(grid, points, 0.6);
}

// Three cells of 0.25 in each direction hold 9/96 of the 300 bodies in 12 x 8 cells, 28 on average.
TEST(PlanarGrid, LooksAtTheCellsAroundAlone) {
  const Points points = random_points(300, 3.0, 2.0);
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.25);
  for (int k = 0; k < 300; ++k)
    EXPECT_LT(found_around(grid, points.x[k], points.y[k], 0.25).size(), 60u);
}

TEST(PlanarGrid, FindsBodiesWhereTheyHaveMoved) {
  Points points = random_points(300, 3.0, 2.0);
  const Points later = random_points(900, 3.0, 2.0);
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.25);
  for (int n = 0; n < 300; ++n) {
    const int k = 77 * n % 300;  // out of the middle of the list of a cell too
    points.x[k] = later.x[k + 600];
    points.y[k] = later.y[k + 600];
    grid.move(k, points.x[k], points.y[k]);
  }
  expect_neighbours_are_found(grid, points, 0.25);
}

TEST(PlanarGrid, BodiesThatLeaveItsEdgeStayNeighbours) {
  Points points = random_points(200, 1.0, 1.0);
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.2);
  for (int k = 0; k < 200; ++k) {  // all of them, to three times the size on all sides
    points.x[k] = 3.0 * points.x[k] - 1.0;
    points.y[k] = 3.0 * points.y[k] - 1.0;
    grid.move(k, points.x[k], points.y[k]);
  }
  expect_neighbours_are_found(grid, points, 0.2);
}

TEST(PlanarGrid, BodiesComeAndGo) {
  Points points = random_points(150, 1.0, 1.0);
  PlanarGrid grid;
  grid.build({points.x.begin(), points.x.begin() + 100}, {points.y.begin(), points.y.begin() + 100},
             0.2);
  for (int k = 0; k < 100; k += 3) {
    grid.remove(k);
    points.in_grid.erase(k);
  }
  for (int k = 100; k < 150; ++k) grid.add(k, points.x[k], points.y[k]);
  expect_neighbours_are_found(grid, points, 0.2);
}

// Cells of 0.1 would be 10^20 here.
TEST(PlanarGrid, OneBodyFarAwayDoesNotTakeAllMemory) {
  Points points = random_points(100, 1.0, 1.0);
  points.x[7] = 1e9;
  points.y[7] = -1e9;
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.1);
  expect_neighbours_are_found(grid, points, 0.1);
}

// Points from 0 to 3 along x and to 2 along y, to a hundredth, in cells of 0.25: columns 1 to 12
// and rows 1 to 8, with one more on each side. A line is half a cell, 0.125, away from a column.
TEST(PlanarGrid, KnowsWhichColumnsAndRowsALineIsNear) {
  Points points = random_points(300, 3.0, 2.0);
  points.x[0] = points.y[0] = 0.0;
  points.x[1] = 2.99;
  points.y[1] = 1.99;
  PlanarGrid grid;
  grid.build(points.x, points.y, 0.25);
  const auto near = [&](int axis, double position) {
    std::vector<int> found;
    const int columns = axis == 0 ? grid.stride() : grid.cells() / grid.stride();
    for (int column = 0; column < columns; ++column)
      if (grid.reaches(axis, column, position)) found.push_back(column);
    return found;
  };
  EXPECT_EQ(grid.stride(), 14);
  EXPECT_EQ(grid.cells(), 14 * 10);
  EXPECT_EQ(near(0, 1.10), (std::vector<int>{4, 5}));
  EXPECT_EQ(near(1, 1.20), (std::vector<int>{5, 6}));
  EXPECT_EQ(near(0, -7.0), (std::vector<int>{0, 1})) << "bodies may have gone there";
  EXPECT_EQ(near(1, 7.0), (std::vector<int>{8, 9}));
}

TEST(PlanarGrid, MayHaveNoBodies) {
  PlanarGrid grid;
  grid.build({}, {}, 0.1);
  EXPECT_TRUE(found_around(grid, 0.0, 0.0, 0.1).empty());
  grid.add(0, 5.0, 5.0);
  EXPECT_EQ(found_around(grid, 5.0, 5.0, 0.1), std::vector<int>{0});
}

}  // namespace rodpack

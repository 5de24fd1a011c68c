// SPDX-License-Identifier: GPL-2.0-or-later
#include "figures/packings/particles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "figures/figure.h"
#include "liggghts_run.h"
#include "reading/text_file.h"
#include "study/panels.h"
#include "../synthetic_packing.h"

namespace {
using namespace rodpack;
using rodpack::test::frame_head;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using testing::ElementsAre;
using testing::HasSubstr;

Frame spheres(std::size_t rows, const std::string& text, const std::string& columns) {
  return last_frame(
      {put(fresh_folder() / "spheres.1.dump", frame_head(1, rows, 10, 10, columns) + text)});
}

// Two dimers of unit spheres that touch at the second and third one, the rows of the first apart.
TEST(Joints, JoinTheSpheresOfAParticleAndNotThoseOfTwo) {
  const auto frame =
      spheres(4, "2 1 2 1 0.5\n3 2 3 1 0.5\n1 1 1 1 0.5\n4 2 4 1 0.5\n", "id body x y radius");
  const auto joints = joints_of(frame, {0, 1, 2, 3});
  ASSERT_EQ(joints.size(), 2U);
  EXPECT_DOUBLE_EQ(joints[0].x, 1.5);
  EXPECT_DOUBLE_EQ(joints[1].x, 3.5);
  for (const auto& joint : joints) {
    EXPECT_DOUBLE_EQ(joint.y, 1);
    // A third sphere that touches both reaches to (sqrt(3) - 1) / 2 from their line.
    EXPECT_LT(joint.radius, (std::sqrt(3.0) - 1) / 2);
    EXPECT_DOUBLE_EQ(joint.radius, 0.25);
  }
}

TEST(Joints, AreThereWhereDrawnDiametersLeaveAGapAndNotInDeepOverlaps) {
  // Of 0.95 d_p, whose centres are 1.05 d_p apart; of 50 % overlap.
  const auto columns = "id body x y radius";
  EXPECT_EQ(joints_of(spheres(2, "1 1 1 1 0.475\n2 1 2.05 1 0.475\n", columns), {0, 1}).size(), 1U);
  EXPECT_TRUE(joints_of(spheres(2, "1 1 1 1 0.5\n2 1 1.5 1 0.5\n", columns), {0, 1}).empty());
}

TEST(Joints, NoneCrossesAPeriodicSideAndRowsFollowEachOtherWithoutIds) {
  EXPECT_TRUE(
      joints_of(spheres(2, "1 0.2 1 0.5\n1 9.8 1 0.5\n", "body x y radius"), {0, 1}).empty());
  EXPECT_EQ(joints_of(spheres(3, "1 1 1 0.5\n1 2 1 0.5\n1 3 1 0.5\n", "body x y radius"), {0, 1, 2})
                .size(),
            2U);
}

TEST(VisibleSpheres, AreThoseThatReachIntoTheWindow) {
  const auto frame = spheres(3, "1 1 1 0.5\n1 2.4 1 0.5\n1 2.6 1 0.5\n", "body x y radius");
  EXPECT_THAT(visible_spheres(frame, {0, 2, 0, 2}), ElementsAre(0U, 1U));
}

TEST(Datablock, ARowWithoutANumberPartsTheLine) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(datablock("d", {{1, 2, 3}, {4, none, 6}}), "$d << EOD\n1 4\n\n3 6\nEOD\n");
}

// A line from (1, 1) by a hole to (3, 1) is drawn in two pieces: gnuplot starts each with a move.
TEST(Figure, NoLineCrossesAnEmptyBin) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto moves = [&](double middle) {
    const auto stem = (fresh_folder() / "gap").string();
    draw_figure(stem, 1,
                datablock("d", {{1, 2, 3, 4, 5}, {1, 1, middle, 1, 1}}) +
                    "unset border\nunset tics\nplot $d using 1:2 with lines\n");
    const auto svg = read_text(stem + ".svg");
    int count = 0;
    const auto begin = svg.find("<title>gnuplot_plot_1</title>");
    for (auto at = svg.find('M', begin); at != std::string::npos; at = svg.find('M', at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(moves(none), moves(1) + 1);
}

TEST(SeriesOf, AnEntryWithoutRepetitionPartsTheLineAndIsLeftOutAtTheEnds) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EnsembleCurve curve;
  curve.x = {0, 1, 2, 3, 4, 5};
  for (const double value : {none, 1.0, none, none, 2.0, none})
    curve.y.push_back({value, std::nullopt, std::isnan(value) ? 0 : 1});
  const auto series = series_of(curve);
  ASSERT_THAT(series.x, ElementsAre(1, 3, 4));
  EXPECT_EQ(series.y[0], 1);
  EXPECT_TRUE(std::isnan(series.y[1]));
  EXPECT_EQ(series.y[2], 2);
}

}  // namespace

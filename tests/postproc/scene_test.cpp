// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {
using rodpack::scene_unlike_the_papers;
using testing::HasSubstr;

nlohmann::json parameters(double width, double height) {
  return {{"particle_diameter_m", 3e-3},
          {"aspect_ratio", 2},
          {"container_width_m", width},
          {"container_height_m", height}};
}

TEST(Scene, ANarrowOrLowContainerIsNotThePapers) {
  const auto quick = scene_unlike_the_papers(parameters(0.072, 0.4));
  for (const auto* words : {"24 d_p wide", "12 particle lengths", "0.4 m high", "40 d_p", "0, 60"})
    EXPECT_THAT(quick, HasSubstr(words));
  EXPECT_THAT(scene_unlike_the_papers(parameters(0.12, 0.4)), HasSubstr("Not the paper's"));
  EXPECT_THAT(scene_unlike_the_papers(parameters(0.072, 2)), HasSubstr("Not the paper's"));
}

TEST(Scene, ThePapersAndAnUnknownOneSayNothing) {
  EXPECT_EQ(scene_unlike_the_papers(parameters(0.12, 2)), "");
  EXPECT_EQ(scene_unlike_the_papers(parameters(0.1199999, 2)), "");  // rounded to six digits
  EXPECT_EQ(scene_unlike_the_papers(parameters(0.3, 3)), "");
  EXPECT_EQ(scene_unlike_the_papers({{"aspect_ratio", 2}}), "");
  auto words = parameters(0.072, 0.4);
  words["container_width_m"] = "narrow";
  EXPECT_EQ(scene_unlike_the_papers(words), "");
}

}  // namespace

// SPDX-License-Identifier: GPL-2.0-or-later
#include "study/study_figures.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "reading/text_file.h"
#include "liggghts_run.h"
#include "synthetic_study.h"

namespace {
using namespace rodpack;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

TEST(StudyCase, NamesSayWhatTheCasesAre) {
  const auto curved = study_case("curved-AR5-theta60");
  ASSERT_TRUE(curved);
  EXPECT_EQ(curved->surface, Surface::smooth);
  EXPECT_EQ(curved->aspect_ratio, 5);
  EXPECT_EQ(curved->theta, 60);
  EXPECT_EQ(study_case("coarse-AR2.5")->aspect_ratio, 2.5);
  EXPECT_EQ(study_case("smooth-AR5-kn4000")->variation, "kn4000");
  EXPECT_EQ(study_case("spheres")->surface, Surface::sphere);
  for (const auto* name : {"rough-AR2", "smooth-AR", "curved-AR5", "my case"})
    EXPECT_FALSE(study_case(name)) << name;
}

TEST(StudyFigures, AreDrawnFromTheCasesThereAre) {
  const auto out = test::fresh_folder().string();
  const auto figures = draw_study_figures(study_of_claims(1).ensemble, out, out);
  EXPECT_GE(figures.size(), 13U);
  for (const auto& figure : figures) {
    // The synthetic cases have neither dumps nor fields.
    const bool from_runs = figure.name == "fig1_packings" || figure.name == "fig6b_voids" ||
                           figure.name == "fig2_solid_fraction_maps" ||
                           figure.name.find("fig2_slice") == 0;
    EXPECT_EQ(figure.not_drawn.empty(), !from_runs) << figure.name << ": " << figure.not_drawn;
    for (const char* suffix : {".png", ".svg"})
      EXPECT_EQ(fs::exists(out + "/" + figure.name + suffix), !from_runs) << figure.name;
  }
  // Peaks are named by their position, coarse and smooth.
  const auto svg = read_text(out + "/fig4_rdf.svg");
  EXPECT_THAT(svg, HasSubstr("1.75"));
  EXPECT_THAT(svg, HasSubstr("1.95"));
  EXPECT_THAT(read_text(out + "/fig4_rdf_peaks.csv"), HasSubstr("\ncoarse-AR2,1.75,"));
  EXPECT_THAT(read_text(out + "/table2.md"), HasSubstr("| smooth-AR5 | 5 |"));
}

TEST(StudyFigures, OfNoCasesAreNotDrawnAndSayWhy) {
  const auto out = test::fresh_folder().string();
  for (const auto& figure : draw_study_figures({}, out, out)) {
    EXPECT_THAT(figure.not_drawn, HasSubstr("no ")) << figure.name;
    EXPECT_FALSE(fs::exists(out + "/" + figure.name + ".png"));
  }
}

TEST(StudyFigures, SingleRunsAreDrawnWithoutErrors) {
  SyntheticStudy study;
  study.orientation("smooth-AR5", [](double) { return 1.0; });
  for (auto& value : study.ensemble.cases[0].curves["orientation.probability_density_per_deg"].y)
    value = {value.mean, std::nullopt, 1};
  const auto out = test::fresh_folder().string();
  EXPECT_EQ(draw_orientation(study.ensemble, out).not_drawn, "");
  EXPECT_TRUE(fs::exists(out + "/fig3_orientation.svg"));
}

}  // namespace

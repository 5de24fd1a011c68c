// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "ensemble/ensemble.h"
#include "liggghts_run.h"
#include "page/frame.h"
#include "figures/packings/base64.h"
#include "page/html.h"
#include "page/study_page.h"
#include "reading/data_error.h"
#include "synthetic_packing.h"

namespace {
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::text_of;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A run folder as the page reads it: packing, log, result, and what the analysis noted.
void write_run(const fs::path& run, const std::string& notes) {
  rodpack::test::SyntheticPacking packing;
  packing.height = 0.1;
  packing.fill();
  packing.write_run(run);
  put(run / "result.json", R"({"step": 2000, "time_s": 0.022, "particles": 120})");
  put(run / "log.liggghts",
      "Step CPU\n0 0\nLoop time of 7200 on 1 procs for 9 steps with 9 atoms\n");
  put(run / "analysis" / "summary.json",
      R"({"particles": 120, "notes": [)" + notes +
          R"(], "rodpack": {"version": "9.8", "commit": "abc"}})");
}

rodpack::EnsembleCase case_of(const std::string& name, std::vector<long> seeds, double phi) {
  rodpack::EnsembleCase one;
  one.name = name;
  one.parameters = {{"surface", "smooth"}, {"aspect_ratio", 5 + phi}, {"friction", 0.3}};
  one.seeds = std::move(seeds);
  for (const long seed : one.seeds)
    one.runs.push_back("runs/" + name + "/seed-" + std::to_string(seed));
  one.numbers["solid_fraction"] = {phi, 0.00123456, static_cast<int>(one.seeds.size())};
  one.numbers["nematic_order_S2"] = {phi / 2, std::nullopt, 1};
  one.numbers["unheard_of_N_m"] = {3.25, 0.5, 2};
  return one;
}

const std::string odd_name = "a<b>&'c";

/// A study of two cases; of the one with an odd name seed 2 is missing.
fs::path write_study(const fs::path& folder) {
  rodpack::Ensemble ensemble;
  ensemble.cases = {case_of("smooth-AR5", {1, 3}, 0.8512345), case_of(odd_name, {1}, 0.7654321)};
  ensemble.notes = {"left out: <seed> 2"};
  rodpack::write_ensemble(ensemble, (folder / "ensemble").string());
  put(folder / "cases.json",
      R"({"format": "rodpack-study 1", "title": "A <small> study", "columns": ["surface", "aspect_ratio"],
          "cases": {"smooth-AR5": {"seeds": [1, 3], "ranks": 16}, "a<b>&'c": {"seeds": [1, 2]},
                    "smooth-AR7": {"seeds": [1], "parameters": {"aspect_ratio": 7}}}})");
  for (const long seed : {1, 3})
    write_run(folder / "runs" / "smooth-AR5" / ("seed-" + std::to_string(seed)),
              "\"a margin of 12." + std::to_string(seed) + " d_p\"");
  write_run(folder / "runs" / odd_name / "seed-1", "\"a margin of 14 d_p\", \"too <low>\"");
  return folder;
}

void write_results(const fs::path& ensemble) {
  put(ensemble / "table2.csv",
      "case,quantity,solid_fraction,sem,n,published,published_error,difference,combined_error,"
      "source\n"
      "smooth-AR5,solid_fraction,0.8512345,0.0012,2,0.85,0.0015,0.0012345,0.00192,The paper\n"
      "<i>other</i>,solid_fraction,0.7654321,,1,,,,,\n");
  put(ensemble / "claims.json",
      R"({"decisive_sigmas": 2, "claims": [
          {"claim": "φ falls with <AR>", "measured": "slope", "value": -0.03512, "error": 0.0012,
           "test": "least squares & co", "sigmas": 29.25, "verdict": "holds", "remark": "3 means"},
          {"claim": "It is so", "measured": "", "value": null, "error": null, "test": "t",
           "sigmas": -4.5, "verdict": "does not hold", "remark": ""}]})");
  put(ensemble / "figures.json",
      R"({"figures": [{"name": "fig10_b", "paper": "Fig. 10", "caption": "Tenth <b>", "not_drawn": ""},
          {"name": "fig6b", "paper": "Fig. 6b", "caption": "", "not_drawn": "no <case>"}]})");
  for (const std::string name : {"fig2_a", "fig10_b", "fig11_c"}) {
    put(ensemble / (name + ".png"), "\x89PNG picture of " + name);
    put(ensemble / (name + ".svg"),
        "<svg>" + name + (name == "fig2_a" ? "" : " that is much longer") + "</svg>");
  }
}

std::set<double> numbers_in(const std::string& html) {
  const std::regex value("<data value=\"([^\"]*)\"");
  std::set<double> numbers;
  for (auto match = std::sregex_iterator(html.begin(), html.end(), value);
       match != std::sregex_iterator(); ++match)
    numbers.insert(std::stod((*match)[1]));
  return numbers;
}

TEST(StudyPage, HoldsCasesNumbersClaimsFiguresPackingsAndCost) {
  const auto folder = write_study(fresh_folder() / "study");
  write_results(folder / "ensemble");
  EXPECT_EQ(rodpack::write_study_page(folder.string()), (folder / "report.html").string());
  const auto html = text_of(folder / "report.html");
  const auto numbers = numbers_in(html);
  // The means of ensemble.json, of table2.csv and of claims.json, whole.
  for (const double number : {0.8512345, 0.7654321, 0.00123456, 0.8512345 / 2, 3.25, 0.0012, 0.85,
                              0.0015, 0.0012345, 0.00192, -0.03512, 29.25, -4.5})
    EXPECT_TRUE(numbers.count(number)) << number;
  EXPECT_THAT(html, HasSubstr("(The paper)"));
  EXPECT_THAT(html, HasSubstr(">holds</span>"));
  EXPECT_THAT(html, HasSubstr("class=\"verdict-fails\">does not hold</span>"));
  EXPECT_THAT(html, HasSubstr("rodpack 9.8 (commit abc)"));
  // 7200 s each: 120 min, 2 core-hours, 6 in all.
  EXPECT_THAT(html, HasSubstr("<data value=\"7200.0\">120</data>"));
  EXPECT_THAT(html, HasSubstr("<data value=\"21600.0\">6</data>"));
  // One packing for each case that has runs, of its lowest seed.
  EXPECT_THAT(html, HasSubstr("<option value=\"packing-0\">smooth-AR5, seed 1</option>"));
  EXPECT_THAT(html,
              HasSubstr("<option value=\"packing-1\">a&lt;b&gt;&amp;&#39;c, seed 1</option>"));
  EXPECT_THAT(html, Not(HasSubstr("packing-2")));
  EXPECT_THAT(html, HasSubstr("missing: 2"));
  EXPECT_THAT(html, HasSubstr("all missing"));
  EXPECT_TRUE(numbers.count(16));
}

TEST(StudyPage, FiguresStandInTheListsOrderThenByNumberEachAsItsSmallerFile) {
  const auto folder = write_study(fresh_folder() / "study");
  write_results(folder / "ensemble");
  rodpack::write_study_page(folder.string());
  const auto html = text_of(folder / "report.html");
  const auto at = [&](const std::string& text) { return html.find(text); };
  const auto image = [](const std::string& type, const std::string& bytes) {
    return "src=\"data:image/" + type + ";base64," + rodpack::base64(bytes) + "\"";
  };
  const auto tenth = at(image("png", "\x89PNG picture of fig10_b"));
  const auto second = at(image("svg+xml", "<svg>fig2_a</svg>"));
  const auto eleventh = at(image("png", "\x89PNG picture of fig11_c"));
  ASSERT_NE(tenth, std::string::npos);
  ASSERT_NE(second, std::string::npos);
  ASSERT_NE(eleventh, std::string::npos);
  EXPECT_LT(tenth, second);
  EXPECT_LT(second, eleventh);
  EXPECT_THAT(html, HasSubstr("Tenth &lt;b&gt;"));
  EXPECT_THAT(html, HasSubstr("Fig. 6b: no &lt;case&gt;"));
}

TEST(StudyPage, NoTextOfTheDataIsReadAsMarkup) {
  const auto folder = write_study(fresh_folder() / "study");
  write_results(folder / "ensemble");
  rodpack::write_study_page(folder.string());
  const auto html = text_of(folder / "report.html");
  EXPECT_THAT(html, HasSubstr("<title>A &lt;small&gt; study</title>"));
  for (const std::string markup :
       {"<small>", "a<b>", "<AR>", "<i>other", "<low>", "<seed>", "<case>"})
    EXPECT_THAT(html, Not(HasSubstr(markup)));
  EXPECT_THAT(html, HasSubstr("least squares &amp; co"));
  EXPECT_THAT(html, HasSubstr("&lt;i&gt;other&lt;/i&gt;"));
}

TEST(StudyPage, WhatIsMissingIsNamedWithTheCommandThatMakesIt) {
  const auto folder = write_study(fresh_folder() / "study");
  fs::remove(folder / "cases.json");
  fs::remove_all(folder / "runs" / odd_name);
  rodpack::write_study_page(folder.string());
  const auto html = text_of(folder / "report.html");
  for (const std::string file : {"table2.csv", "claims.json"})
    EXPECT_THAT(html, HasSubstr("Missing: " + file + ". <code>rodpack ensemble "));
  EXPECT_THAT(html, HasSubstr("Missing: "));
  EXPECT_THAT(html, HasSubstr("No cases.json in the folder"));
  EXPECT_THAT(html, HasSubstr("Not shown:"));  // the packing whose folder is gone
  EXPECT_THAT(html, HasSubstr("1 run has no log.liggghts that tells its time"));
}

TEST(StudyPage, WithoutEnsembleItIsRefusedAndNothingIsWritten) {
  const auto folder = fresh_folder();
  put(folder / "study" / "cases.json", "{}");
  try {
    rodpack::write_study_page((folder / "study").string());
    FAIL() << "nothing was thrown";
  } catch (const rodpack::DataError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("study/ensemble/ensemble.json: no such file; \"rodpack ensemble "));
  }
  EXPECT_FALSE(fs::exists(folder / "study" / "report.html"));
}

TEST(StudyPage, OfResultsThatWereWrittenElsewhereStandsBesideThem) {
  const auto folder = write_study(fresh_folder() / "study");
  const auto results = folder / "ensemble";
  EXPECT_EQ(rodpack::write_study_page(results.string()), (results / "report.html").string());
  EXPECT_THAT(text_of(results / "report.html"), HasSubstr("smooth-AR5, seed 1</option>"));
}

TEST(Notes, AlikeOnesAboutSeveralRunsStandOnce) {
  const auto html = rodpack::notes_html({{"", "left out: 2"},
                                         {"", "left out: 3"},
                                         {"a", "margin 12.5"},
                                         {"b", "margin 13"},
                                         {"a", "margin 1"}});
  EXPECT_THAT(html, HasSubstr("<li>left out: 2</li>"));
  EXPECT_THAT(html, HasSubstr("<li>left out: 3</li>"));
  EXPECT_THAT(html,
              HasSubstr("margin 12.5 <span class=\"about\">(a, b)</span> <span class=\"about\">and "
                        "alike with other numbers</span>"));
  EXPECT_THAT(html, Not(HasSubstr("margin 13")));
}

}  // namespace

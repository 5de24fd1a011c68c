// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "liggghts_run.h"
#include "figures/packings/base64.h"
#include "page/html.h"
#include "page/packing_data.h"
#include "page/tables.h"
#include "page/words.h"
#include "reading/data_error.h"
#include "synthetic_packing.h"

namespace {
using nlohmann::json;
using rodpack::test::fresh_folder;
using rodpack::test::put;
using rodpack::test::SyntheticPacking;
using rodpack::test::text_of;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

auto rodpack_command(const std::string& arguments, const fs::path& folder = fresh_folder()) {
  return rodpack::test::run_rodpack(arguments, folder);
}

std::string file_in_base64(const fs::path& file) { return rodpack::base64(text_of(file)); }

/// All captures of the first group.
std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), expression);
       match != std::sregex_iterator(); ++match)
    found.push_back((*match)[1]);
  return found;
}

/// The page without what is in it in base64, which no pattern should be looked for in.
std::string without_data(std::string html) {
  for (auto at = html.find(";base64,"); at != std::string::npos; at = html.find(";base64,", at)) {
    const auto end = html.find('"', at);
    html.erase(at, end - at);
  }
  return html;
}

void expect_self_contained(const std::string& html) {
  const std::string page = without_data(html);
  for (const auto& target : all_matches(page, "(?:src|href|srcset|action)\\s*=\\s*\"([^\"]*)\""))
    EXPECT_TRUE(target.rfind("data:", 0) == 0 || target.rfind('#', 0) == 0) << target;
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  for (const auto& id : all_matches(page, "href=\"#([^\"]*)\""))
    EXPECT_THAT(page, HasSubstr("id=\"" + id + "\""));
}

std::set<std::string> figures_in(const fs::path& folder) {
  std::set<std::string> stems;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".png") stems.insert(entry.path().stem().string());
  return stems;
}

fs::path analysed_run(const fs::path& folder, double curvature = 0) {
  SyntheticPacking packing;
  packing.shape.curvature_angle = curvature;
  packing.fill();
  packing.write_run(folder);
  const auto run = rodpack_command("analyse '" + folder.string() + "'");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return folder;
}

TEST(Html, TextCannotBecomeMarkup) {
  EXPECT_EQ(rodpack::escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
  EXPECT_THAT(rodpack::data_element("x", {{"name", "</script><script>alert(1)"}}),
              HasSubstr(R"~({"name":"\u003c/script>\u003cscript>alert(1)"}</script>)~"));
}

// The test vectors of RFC 4648, section 10.
TEST(Html, Base64IsThatOfItsStandard) {
  const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                 {"f", "Zg=="},
                                                                 {"fo", "Zm8="},
                                                                 {"foo", "Zm9v"},
                                                                 {"foob", "Zm9vYg=="},
                                                                 {"fooba", "Zm9vYmE="},
                                                                 {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(rodpack::base64(bytes), text);
  EXPECT_EQ(rodpack::base64("\xff\xfe\xfd"), "//79");
}

TEST(Html, NumbersAreShownRoundedAndKeptWhole) {
  EXPECT_EQ(rodpack::number_html(0.6443986896396318, 4),
            "<data value=\"0.6443986896396318\">0.6444</data>");
  EXPECT_THAT(rodpack::number_html(-1.1e-5),
              HasSubstr(">\u22121.1\u00a0×\u00a010<sup>\u22125</sup><"));
  EXPECT_THAT(rodpack::number_html(0.00762, 3, 1e3), HasSubstr(">7.62<"));
}

// The error has two significant digits, and the mean as many decimals.
TEST(Html, AMeanHasTheDecimalsOfItsError) {
  const auto shown = [](double mean, double error, double factor = 1) {
    return std::regex_replace(rodpack::measured_html(mean, error, factor), std::regex("<[^>]*>"),
                              "");
  };
  EXPECT_EQ(shown(0.87123, 0.00214), "0.8712\u00a0±\u00a00.0021");
  EXPECT_EQ(shown(-12.345, 1.234), "\u221212.3\u00a0±\u00a01.2");
  EXPECT_EQ(shown(120.4, 34), "120\u00a0±\u00a034");
  EXPECT_EQ(shown(3.214e-7, 1.5e-9), "(3.214\u00a0±\u00a00.015)\u00a0×\u00a010\u22127");
  EXPECT_EQ(shown(0.0076243, 0.00012, 1e3), "7.62\u00a0±\u00a00.12");
  EXPECT_THAT(rodpack::measured_html(0.5, std::nullopt), HasSubstr(">0.5000<"));
}

TEST(Words, AKeyTellsItsUnit) {
  EXPECT_EQ(rodpack::wording("container_width_m").unit, "m");
  EXPECT_EQ(rodpack::wording("container_width_m").label, "container width");
  EXPECT_EQ(rodpack::wording("pressure_N_m").unit, "N/m");
  EXPECT_EQ(rodpack::wording("nematic_order_S2").unit, "");
  EXPECT_EQ(rodpack::wording("a<b_deg").label, "a&lt;b");
}

TEST(Tables, AStandardErrorStandsBesideItsValue) {
  const auto table = rodpack::values_table({{"order", 0.5},
                                            {"order_standard_error", 0.02},
                                            {"tail_mean", 0.99},
                                            {"tail_standard_error", 0.01},
                                            {"pressure_N_m", 7.0},
                                            {"pressure_standard_error_N_m", 0.5},
                                            {"depth_over_dp", nullptr}},
                                           "");
  EXPECT_THAT(table, HasSubstr(">0.500</data>\u00a0±\u00a0<data value=\"0.02"));
  EXPECT_THAT(table, HasSubstr(">0.990</data>\u00a0±\u00a0<data value=\"0.01"));
  EXPECT_THAT(table, HasSubstr(">7.00</data>\u00a0±\u00a0<data value=\"0.5\""));
  EXPECT_THAT(table, HasSubstr("not measured"));
  EXPECT_EQ(all_matches(table, "(<tr><th scope=\"row\")").size(), 4U);
}

/// Reads back what packing_data() packed, independently of the page's script.
std::vector<double> unpacked(const std::string& base64, std::size_t bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string raw;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    raw += static_cast<char>(bits >> held & 255U);
  }
  std::vector<double> values;
  for (std::size_t at = 0; at + bytes <= raw.size(); at += bytes) {
    double value = 0;
    for (std::size_t k = bytes; k-- > 0;)
      value = 256 * value + static_cast<unsigned char>(raw[at + k]);
    values.push_back(value);
  }
  return values;
}

// 16 bits over 0.3 m are 5 µm, half of that when rounded; over 360° at half a length of 7.5 mm 0.4
// µm; the centres are written to 1e-5 lengths of 12 mm, 0.1 µm.
TEST(PackingData, EverySphereIsWhereTheDumpHasIt) {
  for (const double curvature : {0.0, 2.0}) {
    SyntheticPacking packing;
    packing.shape.curvature_angle = curvature;
    packing.fill();
    const auto run = fresh_folder();
    packing.write_run(run);
    const json data = rodpack::packing_data(run.string());
    ASSERT_EQ(data["particles"], packing.body_count);
    ASSERT_EQ(data["shapes"].size(), 1U);
    EXPECT_EQ(data["shapes"][0]["gamma_range_deg"], curvature > 0 ? 360 : 180);
    const auto column = [&](const std::string& name, std::size_t k) {
      const auto& range = data[name + "_range"];
      const double low = range[0], high = range[1];
      return low + (high - low) * unpacked(data[name], 2)[k] / 65535;
    };
    const auto angles = unpacked(data["angle"], 2);
    std::istringstream rows(packing.spheres);
    double id, body, type, x, y, z, radius, fx, fy, fz, sum;
    const std::size_t per_body = data["shapes"][0]["centres"].size();
    for (std::size_t k = 0; k < 20 * per_body; ++k) {
      rows >> id >> body >> type >> x >> y >> z >> radius >> fx >> fy >> fz >> sum;
      const std::size_t p = k / per_body;
      const auto& centre = data["shapes"][0]["centres"][k % per_body];
      const double unit = 2 * (data["shapes"][0]["half_length_m"].get<double>() - radius);
      const double u = unit * centre[0].get<double>(), v = unit * centre[1].get<double>();
      const double angle = angles[p] * std::acos(-1.0) / 32768;
      EXPECT_NEAR(column("x", p) + std::cos(angle) * u - std::sin(angle) * v, x, 4e-6);
      EXPECT_NEAR(column("y", p) + std::sin(angle) * u + std::cos(angle) * v, y, 4e-6);
    }
  }
}

// All pairs of the made-up packing push with 1e-3 N/m times d; one that is changed here is weaker.
TEST(PackingData, ForcesOfPairsKeepThreeDigitsOverTheirWholeRange) {
  SyntheticPacking packing;
  packing.fill();
  const auto run = fresh_folder();
  packing.write_run(run);
  const std::string columns =
      "body_i body_j sphere_i sphere_j wall x y z fx fy fz bix biy biz bjx bjy bjz overlap_n "
      "overlap_t nx ny nz";
  const auto row = [](const std::string& pair, const std::string& force,
                      const std::string& normal) {
    return pair + " 0 0 0 " + force + " 0 0 0 0 0.01 0 0 1e-6 0 " + normal + " 0\n";
  };
  put(run / "dumps" / "contacts.2000.dump",
      rodpack::test::frame_head(2000, 5, 0.3, 2, columns) + row("2 1 11 2 0", "3e-3 4e-3", "1 0") +
          row("1 2 1 12 0", "-3e-3 -4e-3", "-1 0") + row("3 4 20 30 0", "1.234e-9 0", "1 0") +
          row("5 0 40 0 1", "0 0.5", "0 1") + row("6 5 50 40 0", "0 0", "1 0"));
  const json data = rodpack::packing_data(run.string());
  const auto& contacts = data["contacts"];
  EXPECT_EQ(contacts["walls"], json::array({"floor"}));
  const auto i = unpacked(contacts["i"], 2), j = unpacked(contacts["j"], 2);
  const auto q = unpacked(contacts["force"], 2);
  const double lowest = contacts["lowest_N"], highest = contacts["highest_N"];
  std::map<std::pair<double, double>, double> forces;
  for (std::size_t k = 0; k < q.size(); ++k)
    forces[{i[k], j[k]}] = q[k] == 0 ? 0 : lowest * std::pow(highest / lowest, (q[k] - 1) / 65534);
  ASSERT_EQ(forces.size(), 4U);
  // Places count from 0; two contacts of one pair add up: 2 (3, 4) mN have the magnitude 10 mN.
  EXPECT_NEAR((forces[{0, 1}]), 1e-2, 1e-5);
  EXPECT_NEAR((forces[{2, 3}]), 1.234e-9, 1e-12);
  EXPECT_NEAR((forces[{4, static_cast<double>(packing.body_count)}]), 0.5, 1e-12);
  EXPECT_EQ((forces[{4, 5}]), 0);
}

TEST(PackingData, ASphereOutOfPlaceIsRefusedByName) {
  SyntheticPacking packing;
  packing.fill();
  const auto run = fresh_folder();
  packing.write_run(run);
  auto text = packing.spheres_frame(2000);
  const auto first = text.find("\n1 1 1 ") + 7;
  text.replace(first, text.find(' ', first) - first, "0.29");
  put(run / "dumps" / "spheres.2000.dump", text);
  try {
    rodpack::packing_data(run.string());
    FAIL() << "nothing was thrown";
  } catch (const rodpack::DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("spheres.2000.dump: sphere "));
    EXPECT_THAT(error.what(), HasSubstr("off its place in its particle"));
  }
}

TEST(RunPage, HoldsEveryFigureAndEveryNumberOfTheAnalysisAndNothingFromElsewhere) {
  const auto run = analysed_run(fresh_folder() / "run");
  const auto html = text_of(run / "analysis" / "report.html");
  expect_self_contained(html);

  const auto figures = figures_in(run / "analysis");
  EXPECT_GE(figures.size(), 13U);
  for (const auto& stem : figures) {
    EXPECT_THAT(html, HasSubstr("id=\"figure-" + stem + "\""));
    const auto png = run / "analysis" / (stem + ".png"), svg = run / "analysis" / (stem + ".svg");
    const bool smaller = fs::file_size(svg) < fs::file_size(png);
    EXPECT_NE(html.find(file_in_base64(smaller ? svg : png)), std::string::npos) << stem;
  }
  EXPECT_EQ(all_matches(html, "(<img alt=\"[^\"]+\")").size(), figures.size());

  std::set<double> shown;
  for (const auto& value : all_matches(html, "<data value=\"([^\"]*)\""))
    shown.insert(std::stod(value));
  const auto summary = json::parse(text_of(run / "analysis" / "summary.json"));
  int numbers = 0;
  for (const auto& [key, value] : summary.items())
    if (value.is_number()) {
      ++numbers;
      EXPECT_TRUE(shown.count(value.get<double>())) << key;
    }
  EXPECT_GT(numbers, 20);
  for (const auto& [key, value] : summary["parameters"].items()) {
    if (value.is_number()) {
      EXPECT_TRUE(shown.count(value.get<double>())) << key;
    }
  }
  for (const auto& note : summary["notes"])
    EXPECT_THAT(html, HasSubstr(rodpack::escaped(note.get<std::string>())));
}

// The container of SyntheticPacking, 20 l_axial wide, in a run that says that it is 0.4 m high.
TEST(RunPage, AnotherSceneThanThePapersSaysSoAsTheRunDoes) {
  const auto run = fresh_folder() / "run";
  SyntheticPacking made;
  made.fill();
  made.write_run(run);
  auto parameters = json::parse(text_of(run / "parameters.json"));
  parameters["container_height_m"] = 0.4;
  put(run / "parameters.json", parameters.dump() + "\n");
  const auto output = rodpack_command("analyse " + run.string());
  EXPECT_EQ(output.exit_code, 0) << output.output;
  EXPECT_THAT(output.output, HasSubstr("Not the paper's scene"));
  EXPECT_THAT(text_of(run / "analysis" / "report.html"), HasSubstr("Not the paper"));
  const auto summary = json::parse(text_of(run / "analysis" / "summary.json"));
  EXPECT_THAT(summary["scene"].get<std::string>(), HasSubstr("0.4 m high"));
  for (const auto* key : {"sixfold_order_S6", "mean_cos_6_gamma", "sixfold_bond_order_local",
                          "sixfold_bond_order_global", "sixfold_bond_order_points"})
    EXPECT_TRUE(summary[key].is_number()) << key;
}

TEST(RunPage, IsMadeAnewByReportAndByAnalyse) {
  const auto run = analysed_run(fresh_folder() / "run", 2.0);
  const auto page = run / "analysis" / "report.html";
  const auto first = text_of(page);
  fs::remove(page);
  const auto report = rodpack_command("report '" + run.string() + "/'");
  EXPECT_EQ(report.exit_code, 0) << report.output;
  EXPECT_THAT(report.output, HasSubstr("written: " + page.string()));
  EXPECT_TRUE(first == text_of(page)) << "the two pages differ";
}

TEST(RunPage, NamesCannotBreakIt) {
  const auto folder = fresh_folder() / "a<b>&\"c";
  SyntheticPacking packing;
  packing.fill();
  packing.write_run(folder);
  auto parameters = text_of(folder / "parameters.json");
  parameters.insert(1, "\"surface\": \"<script>alert(1)</script>\", \"<i>key</i>_m\": 1, ");
  put(folder / "parameters.json", parameters);
  rodpack_command("analyse '" + folder.string() + "'");
  const auto html = text_of(folder / "analysis" / "report.html");
  EXPECT_THAT(html, HasSubstr("a&lt;b&gt;&amp;&quot;c"));
  EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
  EXPECT_THAT(html, HasSubstr("&lt;i&gt;key&lt;/i&gt;"));
  EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(html, Not(HasSubstr("a<b>")));
  EXPECT_THAT(html, Not(HasSubstr("<i>key")));
}

TEST(RunPage, APackingWithoutContactsSaysSo) {
  const auto run = fresh_folder() / "run";
  SyntheticPacking packing;
  packing.fill();
  packing.write_run(run);
  for (const std::string step : {"1000", "2000"})
    fs::remove(run / "dumps" / ("contacts." + step + ".dump"));
  const auto analyse = rodpack_command("analyse '" + run.string() + "'");
  ASSERT_EQ(analyse.exit_code, 0) << analyse.output;
  EXPECT_THAT(text_of(run / "analysis" / "report.html"),
              HasSubstr("\"contacts\":null,\"contacts_missing\":\"no file matches"));
}

TEST(Report, WhatIsNoStudyAndNoAnalysedRunGivesOneLine) {
  const auto folder = fresh_folder();
  const auto none = rodpack_command("report none", folder);
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_EQ(none.output, "rodpack: none: no such folder\n");
  fs::create_directory(folder / "empty");
  const auto empty = rodpack_command("report empty", folder);
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_EQ(empty.output,
            "rodpack: empty: expected the folder of a study (cases.json) or of a run "
            "(parameters.json, or analysis/summary.json)\n");
  put(folder / "run" / "parameters.json", "{}");
  const auto run = rodpack_command("report run", folder);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output,
            "rodpack: run/analysis/summary.json: no such file; \"rodpack analyse run\" makes it\n");
  EXPECT_EQ(rodpack_command("report", folder).exit_code, 2);
}

}  // namespace

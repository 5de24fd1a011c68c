// SPDX-License-Identifier: GPL-2.0-or-later
#include "page/study_page.h"

#include <filesystem>
#include <set>

#include "page/html.h"
#include "page/study_results.h"
#include "page/study_runs.h"
#include "reading/text_file.h"
#include "report/scene.h"

namespace rodpack {
namespace {
namespace fs = std::filesystem;

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string lead_of(const Study& study) {
  std::set<double> particles;
  for (const auto& run : study.runs)
    if (const auto found = run.summary.find("particles");
        found != run.summary.end() && found->is_number())
      particles.insert(found->get<double>());
  std::string text = counted(study.ensemble.cases.size(), "case", "cases") + ", " +
                     counted(study.runs.size(), "run", "runs");
  if (!particles.empty()) {
    text += " of " + number_html(*particles.begin(), 12);
    if (particles.size() > 1) text += " to " + number_html(*particles.rbegin(), 12);
    text += " particles each";
  }
  text += ". Errors are standard errors of the mean over repetitions.";
  for (const auto& each : study.ensemble.cases)
    if (const auto scene = scene_unlike_the_papers(nlohmann::json(each.parameters)); !scene.empty())
      return text + " <b>" + escaped(each.name + ": " + scene) + "</b>";  // the others' are alike
  return text;
}

std::vector<ShownPacking> packings_of(const Study& study) {
  std::vector<ShownPacking> packings;
  for (const auto& run : study.runs)
    if (packings.empty() || packings.back().name.rfind(run.case_name + ", seed ", 0) != 0)
      packings.push_back({run.case_name + ", seed " + std::to_string(run.seed), run.folder});
  return packings;
}

}  // namespace

std::string write_study_page(const std::string& folder) {
  const Study study = read_study(folder);
  const auto notes = notes_of(study);
  Page page;
  page.title = study.table.contains("title") && study.table["title"].is_string()
                   ? study.table["title"].get<std::string>()
                   : "Study of packings";
  page.lead = lead_of(study);
  page.sections = {
      {"runs", "What was run", runs_html(study)},
      {"solid-fraction", "Solid fraction beside published values", solid_fraction_html(study)},
      {"claims", "Claims of the paper", claims_html(study)},
      {"figures", "Figures", study_figures_html(study)},
      {"packings", "The packings", viewer_html(packings_of(study))},
      {"numbers", "Numbers of each case", numbers_html(study)},
      {"cost", "Cost", cost_html(study)},
      {"notes", "What was left out, and why",
       notes.empty() ? "<p>Nothing.</p>\n" : notes_html(notes)}};
  auto file = (fs::path(folder) / "report.html").string();
  write_text(file, page_html(page));
  return file;
}

}  // namespace rodpack

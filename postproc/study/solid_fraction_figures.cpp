// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "figures/figure.h"
#include "study/case_panels.h"
#include "study/published.h"

namespace rodpack {
namespace {

const char* const solid_fraction = "solid_fraction";

// Published values of the straight cases of one surface, beside the measured ones.
Series published_series(const std::vector<PublishedValue>& published, Surface surface) {
  const bool coarse = surface == Surface::coarse;
  Series series = with_look({}, coarse);
  series.title = coarse ? "coarse, published" : "smooth, published";
  series.point = 13;
  series.line = false;
  for (const auto& value : published) {
    const auto meaning = study_case(value.case_name);
    if (value.quantity != solid_fraction || !meaning || meaning->surface != surface ||
        meaning->theta > 0 || !meaning->variation.empty())
      continue;
    series.x.push_back(meaning->aspect_ratio + 0.12);
    series.y.push_back(value.value);
    series.sem.push_back(value.error);
  }
  return series;
}

}  // namespace

StudyFigure draw_solid_fraction_over_theta(const Ensemble& ensemble, const std::string& out) {
  PanelSheet sheet =
      sheet_of_one("opening angle {/:Italic θ} (°)", "solid fraction {/:Italic φ}", "30");
  Panel panel;
  std::size_t place = 0;
  for (const double aspect_ratio : aspect_ratios(ensemble, true)) {
    Series series = with_look_of_place({}, ++place);
    series.title = aspect_ratio_title(aspect_ratio);
    for (const double theta : angles_from_straight(ensemble, aspect_ratio))
      if (const auto* mean = number_of(curved_case(ensemble, aspect_ratio, theta), solid_fraction))
        add_point(series, theta, *mean);
    panel.series.push_back(series);
  }
  sheet.panels.push_back(panel);
  fit_x(sheet);
  return finish({"fig6a_solid_fraction_over_theta", "Fig. 6a",
                 "Mean solid fraction (central slice, from 3ω above the floor to the surface) "
                 "of curved particles over the opening angle of their arc; 0°: straight, "
                 "smooth. Mean and standard error over the repetitions.",
                 ""},
                sheet, out, "no curved case has a solid fraction");
}

StudyFigure draw_solid_fraction_over_aspect_ratio(const Ensemble& ensemble,
                                                  const std::vector<PublishedValue>& published,
                                                  const std::string& out) {
  StudyFigure figure{"table2_solid_fraction", "Table 2",
                     "Mean solid fraction (central slice, from 3ω above the floor to the surface) "
                     "of straight particles, mean and standard error over the repetitions, beside "
                     "published values (shifted to the right). The table in table2.csv and .md has "
                     "the mean up to 3ω below the surface too.",
                     ""};
  PanelSheet sheet = sheet_of_one("aspect ratio AR", "solid fraction {/:Italic φ}", "1");
  Panel panel;
  bool any = false;
  for (const bool coarse : {true, false}) {
    Series series = with_look({}, coarse);
    for (const double aspect_ratio : aspect_ratios(ensemble, false))
      if (const auto* mean =
              number_of(straight_case(ensemble, surface_of(coarse), aspect_ratio), solid_fraction))
        add_point(series, aspect_ratio, *mean);
    any = any || !series.x.empty();
    panel.series.push_back(series);
  }
  if (!any) {
    figure.not_drawn = "no straight case has a solid fraction";
    return figure;
  }
  for (const auto surface : {Surface::coarse, Surface::smooth})
    panel.series.push_back(published_series(published, surface));
  sheet.panels.push_back(panel);
  fit_x(sheet);
  draw_panels(sheet, out + "/" + figure.name);
  return figure;
}

}  // namespace rodpack
